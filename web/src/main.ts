import { keepToken } from './lib/api';
import { fill, h } from './lib/dom';
import { count, number } from './lib/words';
import { catalog } from './pages/catalog';
import { cell } from './pages/cell';
import { design } from './pages/design';
import { loadorder } from './pages/loadorder';
import { plan } from './pages/plan';
import { search } from './pages/search';
import { theorems } from './pages/theorems';
import { verify } from './pages/verify';
import { about } from './shell/about';
import { whereThereIsAServer } from './shell/live';
import { link, placeOf, Router, type Page } from './shell/router';
import { startTheme, toggleTheme } from './shell/theme';

const pages: readonly Page[] = [catalog, cell, design, verify, plan, loadorder, search, theorems].map((page) => (page.live ? whereThereIsAServer(page) : page));

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`the page has no #${id}`);
  }
  return found;
}

function navigation(current: Page): void {
  fill(
    element('top'),
    h('a', { class: 'brand', href: link(catalog.path) }, 'Changeover'),
    h(
      'nav',
      { 'aria-label': 'Pages' },
      h(
        'ul',
        {},
        pages
          .filter((page) => !page.hidden)
          .map((page) => h('li', {}, h('a', { href: link(page.path), 'aria-current': page === current ? 'page' : null }, page.title))),
      ),
    ),
    h('button', { type: 'button', class: 'plain', onclick: toggleTheme, 'aria-label': 'Switch between light and dark' }, '◐'),
  );
  document.title = `${current.title} · Changeover`;
}

async function foot(): Promise<void> {
  const { version, catalog: kept, files, static: frozen } = await about();
  fill(
    element('bottom'),
    h(
      'p',
      {},
      `Changeover ${version}. ${count(kept.designs, 'design')} in ${number(kept.cells)} cells. `,
      frozen ? 'A static copy: `changeover serve` checks, plans and searches too.' : 'This page comes from this machine alone.',
    ),
    files.length > 0 && h('p', {}, 'Opened with: ', files.map((file, i) => [i > 0 ? ', ' : '', h('a', { href: link(design.path, { file: file.index }) }, file.name)]).flat()),
  );
}

keepToken();
const router = new Router(pages, element('main'), navigation);
startTheme();
router.draw();
foot().catch(() => undefined);
if (placeOf(window.location.hash).path === '') {
  // One file on the command line: show it.
  about().then(({ files }) => {
    if (files.length === 1 && placeOf(window.location.hash).path === '') {
      window.location.hash = link(design.path, { file: files[0]!.index });
    }
  }, () => undefined);
}
