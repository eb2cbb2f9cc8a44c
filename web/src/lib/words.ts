// Numbers and parameters as people read them.
import type { Cell, Kind } from './api';

export function count(n: number, singular: string, plural = `${singular}s`): string {
  return `${number(n)} ${n === 1 ? singular : plural}`;
}

/** With narrow spaces, at which no line is broken, between thousands from 10 000 on. */
export function number(n: number): string {
  const digits = String(Math.abs(n));
  return Number.isInteger(n) && digits.length > 4
    ? (n < 0 ? '−' : '') + digits.replace(/\B(?=(\d{3})+$)/g, '\u202f')
    : String(n);
}

/** What must be together in a block: pairs, or more for a larger strength. */
export function setWord(strength: number): string {
  return ['pair', 'triple', 'quadruple'][strength - 2] ?? `${strength}-subset`;
}
export const setsOf = (strength: number): string => `${setWord(strength)}s`;

export function changeWord(change: number): string {
  return change === 1 ? 'single-change' : change === 2 ? 'double-change' : `${change}-change`;
}

/** "circular double-change covering design on 61 elements in blocks of 4" */
export function nameOf(cell: Cell): string {
  return (
    `${cell.kind} ${changeWord(cell.change)} covering design on ${number(cell.v)} ` +
    `elements in blocks of ${cell.k}`
  );
}

export const kinds: readonly (readonly [Kind, string])[] = [
  ['circular', 'circular'],
  ['linear', 'linear'],
];

export const changes: readonly (readonly [string, string])[] = [
  ['1', 'single-change (m = 1)'],
  ['2', 'double-change (m = 2)'],
  ['3', '3-change (m = 3)'],
];

/** What a static copy has: "k = 3 to 6 and v = 4 to 30" */
export function rangeWords(range: {
  k_from: number;
  k_to: number;
  v_from: number;
  v_to: number;
}): string {
  return (
    `k\u00a0=\u00a0${range.k_from} to ${range.k_to} and ` +
    `v\u00a0=\u00a0${range.v_from} to ${range.v_to}`
  );
}

export function bytes(n: number): string {
  const units = ['bytes', 'kB', 'MB', 'GB', 'TB', 'PB'];
  let unit = 0;
  let rest = n;
  while (rest >= 1000 && unit < units.length - 1) {
    rest /= 1000;
    ++unit;
  }
  return `${unit === 0 ? rest : rest.toPrecision(3)} ${units[unit]}`;
}

export function ratio(b: number, bound: number): string {
  return (b / bound).toFixed(3);
}

/** "< 1 %", "37 %"; 100 % only if it is all. */
export function percent(part: number, all: number): string {
  const whole = all > 0 ? Math.floor((100 * part) / all) : 100;
  return whole === 0 && part > 0 ? '< 1 %' : `${whole} %`;
}

const below = '₀₁₂₃₄₅₆₇₈₉';

/** The name of an element, "0_12", with its index below: "0₁₂". As text, for pictures, too. */
export function indexed(name: string): string {
  return name.replace(/(?<=[\p{L}\d∞])_(\d+)$/u, (_, index: string) =>
    [...index].map((digit) => below[Number(digit)]).join(''),
  );
}

/** As the beginning of a sentence. */
export const capital = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}`;
