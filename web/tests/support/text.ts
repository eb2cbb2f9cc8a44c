// What shows text, for tests of what it says.
export { markup } from '../../src/lib/markup';
export { prepare } from '../../src/lib/mathematics';
export { spoken } from '../../src/lib/citations';
