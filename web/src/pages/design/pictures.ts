// The program's own pictures of a design, as files to keep; and the tree of its recipe.
import type { Design } from '../../lib/api';
import { fill, h, picture } from '../../lib/dom';
import { save } from '../../lib/save';
import { draw, type Asked, type DrawQuery, type PictureName } from '../../lib/source';
import { fileName } from '../../parts/downloads';
import { problem } from '../../shell/router';
import { theme } from '../../shell/theme';

/** So many blocks a picture has at most when it is saved. */
const mostBlocks = 400;

/** A button that keeps a picture as SVG, as `changeover draw` draws it. */
export function savePicture(
  name: PictureName,
  asked: Asked,
  design: Design,
  how: () => Partial<DrawQuery>,
  signal: AbortSignal,
): HTMLElement {
  const said = h('span', { role: 'status' });
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      onclick: async () => {
        button.disabled = true;
        fill(said);
        try {
          const { from = 1, to = design.blocks.length } = how();
          const paged =
            name === 'array' || name === 'stays'
              ? { from, to: Math.min(to, from + mostBlocks - 1) }
              : {};
          const order =
            name === 'stays' || name === 'coverage' ? { order: how().order ?? 'first' } : {};
          const text = await draw(
            asked,
            { picture: name, theme: theme(), ...order, ...paged },
            signal,
          );
          if (text !== null) {
            save(fileName(design, `${name}.svg`), text, 'image/svg+xml');
          }
        } catch (fault) {
          if (!signal.aborted) {
            fill(said, problem(fault));
          }
        }
        button.disabled = false;
      },
    },
    'Save as SVG',
  );
  return h('span', { class: 'save-picture' }, button, said);
}

/** The tree of constructions as a picture; nothing in a static copy. */
export async function recipePicture(
  asked: Asked,
  panel: HTMLElement,
  signal: AbortSignal,
): Promise<void> {
  const show = async (): Promise<void> => {
    const text = await draw(asked, { picture: 'recipe', theme: theme() }, signal).catch(() => null);
    if (text !== null && !signal.aborted) {
      const image = picture(text);
      image.style.setProperty(
        '--width',
        `${image.viewBox.baseVal.width || Number(image.getAttribute('width')) || 0}px`,
      );
      fill(
        panel,
        h(
          'div',
          {
            class: 'picture scroll recipe',
            tabindex: 0,
            role: 'region',
            'aria-label': 'Picture: recipe',
          },
          image,
        ),
      );
    }
  };
  document.addEventListener('themechange', () => void show(), { signal });
  await show();
}
