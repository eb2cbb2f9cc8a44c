// What the server is and may do, asked once. In a static export a file answers instead.
import type { About } from '../lib/api';

let known: Promise<About> | undefined;

/** `data/config.json` says that there is no server behind these pages; where it is missing, there is one. */
export function about(): Promise<About> {
  known ??= (async () => {
    const live = await fetch('api/about').catch(() => null);
    if (live?.ok && live.headers.get('content-type')?.startsWith('application/json')) {
      return (await live.json()) as About;
    }
    const kept = await fetch('data/config.json').catch(() => null);
    if (kept?.ok) {
      return (await kept.json()) as About;
    }
    known = undefined;
    throw new Error('The server does not answer. Is `changeover serve` still running?');
  })();
  return known;
}
