// What the server is and may do, asked once. In a static export a file answers instead.
import { noAnswer, type About } from '../lib/api';

let known: Promise<About> | undefined;

/** Where a static export has its files, relative to the page. */
export function dataFolder(): string {
  return (
    document.querySelector<HTMLMetaElement>('meta[name="changeover-data"]')?.content ?? 'data/'
  );
}

/**
 * Whether these pages are a static export: they say so themselves (`<meta name="changeover-data"
 * content="data/">`).
 */
export function isCopy(): boolean {
  return document.querySelector('meta[name="changeover-data"]') !== null;
}

/** Asks the server, or `config.json` of the static export. */
export function about(): Promise<About> {
  known ??= (async () => {
    const answer = await fetch(isCopy() ? `${dataFolder()}config.json` : 'api/about').catch(
      () => null,
    );
    if (answer?.ok) {
      return (await answer.json()) as About;
    }
    known = undefined;
    throw new Error(
      isCopy() ? 'This copy is not complete: data/config.json is missing.' : noAnswer,
    );
  })();
  return known;
}
