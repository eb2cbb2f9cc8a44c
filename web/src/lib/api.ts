// The server's addresses, as types, and asking them.
//
// All addresses are relative to the page, so that the pages work below any folder. What changes
// anything carries the token that came with the printed address.

import type { Design, Explorer, LoadRequest, Refusal } from '../../answers';

export type * from '../../answers';

type Posted = Explorer['post'];
type Bodies = {
  [P in keyof Posted]: P extends keyof Explorer['body']
    ? Explorer['body'][P]
    : string | Blob | undefined;
} & { loadorder: LoadRequest };

/** What the stream tells of a run that the server keeps. */
export interface RunEvent {
  id: string;
  revision: number;
  sheet_revision: number;
  removed: boolean;
}

export type Cell = Pick<Design, 'v' | 'k' | 'change' | 'kind' | 'strength'>;

/** Which design: a cell's best, one of the catalog, of the command line, or of a search. */
export type Selector = Cell | { label: string } | { file: number } | { job: string };

/** Between backticks stands a command. */
export const noAnswer =
  'The server does not answer. If it was stopped, start `changeover serve` again and open the ' +
  'address that it prints.';

/** What a server said instead of an answer: one line that can be shown as it is. */
export class ApiError extends Error {
  constructor(
    message: string,
    readonly status: number,
    readonly line?: number,
    readonly column?: number,
  ) {
    super(message);
  }
}

const tokenKey = 'changeover-token';

/**
 * Takes the token out of the address, so that it is not in links that are passed on, and keeps it
 * for this window.
 */
export function keepToken(): void {
  const address = new URL(window.location.href);
  const token = address.searchParams.get('token');
  if (token) {
    sessionStorage.setItem(tokenKey, token);
    address.searchParams.delete('token');
    history.replaceState(history.state, '', address);
  }
}

export function hasToken(): boolean {
  return sessionStorage.getItem(tokenKey) !== null;
}

/** A link to a place of these pages that lets others change things, too. */
export function linkForOthers(fragment: string): string {
  const address = new URL(window.location.href);
  const token = sessionStorage.getItem(tokenKey);
  address.search = token ? new URLSearchParams({ token }).toString() : '';
  address.hash = fragment;
  return address.href;
}

export function query(parameters: object): string {
  const pairs = Object.entries(parameters).filter(
    ([, value]) => value !== undefined && value !== null && value !== '',
  );
  return new URLSearchParams(pairs.map(([name, value]) => [name, String(value)])).toString();
}

export function address(path: string, parameters: object = {}): string {
  const text = query(parameters);
  return `api/${path}${text ? `?${text}` : ''}`;
}

/** Asks with what `fetch` takes; a fault is an ApiError with a line that can be shown. */
export async function askWith(url: string, init: RequestInit): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, init);
  } catch (fault) {
    if (init.signal?.aborted) {
      throw fault;
    }
    throw new ApiError(noAnswer, 0);
  }
  if (!response.ok) {
    const body = (await response.json().catch(() => null)) as Refusal | null;
    // Places in JSON that a page has written say nothing to its reader.
    const isJson = new Headers(init.headers).get('Content-Type') === 'application/json';
    throw new ApiError(
      body?.error?.message ?? `The server answered ${response.status} ${response.statusText}.`,
      response.status,
      isJson ? undefined : body?.error?.line,
      isJson ? undefined : body?.error?.column,
    );
  }
  return response;
}

export async function get<P extends keyof Explorer['get']>(
  path: P,
  parameters: object,
  signal: AbortSignal,
): Promise<Explorer['get'][P]> {
  return (
    await askWith(address(path.replace(/[?].*/, ''), parameters), { signal })
  ).json() as Promise<Explorer['get'][P]>;
}

export async function getText(
  path: string,
  parameters: object,
  signal: AbortSignal,
): Promise<string> {
  return (await askWith(address(path, parameters), { signal })).text();
}

/** A file of a static export. What it does not have is said in `missing`. */
export async function askFile(
  url: string,
  signal: AbortSignal,
  missing: string,
): Promise<Response> {
  const response = await fetch(url, { signal });
  if (!response.ok) {
    throw new ApiError(
      response.status === 404 ? missing : `The server answered ${response.status} for ${url}.`,
      response.status,
    );
  }
  return response;
}

export async function getFile<T>(url: string, signal: AbortSignal, missing: string): Promise<T> {
  return (await askFile(url, signal, missing)).json() as Promise<T>;
}

/**
 * Asks with a body: an object goes as JSON, a string or a file as it is. With the token if this
 * window has it.
 */
export async function post<P extends keyof Posted>(
  path: P,
  parameters: object,
  body: Bodies[P],
  signal: AbortSignal,
): Promise<Posted[P]> {
  const token = sessionStorage.getItem(tokenKey);
  const text = typeof body === 'string' || body instanceof Blob;
  const headers: Record<string, string> = {
    'Content-Type': text ? 'text/plain; charset=utf-8' : 'application/json',
  };
  if (token) {
    headers['X-Changeover-Token'] = token;
  }
  const response = await askWith(address(path, parameters), {
    method: 'POST',
    headers,
    body: text ? body : JSON.stringify(body),
    signal,
  });
  return response.json() as Promise<Posted[P]>;
}

export async function postText(
  path: string,
  parameters: object,
  body: string,
  signal: AbortSignal,
): Promise<string> {
  return (
    await askWith(address(path, parameters), {
      method: 'POST',
      headers: { 'Content-Type': 'text/plain; charset=utf-8' },
      body,
      signal,
    })
  ).text();
}
