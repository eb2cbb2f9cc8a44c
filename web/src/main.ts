import { keepToken } from './lib/api';
import { fill, h } from './lib/dom';
import { cellOfLabel } from './lib/source';
import { count, number, rangeWords } from './lib/words';
import { catalog } from './pages/catalog';
import { cell } from './pages/cell';
import { design } from './pages/design';
import { get } from './pages/get';
import { glossary } from './pages/glossary';
import { home } from './pages/home';
import { loadorder } from './pages/loadorder';
import { plan } from './pages/plan';
import { search } from './pages/search';
import { theorems } from './pages/theorems';
import { verify } from './pages/verify';
import { about, isCopy } from './shell/about';
import { withoutLinksBeyond } from './shell/copy';
import { openGlossary } from './shell/glossary';
import { followQuestionMark, openKeys } from './shell/keys';
import { whereThereIsAServer } from './shell/live';
import { link, placeOf, Router, type Page } from './shell/router';
import { startTheme, toggleTheme } from './shell/theme';
import style from './style/main.css';

const pages: readonly Page[] = [
  home,
  plan,
  loadorder,
  catalog,
  cell,
  design,
  search,
  verify,
  theorems,
  get,
  glossary,
].map((page) => (page.live ? whereThereIsAServer(page) : page));

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`the page has no #${id}`);
  }
  return found;
}

/** Pages about one entry of the catalog. */
const inCatalog: readonly Page[] = [cell, design];

function navigation(current: Page): void {
  fill(
    element('top'),
    h(
      'a',
      { class: 'brand', href: link(home.path), 'aria-current': current === home ? 'page' : null },
      'Changeover',
    ),
    h(
      'nav',
      { 'aria-label': 'Pages' },
      h(
        'ul',
        {},
        pages
          .filter((page) => !page.hidden)
          .map((page) =>
            h(
              'li',
              {},
              h(
                'a',
                {
                  href: link(page.path),
                  'aria-current':
                    page === current
                      ? 'page'
                      : page === catalog && inCatalog.includes(current)
                        ? 'true'
                        : null,
                },
                page.title,
                // A copy of files has no program behind it.
                isCopy() &&
                  page.live &&
                  h('small', { class: 'needs-program' }, 'needs the program'),
              ),
            ),
          ),
      ),
    ),
    h('button', { type: 'button', class: 'plain', onclick: () => openGlossary() }, 'Glossary'),
    h(
      'button',
      {
        type: 'button',
        class: 'plain with-keys',
        onclick: () => openKeys(current.path),
        'aria-label': 'Keys of this page',
        'aria-keyshortcuts': '?',
        title: 'Keys of this page',
      },
      '?',
    ),
    h(
      'button',
      {
        type: 'button',
        class: 'plain',
        onclick: toggleTheme,
        'aria-label': 'Switch between light and dark',
      },
      '◐',
    ),
  );
  document.title =
    current === home ? 'Changeover: change covering designs' : `${current.title} · Changeover`;
}

/**
 * `?cell=40.6.2.circular` and `?design=LABEL` are permanent addresses: they lead to the page of
 * that cell or design.
 */
function followAddress(): void {
  const address = new URL(window.location.href);
  const [cellName, label] = [address.searchParams.get('cell'), address.searchParams.get('design')];
  const found = cellName ? cellOfLabel(cellName) : null;
  const to = label ? link(design.path, { label }) : found ? link(cell.path, { ...found }) : null;
  if (to && address.hash === '') {
    address.searchParams.delete('cell');
    address.searchParams.delete('design');
    history.replaceState(history.state, '', `${address.pathname}${address.search}${to}`);
  }
}

async function foot(): Promise<void> {
  const { version, catalog: kept, files, static: frozen, range } = await about();
  fill(
    element('bottom'),
    h(
      'p',
      {},
      `Changeover ${version}. `,
      range
        ? `Designs with ${rangeWords(range)}. `
        : `${count(kept.designs, 'design')} in ${number(kept.cells)} cells. `,
      frozen
        ? [
            'A copy for reading; ',
            h('a', { href: link(get.path) }, 'the program'),
            ' plans and searches, too.',
          ]
        : 'Everything on this page comes from this machine.',
    ),
    files.length > 0 &&
      h(
        'p',
        {},
        'Opened with: ',
        files
          .map((file, i) => [
            i > 0 ? ', ' : '',
            h('a', { href: link(design.path, { file: file.index }) }, file.name),
          ])
          .flat(),
      ),
  );
}

function begin(): void {
  // What is not needed for the first frame; a sheet that a script makes waits for no other file.
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style);
  document.adoptedStyleSheets = [sheet];
  keepToken();
  followAddress();
  if (isCopy()) {
    withoutLinksBeyond(element('main'));
  }
  const router = new Router(pages, element('main'), navigation);
  startTheme();
  followQuestionMark(() => placeOf(window.location.hash).path);
  router.draw();
  foot().catch(() => undefined);
  if (placeOf(window.location.hash).path === '') {
    // One file on the command line: show it.
    about().then(
      ({ files }) => {
        if (files.length === 1 && placeOf(window.location.hash).path === '') {
          window.location.hash = link(design.path, { file: files[0]!.index });
        }
      },
      () => undefined,
    );
  }
}

begin();
