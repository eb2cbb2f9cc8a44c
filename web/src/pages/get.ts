// How to get the program: where pages of a static copy that need it lead.
import { fill, h } from '../lib/dom';
import { toCopy } from '../parts/command';
import { about } from '../shell/about';
import { link, type Page } from '../shell/router';

const ways: readonly (readonly [string, string, readonly string[]])[] = [
  [
    'Debian 12, from the sources',
    'In their folder. The first line installs what is missing and builds; the second puts the ' +
      'program beside your others.',
    ['./dev build', 'cmake --install build/release --prefix ~/.local'],
  ],
  [
    'Debian packages',
    'The first line makes them from the sources; the second can be run on any machine.',
    ['./dev package', 'apt install ./changeover_*.deb'],
  ],
  ['Python', 'In the folder of the sources: the module, without the program.', ['pip install .']],
];

const uses: readonly (readonly [string, string])[] = [
  ['These pages, with everything that they can do', 'changeover serve --open'],
  ['Plan tests of the parts in a file', 'changeover plan parts.csv -k 4 --test-cost 10'],
  ['Order the loads of 64 items, room for 16', 'changeover loadorder --items 64 --room 16'],
  ['The best design that is known', 'changeover design 20 5'],
  ['Search for a better one', 'changeover search 20 5 --circular --time 1m'],
  ['Check a list of blocks', 'changeover verify blocks.txt'],
  ['What else there is', 'changeover --help'],
];

export const get: Page = {
  path: 'get',
  title: 'Get the program',
  hidden: true,
  render(view) {
    const where = h('p', {}, '\u00a0');
    fill(
      view.root,
      h('h1', {}, this.title),
      where,
      h('h2', {}, 'Install'),
      ways.map(([title, what, lines]) =>
        h('section', {}, h('h3', {}, title), h('p', { class: 'small' }, what), lines.map(toCopy)),
      ),
      h('h2', {}, 'Ask'),
      h(
        'dl',
        { class: 'asked' },
        uses.flatMap(([what, line]) => [h('dt', {}, what), h('dd', {}, toCopy(line))]),
      ),
      h(
        'p',
        {},
        'With the sources come a first tour (docs/start.md) and a manual of each command.',
      ),
    );
    about().then(
      ({ sources }) =>
        fill(
          where,
          'Changeover is one program without a network: it makes, checks and searches designs, ' +
            'plans tests and orders loads. ',
          sources
            ? ['Get it at ', h('a', { href: sources, rel: 'noreferrer' }, sources), '.']
            : [
                'Ask those who publish these pages for its sources, or see the ',
                h('a', { href: link('catalog') }, 'catalog'),
                ' here.',
              ],
        ),
      () => undefined,
    );
  },
};
