// Runs beside the page (see check.ts): asks, reads the answer, and turns its blocks into rows of
// numbers.
import { ApiError, askWith, type Design, type Verified } from '../../lib/api';
import { verifyAlone } from './alone';
import type { Answer, Blocks, Question, Reply } from './check';

const port = self as unknown as {
  onmessage: ((event: MessageEvent<Question>) => void) | null;
  postMessage(message: Reply, transfer: Transferable[]): void;
};

function rows(design: Design): Blocks {
  const { v, k, change, kind } = design;
  const b = design.blocks.length;
  const blocks = Int32Array.from(design.blocks.flat());
  const placed = new Int32Array(b * k);
  const introduced = new Int32Array(b);
  // seen[x] is the last block (from 1) that x was found in, place[x] where it stood.
  const seen = new Int32Array(v);
  const place = new Int32Array(v);
  if (kind === 'circular' && b > 1) {
    for (let j = 0; j < k; ++j) {
      seen[blocks[(b - 1) * k + j]!] = -1;
    }
  }
  for (let i = 0; i < b; ++i) {
    const start = i * k;
    const before = i === 0 ? -1 : i;
    const taken = new Uint8Array(k);
    const fresh: number[] = [];
    for (let j = 0; j < k; ++j) {
      const x = blocks[start + j]!;
      if (seen[x] === before && i > 0) {
        placed[start + place[x]!] = x;
        taken[place[x]!] = 1;
      } else {
        if (seen[x] !== before) {
          ++introduced[i]!;
        }
        fresh.push(x);
      }
    }
    let free = 0;
    for (const x of fresh) {
      while (taken[free]) {
        ++free;
      }
      placed[start + free] = x;
      taken[free] = 1;
      place[x] = free;
    }
    for (let j = 0; j < k; ++j) {
      seen[blocks[start + j]!] = i + 1;
    }
  }
  return {
    shown: true,
    v,
    k,
    b,
    change,
    kind,
    strength: design.strength ?? 2,
    labels: design.labels ?? null,
    blocks,
    placed,
    introduced,
  };
}

function noRows({ v, k, b, change, kind, strength }: Answer['details']): Blocks {
  return {
    shown: false,
    v,
    k,
    b,
    change,
    kind,
    strength,
    labels: null,
    blocks: new Int32Array(),
    placed: new Int32Array(),
    introduced: new Int32Array(),
  };
}

async function verified({ url, body, alone }: Question): Promise<Verified> {
  if (alone) {
    return verifyAlone(typeof body === 'string' ? body : await body.text(), alone);
  }
  const headers = { 'Content-Type': 'text/plain; charset=utf-8' };
  return (await askWith(url, { method: 'POST', headers, body })).json() as Promise<Verified>;
}

port.onmessage = ({ data }) => {
  verified(data)
    .then(({ design, ...answer }) => {
      const blocks = design ? rows(design) : noRows(answer.details);
      port.postMessage({ report: { answer, blocks } }, [
        blocks.blocks.buffer,
        blocks.placed.buffer,
        blocks.introduced.buffer,
      ]);
    })
    .catch((fault: unknown) => {
      const { message, status = 0, line, column } = fault as Partial<ApiError> & Error;
      port.postMessage({ fault: { message, status, line, column } }, []);
    });
};
