// A list that is a design: is it known, from whom, and how is it cited.
import type { Cell } from '../../lib/api';
import { checksumOf } from '../../lib/checksum';
import { fill, h } from '../../lib/dom';
import { cellDetail, cite, isHeld } from '../../lib/source';
import { getText } from '../../lib/api';
import { count, number } from '../../lib/words';
import { copyButton } from '../../parts/copy';
import { isCopy } from '../../shell/about';
import { link, problem } from '../../shell/router';
import type { Report } from './check';

export function citation(report: Report, signal: AbortSignal): HTMLElement {
  const { v, k, b, change, kind, strength, blocks } = report.blocks;
  const block = (i: number) => blocks.subarray(i * k, (i + 1) * k);
  const place = h('div', {}, h('p', { class: 'hint' }, 'Asking whether it is known …'));
  const cell: Cell = { v, k, change, kind, ...(strength === 2 ? {} : { strength }) };
  void (async () => {
    try {
      if (!(await isHeld(cell))) {
        fill(
          place,
          h(
            'p',
            { class: 'hint' },
            'This copy has no designs with these parameters to compare with.',
          ),
        );
        return;
      }
      const [detail, hash] = await Promise.all([cellDetail(cell, signal), checksumOf(b, k, block)]);
      const same = hash === null ? undefined : detail.designs.find((entry) => entry.hash === hash);
      const best = detail.best?.b ?? null;
      const text = same
        ? await cite(same.label, signal)
        : isCopy()
          ? null
          : await getText('cite', {}, signal);
      fill(
        place,
        same
          ? h(
              'p',
              {},
              'This list is in the catalog: ',
              h('a', { class: 'code', href: link('design', { label: same.label }) }, same.label),
              same.credit.who && ` by ${same.credit.who}`,
              same.credit.date && `, ${same.credit.date}`,
              '.',
            )
          : h(
              'p',
              {},
              best === null
                ? 'No other design with these parameters is known: this is the first.'
                : b < best
                  ? `The best known design has ${count(best, 'block')}: this one is better by ` +
                    `${number(best - b)}.`
                  : b === best
                    ? `The best known design has as many blocks, ${number(best)}; this list is ` +
                      `not the one in the catalog.`
                    : `The best known design has ${count(best, 'block')}, ${number(b - best)} ` +
                      `fewer.`,
              ' ',
              h('a', { href: link('cell', { ...cell }) }, 'More about these parameters'),
              '.',
            ),
        text !== null && [
          h(
            'h3',
            {},
            same ? 'BibTeX of this design' : 'BibTeX of the catalog that it was compared with',
          ),
          h('pre', { tabindex: 0 }, text),
          copyButton('Copy', () => text),
        ],
      );
    } catch (fault) {
      if (!signal.aborted) {
        fill(place, problem(fault));
      }
    }
  })();
  return h(
    'section',
    { class: 'verify-citation' },
    h('h2', {}, 'Known designs and citation'),
    place,
  );
}
