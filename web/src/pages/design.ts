// One design: its pictures, its blocks, and a player that steps through them.
import type { Design } from '../lib/api';
import { fill, h, scroll } from '../lib/dom';
import { designOf, explain, isCell, type Asked, type PictureName } from '../lib/source';
import { waiting } from '../lib/wait';
import { count, nameOf } from '../lib/words';
import { copyButton } from '../parts/copy';
import { asText, downloads } from '../parts/downloads';
import { askedOf } from '../parts/fields';
import { recipeTree } from '../parts/recipe';
import { tabs, type Tab } from '../parts/tabs';
import { about, isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { facts } from './design/facts';
import { drawn } from './design/pictures';
import { openPlayer } from './design/player';

/** More blocks than this are not put into the page as text. */
const mostText = 20_000;

function recipeTab(asked: Asked, design: Design, view: View, panel: HTMLElement, signal: AbortSignal): void {
  const place = h('div');
  const image = h('div');
  fill(panel, place, image);
  waiting(explain(asked, signal), signal, () => fill(place, h('p', { class: 'hint' }, 'Asking how it is made…'))).then(
    (found) => {
      if (!found) {
        fill(place, h('p', {}, design.recipe ? `Made by ${design.recipe.construction}, as its file says.` : 'The blocks are all that is known of this design: nothing says how it was made.'));
        return;
      }
      fill(place, recipeTree(found.tree));
      if (found.tree.inputs.length > 0) {
        drawn('recipe', asked, design, view, image, signal);
      }
    },
    (fault: unknown) => !signal.aborted && fill(place, problem(fault)),
  );
}

function textTab(design: Design, panel: HTMLElement): void {
  const short = design.blocks.length > mostText;
  const shown = short ? { ...design, blocks: design.blocks.slice(0, mostText) } : design;
  fill(
    panel,
    h('p', {}, copyButton('Copy the blocks', () => asText(design)), ' ', h('span', { class: 'hint' }, 'One block a line, in order, as every verb of the program reads it.')),
    h('pre', { class: 'blocks', tabindex: 0, role: 'region', 'aria-label': 'Blocks as text' }, asText(shown)),
    short && h('p', { class: 'hint' }, `The first ${mostText} of ${design.blocks.length} blocks; download the design for all.`),
  );
}

function verified(asked: Asked, design: Design, frozen: boolean): string {
  if (!design.verdict) {
    return 'Not verified: open it on the page Verify.';
  }
  if (!design.verdict.valid) {
    return 'Refuted: not every pair is covered, or a step is wrong.';
  }
  const who = 'a checker that shares no code with what made the design';
  return frozen ? `Verified by ${who} when this copy was written: every step and every pair.` : 'local' in asked ? `Verified on the page Verify by ${who}.` : `Verified by ${who} before it was sent: every step and every pair.`;
}

export const design: Page = {
  path: 'design',
  title: 'Design',
  hidden: true,
  async render(view: View) {
    const asked = askedOf(view.params);
    if (!asked) {
      fill(view.root, h('h1', {}, 'Which design?'), h('p', {}, 'Choose a cell in the ', h('a', { href: link('catalog') }, 'catalog'), ', paste a design on the page ', h('a', { href: link('verify') }, 'Verify'), ', or write a label into the address, as #/design?label=20.5.2.circular.29.17482f88.'));
      return;
    }
    const frozen = isCopy();
    let shown: Design;
    try {
      shown = await waiting(designOf(asked, view.signal), view.signal, () => fill(view.root, h('h1', {}, 'Design'), h('p', { class: 'hint' }, 'Asking for the design…')));
    } catch (fault) {
      if (view.signal.aborted) {
        return;
      }
      fill(
        view.root,
        h('h1', {}, 'No design to show'),
        problem(fault),
        isCell(asked) && h('p', {}, h('a', { href: link('cell', { ...asked }) }, `What is known of v = ${asked.v}, k = ${asked.k}`)),
        h('p', {}, h('a', { href: link('catalog') }, 'The catalog')),
      );
      return;
    }
    const b = shown.blocks.length;
    const name = nameOf(shown);
    document.title = `(${shown.v},${shown.k},${b}) ${shown.kind} m = ${shown.change} · Changeover`;

    const picture = (which: PictureName, title: string): Tab => ({ name: which, title, draw: (panel, signal) => drawn(which, asked, shown, view, panel, signal) });
    const all: Tab[] = [
      {
        name: 'steps',
        title: 'Steps',
        draw: (panel, signal) =>
          void openPlayer(panel, shown, {
            at: Number(view.params.get('at')) || 1,
            speed: view.params.get('speed') ?? '3',
            signal,
            moved: (at, speed) => view.go({ at: at === 1 ? null : at, speed: speed === '3' ? null : speed }, { quiet: true }),
          }).catch((fault: unknown) => fill(panel, problem(fault))),
      },
      picture('array', 'Array'),
      picture('stays', 'Stays'),
      picture('coverage', 'Coverage'),
      picture('circle', 'Circle'),
      { name: 'recipe', title: 'Recipe', draw: (panel, signal) => recipeTab(asked, shown, view, panel, signal) },
      { name: 'blocks', title: 'Blocks', draw: (panel) => textTab(shown, panel) },
    ];
    const from =
      shown.label ?? ('local' in asked ? 'of this window, in no catalog' : 'file' in asked ? `file ${(await about()).files.find((each) => each.index === asked.file)?.name ?? asked.file}` : 'job' in asked ? `found by search ${asked.job}` : '');
    const start = view.params.get('show') ?? (view.params.has('at') || frozen ? 'steps' : 'array');
    fill(
      view.root,
      h('h1', {}, `${name[0]!.toUpperCase()}${name.slice(1)}${(shown.strength ?? 2) > 2 ? `, strength ${shown.strength}` : ''}: ${count(b, 'block')}`),
      h(
        'p',
        { class: 'under' },
        from && [shown.label === from ? h('span', { class: 'code' }, from) : from, ' · '],
        h('a', { href: link('cell', { v: shown.v, k: shown.k, change: shown.change, kind: shown.kind, strength: shown.strength === 2 ? null : shown.strength }) }, 'what is known of these parameters'),
      ),
      tabs('What to show of the design', all, start, view.signal, (which) => view.go({ show: which }, { quiet: true })),
      h('h2', {}, 'In numbers'),
      h('p', { class: `verdict ${shown.verdict ? (shown.verdict.valid ? 'valid' : 'invalid') : ''}` }, verified(asked, shown, frozen)),
      scroll('The design in numbers', facts(shown)),
      h('h2', {}, 'Download'),
      downloads(asked, shown, frozen),
    );
  },
};
