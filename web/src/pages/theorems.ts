// The theorems that the program uses beyond the published ones, and all constructions, each with an
// example to look at.
import type { Construction, Theorem } from '../lib/api';
import { cited } from '../lib/citations';
import { fill, h, type Child } from '../lib/dom';
import { line, markup } from '../lib/markup';
import { afterSight, prepare } from '../lib/mathematics';
import { constructions, theorems as ask } from '../lib/source';
import { waiting } from '../lib/wait';
import { citation, reason } from '../parts/recipe';
import { link, problem, type Page, type View } from '../shell/router';
import { linkTerms } from '../parts/knowl';
import { findField, type Shelf } from './theorems/find';
import { Gallery } from './theorems/gallery';
import { groups, kindsOf, type Entry } from './theorems/groups';

/** As a reader looks for them: by their authors, or else their titles. */
const inOrder = [...cited].sort(([, one], [, other]) => one.localeCompare(other, 'en'));

/** Links of docs/theorems.md, and constructions that it names, in these pages. */
function inPages(constructions: ReadonlySet<string>): (to: string) => string | null {
  return (to) => {
    const theorem = /#theorem-(\d+)$/.exec(to);
    const code = /^`(.*)`$/.exec(to)?.[1];
    return theorem
      ? link('theorems', { theorem: theorem[1] })
      : code !== undefined && constructions.has(code)
        ? link('theorems', { construction: code })
        : to === 'plan.md'
          ? link('plan')
          : /^https:/.test(to)
            ? to
            : null;
  };
}

/** A theorem; its statement is written by `write`. */
function theorem(
  it: Theorem,
  gallery: Gallery,
  chosen: boolean,
  links: (to: string) => string | null,
): { element: HTMLElement; write(): void } {
  const prose = h('div', { class: 'prose' });
  // The heading says its number.
  const named = it.statement.replace(
    new RegExp(`\\*\\*Theorem ${it.number}(\\.?)\\*\\*`),
    '**Theorem$1**',
  );
  // Where each condition has its own proof these are folded as proofs are.
  const listed = it.proof === '' ? named.search(/\n1\. (?=\S)/) : -1;
  const [statement, proof] =
    listed > 0 ? [named.slice(0, listed), named.slice(listed + 1)] : [named, it.proof];
  const kinds = kindsOf(it.number);
  const element = h(
    'article',
    { id: `theorem-${it.number}`, class: chosen ? 'statement chosen' : 'statement', tabindex: -1 },
    h(
      'h3',
      {},
      h('a', { href: link('theorems', { theorem: it.number }) }, `Theorem ${it.number}`),
      it.title && it.title !== `Theorem ${it.number}` ? [': ', ...line(it.title)] : '',
    ),
    kinds.length > 0 &&
      h(
        'p',
        { class: 'kinds' },
        kinds.map((kind) => h('span', { class: 'kind-tag' }, kind)),
      ),
    h('div', { class: 'with-example' }, prose, it.example && gallery.add(it.example)),
  );
  return {
    element,
    write: () => {
      fill(
        prose,
        markup(statement, links),
        proof &&
          h(
            'details',
            { class: 'proof' },
            h('summary', {}, listed > 0 ? 'The conditions and their proofs' : 'Proof'),
            lazily(() => markup(proof, links)),
          ),
      );
      linkTerms(prose);
    },
  };
}

/**
 * Calls the first few at once and the others in pieces of some milliseconds, so that a long page is
 * there at once; `rest` calls those that are left.
 */
function piecewise(tasks: (() => void)[], first: number, signal: AbortSignal): { rest(): void } {
  const left = [...tasks];
  const rest = (): void => left.splice(0).forEach((task) => task());
  left.splice(0, first).forEach((task) => task());
  const more = (): void => {
    const deadline = performance.now() + 12;
    while (!signal.aborted && left.length > 0 && performance.now() < deadline) {
      left.shift()!();
    }
    !signal.aborted && left.length > 0 && setTimeout(more, 0);
  };
  afterSight(more);
  return { rest };
}

/** Tells the browser how high an article is that it lays out when that comes near. */
function measured(article: HTMLElement): () => void {
  return () => {
    article.style.contentVisibility = 'visible';
    const { height } = article.getBoundingClientRect();
    article.style.contentVisibility = '';
    if (height > 0) {
      article.style.containIntrinsicSize = `auto ${height}px`;
    }
  };
}

/**
 * Scrolls to a part and keeps it there while what is above gets its height: statements are laid out
 * as they come near, and then the part moves. At once, for on a way through them the end would
 * move, too. Ends when the reader does anything.
 */
function land(part: HTMLElement, signal: AbortSignal): void {
  const mine = new AbortController();
  const align = (): void => part.scrollIntoView({ block: 'start', behavior: 'instant' });
  const heights = new ResizeObserver(align);
  mine.signal.addEventListener('abort', () => heights.disconnect());
  signal.addEventListener('abort', () => mine.abort(), { signal: mine.signal });
  for (const act of ['wheel', 'touchstart', 'pointerdown', 'keydown']) {
    window.addEventListener(act, () => mine.abort(), { passive: true, signal: mine.signal });
  }
  align();
  heights.observe(part.closest('.page')!);
}

/**
 * Marks in the contents which part is read, says it in `here`, and keeps that entry in sight. What
 * it returns does so once more, when the page has other parts.
 */
function followReading(
  root: HTMLElement,
  contents: HTMLElement,
  here: HTMLElement,
  signal: AbortSignal,
): () => void {
  const entries = new Map(
    [...contents.querySelectorAll<HTMLElement>('a[data-part]')].map((entry) => [
      entry.dataset['part']!,
      entry,
    ]),
  );
  const parts = [...entries.keys()].flatMap(
    (id) => root.querySelector<HTMLElement>(`#${id}`) ?? [],
  );
  const list = contents.querySelector('ul')!;
  let marked: HTMLElement | undefined;
  let asked = false;
  const mark = (): void => {
    asked = false;
    const line = 80; // A part that was jumped to begins just below the edge of the window.
    // What a search hides is at the top, too.
    const seen = parts.filter((part) => !part.hidden);
    const read = seen.filter((part) => part.getBoundingClientRect().top < line).at(-1) ?? seen[0];
    const now = entries.get(read?.id ?? '');
    if (now === marked || !now) {
      return;
    }
    marked?.removeAttribute('aria-current');
    now.setAttribute('aria-current', 'location');
    marked = now;
    here.textContent = now.textContent;
    const [inside, around] = [now.getBoundingClientRect(), contents.getBoundingClientRect()];
    if (
      list.offsetHeight > contents.clientHeight &&
      (inside.top < around.top || inside.bottom > around.bottom)
    ) {
      contents.scrollTop += inside.top - around.top - contents.clientHeight / 2;
    }
  };
  const soon = (): void => void (asked || ((asked = true), requestAnimationFrame(mark)));
  window.addEventListener('scroll', soon, { passive: true, signal });
  soon();
  return soon;
}

/** The theorems as the contents list them; those that are in no group come last. */
function grouped(proved: readonly Theorem[]): (readonly [string, readonly Entry[]])[] {
  const numbers = new Set(proved.map(({ number }) => number));
  const placed = new Set(groups.flatMap(([, entries]) => entries.map(([number]) => number)));
  const rest = proved.filter(({ number }) => !placed.has(number));
  return [
    ...groups.map(
      ([heading, entries]) => [heading, entries.filter(([number]) => numbers.has(number))] as const,
    ),
    ['Others', rest.map(({ number, title }): Entry => [number, title])] as const,
  ].filter(([, entries]) => entries.length > 0);
}

/** What is inside of a fold, made when it is opened. */
function lazily(make: () => Child[]): HTMLElement {
  const place = h('div');
  const watcher = new IntersectionObserver(
    (seen) => {
      if (seen.some((each) => each.isIntersecting)) {
        watcher.disconnect();
        fill(place, make());
      }
    },
    { rootMargin: '400px' }, // What is opened at the lower edge begins below it.
  );
  watcher.observe(place);
  place.append('\u00a0');
  return place;
}

/** A work, with what the program cites it by. */
function reference(
  key: string,
  text: string,
  url: string | null,
  wanted: string | null,
): HTMLElement {
  return h(
    'li',
    {
      id: `reference-${key}`,
      class: key === wanted ? 'statement chosen' : null,
      tabindex: -1,
    },
    `${text.replace(/\.$/, '')}.`,
    url && [' ', h('a', { href: url, rel: 'noreferrer' }, url.replace('https://', ''))],
    [' ', h('span', { class: 'code small' }, `[${key}]`)],
  );
}

function construction(it: Construction, gallery: Gallery, chosen: boolean): HTMLDetailsElement {
  return h(
    'details',
    {
      id: `construction-${it.name}`,
      class: chosen ? 'statement construction chosen' : 'statement construction',
      open: chosen,
    },
    h(
      'summary',
      {},
      h('strong', {}, it.name),
      ' ',
      h('span', { class: 'summary-words' }, reason(it.summary)),
    ),
    h(
      'div',
      { class: 'with-example' },
      h(
        'div',
        { class: 'prose' },
        h(
          'dl',
          { class: 'facts' },
          it.serves ? [h('dt', {}, 'serves'), h('dd', {}, reason(it.serves))] : [],
          it.gives ? [h('dt', {}, 'gives'), h('dd', {}, reason(it.gives))] : [],
          it.citation && it.citation !== '[elementary]'
            ? [h('dt', {}, 'from'), h('dd', {}, citation(it.citation))]
            : [],
        ),
        h(
          'p',
          {},
          h('a', { href: link('catalog', { by: it.name }) }, 'Cells of the catalog that it makes'),
          ' · ',
          h(
            'a',
            { href: link('theorems', { construction: it.name }) },
            'Link to this construction',
          ),
        ),
      ),
      it.example && gallery.add(it.example),
    ),
  );
}

export const theorems: Page = {
  path: 'theorems',
  title: 'Theorems',
  async render(view: View) {
    const wanted = {
      theorem: view.params.get('theorem'),
      construction: view.params.get('construction'),
      reference: view.params.get('reference'),
    };
    prepare().catch(() => undefined); // While the program is asked.
    let answers: [Theorem[], Construction[]];
    try {
      answers = await waiting(
        Promise.all([ask(view.signal), constructions(view.signal)]),
        view.signal,
        () =>
          fill(
            view.root,
            h('h1', {}, 'Theorems and constructions'),
            h('p', { class: 'hint' }, 'Asking…'),
          ),
      );
    } catch (fault) {
      fill(view.root, h('h1', {}, 'Theorems and constructions'), problem(fault));
      return;
    }
    const [told, built] = answers;
    // The page has the order of its contents.
    const inGroups = grouped(told);
    const proved = inGroups.flatMap(([, entries]) =>
      entries.map(([number]) => told.find((each) => each.number === number)!),
    );
    const gallery = new Gallery(view.signal);
    const articles = built.map((each) =>
      construction(each, gallery, each.name === wanted.construction),
    );
    let markRead = (): void => undefined;
    const links = inPages(new Set(built.map(({ name }) => name)));
    const stated = proved.map((each) =>
      theorem(each, gallery, each.number === wanted.theorem, links),
    );
    const anchored = Boolean(wanted.theorem ?? wanted.construction ?? wanted.reference);
    const statements = piecewise(
      [...stated.map(({ write }) => write), ...stated.map(({ element }) => measured(element))],
      anchored ? stated.length : 3,
      view.signal,
    );
    const missing =
      (wanted.theorem &&
        !proved.some((each) => each.number === wanted.theorem) &&
        `There is no Theorem ${wanted.theorem} here.`) ||
      (wanted.construction &&
        !built.some((each) => each.name === wanted.construction) &&
        `There is no construction “${wanted.construction}” here.`);

    const jump = (words: Child[], id: string, to: string): HTMLElement =>
      h(
        'li',
        {},
        h(
          'a',
          {
            href: to,
            'data-part': id,
            onclick: (event) => {
              // The page is there already: no need to draw it again.
              event.preventDefault();
              view.go(
                {
                  theorem: null,
                  construction: null,
                  reference: null,
                  ...Object.fromEntries(new URLSearchParams(to.split('?')[1] ?? '')),
                },
                { quiet: true },
              );
              go(document.getElementById(id) ?? undefined);
            },
          },
          words,
        ),
      );
    const entriesOf = new Map<string, HTMLElement>();
    const heads = new Map<HTMLElement, readonly string[]>();
    const headOf = (heading: string, entries: readonly Entry[]) => {
      const head = h('li', { class: 'contents-group' }, heading);
      heads.set(
        head,
        entries.map(([number]) => number),
      );
      return head;
    };
    const pageHead = (heading: string, entries: readonly Entry[]): HTMLElement => {
      const head = h('h3', { class: 'theorem-group' }, heading);
      heads.set(
        head,
        entries.map(([number]) => number),
      );
      return head;
    };
    const more = new Map(
      ['Constructions', 'References'].map((words) => [
        words.toLowerCase(),
        jump([h('strong', {}, words)], words.toLowerCase(), link('theorems')),
      ]),
    );
    const here = h('span', { class: 'contents-here', 'aria-hidden': 'true' });
    const beside = window.matchMedia('(min-width: 56.01rem)');
    const contents = h(
      'nav',
      { class: 'contents', 'aria-label': 'Contents' },
      h(
        'details',
        { open: beside.matches },
        h('summary', {}, h('span', {}, 'Contents'), here),
        h(
          'ul',
          {},
          inGroups.flatMap(([heading, entries]) => [
            headOf(heading, entries),
            ...entries.map(([number, title]) => {
              const entry = jump(
                [h('strong', {}, number), ' ', ...line(title)],
                `theorem-${number}`,
                link('theorems', { theorem: number }),
              );
              entriesOf.set(number, entry);
              return entry;
            }),
          ]),
          h('li', { class: 'contents-group' }, 'More'),
          [...more.values()],
        ),
      ),
    );
    const theoremsHead = h('h2', {}, 'Theorems');
    const keys = h(
      'p',
      { class: 'hint' },
      'In brackets behind a work: its key, by which the program and its files cite it.',
    );
    const folds = h(
      'button',
      {
        type: 'button',
        class: 'plain small',
        onclick: () => {
          const open = articles.some((each) => !each.hidden && !each.open);
          articles.filter((each) => !each.hidden).forEach((each) => (each.open = open));
          folds.textContent = open ? 'Collapse all' : 'Expand all';
        },
      },
      'Expand all',
    );
    const go = (part: HTMLElement | undefined): void => {
      contents.querySelector('details')!.open = beside.matches;
      statements.rest(); // What is above has its height then.
      if (part) {
        land(part, view.signal);
        part.focus({ preventScroll: true });
      }
    };
    const heading = {
      constructions: h('h2', { id: 'constructions', tabindex: -1 }, 'Constructions'),
      references: h('h2', { id: 'references', tabindex: -1 }, 'References'),
    };
    const cites = inOrder.map(([key, text, url]) => reference(key, text, url, wanted.reference));
    const shelves: Shelf[] = [
      {
        noun: 'theorem',
        texts: proved.map((each) =>
          [each.number, each.title, each.statement, ...kindsOf(each.number)].join(' '),
        ),
        show(i, shows) {
          stated[i]!.element.hidden = !shows;
          entriesOf.get(proved[i]!.number)!.hidden = !shows;
        },
        left(some) {
          theoremsHead.hidden = some === 0;
          heads.forEach((numbers, head) => {
            head.hidden = numbers.every((number) => entriesOf.get(number)!.hidden);
          });
        },
        go: () => go(stated.find(({ element }) => !element.hidden)?.element),
      },
      {
        noun: 'construction',
        texts: built.map(({ name, summary, serves, citation: from }) =>
          [name, summary, serves, from].join(' '),
        ),
        show: (i, shows) => (articles[i]!.hidden = !shows),
        left: (some) => {
          heading.constructions.hidden = folds.hidden = some === 0;
          more.get('constructions')!.hidden = some === 0;
        },
        go: () => go(heading.constructions),
      },
      {
        noun: 'reference',
        texts: inOrder.map(([key, text]) => `${key} ${text}`),
        show: (i, shows) => (cites[i]!.hidden = !shows),
        left: (some) => {
          heading.references.hidden = keys.hidden = some === 0;
          more.get('references')!.hidden = some === 0;
        },
        go: () => go(heading.references),
      },
    ];
    const find = findField(view.params.get('find') ?? '', shelves, (words) => {
      statements.rest();
      markRead();
      view.go({ find: words || null }, { quiet: true });
    });
    const reading = h('div', { class: 'told', tabindex: -1 });
    const skip = h(
      'a',
      {
        class: 'skip',
        href: link('theorems'),
        onclick: (event) => {
          event.preventDefault();
          reading.focus({ preventScroll: true });
        },
      },
      'Skip the contents',
    );
    fill(
      view.root,
      h('h1', {}, 'Theorems and constructions'),
      missing && h('p', { class: 'note', role: 'alert' }, missing),
      h(
        'div',
        { class: 'with-contents' },
        h('div', { class: 'contents-side' }, find.element, skip, contents),
        reading,
      ),
    );
    fill(
      reading,
      h(
        'p',
        {},
        'These theorems go beyond the published ones; each has its proof. Below them stand ' +
          'all constructions of the program. SCCD(v, k) and DCCD(v, k) are the ' +
          'single-change and double-change covering designs on v elements in blocks of k; a ' +
          'third number is that of blocks, as in DCCD(v, k, b).',
      ),
      theoremsHead,
      inGroups.flatMap(([title, entries]) => [
        pageHead(title, entries),
        ...entries.map(
          ([number]) => stated[proved.findIndex((each) => each.number === number)]!.element,
        ),
      ]),
      heading.constructions,
      h('div', { class: 'row' }, folds),
      h('div', { class: 'constructions' }, articles),
      heading.references,
      keys,
      h('ul', { class: 'references' }, cites),
    );
    heads.forEach((numbers, head) => {
      head.hidden = numbers.every((number) => entriesOf.get(number)!.hidden);
    });
    markRead = followReading(view.root, contents, here, view.signal);
    const chosen = view.root.querySelector<HTMLElement>('.chosen');
    if (chosen) {
      land(chosen, view.signal);
      chosen.focus({ preventScroll: true });
    }
  },
};
