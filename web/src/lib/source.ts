// One way to ask for what a page shows: of the server, or of the files of a static export (docs/explorer.md has the rule).
import { dataFolder, isCopy } from '../shell/about';
import type { Theme } from '../shell/theme';
import { address, ApiError, get, getFile, getFileText, getText, postText, type Cell, type CellDetail, type Completeness, type Construction, type Design, type Explanation, type Kind, type Selector, type TableCell, type Theorem } from './api';
import { inRange, parseRange } from './range';
import { localDesign } from './local';

export interface TableQuery {
  change: number;
  kind: Kind;
  k: string;
  v: string;
}

export type Measure = 'ratio' | 'status' | 'gap';
export type PictureName = 'array' | 'stays' | 'circle' | 'coverage' | 'recipe';

export interface DrawQuery {
  picture: PictureName;
  theme: Theme;
  order?: string;
  from?: number;
  to?: number;
}

/** A design to ask for, the one of this window (`local`) included. */
export type Asked = Selector | { local: true };

export function isCell(asked: Asked): asked is Cell {
  return 'v' in asked;
}

const notCopied = 'This static copy does not have it. `changeover serve` on a machine of your own shows every cell and design.';

async function file<T>(path: string, signal: AbortSignal): Promise<T> {
  return getFile<T>(dataFolder() + path, signal, notCopied);
}

function parameters(cell: Cell): object {
  const { v, k, change, kind, strength } = cell;
  return { v, k, change, kind, strength: strength === 2 ? undefined : strength };
}

export async function table(query: TableQuery, signal: AbortSignal): Promise<TableCell[]> {
  if (!isCopy()) {
    return get('table', query, signal);
  }
  const k = parseRange(query.k);
  const v = parseRange(query.v);
  const cells = await file<TableCell[]>(`table/${query.change}.${query.kind}.json`, signal);
  return cells.filter((cell) => inRange(cell.k, k) && inRange(cell.v, v));
}

/** A static copy has the picture of its whole range only. */
export async function heatmap(query: TableQuery, measure: Measure, theme: Theme, signal: AbortSignal): Promise<string> {
  return isCopy()
    ? getFileText(`${dataFolder()}heatmap/${query.change}.${query.kind}.${measure}.${theme}.svg`, signal, notCopied)
    : getText('heatmap', { ...query, measure, theme }, signal);
}

type KeptCell = CellDetail & { explain?: Explanation | null };

async function keptCell(cell: Cell, signal: AbortSignal): Promise<KeptCell> {
  const shelf = (cell.strength ?? 2) === 2 ? '' : `.t${cell.strength}`;
  const row = await file<Record<string, KeptCell>>(`cell/${cell.change}.${cell.kind}.${cell.k}${shelf}.json`, signal);
  const found = row[String(cell.v)];
  if (!found) {
    throw new ApiError(notCopied, 404);
  }
  return found;
}

export async function cellDetail(cell: Cell, signal: AbortSignal): Promise<CellDetail> {
  return isCopy() ? keptCell(cell, signal) : get('cell', parameters(cell), signal);
}

export async function designOf(asked: Asked, signal: AbortSignal): Promise<Design> {
  if ('local' in asked) {
    const kept = localDesign();
    if (!kept) {
      throw new ApiError('This window has no pasted design any more. Paste it on the page Verify.', 404);
    }
    return kept;
  }
  if (!isCopy()) {
    return get('design', isCell(asked) ? parameters(asked) : asked, signal);
  }
  if ('label' in asked) {
    return file<Design>(`design/${asked.label}.json`, signal);
  }
  if (!isCell(asked)) {
    throw new ApiError(notCopied, 404);
  }
  const label = (await keptCell(asked, signal)).best?.label;
  if (!label) {
    throw new ApiError(notCopied, 404);
  }
  return file<Design>(`design/${label}.json`, signal);
}

/** The tree of constructions of a cell's best design, or of a labelled one; null where nothing is known of how it was made. */
export async function explain(asked: Asked, signal: AbortSignal): Promise<Explanation | null> {
  if (!isCell(asked) && !('label' in asked)) {
    return null;
  }
  if (!isCopy()) {
    return get('explain', isCell(asked) ? parameters(asked) : asked, signal);
  }
  return (await keptCell(isCell(asked) ? asked : cellOfLabel(asked.label)!, signal)).explain ?? null;
}

/** Pictures of designs are drawn by a server only; null in a static copy. */
export async function draw(asked: Asked, query: DrawQuery, signal: AbortSignal): Promise<string | null> {
  if (isCopy()) {
    return null;
  }
  return 'local' in asked
    ? postText('draw', query, JSON.stringify(localDesign()), signal)
    : getText('draw', { ...(isCell(asked) ? parameters(asked) : asked), ...query }, signal);
}

export async function cite(label: string, signal: AbortSignal): Promise<string> {
  return isCopy() ? getFileText(`${dataFolder()}cite/${label}.bib`, signal, notCopied) : getText('cite', { label }, signal);
}

export async function completeness(signal: AbortSignal): Promise<Completeness[]> {
  return isCopy() ? file('completeness.json', signal) : get('completeness', {}, signal);
}

export async function constructions(signal: AbortSignal): Promise<Construction[]> {
  return isCopy() ? file('constructions.json', signal) : get('constructions', {}, signal);
}

export async function theorems(signal: AbortSignal): Promise<Theorem[]> {
  return isCopy() ? file('theorems.json', signal) : get('theorems', {}, signal);
}

/** Where the server gives a design as a file of that format. */
export function downloadAddress(asked: Selector, format: string): string {
  return address('download', { ...(isCell(asked) ? parameters(asked) : asked), format });
}

/** `20.5.2.linear…` to its cell; null if it begins otherwise. */
export function cellOfLabel(label: string): Cell | null {
  const found = /^(\d+)\.(\d+)\.(\d+)\.(circular|linear)(?:\.t(\d+))?(?=\.|$)/.exec(label);
  if (!found) {
    return null;
  }
  const cell: Cell = { v: Number(found[1]), k: Number(found[2]), change: Number(found[3]), kind: found[4] as Kind };
  return found[5] ? { ...cell, strength: Number(found[5]) } : cell;
}
