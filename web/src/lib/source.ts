// One way to ask for what a page shows: of the server, or of the files of a static export
// (docs/explorer.md has the rule).
import { about, dataFolder, isCopy } from '../shell/about';
import type { Theme } from '../shell/theme';
import {
  address,
  ApiError,
  askFile,
  get,
  getFile,
  getText,
  postText,
  type Cell,
  type CellDetail,
  type AtlasDocument,
  type Completeness,
  type Construction,
  type Design,
  type Explanation,
  type GroupsDocument,
  type Kind,
  type Selector,
  type Theorem,
} from './api';
import { Atlas, type Selection } from './atlas';
import { localDesign } from './local';
import { PackedShelf } from './packed';

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

const notCopied =
  'This static copy does not have it. `changeover serve` on a machine of your own shows every ' +
  'cell and design.';

/** The bytes of a file that is kept compressed. A server may have taken its coding off already. */
async function unzipped(path: string, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(
    await (await askFile(`${dataFolder()}${path}`, signal, notCopied)).arrayBuffer(),
  );
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) {
    return bytes;
  }
  return new Uint8Array(
    await new Response(
      new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')),
    ).arrayBuffer(),
  );
}

async function zipped<T>(path: string, signal: AbortSignal): Promise<T> {
  return JSON.parse(new TextDecoder().decode(await unzipped(`${path}.gz`, signal))) as T;
}

async function file<T>(path: string, signal: AbortSignal): Promise<T> {
  return getFile<T>(dataFolder() + path, signal, notCopied);
}

function parameters(cell: Cell): object {
  const { v, k, change, kind, strength } = cell;
  return { v, k, change, kind, strength: strength === 2 ? undefined : strength };
}

const atlases = new Map<string, Promise<Atlas>>();

function nameOf({ change, kind, strength }: Selection): string {
  return `${change}.${kind}${strength > 2 ? `.t${strength}` : ''}`;
}

/** All cells of a selection. Kept: who comes back finds it there. */
export function atlasOf(selection: Selection): Promise<Atlas> {
  const name = nameOf(selection);
  const found = atlases.get(name);
  if (found) {
    return found;
  }
  const never = new AbortController().signal;
  const { change, kind, strength } = selection;
  const asked = (
    isCopy()
      ? zipped<AtlasDocument>(`atlas/${name}.json`, never)
      : get('atlas', { change, kind, strength: strength > 2 ? strength : undefined }, never)
  ).then((document) => new Atlas(document));
  atlases.set(name, asked);
  asked.catch(() => atlases.delete(name));
  return asked;
}

/** Tables of the program have no larger v or k. */
const largest = 1000;

/**
 * The part of a selection near a cell. Where the catalog has no map, which takes long to compute,
 * it is of these cells only; null in a static copy, and where there are no tables.
 */
export async function atlasNear(
  cell: Cell,
  around: { v: number; k: number },
  signal: AbortSignal,
): Promise<Atlas | null> {
  const strength = cell.strength ?? 2;
  const whole =
    cell.change <= 3 ? await atlasOf({ change: cell.change, kind: cell.kind, strength }) : null;
  if (whole?.has(cell.v, cell.k) || isCopy()) {
    return whole;
  }
  if (Math.max(cell.v, cell.k) > largest) {
    return null;
  }
  const range = (at: number, by: number, least: number): string =>
    `${Math.max(least, at - by)}..${Math.min(at + by, largest)}`;
  return new Atlas(
    await get(
      'atlas',
      {
        ...parameters(cell),
        k: range(cell.k, around.k, Math.max(2, cell.change)),
        v: range(cell.v, around.v, 3),
      },
      signal,
    ),
  );
}

/** Has the atlas know the groups of its designs. */
export async function addGroups(atlas: Atlas, signal: AbortSignal): Promise<void> {
  if (!atlas.knowsGroups) {
    const { change, kind, strength } = atlas.selection;
    atlas.addGroups(
      await (isCopy()
        ? zipped<GroupsDocument>(`groups/${nameOf(atlas.selection)}.json`, signal)
        : get('groups', { change, kind, strength: strength > 2 ? strength : undefined }, signal)),
    );
  }
}

/** Asks for all again: the user's catalog has changed. */
export function forgetAtlases(): void {
  atlases.clear();
}

/** A design of the catalog, as a cell has it. */
type Entry = CellDetail['designs'][number];

/** A cell of a static copy: its designs do not say again what it says. */
type KeptCell = Omit<CellDetail, 'designs'> & {
  designs: (Omit<Entry, 'v' | 'k' | 'change' | 'kind' | 'lower_bound' | 'reason'> &
    Partial<Entry>)[];
  tree: Explanation['tree'] | null;
  /** Of each design the number of the form of its citation. */
  cite: number[];
};

/** Where a static copy has the cells of a block size, and where their designs. */
function shelf(cell: Cell): string {
  return (
    `${cell.change}.${cell.kind}${(cell.strength ?? 2) === 2 ? '' : `.t${cell.strength}`}.` +
    `${cell.k}`
  );
}

/** The last few files that were read: neighbours are on the same shelf. */
const shelves = new Map<string, Promise<unknown>>();
function onShelf<T>(name: string, read: () => Promise<T>): Promise<T> {
  const found = shelves.get(name) as Promise<T> | undefined;
  if (found) {
    return found;
  }
  const reading = read();
  shelves.set(name, reading);
  reading.catch(() => shelves.delete(name));
  if (shelves.size > 12) {
    shelves.delete(shelves.keys().next().value!);
  }
  return reading;
}

function packedShelf(cell: Cell): Promise<PackedShelf> {
  const never = new AbortController().signal;
  return onShelf(
    `design ${shelf(cell)}`,
    async () => new PackedShelf(await unzipped(`design/${shelf(cell)}.gz`, never)),
  );
}

async function keptCell(cell: Cell): Promise<KeptCell> {
  const never = new AbortController().signal;
  const row = await onShelf(`cell ${shelf(cell)}`, () =>
    zipped<Record<string, KeptCell>>(`cell/${shelf(cell)}.json`, never),
  );
  const found = row[String(cell.v)];
  if (!found) {
    throw new ApiError(notCopied, 404);
  }
  return found;
}

export async function cellDetail(cell: Cell, signal: AbortSignal): Promise<CellDetail> {
  return isCopy() ? wholeCell(await keptCell(cell)) : get('cell', parameters(cell), signal);
}

function wholeCell(kept: KeptCell): CellDetail {
  const { v, k, change, kind, strength, reason } = kept;
  const said = {
    ...{ v, k, change, kind, reason, lower_bound: kept.lower_bound ?? 0 },
    ...(strength === 2 ? {} : { strength }),
  };
  return { ...kept, designs: kept.designs.map((design) => ({ ...said, ...design })) };
}

export async function designOf(asked: Asked, signal: AbortSignal): Promise<Design> {
  if ('local' in asked) {
    const kept = localDesign();
    if (!kept) {
      throw new ApiError(
        'This window has no pasted design any more. Paste it on the page Verify.',
        404,
      );
    }
    return kept;
  }
  if (!isCopy()) {
    return get('design', isCell(asked) ? parameters(asked) : asked, signal);
  }
  if ('label' in asked) {
    return shelved(asked.label);
  }
  if (!isCell(asked)) {
    throw new ApiError(notCopied, 404);
  }
  const { best } = await keptCell(asked);
  if (!best) {
    throw new ApiError(notCopied, 404);
  }
  if (best.label) {
    return shelved(best.label);
  }
  // A design of a construction: the catalog does not keep it, so it has no label.
  const { label: _, ...made } = await shelved(cellLabel(asked));
  return made;
}

/** `20.5.2.linear`, with which labels of the cell's designs begin. */
function cellLabel({ v, k, change, kind, strength = 2 }: Cell): string {
  return `${v}.${k}.${change}.${kind}${strength === 2 ? '' : `.t${strength}`}`;
}

function cellOf(label: string): Cell {
  const cell = cellOfLabel(label);
  if (!cell) {
    throw new ApiError(`“${label}” is not a label of a design.`, 404);
  }
  return cell;
}

async function shelved(label: string): Promise<Design> {
  const found = (await packedShelf(cellOf(label))).find(label);
  if (!found) {
    throw new ApiError(notCopied, 404);
  }
  return found;
}

/** Whether a static copy has a cell; a server has all. */
export async function isHeld(cell: Cell): Promise<boolean> {
  const { range } = isCopy() ? await about() : { range: undefined };
  const { change, kind, strength = 2 } = cell;
  return (
    !range ||
    (range.changes.includes(change) &&
      cell.k >= range.k_from &&
      cell.k <= range.k_to &&
      cell.v >= range.v_from &&
      cell.v <= range.v_to &&
      // Of larger strengths it has fewer.
      (strength === 2 ||
        (await atlasOf({ change, kind, strength }).then(
          (atlas) => atlas.has(cell.v, cell.k),
          () => false,
        ))))
  );
}

/**
 * The tree of constructions of a cell's best design, or of a labelled one; null where nothing is
 * known of how it was made.
 */
export async function explain(asked: Asked, signal: AbortSignal): Promise<Explanation | null> {
  if (!isCell(asked) && !('label' in asked)) {
    return null;
  }
  if (!isCopy()) {
    return get('explain', isCell(asked) ? parameters(asked) : asked, signal);
  }
  const { best, tree } = await keptCell(isCell(asked) ? asked : cellOf(asked.label));
  return best && tree ? { recipe: best.recipe, tree } : null;
}

/** Pictures of designs are drawn by a server only; null in a static copy. */
export async function draw(
  asked: Asked,
  query: DrawQuery,
  signal: AbortSignal,
): Promise<string | null> {
  if (isCopy()) {
    return null;
  }
  return 'local' in asked
    ? postText('draw', query, JSON.stringify(localDesign()), signal)
    : getText('draw', { ...(isCell(asked) ? parameters(asked) : asked), ...query }, signal);
}

/** A design of the catalog as BibTeX; the whole catalog without a label. */
export async function cite(label: string | null, signal: AbortSignal): Promise<string> {
  if (!isCopy()) {
    return getText('cite', { label: label ?? undefined }, signal);
  }
  if (label === null) {
    throw new ApiError(notCopied, 404);
  }
  const kept = await keptCell(cellOf(label));
  const { designs } = wholeCell(kept);
  const place = designs.findIndex((design) => design.label === label);
  if (place < 0) {
    throw new ApiError(notCopied, 404);
  }
  const never = new AbortController().signal;
  const forms = await onShelf('citations', () => zipped<string[]>('citations.json', never));
  return filled(forms[kept.cite[place]!]!, designs[place]!);
}

/** A form with what a design says in its open places. */
function filled(form: string, design: Entry): string {
  return form.replace(/<(label|hash|kind|v|k|b)>/g, (_, name: 'label') => String(design[name]));
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

/** One design for a paper: html, latex or markdown. */
export function dossierAddress(of: Cell | { label: string }, format: string): string {
  return address('dossier', { ...('label' in of ? of : parameters(of)), format });
}

/** `20.5.2.linear…` to its cell; null if it begins otherwise. */
export function cellOfLabel(label: string): Cell | null {
  const found = /^(\d+)\.(\d+)\.(\d+)\.(circular|linear)(?:\.t(\d+))?(?=\.|$)/.exec(label);
  if (!found) {
    return null;
  }
  const cell: Cell = {
    v: Number(found[1]),
    k: Number(found[2]),
    change: Number(found[3]),
    kind: found[4] as Kind,
  };
  return found[5] ? { ...cell, strength: Number(found[5]) } : cell;
}
