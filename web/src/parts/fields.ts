// Which cell or design a link asks for.
import type { Cell, Kind } from '../lib/api';
import type { Asked } from '../lib/source';

function whole(text: string | null): number | null {
  return text !== null && /^\d{1,9}$/.test(text) ? Number(text) : null;
}

export function cellOf(params: URLSearchParams): Cell | null {
  const [v, k] = [whole(params.get('v')), whole(params.get('k'))];
  const change = whole(params.get('change') ?? '2');
  const kind = params.get('kind') ?? 'circular';
  if (v === null || k === null || change === null || (kind !== 'circular' && kind !== 'linear')) {
    return null;
  }
  const strength = whole(params.get('strength'));
  return {
    v,
    k,
    change,
    kind: kind as Kind,
    ...(strength !== null && strength !== 2 ? { strength } : {}),
  };
}

export function askedOf(params: URLSearchParams): Asked | null {
  if (params.get('local')) {
    return { local: true };
  }
  const label = params.get('label');
  if (label) {
    return { label };
  }
  const file = whole(params.get('file'));
  if (file !== null) {
    return { file };
  }
  const job = params.get('job');
  return job ? { job } : cellOf(params);
}

/** What a key press is not for the page: it goes to a field, or has Ctrl, Alt or Meta with it. */
export function busyKey(event: KeyboardEvent, also = ''): boolean {
  return (
    event.ctrlKey ||
    event.altKey ||
    event.metaKey ||
    event.defaultPrevented ||
    (event.target instanceof Element &&
      event.target.closest(`input, select, textarea, [role="tab"], .scroll, .virtual${also}`) !==
        null)
  );
}
