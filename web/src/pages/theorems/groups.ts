// What the theorems are about, for readers who look for one: groups, short titles and kinds.

type Kind = 'minimum' | 'tight' | 'construction' | 'bound';

/** A theorem in the contents. */
export type Entry = readonly [number: string, title: string, ...kinds: Kind[]];

export const groups: readonly (readonly [heading: string, entries: readonly Entry[]])[] = [
  [
    'Double change',
    [
      ['1', 'Tight circular DCCD(c(4k−6)+1, k)', 'construction', 'tight', 'minimum'],
      ['2', 'Minimum DCCD, k+2 ≤ v ≤ 2k−2', 'minimum'],
      ['3', 'The recursion for every parity', 'construction'],
      ['16', 'Circular DCCD of constant waste', 'construction'],
      ['31', 'Tight circular DCCD over two orbits', 'construction', 'tight', 'minimum'],
      ['32', 'Tight circular DCCD over 2k−3 orbits', 'construction', 'tight', 'minimum'],
      ['33', 'DCCD within a constant of the least', 'construction', 'minimum'],
    ],
  ],
  [
    'Single change',
    [
      ['6', 'Minimum linear SCCD, v ≤ 4k−5', 'minimum'],
      ['8', 'Minimum circular SCCD, 2k+1 ≤ v ≤ 3k−3', 'minimum'],
      ['10', 'Circular SCCD between tight ones', 'construction'],
      ['11', 'SCCD for v near 4k and 6k', 'construction'],
      ['12', 'Even visits', 'construction'],
      ['13', 'Linear SCCD one after the other', 'construction'],
      ['14', 'Minimum SCCD(v, 5)', 'minimum'],
      ['22', 'Circular SCCD, 3k−2 ≤ v ≤ (10k−5)/3', 'construction'],
      ['30', 'Tight circular SCCD, several orbits', 'construction', 'tight', 'minimum'],
    ],
  ],
  [
    'Three changes and more',
    [
      ['4', 'Tight circular 3-change designs', 'construction', 'tight', 'minimum'],
      ['19', 'Minimum 3-change designs of triples', 'minimum'],
      ['34', '3-change designs near the bound', 'construction', 'minimum'],
    ],
  ],
  [
    'Every change number',
    [
      ['7', 'The minimum for small v', 'minimum'],
      ['38', 'All k-subsets in revolving-door order', 'construction', 'minimum'],
      ['39', 'The minimum for v = k+m', 'minimum'],
      ['40', 'The minimum for v = 2k+1, m = k', 'minimum'],
      ['9', 'Carriers beside cyclic designs', 'construction'],
      ['15', 'Concatenation with groups', 'construction'],
    ],
  ],
  [
    'Lower bounds',
    [
      ['5', 'Stays', 'bound'],
      ['35', 'Residues of degrees', 'bound'],
      ['36', 'Returning elements', 'bound'],
      ['37', 'No Steiner systems', 'bound'],
      ['29', 'No circular SCCD(14, 5) has 23 blocks', 'bound'],
    ],
  ],
  [
    'Run sheets and loads',
    [
      ['17', 'What one of W workers must load', 'bound'],
      ['18', 'Run sheets with slots', 'bound'],
      ['20', 'Costs by what is replaced', 'bound'],
      ['21', 'How few tests show all pairs of values', 'bound'],
      ['23', 'What a run sheet costs at least', 'bound'],
      ['24', 'Settings of parameters of g values', 'bound'],
      ['25', 'Settings of parameters of two values', 'bound'],
      ['26', 'What one of several benches must mount', 'bound'],
      ['27', 'Settings of parameters of three values', 'bound'],
      ['28', 'How often the costliest parts come', 'bound'],
    ],
  ],
];

const kinds = new Map(groups.flatMap(([, some]) => some.map(([n, , ...each]) => [n, each])));

/** What a theorem says: "tight", "bound", …; nothing of one that is not in a group. */
export const kindsOf = (number: string): readonly string[] => kinds.get(number) ?? [];
