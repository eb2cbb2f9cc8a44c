// The server's addresses, as types, and asking them.
//
// All addresses are relative to the page, so that the pages work below any folder. What changes anything carries the
// token that came with the printed address.

export type Kind = 'circular' | 'linear';

export interface Cell {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength?: number;
}

/** Which design: a cell's best, one of the catalog, of the command line, or of a search. */
export type Selector = Cell | { label: string } | { file: number } | { job: string };

export interface TableCell extends Cell {
  b: number | null;
  lower_bound: number | null;
  status: 'minimum' | 'best-known' | 'impossible' | 'unknown';
  construction: string | null;
  label: string | null;
}

export interface Recipe {
  construction: string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  arguments?: Record<string, unknown>;
  inputs?: Recipe[];
}

export interface TreeNode {
  construction: string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  explanation: string;
  citation?: string;
  b?: number;
  verdict?: Verdict;
  inputs: TreeNode[];
}

export interface Verdict {
  valid: boolean;
  tight: boolean;
  economical: boolean;
  b: number;
  lower_bound: number;
  minimum: string;
}

export interface Design extends Cell {
  format: string;
  blocks: (number | string)[][];
  labels?: string[];
  recipe?: Recipe;
  verdict?: Verdict;
  label?: string;
}

export interface Credit {
  who: string;
  date: string;
  program?: string;
  command?: string;
}

export interface CatalogEntry {
  label: string;
  b: number;
  status: string;
  construction: string;
  credit?: Credit;
  cites?: string[];
  hash: string;
  retracted?: string;
}

export interface CellDetail extends Cell {
  lower_bound: number | null;
  reason: string;
  bounds: { name: string; blocks: number; reason: string }[];
  best: { b: number; label: string | null; status: string; construction: string; recipe: Recipe } | null;
  designs: CatalogEntry[];
  offers: { construction: string; b: number; recipe: Recipe }[];
  history: { date: string; b: number; label: string; credit: Credit | string; how: string }[];
  impossible: string | null;
  /** Fewer blocks that a publication reports; absent from data that an older version wrote. */
  reported?: { blocks: number; cites: string } | null;
}

export interface Construction {
  name: string;
  summary: string;
  citation: string;
  serves: string;
  /** How many blocks, or how few. */
  gives?: string;
  example: Cell | null;
}

export interface Theorem {
  number: string;
  title: string;
  statement: string;
  example: Cell | null;
}

export interface SearchJob {
  id: number | string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  state: 'running' | 'done' | 'stopped' | 'failed';
  best: number | null;
  lower_bound: number | null;
  start_best: number | null;
  seconds: number;
  /** So many seconds it may take. */
  limit?: number;
  restarts: number | null;
  message: string;
  points?: { seconds: number; best: number | null; rate: number }[];
}

export interface About {
  version: string;
  catalog: { designs: number; cells: number; version?: string };
  limits?: { body_bytes: number; seconds: number; memory: number; searches: number };
  write: boolean;
  files: { index: number; name: string }[];
  static: boolean;
  /** Of a static copy: what of the table it has. */
  ranges?: { change: number; kind: Kind; k: [number, number]; v: [number, number] }[];
}

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

/** Takes the token out of the address, so that it is not in links that are passed on, and keeps it for this window. */
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

export function query(parameters: object): string {
  const pairs = Object.entries(parameters).filter(([, value]) => value !== undefined && value !== null && value !== '');
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
    throw new ApiError('The server does not answer. Is `changeover serve` still running?', 0);
  }
  if (!response.ok) {
    const body = (await response.json().catch(() => null)) as { error?: { message: string; line?: number; column?: number } } | null;
    throw new ApiError(body?.error?.message ?? `The server answered ${response.status} ${response.statusText}.`, response.status, body?.error?.line, body?.error?.column);
  }
  return response;
}

export async function get<T>(path: string, parameters: object, signal: AbortSignal): Promise<T> {
  return (await askWith(address(path, parameters), { signal })).json() as Promise<T>;
}

export async function getText(path: string, parameters: object, signal: AbortSignal): Promise<string> {
  return (await askWith(address(path, parameters), { signal })).text();
}

/** A file of a static export. What it does not have is said in `missing`. */
async function askFile(url: string, signal: AbortSignal, missing: string): Promise<Response> {
  const response = await fetch(url, { signal });
  if (!response.ok) {
    throw new ApiError(response.status === 404 ? missing : `The server answered ${response.status} for ${url}.`, response.status);
  }
  return response;
}

export async function getFile<T>(url: string, signal: AbortSignal, missing: string): Promise<T> {
  return (await askFile(url, signal, missing)).json() as Promise<T>;
}

export async function getFileText(url: string, signal: AbortSignal, missing: string): Promise<string> {
  return (await askFile(url, signal, missing)).text();
}

/** Asks with a body: an object goes as JSON, a string or a file as it is. With the token if this window has it. */
export async function post<T>(path: string, parameters: object, body: unknown, signal: AbortSignal): Promise<T> {
  const token = sessionStorage.getItem(tokenKey);
  const text = typeof body === 'string' || body instanceof Blob;
  const headers: Record<string, string> = { 'Content-Type': text ? 'text/plain; charset=utf-8' : 'application/json' };
  if (token) {
    headers['X-Changeover-Token'] = token;
  }
  const response = await askWith(address(path, parameters), { method: 'POST', headers, body: text ? body : JSON.stringify(body), signal });
  return response.json() as Promise<T>;
}

export async function postText(path: string, parameters: object, body: string, signal: AbortSignal): Promise<string> {
  return (await askWith(address(path, parameters), { method: 'POST', headers: { 'Content-Type': 'text/plain; charset=utf-8' }, body, signal })).text();
}
