// A design as a file, in every format that the program writes.
import type { Design } from '../lib/api';
import { h } from '../lib/dom';
import { addressOf } from '../lib/save';
import { downloadAddress, type Asked } from '../lib/source';

const formats: readonly (readonly [string, string, string])[] = [
  ['text', 'Text', 'one block per line'],
  ['json', 'JSON', 'with recipe and verdict'],
  ['csv', 'CSV', 'for a spreadsheet'],
  ['latex', 'LaTeX', 'the array as the field prints it'],
  ['gap', 'GAP', 'package DESIGN'],
  ['sage', 'Sage', 'IncidenceStructure'],
  ['designtheory', 'designtheory.org', 'XML'],
  ['ljcr', 'La Jolla', 'covering repository'],
  ['svg', 'SVG', 'a picture'],
  ['tikz', 'TikZ', 'a picture for LaTeX'],
];

/** What a file of a design is called: its label, or its parameters, and an ending. */
export function fileName(design: Design, ending: string): string {
  const { label, v, k, change, kind, blocks } = design;
  return `${label ?? `${v}.${k}.${change}.${kind}.${blocks.length}`}.${ending}`;
}

/** What an element is called: blocks have their places among the labels, if there are labels. */
function nameOf(design: Design): (element: number) => string {
  return (element) => design.labels?.[element] ?? String(element);
}

export function asText(design: Design): string {
  const called = nameOf(design);
  const labels = design.labels ? `# labels: ${design.labels.join(' ')}\n` : '';
  return (
    `# changeover design v=${design.v} k=${design.k} change=${design.change} ` +
    `kind=${design.kind}\n${labels}` +
    `${design.blocks.map((block) => `${block.map(called).join(' ')}\n`).join('')}`
  );
}

export function asCsv(design: Design): string {
  const called = nameOf(design);
  const cell = (element: number): string =>
    /[",\n]/.test(called(element)) ? `"${called(element).replace(/"/g, '""')}"` : called(element);
  const head = [
    'block',
    ...Array.from({ length: design.k }, (_, i) => `element_${i + 1}`),
    'v',
    'change',
    'kind',
  ];
  const lines = design.blocks.map((block, i) =>
    [i + 1, ...block.map(cell), design.v, design.change, design.kind].join(','),
  );
  return `${[head.join(','), ...lines].join('\n')}\n`;
}

/** A file made by the page itself. */
function made(words: string, file: string, type: string, text: () => string): HTMLElement {
  const anchor = h(
    'a',
    {
      href: '#',
      class: 'button plain',
      download: file,
      onclick: () => {
        anchor.href = addressOf(text(), type);
      },
    },
    words,
  );
  return anchor;
}

/**
 * Of the server where it knows the design; of the page where there is none, or where the design is
 * this window's alone.
 */
export function downloads(asked: Asked, design: Design | null, frozen: boolean): HTMLElement {
  const links =
    frozen || 'local' in asked
      ? design
        ? [
            made('Text', fileName(design, 'txt'), 'text/plain', () => asText(design)),
            made('JSON', fileName(design, 'json'), 'application/json', () =>
              JSON.stringify(design),
            ),
            made('CSV', fileName(design, 'csv'), 'text/csv', () => asCsv(design)),
          ]
        : []
      : formats.map(([format, words, hint]) =>
          h(
            'a',
            {
              class: 'button plain',
              href: downloadAddress(asked, format),
              download: true,
              title: hint,
            },
            words,
          ),
        );
  return h(
    'ul',
    { class: 'downloads', 'aria-label': 'Download the design' },
    links.map((each) => h('li', {}, each)),
  );
}
