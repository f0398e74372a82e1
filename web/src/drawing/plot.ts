// Charts that Observable Plot draws: one description for the page and for the file that leaves it.
import type { Markish, Plot as Plotted } from '@observablehq/plot';
import { cumsum, max } from 'd3-array';
import { scaleLinear, scaleLog } from 'd3-scale';
import { Plot } from './library';
import { powerOfTen, prefixFor, written } from './numbers';
import type { Look, Theme } from './theme';

/** From where to where an axis goes. */
export interface Scale {
  low: number;
  high: number;
  log: boolean;
}

export interface Axis extends Scale {
  label: string;
  /** '' for a pure number */
  unit?: string;
}

/** What the numbers along an axis are in: its unit with the prefix that suits it. */
export function unitAlong({ low, high, unit = '' }: Axis): { size: number; unit: string } {
  return prefixFor(Math.max(Math.abs(low), Math.abs(high)), unit);
}

/** What an axis shows, with that unit. */
export function labelOf(axis: Axis): string {
  const { unit } = unitAlong(axis);
  return unit ? `${axis.label} (${unit})` : axis.label;
}

/** Places of the numbers along an axis, and what they are. */
interface Ticks {
  places: number[];
  words: (place: number) => string;
}

export interface Chart {
  width: number;
  /** of the axes */
  height: number;
  x: Axis;
  y: Axis;
  /** where x has no scale of its own */
  ticks?: Ticks;
  /** whether x has numbers and a label, and y a label above */
  bottom?: boolean;
  top?: boolean;
  marks: Markish[];
}

export type Drawn = SVGSVGElement & Plotted;

const MARGIN = { left: 62, right: 14, top: 30, bottom: 46 };

/** Pixels of a chart beside what it shows. */
export const BESIDE = MARGIN.left + MARGIN.right;

const PITCH = 64; // pixels for the number of a tick along x
const RISE = 30; // and along y

/** Round numbers along an axis of some length in pixels; of a logarithmic one only some have a name. */
export function ticksOf({ low, high, log }: Scale, length: number, pitch: number): Ticks {
  const count = Math.max(2, Math.floor(length / pitch));
  if (!log) {
    const scale = scaleLinear([low, high], [0, 1]);
    const usual = scale.tickFormat(count);
    const plain = Math.max(Math.abs(low), Math.abs(high)) < 1e5 && high - low > 1e-3;
    return { places: scale.ticks(count), words: (each) => (plain && each !== 0 ? usual(each) : written(each)) };
  }
  const decades = Math.log10(high / low);
  const leads = 3 * decades <= count ? [1, 2, 5] : [1];
  const words = (each: number): string => {
    const [lead, power] = each.toExponential(3).split('e').map(Number) as [number, number];
    // A row of powers looks best with all written alike.
    if (lead === 1 && decades > 4 && (power < -1 || power > 2)) return powerOfTen(power);
    return decades < 0.7 || leads.includes(lead) ? written(each) : '';
  };
  return { places: scaleLog([low, high], [0, 1]).ticks(count), words };
}

function ticksAlong(axis: Axis, length: number, pitch: number): Ticks {
  const { size } = unitAlong(axis);
  const { places, words } = ticksOf({ low: axis.low / size, high: axis.high / size, log: axis.log }, length, pitch);
  return { places: places.map((each) => each * size), words: (each) => words(each / size) };
}

/** Draws marks in a frame of axes. */
export function draw({ width, height, x, y, ticks, bottom = true, top = true, marks }: Chart, theme: Theme): Drawn {
  const margin = { ...MARGIN, ...(bottom ? {} : { bottom: 8 }), ...(top ? {} : { top: 8 }) };
  const [across, up] = [ticks ?? ticksAlong(x, width - BESIDE, PITCH), ticksAlong(y, height, RISE)];
  const named = ({ places, words }: Ticks): number[] => places.filter((each) => words(each) !== '');
  const line = { stroke: theme.line, strokeOpacity: 1, strokeWidth: 0.7 };
  const numbers = { fill: theme.muted, stroke: theme.muted, strokeWidth: 0.8, label: null };
  return plain(Plot.plot({
    width, height: height + margin.top + margin.bottom,
    marginLeft: margin.left, marginRight: margin.right, marginTop: margin.top, marginBottom: margin.bottom,
    style: { background: 'none', color: theme.text, fontSize: '12px' },
    x: { type: x.log ? 'log' : 'linear', domain: [x.low, x.high] },
    y: { type: y.log ? 'log' : 'linear', domain: [y.low, y.high] },
    marks: [
      ticks ? null : Plot.gridX(named(across), line),
      Plot.gridY(named(up), line),
      Plot.axisX(across.places, { ...numbers, tickSize: ticks ? 0 : 5, text: bottom ? across.words : () => '' }),
      Plot.axisY(up.places, { ...numbers, tickSize: 5, text: up.words }),
      bottom ? Plot.text([labelOf(x)], { frameAnchor: 'bottom', dy: 38 }) : null,
      top ? Plot.text([labelOf(y)], { frameAnchor: 'top-left', dy: -18 }) : null,
      Plot.frame({ anchor: 'left', stroke: theme.muted }),
      Plot.frame({ anchor: 'bottom', stroke: theme.muted }),
      ...marks,
    ],
  }));
}

/** A picture without the labels of its marks, which have no role that may have one. */
function plain(plot: Element): Drawn {
  for (const each of plot.querySelectorAll('[aria-label]')) each.removeAttribute('aria-label');
  return plot as Drawn;
}

/** What is drawn has a colour; a line has a dash, and points have a marker. */
type Entry = { label: string } & Pick<Look, 'color'> & Partial<Look>;

const KEY = 32; // pixels of a line or marker before its label
const LETTER = 6.7;
const ROW = 18;

/** The places of a legend's entries, in columns that are as wide as the longest label; where it is wider than the
 *  legend, all have as many rows as it takes. */
export function placed(labels: string[], width: number): { x: number; y: number; rows: number; letters: number }[] {
  const longest = Math.max(0, ...labels.map((label) => label.length));
  const inner = width - MARGIN.left;
  const columns = Math.max(1, Math.floor(inner / (KEY + LETTER * longest + 12)));
  const letters = Math.min(longest, Math.floor((inner - KEY) / LETTER));
  const rows = longest > letters ? Math.ceil(longest / (0.85 * letters)) : 1; // lines end between words
  return labels.map((_, k) => ({
    x: MARGIN.left + (k % columns) * (inner / columns), y: ROW * (rows * Math.floor(k / columns) + 0.5), rows, letters,
  }));
}

/** Draws a legend. */
export function drawLegend(entries: Entry[], width: number, theme: Theme): Drawn {
  const places = placed(entries.map(({ label }) => label), width);
  const height = 6 + (max(places, ({ y, rows }) => y + ROW * (rows - 0.5)) ?? 0);
  return plain(Plot.plot({
    width, height, margin: 0, axis: null, x: { type: 'identity' }, y: { type: 'identity' },
    style: { background: 'none', color: theme.text, fontSize: '12px' },
    marks: entries.flatMap(({ label, color, dash, marker: symbol }, k) => {
      const { x, y, rows, letters } = places[k]!;
      return [
        dash ? Plot.ruleY([y], {
          x1: x, x2: x + 26, stroke: color, strokeWidth: 2, strokeDasharray: dash.join(' '),
        }) : null,
        symbol ? Plot.dot([y], { x: x + 13, y: [y], symbol, r: 4, fill: color, stroke: color }) : null,
        Plot.text([label], {
          x: x + KEY, y: [y], textAnchor: 'start', lineAnchor: 'top', dy: -7, lineHeight: ROW / 12,
          lineWidth: rows > 1 ? letters / 2 : Infinity, // in ems; some fonts are wider than Plot takes them for
        }),
      ];
    }),
  }));
}

/** Charts below each other as one picture with a title, on a ground of its own where it leaves the page. */
export function stacked(parts: SVGSVGElement[], title: string, ground?: string): SVGSVGElement {
  const whole = parts[0]!.cloneNode(false) as SVGSVGElement;
  const width = parts[0]!.width.baseVal.value;
  const bottoms = cumsum(parts, (part) => part.height.baseVal.value);
  const height = bottoms.at(-1)!;
  const set = <Made extends Element>(made: Made, attributes: Record<string, string | number>): Made => {
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    return made;
  };
  const add = (name: string, attributes: Record<string, string | number>, inside: Iterable<Node | string> = []): void =>
    whole.appendChild(set(document.createElementNS('http://www.w3.org/2000/svg', name), attributes)).append(...inside);
  set(whole, { height, viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': title });
  add('title', {}, [title]);
  if (ground) add('rect', { width, height, fill: ground, stroke: 'none' });
  parts.forEach((part, n) => add('g', { transform: `translate(0,${bottoms[n - 1] ?? 0})` }, [...part.childNodes]));
  return whole;
}
