// Times of tests as people say them. A plan counts hours since the day began; the page adds when it
// begins.

import type { Job } from './job';

const planned = /^(?:day (\d+)|(\d{4}-\d\d-\d\d)), (\d+):(\d\d)$/;

const weekdays = ['Sun', 'Mon', 'Tue', 'Wed', 'Thu', 'Fri', 'Sat'];
const months = 'Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec'.split(' ');

/** "4 Dec", as this place counts days */
export const dayOf = (time: Date): string => `${time.getDate()} ${months[time.getMonth()]}`;

/** "Fri 4 Dec" for 2026-12-04, or for a later day. */
export function dateWords(date: string, later = 0): string {
  const day = new Date(`${date}T00:00:00Z`);
  day.setUTCDate(day.getUTCDate() + later);
  return `${weekdays[day.getUTCDay()]} ${day.getUTCDate()} ${months[day.getUTCMonth()]}`;
}

/** Minutes since midnight; null: when a day begins was left open. */
function minutesOf(begins: string): number | null {
  const found = /^(\d\d):(\d\d)/.exec(begins);
  return found ? 60 * Number(found[1]) + Number(found[2]) : null;
}

/**
 * "day 1, 2:00" of a plan, for days that begin at 08:00: "day 1, 10:00"; "2026-12-04, 5:00" is "Fri
 * 4 Dec, 13:00". Without a beginning of days it says how much of the day has gone.
 */
export function timeWords(time: string, begins: string): string {
  const [, day, date, hours, minutes] = planned.exec(time) ?? [];
  if (hours === undefined || minutes === undefined) {
    return time;
  }
  const named = (later: number) =>
    date === undefined ? `day ${Number(day) + later}` : dateWords(date, later);
  const first = minutesOf(begins);
  if (first === null) {
    return `${named(0)}, after\u00a0${hours}:${minutes}\u00a0h`;
  }
  const all = first + 60 * Number(hours) + Number(minutes);
  // The end of a working day at midnight is still of that day.
  const later = all % 1440 === 0 && Number(hours) > 0 ? all / 1440 - 1 : Math.floor(all / 1440);
  const clock = all - 1440 * later;
  const rest = String(clock % 60).padStart(2, '0');
  return `${named(later)}, ${Math.floor(clock / 60)}:${rest}`;
}

/** The date of a time of a plan with dates, as words; null for others. */
export function dayWords(time: string): string | null {
  const date = planned.exec(time)?.[2];
  return date === undefined ? null : dateWords(date);
}

/** The day of work with this number from 0 on, as the planner writes dates. */
function workday(first: string, weekends: boolean, number: number): string {
  const day = new Date(`${first}T00:00:00Z`);
  const isFree = () => !weekends && [0, 6].includes(day.getUTCDay());
  for (let left = number; isFree() || left > 0; day.setUTCDate(day.getUTCDate() + 1)) {
    left -= isFree() ? 0 : 1;
  }
  return day.toISOString().slice(0, 10);
}

/**
 * Says the end of a plan, a sum of hours of work in the unit of costs, as a time of the calendar;
 * null for benches without days.
 */
export function calendarOf(job: Job): ((end: number) => string) | null {
  const up = job.benches.filter(({ name, down }) => name !== '' && !down);
  const own = up.map(({ hours }) => Number((hours.trim() || job.hours.trim()).replace(',', '.')));
  if (!own.some((hours) => hours > 0)) {
    return null;
  }
  const day = Math.max(...own.map((hours) => (hours > 0 ? hours : 24)));
  const inHours = { seconds: 1 / 3600, minutes: 1 / 60, hours: 1, money: 1, '': 1 }[job.unit];
  return (end) => {
    const all = end * inHours;
    const days = Math.max(0, Math.ceil(all / day - 1e-9) - 1);
    const minutes = Math.round((all - days * day) * 60);
    const name =
      job.firstDay && days < 1e4 ? workday(job.firstDay, job.weekends, days) : `day ${days + 1}`;
    const rest = String(minutes % 60).padStart(2, '0');
    return timeWords(`${name}, ${Math.floor(minutes / 60)}:${rest}`, job.dayBegins);
  };
}
