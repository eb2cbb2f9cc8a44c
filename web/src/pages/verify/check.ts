// Asking the server and looking through the blocks, beside the page: a file of 50 MB must not stop
// it. Where there is no server, the worker counts itself.
import { ApiError, noAnswer, type Kind, type Verified } from '../../lib/api';
import type { Declared } from './alone';

export interface Question {
  url: string;
  body: string | Blob;
  /** There is no server: what the form says instead of the text. */
  alone?: Declared;
}

/** What the server says, without the blocks. */
export type Answer = Omit<Verified, 'design'>;

/** The blocks as numbers in a row: element j of block i is blocks[i·k + j]. */
export interface Blocks {
  /** The server leaves out the blocks of very long lists; the three rows are empty then. */
  shown: boolean;
  v: number;
  k: number;
  b: number;
  change: number;
  kind: Kind;
  strength: number;
  labels: string[] | null;
  blocks: Int32Array;
  /** The same in an order in which an element keeps its place while it stays. */
  placed: Int32Array;
  /**
   * How many elements of block i are introduced, and so must be `change` (but in the first block of
   * a linear design).
   */
  introduced: Int32Array;
}

export interface Report {
  answer: Answer;
  blocks: Blocks;
}

export type Reply =
  { report: Report } | { fault: Pick<ApiError, 'message' | 'status' | 'line' | 'column'> };

/** @throws ApiError with line and column if the text is not a list of blocks. */
export function check(question: Question, signal: AbortSignal): Promise<Report> {
  return new Promise((resolve, reject) => {
    const worker = new Worker('assets/verify-worker.js', { type: 'module' });
    const stop = () => {
      worker.terminate();
      reject(new DOMException('left', 'AbortError'));
    };
    signal.addEventListener('abort', stop, { once: true });
    const done = () => {
      signal.removeEventListener('abort', stop);
      worker.terminate();
    };
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      done();
      if ('report' in data) {
        resolve(data.report);
      } else {
        const { message, status, line, column } = data.fault;
        reject(new ApiError(message, status, line, column));
      }
    };
    worker.onerror = (event) => {
      done();
      // Where the worker itself could not be fetched, the event has no message.
      reject(
        event instanceof ErrorEvent && event.message
          ? new Error(
              'The answer could not be read: it may be larger than this browser can hold. ' +
                '`changeover verify FILE` has no such limit.',
            )
          : new ApiError(noAnswer, 0),
      );
    };
    worker.postMessage({ ...question, url: new URL(question.url, document.baseURI).href });
  });
}
