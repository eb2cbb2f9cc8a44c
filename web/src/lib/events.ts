// What the server tells by itself: one stream for the window, whichever pages listen.
//
// The stream is open while something listens and the window is seen (a browser has few connections
// for one server), and is opened again with growing pauses when it breaks. After each opening
// listeners hear 'open', so that they ask for what they missed.
import type { PlanJob, RunEvent, SearchJob } from './api';

export type StreamState = 'closed' | 'opening' | 'open' | 'waiting';

interface Listener {
  search?(job: SearchJob): void;
  plan?(job: PlanJob): void;
  run?(run: RunEvent): void;
  state?(state: StreamState, retryInSeconds: number): void;
}

const listeners = new Set<Listener>();
const longestPause = 30;
let source: EventSource | null = null;
let state: StreamState = 'closed';
let pause = 1;
let timer: ReturnType<typeof setTimeout> | undefined;

function become(next: StreamState): void {
  state = next;
  for (const listener of listeners) {
    listener.state?.(next, pause);
  }
}

function close(): void {
  clearTimeout(timer);
  source?.close();
  source = null;
}

function open(): void {
  close();
  become('opening');
  source = new EventSource('api/events');
  source.onopen = () => {
    pause = 1;
    become('open');
  };
  source.onerror = () => {
    close();
    become('waiting');
    timer = setTimeout(open, pause * 1000);
    pause = Math.min(pause * 2, longestPause);
  };
  const tell = <T>(event: string, to: (listener: Listener) => ((data: T) => void) | undefined) =>
    source!.addEventListener(event, (message) => {
      const data = JSON.parse((message as MessageEvent<string>).data) as T;
      for (const listener of listeners) {
        to(listener)?.(data);
      }
    });
  tell<SearchJob>('search', (listener) => listener.search);
  tell<PlanJob>('plan', (listener) => listener.plan);
  tell<RunEvent>('run', (listener) => listener.run);
}

function settle(): void {
  const wanted = listeners.size > 0 && document.visibilityState === 'visible';
  if (wanted && state === 'closed') {
    open();
  } else if (!wanted && state !== 'closed') {
    close();
    become('closed');
  }
}
document.addEventListener('visibilitychange', settle);

/** Opens the stream at once instead of after the pause. */
export function retryNow(): void {
  if (state === 'waiting') {
    pause = 1;
    open();
  }
}

/**
 * Listens until `signal` is aborted. The stream stays open for a while after the last one left:
 * pages follow each other.
 */
export function listen(listener: Listener, signal: AbortSignal): void {
  listeners.add(listener);
  signal.addEventListener('abort', () => {
    listeners.delete(listener);
    setTimeout(settle, 10_000);
  });
  settle();
  listener.state?.(state, pause);
}
