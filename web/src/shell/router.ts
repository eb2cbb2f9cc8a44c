// Every state is a link: the page and its parameters are the fragment of the address.
//
//     #/catalog?change=2&kind=linear
//
// A page draws itself from its parameters and changes them by `view.go`. It is redrawn when the
// address changes in any way that it did not ask for itself.
import { ApiError } from '../lib/api';
import { fill, h } from '../lib/dom';

export interface View {
  /** Where the page draws. */
  readonly root: HTMLElement;
  readonly params: URLSearchParams;
  /** Aborted as soon as the page is left or redrawn. */
  readonly signal: AbortSignal;
  /**
   * Changes the parameters given (null takes one away). The page is redrawn unless `quiet`; a
   * new entry of the history only if `push`.
   */
  go(
    changes: Record<string, string | number | null>,
    how?: { quiet?: boolean; push?: boolean },
  ): void;
}

export interface Page {
  /** The word in the address. */
  readonly path: string;
  /** In the navigation and the window's title. */
  readonly title: string;
  /** Not in the navigation: reached from other pages. */
  readonly hidden?: boolean;
  /** Needs a server: not part of a static export. */
  readonly live?: boolean;
  render(view: View): void | Promise<void>;
}

export interface Place {
  path: string;
  params: URLSearchParams;
}

export function placeOf(fragment: string): Place {
  const text = fragment.replace(/^#\/?/, '');
  const at = text.indexOf('?');
  return {
    path: at < 0 ? text : text.slice(0, at),
    params: new URLSearchParams(at < 0 ? '' : text.slice(at + 1)),
  };
}

export function link(
  path: string,
  params: Record<string, string | number | null | undefined> = {},
): string {
  const pairs = Object.entries(params).filter(
    ([, value]) => value !== null && value !== undefined && value !== '',
  );
  const text = new URLSearchParams(pairs.map(([name, value]) => [name, String(value)])).toString();
  return `#/${path}${text ? `?${text}` : ''}`;
}

export class Router {
  private leaving = new AbortController();
  private drawn = '';

  constructor(
    private readonly pages: readonly Page[],
    private readonly root: HTMLElement,
    private readonly entered: (page: Page) => void,
  ) {
    window.addEventListener('hashchange', () => this.draw());
  }

  /** Draws the page that the address names. The first page is home. */
  draw(): void {
    const fragment = window.location.hash;
    if (fragment === '#main') {
      this.root.focus();
      return;
    }
    if (fragment === this.drawn && fragment !== '') {
      return;
    }
    const moved = placeOf(fragment).path !== placeOf(this.drawn).path;
    this.drawn = fragment;
    this.leaving.abort();
    this.leaving = new AbortController();
    const { path, params } = placeOf(fragment);
    const page =
      this.pages.find((each) => each.path === path) ?? (path === '' ? this.pages[0] : undefined);
    if (!page) {
      this.entered({ path, title: 'No such page', render: () => undefined });
      this.root.removeAttribute('aria-busy');
      fill(
        this.root,
        h('h1', {}, 'No such page'),
        h(
          'p',
          {},
          `There is no page “${path}”. `,
          h('a', { href: link(this.pages[0]!.path) }, 'Go to the start page'),
          '.',
        ),
      );
      return;
    }
    this.entered(page);
    const signal = this.leaving.signal;
    // Each drawing has its own place: what a page that was left still writes is not seen. What
    // was there before stays until the page has something to show.
    const before = [...this.root.childNodes];
    const place = h('div', { class: 'page' });
    this.root.append(place);
    const shown = () => {
      filled.disconnect();
      before.forEach((node) => node.remove());
    };
    const filled = new MutationObserver(shown);
    filled.observe(place, { childList: true });
    const view: View = {
      root: place,
      params,
      signal,
      go: (changes, how = {}) => {
        if (signal.aborted) {
          return;
        }
        for (const [name, value] of Object.entries(changes)) {
          value === null || value === '' ? params.delete(name) : params.set(name, String(value));
        }
        const next = link(page.path, Object.fromEntries(params));
        if (how.push) {
          history.pushState(null, '', next);
        } else {
          history.replaceState(null, '', next);
        }
        if (how.quiet) {
          this.drawn = next;
        } else {
          this.draw();
        }
      },
    };
    this.root.setAttribute('aria-busy', 'true');
    const done = () => {
      if (!signal.aborted) {
        shown();
        this.root.removeAttribute('aria-busy');
      }
    };
    Promise.resolve()
      .then(() => page.render(view))
      .then(done, (fault: unknown) => {
        if (!signal.aborted) {
          place.append(problem(fault));
          done();
        }
      });
    if (moved) {
      window.scrollTo(0, 0);
    }
  }
}

/** What went wrong, as a page shows it. */
export function problem(fault: unknown): HTMLElement {
  const message = fault instanceof Error ? fault.message : String(fault);
  const place =
    fault instanceof ApiError && fault.line
      ? ` (line ${fault.line}${fault.column ? `, column ${fault.column}` : ''})`
      : '';
  // Commands stand between backticks.
  const pieces = message.split('`').map((piece, i) => (i % 2 === 1 ? h('code', {}, piece) : piece));
  return h('p', { class: 'problem', role: 'alert' }, pieces, place);
}
