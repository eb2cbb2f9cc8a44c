// Lists to try the page with: what the tests say of each is what the page shows.
const good = `# changeover design v=9 k=4 change=2 kind=linear
1 3 7 8
2 5 7 8
0 2 3 8
2 3 4 5
1 2 3 6
0 1 5 6
0 1 4 7
4 6 7 8
`;

export interface Example {
  name: string;
  title: string;
  text: string;
}

export const examples: readonly Example[] = [
  { name: 'good', title: 'a good one', text: good },
  {
    name: 'steps',
    title: 'one with bad steps',
    text: good.replace('0 1 5 6\n0 1 4 7', '0 1 4 7\n0 1 5 6'),
  },
  { name: 'pairs', title: 'one with missing pairs', text: good.replace('4 6 7 8', '4 5 7 8') },
  { name: 'typing', title: 'one with a typing error', text: good.replace('2 3 4 5', '2 3 4 4') },
];
