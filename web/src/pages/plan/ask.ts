// Planning: what is asked of the server, followed while it searches.
import type { Job as Request } from '../../../answers';
import { ApiError, get, hasToken, post, type PlanJob, type Planned } from '../../lib/api';
import { listen } from '../../lib/events';
import { about } from '../../shell/about';

/** After so long without news the server is asked: the stream may be closed, or held up. */
const silence = 4000;
/** A server that does not answer so often in turn is gone. */
const mostAway = 6;

/** Whether this window may start searches, and have runs kept. */
export async function mayStart(): Promise<boolean> {
  return hasToken() && (await about()).write;
}

export interface Following {
  /** The number of the plan on the server; null if it was only waited for. */
  readonly job: number | null;
  readonly planned: Planned;
  /** What is to be said of how it ended. */
  readonly message: string;
}

/**
 * Plans. `news` hears of every better plan; `best` is aborted to have the best so far. Where
 * nothing may be started, the answer is waited for.
 * @throws Error with a line that can be shown; ApiError
 */
export async function follow(
  request: Request,
  signal: AbortSignal,
  best: AbortSignal,
  news: (job: PlanJob) => void,
): Promise<Following> {
  if (!(await mayStart())) {
    return { job: null, planned: await post('plan', {}, request, signal), message: '' };
  }
  const { id } = await post('plan/start', {}, request, signal);
  const own = new AbortController();
  let quiet: ReturnType<typeof setTimeout> | undefined;
  let away = 0;
  const stop = () => void post('plan/stop', { id }, undefined, own.signal).catch(() => undefined);
  best.addEventListener('abort', stop, { once: true });
  signal.addEventListener('abort', stop, { once: true });
  try {
    const ended = await new Promise<PlanJob>((resolve, reject) => {
      const ask = () =>
        get('plan/job', { id }, own.signal).then(hear, (fault: unknown) => {
          if (fault instanceof ApiError && fault.status === 0 && ++away < mostAway) {
            listenOn();
          } else if (!own.signal.aborted) {
            reject(fault);
          }
        });
      const listenOn = () => {
        clearTimeout(quiet);
        quiet = own.signal.aborted ? undefined : setTimeout(() => void ask(), silence);
      };
      const hear = (job: PlanJob) => {
        away = 0;
        listenOn();
        if (job.state === 'running') {
          news(job);
        } else if (job.answer === undefined) {
          void ask(); // The stream tells that it has ended, not its answer.
        } else {
          resolve(job);
        }
      };
      signal.addEventListener('abort', () => reject(signal.reason as Error), { once: true });
      listen(
        {
          plan: (job) => job.id === id && hear(job),
          state: (state) => state === 'open' && void ask(),
        },
        own.signal,
      );
      listenOn();
    });
    if (!ended.answer) {
      throw new Error(ended.message);
    }
    return { job: id, planned: ended.answer, message: ended.message };
  } finally {
    clearTimeout(quiet);
    best.removeEventListener('abort', stop);
    signal.removeEventListener('abort', stop);
    if (!signal.aborted) {
      own.abort();
    }
  }
}
