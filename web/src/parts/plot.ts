// A plot of a few lines: uPlot in the page's colours, as wide as its place, with a table of the
// numbers for those who do not see it.
import type uPlot from 'uplot';
import { h } from '../lib/dom';
import { withTheme } from '../shell/theme';

export interface Line {
  label: string;
  /** Which of the colours --line-1 … --line-6. */
  colour: number;
  values: (number | null)[];
  /** Dashes tell lines apart without colour. */
  dash?: number[];
  width?: number;
  /** A separate scale on the right-hand side. */
  right?: boolean;
  /** Holds its value up to the next point. */
  steps?: boolean;
}

export interface PlotOptions {
  label: string;
  x: string;
  y: string;
  right?: string;
  height?: number;
  signal: AbortSignal;
  xText?: (x: number) => string;
  yText?: (y: number) => string;
  rightText?: (y: number) => string;
  /** An upright line at this x. */
  mark?: () => number | null;
  /** What it is of, beside its head. */
  markText?: () => string;
  fromZero?: boolean;
  /** What is counted has no halves: no lines between whole numbers. */
  whole?: boolean;
}

export interface Plot {
  readonly element: HTMLElement;
  set(xs: number[], lines: Line[]): void;
  /** Redraws the plot after the mark has moved. */
  redraw(): void;
}

function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

const wholeSteps = Array.from(
  { length: 27 },
  (_, i) => [1, 2, 5][i % 3]! * 10 ** Math.floor(i / 3),
);

const short = (value: number) =>
  Math.abs(value) >= 1e6 ? value.toPrecision(3).replace('+', '') : String(+value.toPrecision(6));

/** Read when the first plot is drawn: what it sets up takes as long as all of a page. */
let drawing: typeof uPlot | undefined;

export function plot(options: PlotOptions): Plot {
  const { label, height = 280, signal } = options;
  const place = h('div', { class: 'plot', role: 'img', 'aria-label': label });
  place.style.minHeight = `${height}px`;
  let made: uPlot | null = null;
  let xs: number[] = [];
  let lines: Line[] = [];
  let shape = '';

  function make(): void {
    made?.destroy();
    made = null;
    const width = place.clientWidth;
    if (width === 0 || lines.length === 0) {
      return;
    }
    if (!drawing) {
      void import('uplot').then((read) => {
        drawing = read.default;
        signal.aborted || make();
      });
      return;
    }
    const { paths } = drawing;
    const text = colour('--faint');
    const grid = { stroke: colour('--line'), width: 1 };
    const axis = {
      stroke: text,
      grid,
      ticks: grid,
      font: `12px ${colour('--text-font')}`,
      labelFont: `12px ${colour('--text-font')}`,
      labelSize: 20,
    };
    const right = lines.some((line) => line.right);
    const yText = options.yText ?? short;
    const rightText = options.rightText ?? short;
    made = new drawing(
      {
        width,
        height,
        scales: {
          x: { time: false },
          y: options.fromZero ? { range: (_, __, most) => [0, most > 0 ? most * 1.05 : 1] } : {},
          ...(right
            ? {
                right: {
                  range: (_: uPlot, __: number, most: number) =>
                    [0, most > 0 ? most * 1.05 : 1] as [number, number],
                },
              }
            : {}),
        },
        cursor: { drag: { x: false, y: false } },
        legend: {
          live: true,
          markers: { dash: (_, i) => (lines[i - 1]?.dash ? 'dashed' : 'solid') },
        },
        axes: [
          {
            ...axis,
            space: 80,
            label: options.x,
            size: 34,
            values: (_, ticks) => ticks.map((tick) => (options.xText ?? short)(tick)),
          },
          {
            ...axis,
            label: options.y,
            size: 62,
            values: (_, ticks) => ticks.map(yText),
            ...(options.whole ? { incrs: wholeSteps } : {}),
          },
          ...(right
            ? [
                {
                  ...axis,
                  scale: 'right',
                  side: 1,
                  label: options.right ?? '',
                  size: 62,
                  grid: { show: false },
                  values: (_: uPlot, ticks: number[]) => ticks.map(rightText),
                },
              ]
            : []),
        ],
        series: [
          { label: options.x, value: (_, x) => (x === null ? '' : (options.xText ?? short)(x)) },
          ...lines.map((line) => ({
            label: line.label,
            scale: line.right ? 'right' : 'y',
            stroke: colour(`--line-${line.colour}`),
            width: line.width ?? 2,
            points: { show: false },
            pxAlign: 0,
            ...(line.dash ? { dash: line.dash } : {}),
            ...(line.steps ? { paths: paths.stepped!({ align: 1 }) } : {}),
            value: (_: uPlot, y: number | null) =>
              y === null ? '' : (line.right ? rightText : yText)(y),
          })),
        ],
        hooks: {
          draw: [
            (drawn) => {
              const at = options.mark?.() ?? null;
              if (at !== null) {
                const x = drawn.valToPos(at, 'x', true);
                const { ctx, bbox } = drawn;
                ctx.save();
                ctx.strokeStyle = colour('--text');
                ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
                ctx.beginPath();
                ctx.moveTo(x, bbox.top);
                ctx.lineTo(x, bbox.top + bbox.height);
                ctx.stroke();
                const words = options.markText?.() ?? '';
                const gap = 4 * devicePixelRatio;
                ctx.font = `${12 * devicePixelRatio}px ${colour('--text-font')}`;
                ctx.fillStyle = colour('--text');
                ctx.textBaseline = 'top';
                const right = x + gap + ctx.measureText(words).width < bbox.left + bbox.width;
                ctx.textAlign = right ? 'left' : 'right';
                ctx.fillText(words, right ? x + gap : x - gap, bbox.top + gap);
                ctx.restore();
              }
            },
          ],
        },
      },
      [xs, ...lines.map((line) => line.values)] as uPlot.AlignedData,
      place,
    );
  }

  let width = 0;
  const sizes = new ResizeObserver(() => {
    if (place.clientWidth !== width) {
      width = place.clientWidth;
      made && width > 0 ? made.setSize({ width, height }) : make();
    }
  });
  sizes.observe(place);
  signal.addEventListener('abort', () => {
    sizes.disconnect();
    made?.destroy();
    made = null;
  });
  withTheme(signal, make);
  return {
    element: place,
    set(nextXs, nextLines) {
      xs = nextXs;
      lines = nextLines;
      const nextShape = JSON.stringify(lines.map(({ values: _, ...rest }) => rest));
      if (made && nextShape === shape) {
        made.setData([xs, ...lines.map((line) => line.values)] as uPlot.AlignedData);
      } else {
        shape = nextShape;
        make();
      }
    },
    redraw() {
      made?.redraw(false);
    },
  };
}
