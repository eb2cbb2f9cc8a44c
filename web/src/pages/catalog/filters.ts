// Which cells are wanted: what the fields say, what the link says of them, and what they leave in a
// sentence.
import type { AtlasCell } from '../../lib/atlas';
import { append, field, fill, h, select } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { statuses } from '../../parts/status';
import type { View } from '../../shell/router';

const names = ['status', 'by', 'gap', 'blocks', 'tight', 'economical', 'group'] as const;

export interface Filters {
  readonly element: HTMLElement;
  /** Tells of a cell whether it is wanted, as the fields are now. */
  passes(): (cell: AtlasCell) => boolean;
  /** Whether groups must be known to tell. */
  needsGroups(): boolean;
  /** What is waited for. */
  wait(words: string): void;
  /** What is left, in a sentence. */
  say(left: number, all: number): void;
  offer(constructions: readonly string[]): void;
  /** As if that status were chosen in its field. */
  only(status: string): void;
}

export function filters(view: View, changed: () => void): Filters {
  const get = (name: string): string => view.params.get(name) ?? '';
  const set = (name: string, value: string | null): void => {
    view.go({ [name]: value }, { quiet: true });
    changed();
  };
  const status = select(get('status'), statuses, (value) => set('status', value));
  const least = h('input', {
    type: 'number',
    min: 0,
    value: get('gap'),
    placeholder: '0',
    onchange: () => set('gap', least.value),
  });
  const blocks = h('input', {
    type: 'number',
    min: 1,
    value: get('blocks'),
    placeholder: 'any',
    onchange: () => set('blocks', blocks.value),
  });
  const by = h('select', { onchange: () => set('by', by.value) });
  const box = (name: string, words: string, title: string): [HTMLInputElement, HTMLElement] => {
    const input = h('input', {
      type: 'checkbox',
      checked: get(name) !== '',
      onchange: () => set(name, input.checked ? '1' : null),
    });
    return [input, h('label', { class: 'check', title }, input, words)];
  };
  const [tight, tightField] = box('tight', 'tight', 'every pair is newly covered exactly once');
  const [economical, economicalField] = box(
    'economical',
    'economical',
    'as many blocks as counting pairs requires',
  );
  const [group, groupField] = box('group', 'group of order > 1', 'the design has a symmetry');
  const said = h('p', { class: 'filter-says', role: 'status' });
  const clear = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      hidden: true,
      onclick: () => {
        status.value = least.value = blocks.value = by.value = '';
        tight.checked = economical.checked = group.checked = false;
        view.go(Object.fromEntries(names.map((name) => [name, null])), { quiet: true });
        changed();
        status.focus();
      },
    },
    'Clear the filters',
  );

  const any = (): boolean => names.some((name) => get(name) !== '');
  const inWords = (): string => {
    const kind = [
      get('tight') && 'tight',
      get('economical') && 'economical',
      {
        minimum: 'minimum',
        'best-known': 'best known, not proved minimum',
        known: 'with a design',
        open: 'without a known design',
        impossible: 'impossible',
      }[get('status')],
    ]
      .filter(Boolean)
      .join(' and ');
    const more = [
      get('group') && 'with a group of order > 1',
      Number(get('gap')) > 0 && `at least ${count(Number(get('gap')), 'block')} over the bound`,
      get('blocks') && `with ${count(Number(get('blocks')), 'block')}`,
      get('by') && `made by ${get('by')}`,
    ]
      .filter(Boolean)
      .join(', ');
    return [kind, more].filter(Boolean).join(', ');
  };
  return {
    element: h(
      'div',
      { class: 'filters' },
      h(
        'div',
        { class: 'row' },
        field('Status', status),
        field('Blocks', blocks),
        field('Gap at least', least),
        field('Construction', by),
        h(
          'fieldset',
          { class: 'checks' },
          h('legend', { class: 'unseen' }, 'Only designs that are'),
          tightField,
          economicalField,
          groupField,
        ),
      ),
      h('div', { class: 'row filter-line' }, said, clear),
    ),
    passes() {
      const [is, made, over] = [get('status'), get('by'), Number(get('gap'))];
      const exactly = get('blocks');
      const [onlyTight, onlyEconomical, onlyGroup] = [
        get('tight'),
        get('economical'),
        get('group'),
      ];
      return (cell) =>
        (is === '' || cell.status === is || (is === 'known' && cell.b !== null)) &&
        (made === '' || cell.construction === made) &&
        (exactly === '' || cell.b === Number(exactly)) &&
        (over <= 0 || (cell.gap ?? -1) >= over) &&
        (onlyTight === '' || cell.tight) &&
        (onlyEconomical === '' || cell.economical) &&
        (onlyGroup === '' || (cell.order !== null && cell.order !== '1'));
    },
    needsGroups: () => get('group') !== '',
    wait: (words) => fill(said, words),
    say(left, all) {
      clear.hidden = !any();
      fill(
        said,
        // Without a filter the sums below say how many there are.
        any() && [
          h('strong', {}, number(left)),
          ` of ${count(all, 'cell')} in sight: ${inWords()}.`,
        ],
      );
    },
    only(wanted) {
      status.value = wanted;
      set('status', wanted);
      status.focus();
    },
    offer(constructions) {
      const now = get('by');
      fill(by);
      append(
        by,
        ['', ...constructions, ...(now && !constructions.includes(now) ? [now] : [])].map((name) =>
          h('option', { value: name, selected: name === now }, name || 'any'),
        ),
      );
    },
  };
}
