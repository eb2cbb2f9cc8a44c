// The address of a cell.
import type { Cell } from '../../lib/api';
import { link } from '../../shell/router';

export function at(cell: Cell, changes: Partial<Cell> = {}): string {
  return link('cell', { ...cell, ...changes });
}
