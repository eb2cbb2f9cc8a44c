// The theorems that the program uses beyond the published ones, and all constructions, each with an example to look at.
import type { Cell, Construction, Theorem } from '../lib/api';
import { fill, h, picture, type Child } from '../lib/dom';
import { line, markup } from '../lib/markup';
import { constructions, draw, theorems as ask } from '../lib/source';
import { waiting } from '../lib/wait';
import { count } from '../lib/words';
import { citation, reason, shortName } from '../parts/recipe';
import { link, problem, type Page, type View } from '../shell/router';
import { theme } from '../shell/theme';

/** A link of docs/theorems.md, in these pages. */
function inPages(to: string): string | null {
  const theorem = /#theorem-(\d+)$/.exec(to);
  return theorem ? link('theorems', { theorem: theorem[1] }) : /^https:/.test(to) ? to : null;
}

/** Pictures of examples are asked for when they come into sight, one after the other. */
class Gallery {
  private readonly watcher: IntersectionObserver;
  private readonly cells = new Map<Element, Cell>();
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly signal: AbortSignal) {
    this.watcher = new IntersectionObserver((seen) => {
      for (const { target, isIntersecting } of seen) {
        if (isIntersecting) {
          this.watcher.unobserve(target);
          this.queue = this.queue.then(() => this.show(target));
        }
      }
    }, { rootMargin: '300px' });
    signal.addEventListener('abort', () => this.watcher.disconnect());
    document.addEventListener('themechange', () => this.cells.forEach((_, place) => this.watcher.observe(place)), { signal });
  }

  add(cell: Cell): HTMLElement {
    const place = h('span', { class: 'small-picture' });
    this.cells.set(place, cell);
    this.watcher.observe(place);
    return h('a', { class: 'example', href: link('design', { ...cell }) }, place, h('span', {}, `Example: ${shortName(cell)}`, (cell.strength ?? 2) > 2 && `, strength ${cell.strength}`));
  }

  private async show(place: Element): Promise<void> {
    try {
      const svg = await draw(this.cells.get(place)!, { picture: 'circle', theme: theme() }, this.signal);
      if (svg !== null) {
        const image = picture(svg);
        image.setAttribute('aria-hidden', 'true');
        image.setAttribute('focusable', 'false');
        cropToPoints(image);
        fill(place, image);
      }
    } catch {
      // The link is there all the same.
    }
  }
}

/** A small picture has no room for headlines and legends: only the circle of points is left. */
function cropToPoints(image: SVGSVGElement): void {
  const points = [...image.querySelectorAll('circle')].map((point) => ['cx', 'cy', 'r'].map((name) => Number(point.getAttribute(name))));
  if (points.length > 2) {
    const low = (of: number): number => Math.min(...points.map((point) => point[of]! - point[2]!)) - 4;
    const high = (of: number): number => Math.max(...points.map((point) => point[of]! + point[2]!)) + 4;
    image.setAttribute('viewBox', `${low(0)} ${low(1)} ${high(0) - low(0)} ${high(1) - low(1)}`);
  }
}

/** So many paragraphs of a statement are shown at once; some go on into the construction. */
const mostShown = 7;

function statement(text: string): Child[] {
  const parts = markup(text, inPages);
  return parts.length <= mostShown + 1 ? parts : [...parts.slice(0, mostShown), h('details', {}, h('summary', {}, 'More'), parts.slice(mostShown))];
}

function theorem(it: Theorem, gallery: Gallery, chosen: boolean): HTMLElement {
  return h(
    'article',
    { id: `theorem-${it.number}`, class: chosen ? 'statement chosen' : 'statement', tabindex: -1 },
    h('h3', {}, h('a', { href: link('theorems', { theorem: it.number }) }, `Theorem ${it.number}`), it.title && it.title !== `Theorem ${it.number}` ? [': ', ...line(it.title)] : ''),
    h('div', { class: 'with-example' }, h('div', { class: 'prose' }, statement(it.statement)), it.example && gallery.add(it.example)),
  );
}

function construction(it: Construction, gallery: Gallery, chosen: boolean): HTMLElement {
  return h(
    'article',
    { id: `construction-${it.name}`, class: chosen ? 'statement chosen' : 'statement', tabindex: -1 },
    h('h3', {}, h('a', { href: link('theorems', { construction: it.name }) }, it.name)),
    h(
      'div',
      { class: 'with-example' },
      h(
        'div',
        { class: 'prose' },
        h('p', {}, reason(it.summary), '.'),
        it.serves && h('p', { class: 'hint' }, 'Serves: ', reason(it.serves), '.'),
        it.gives && h('p', { class: 'hint' }, 'Gives: ', reason(it.gives), '.'),
        it.citation && it.citation !== '[elementary]' && h('p', { class: 'hint' }, citation(it.citation)),
      ),
      it.example && gallery.add(it.example),
    ),
  );
}

export const theorems: Page = {
  path: 'theorems',
  title: 'Theorems',
  async render(view: View) {
    const wanted = { theorem: view.params.get('theorem'), construction: view.params.get('construction') };
    let answers: [Theorem[], Construction[]];
    try {
      answers = await waiting(Promise.all([ask(view.signal), constructions(view.signal)]), view.signal, () => fill(view.root, h('h1', {}, 'Theorems and constructions'), h('p', { class: 'hint' }, 'Asking…')));
    } catch (fault) {
      fill(view.root, h('h1', {}, 'Theorems and constructions'), problem(fault));
      return;
    }
    const [proved, built] = answers;
    const gallery = new Gallery(view.signal);
    const articles = built.map((each) => construction(each, gallery, each.name === wanted.construction));
    const found = h('p', { class: 'hint', role: 'status' });
    const filter = h('input', { type: 'search', id: 'filter', value: view.params.get('find') ?? '', placeholder: 'cyclic, expansion, m = 1', oninput: () => sift(true) });

    function sift(tell: boolean): void {
      const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
      let left = 0;
      built.forEach((each, i) => {
        const text = `${each.name} ${each.summary} ${each.serves} ${each.citation}`.toLowerCase();
        const shows = words.every((word) => text.includes(word));
        articles[i]!.hidden = !shows;
        left += shows ? 1 : 0;
      });
      fill(found, words.length === 0 ? count(built.length, 'construction') : left === 0 ? 'No construction says that. Try fewer words.' : `${left} of ${count(built.length, 'construction')}`);
      if (tell) {
        view.go({ find: filter.value.trim() || null }, { quiet: true });
      }
    }
    sift(false);
    const missing =
      (wanted.theorem && !proved.some((each) => each.number === wanted.theorem) && `There is no Theorem ${wanted.theorem} here.`) ||
      (wanted.construction && !built.some((each) => each.name === wanted.construction) && `There is no construction “${wanted.construction}” here.`);

    fill(
      view.root,
      h('h1', {}, 'Theorems and constructions'),
      missing && h('p', { class: 'note', role: 'alert' }, missing),
      h('p', {}, 'What the program uses beyond the published theorems, and everything that it can build. Proofs are in docs/theorems.md, which comes with the program. SCCD(v, k) and DCCD(v, k) are single- and double-change covering designs on v elements in blocks of k.'),
      h('nav', { class: 'jump', 'aria-label': 'On this page' }, h('ul', {}, proved.map((each) => h('li', {}, h('a', { href: link('theorems', { theorem: each.number }) }, each.number.match(/^\d+$/) ? `Theorem ${each.number}` : each.number))), h('li', {}, h('a', { href: '#constructions', onclick: (event) => {
        event.preventDefault();
        filter.focus();
      } }, 'Constructions')))),
      h('h2', {}, 'Theorems'),
      proved.map((each) => theorem(each, gallery, each.number === wanted.theorem)),
      h('h2', { id: 'constructions' }, 'Constructions'),
      h('div', { class: 'row' }, h('div', { class: 'field' }, h('label', { for: filter.id }, 'Find a construction'), filter), found),
      h('div', { class: 'constructions' }, articles),
    );
    const chosen = view.root.querySelector<HTMLElement>('.chosen');
    if (chosen) {
      chosen.scrollIntoView({ block: 'start', behavior: 'instant' });
      chosen.focus({ preventScroll: true });
    }
  },
};
