// The look-up box: a cell in any spelling, a label, or a design as it stands.
import type { Kind } from '../../lib/api';
import { fill, h } from '../../lib/dom';
import { keepText } from '../../lib/local';
import { atlasOf, cellOfLabel } from '../../lib/source';
import { link } from '../../shell/router';

export type Found =
  | { to: string; paste?: string }
  /** The first digits of the checksum of a design's blocks. */
  | { checksum: string }
  | { problem: string };

/** Where `text` leads to. `change` and `kind` hold where it does not say. */
export function understand(text: string, change: number, kind: Kind): Found {
  const plain = text.trim();
  if (plain === '') {
    return { problem: 'Type v and k, as 20 5, or a label, as 20.5.2.linear.' };
  }
  if (/\n/.test(plain) || /[{<[]/.test(plain)) {
    return { to: link('verify', { pasted: 1 }), paste: text };
  }
  // A design on one line: 0 1 2; 1 2 3; 0 1 3.
  const blocksOf = plain.split(/\s*[;/]\s*/).filter((block) => block !== '');
  const sizes = new Set(blocksOf.map((block) => block.split(/[\s,]+/).length));
  if (blocksOf.length > 1 && sizes.size === 1 && !sizes.has(1) && !plain.includes('=')) {
    return { to: link('verify', { pasted: 1 }), paste: blocksOf.join('\n') };
  }
  const checksum = /^(?:[0-9a-f]{8}|[0-9a-f]{64})$/i.exec(plain)?.[0];
  if (checksum) {
    return { checksum: checksum.slice(0, 8).toLowerCase() };
  }
  const cell = cellOfLabel(plain);
  if (cell) {
    const rest = plain.replace(/^\d+\.\d+\.\d+\.(circular|linear)(\.t\d+)?/, '');
    return {
      to:
        rest === '' || rest === '.' ? link('cell', { ...cell }) : link('design', { label: plain }),
    };
  }
  const blocks = /^(?:b\s*=\s*)?(\d+)\s*(?:blocks?)$|^b\s*=\s*(\d+)$/i.exec(plain);
  if (blocks) {
    return { to: link('catalog', { change, kind, blocks: blocks[1] ?? blocks[2] }) };
  }
  // The beginning of a label: 20.5.2.
  const begun = /^(\d+)\.(\d+)(?:\.(\d+)\.?)?$/.exec(plain);
  if (begun && Number(begun[2]) <= Number(begun[1]) && Number(begun[2]) > 0) {
    return {
      to: link('cell', { v: begun[1], k: begun[2], change: begun[3] ?? change, kind }),
    };
  }
  if (/(?:^|[\s,(=;])[-−]\s*\d/.test(plain)) {
    return { problem: 'v and k are whole numbers from 1 on, without a sign: write them as 20 5.' };
  }
  let words = plain.toLowerCase().replace(/(?<=\d)\s*[x×]\s*(?=\d)/, ' ');
  const wordChange =
    /\b(?:m|change)\s*=?\s*(\d+)/.exec(words)?.[1] ??
    (/\bsingle|\bsccd/.test(words) ? '1' : /\bdouble|\bdccd/.test(words) ? '2' : null);
  const wordKind = /\b(circular|linear)\b/.exec(words)?.[1] ?? kind;
  words = words.replace(/\b(?:m|change)\s*=?\s*\d+/, '');
  const named = [/\bv\s*=?\s*(\d+)/.exec(words)?.[1], /\bk\s*=?\s*(\d+)/.exec(words)?.[1]];
  const bare = words.match(/\d+/g) ?? [];
  const [v, k] = named[0] && named[1] ? named : bare;
  if (
    v &&
    k &&
    (named[0] || bare.length <= 3) &&
    words.replace(/[\d\s(),;=]|[vk]\b|circular|linear|single|double|change|sccd|dccd|-/g, '') === ''
  ) {
    if (Number(v) < 1 || Number(k) < 1) {
      return { problem: `v = ${v}, k = ${k}: both are whole numbers from 1 on, as 20 5.` };
    }
    if (Number(k) > Number(v)) {
      return {
        problem:
          `A block of k = ${k} elements is more than all v = ${v}; write v first, ` +
          `as ${k} ${v}.`,
      };
    }
    // A third number is m, or b where no design changes so many elements: 40 6 88.
    const third = bare.length === 3 && !named[0] ? bare[2]! : null;
    return {
      to: link('cell', {
        v,
        k,
        change: wordChange ?? (third !== null && Number(third) <= Number(k) ? third : change),
        kind: wordKind,
      }),
    };
  }
  return {
    problem:
      `“${plain.slice(0, 60)}” is neither v and k (20 5), nor a label (20.5.2.linear), ` +
      `nor a design with a block in each line.`,
  };
}

/** The label that ends with these digits, among those of the best designs. */
async function labelled(checksum: string): Promise<string | null> {
  for (const strength of [2, 3, 4]) {
    for (const change of [1, 2, 3]) {
      for (const kind of ['circular', 'linear'] as const) {
        const atlas = await atlasOf({ change, kind, strength }).catch(() => null);
        const label = atlas?.cells().find((cell) => cell.label?.endsWith(`.${checksum}`))?.label;
        if (label) {
          return label;
        }
      }
    }
  }
  return null;
}

export function lookUp(here: () => { change: number; kind: Kind }): HTMLElement {
  const message = h(
    'p',
    { class: 'hint', id: 'look-up-says' },
    'Write v and k (20 5), a label (20.5.2.linear) or the checksum at its end, or paste a design.',
  );
  const input = h('input', {
    id: 'look-up',
    type: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    placeholder: '20 5',
    'aria-describedby': message.id,
  });
  const go = (text: string): void => {
    const { change, kind } = here();
    const found = understand(text, change, kind);
    const fault = (words: string): void => {
      message.className = 'hint wrong';
      message.setAttribute('role', 'alert');
      fill(message, words);
    };
    if ('problem' in found) {
      fault(found.problem);
      return;
    }
    if ('checksum' in found) {
      fill(message, 'Looking for that checksum …');
      void labelled(found.checksum).then((label) =>
        label
          ? (window.location.hash = link('design', { label }))
          : fault(
              `No best design has a checksum that begins with ${found.checksum}. Other designs ` +
                'are found by their whole label.',
            ),
      );
      return;
    }
    if (found.paste !== undefined) {
      keepText(found.paste);
    }
    window.location.hash = found.to;
  };
  input.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    if (text.trim().includes('\n')) {
      event.preventDefault();
      go(text);
    }
  });
  return h(
    'form',
    {
      class: 'look-up',
      role: 'search',
      onsubmit: (event) => {
        event.preventDefault();
        go(input.value);
      },
    },
    h('label', { for: input.id }, 'Look up a design'),
    h('div', { class: 'look-up-row' }, input, h('button', {}, 'Look up')),
    message,
  );
}
