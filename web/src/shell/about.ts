// What the server is and may do, asked once. In a static export a file answers instead.
import type { About } from '../lib/api';

let known: Promise<About> | undefined;

/** Where a static export has its files, relative to the page. */
export function dataFolder(): string {
  return document.querySelector<HTMLMetaElement>('meta[name="changeover-data"]')?.content ?? 'data/';
}

/** Whether the page itself says that it is a static export (`<meta name="changeover-data" content="data/">`). */
function marked(): boolean {
  return document.querySelector('meta[name="changeover-data"]') !== null;
}

/** Asks the server; where there is none, `config.json` of the static export. */
export function about(): Promise<About> {
  known ??= (async () => {
    const live = marked() ? null : await fetch('api/about').catch(() => null);
    if (live?.ok && live.headers.get('content-type')?.startsWith('application/json')) {
      return (await live.json()) as About;
    }
    const kept = await fetch(`${dataFolder()}config.json`).catch(() => null);
    if (kept?.ok) {
      return (await kept.json()) as About;
    }
    known = undefined;
    throw new Error('The server does not answer. Is `changeover serve` still running?');
  })();
  return known;
}
