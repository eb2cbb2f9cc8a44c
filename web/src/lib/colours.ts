// Colours by number: steps that look equally far apart (OKLCH), darker for more on a light ground
// and lighter for more on a dark one.

type Stop = readonly [lightness: number, chroma: number, hue: number];

const light: readonly Stop[] = [
  [0.955, 0.045, 95],
  [0.86, 0.12, 85],
  [0.74, 0.165, 60],
  [0.6, 0.19, 35],
  [0.46, 0.17, 5],
  [0.32, 0.12, 330],
];
const dark: readonly Stop[] = [
  [0.33, 0.05, 300],
  [0.43, 0.12, 325],
  [0.54, 0.17, 5],
  [0.66, 0.175, 38],
  [0.79, 0.15, 70],
  [0.93, 0.11, 100],
];

function channel(linear: number): number {
  const x = Math.min(1, Math.max(0, linear));
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

/** OKLCH as `#rrggbb`. */
export function oklch([lightness, chroma, hue]: Stop): string {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const rgb = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return `#${rgb.map((each) => channel(each).toString(16).padStart(2, '0')).join('')}`;
}

function mixed(stops: readonly Stop[], at: number): Stop {
  const place = Math.min(1, Math.max(0, at)) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(place));
  const [from, to] = [stops[i]!, stops[i + 1]!];
  const part = place - i;
  const turn = ((to[2] - from[2] + 540) % 360) - 180;
  return [
    from[0] + part * (to[0] - from[0]),
    from[1] + part * (to[1] - from[1]),
    from[2] + part * turn,
  ];
}

const steps = 96;

/** The colours from least to most. */
export function scale(theme: 'light' | 'dark'): readonly string[] {
  return Array.from({ length: steps }, (_, i) =>
    oklch(mixed(theme === 'dark' ? dark : light, i / (steps - 1))),
  );
}

/** Kinds of things that have no order: up to ten hues of one lightness, then grey. */
export function hues(count: number, theme: 'light' | 'dark'): readonly string[] {
  return Array.from({ length: count }, (_, i) =>
    i < 10
      ? oklch([theme === 'dark' ? 0.68 : 0.72, 0.125, 20 + i * 36 + (i % 2) * 12])
      : theme === 'dark'
        ? '#55636e'
        : '#b9c2ca',
  );
}

/** Maps ask for the same few colours in each cell. */
const inks = new Map<string, string>();

/** Black or white, whichever is read more easily on `#rrggbb`: its contrast is 4.5 at least. */
export function inkOn(colour: string): string {
  let ink = inks.get(colour);
  if (ink === undefined) {
    const [r, g, b] = [1, 3, 5].map((i) => {
      const x = parseInt(colour.slice(i, i + 2), 16) / 255;
      return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    });
    const light = 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
    ink = (light + 0.05) ** 2 > 1.05 * 0.05 ? '#000000' : '#ffffff';
    inks.set(colour, ink);
  }
  return ink;
}
