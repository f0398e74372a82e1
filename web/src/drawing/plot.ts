// Charts that Observable Plot draws: one description for the page and for the file that leaves it.
import * as Plot from '@observablehq/plot';
import { scaleLinear, scaleLog } from 'd3-scale';
import { powerOfTen, written } from './numbers';
import type { Look, Theme } from './theme';

export interface Axis {
  low: number;
  high: number;
  log: boolean;
  label: string;
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
  marks: Plot.Markish[];
}

export type Drawn = SVGSVGElement & Plot.Plot;

const MARGIN = { left: 62, right: 14, top: 30, bottom: 46 };

/** Pixels of a chart beside what it shows. */
export const BESIDE = MARGIN.left + MARGIN.right;

/** The least width of a chart that leaves the page. */
export const WIDTH = 480;

const PITCH = 64; // pixels for the number of a tick along x
const RISE = 30; // and along y

/** Round numbers along an axis of some length in pixels; of a logarithmic one only some have a name. */
export function ticksOf({ low, high, log }: Axis, length: number, pitch: number): Ticks {
  const count = Math.max(2, Math.floor(length / pitch));
  if (!log) {
    const scale = scaleLinear([low, high], [0, 1]);
    const usual = scale.tickFormat(count);
    const plain = Math.max(Math.abs(low), Math.abs(high)) < 1e5 && high - low > 1e-3;
    return { places: scale.ticks(count), words: plain ? (each) => (each === 0 ? '0' : usual(each)) : written };
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

/** Draws marks in a frame of axes. */
export function draw({ width, height, x, y, ticks, bottom = true, top = true, marks }: Chart, theme: Theme): Drawn {
  const margin = { ...MARGIN, ...(bottom ? {} : { bottom: 8 }), ...(top ? {} : { top: 8 }) };
  const [across, up] = [ticks ?? ticksOf(x, width - BESIDE, PITCH), ticksOf(y, height, RISE)];
  const named = ({ places, words }: Ticks): number[] => places.filter((each) => words(each) !== '');
  const line = { stroke: theme.line, strokeOpacity: 1, strokeWidth: 0.7 };
  const numbers = { fill: theme.muted, stroke: theme.muted, strokeWidth: 0.8, label: null };
  return Plot.plot({
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
      bottom ? Plot.text([x.label], { frameAnchor: 'bottom', dy: 38 }) : null,
      top ? Plot.text([y.label], { frameAnchor: 'top-left', dy: -18 }) : null,
      Plot.frame({ anchor: 'left', stroke: theme.muted }),
      Plot.frame({ anchor: 'bottom', stroke: theme.muted }),
      ...marks,
    ],
  }) as Drawn;
}

export interface Entry {
  label: string;
  look: Look;
  line: boolean;
  marker: boolean;
}

const KEY = 32; // pixels of a line or marker before its label
const LETTER = 6.7;
const ROW = 18;

/** Words in rows of at most so many letters, as far as single words allow. */
function wrapped(words: string, letters: number): string[] {
  const rows: string[] = [];
  for (const word of words.split(' ')) {
    const last = rows.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= letters) rows[rows.length - 1] = `${last} ${word}`;
    else rows.push(word);
  }
  return rows;
}

/** Where the entries of a legend stand, in rows that are not wider than `width`. */
export function placed(entries: Entry[], width: number): (Entry & { x: number; y: number; rows: string[] })[] {
  let [x, y] = [MARGIN.left, ROW / 2];
  return entries.map((entry) => {
    const rows = wrapped(entry.label, Math.floor((width - MARGIN.left - KEY) / LETTER));
    const wide = KEY + LETTER * Math.max(...rows.map((row) => row.length)) + 12;
    if (x > MARGIN.left && x + wide > width) [x, y] = [MARGIN.left, y + ROW];
    const place = { ...entry, x, y, rows };
    x += wide;
    if (rows.length > 1) [x, y] = [width, y + ROW * (rows.length - 1)];
    return place;
  });
}

/** Draws a legend. */
export function drawLegend(entries: Entry[], width: number, theme: Theme): Drawn {
  const all = placed(entries, width);
  const height = Math.max(...all.map(({ y, rows }) => y + ROW * (rows.length - 0.5)), 0) + 6;
  return Plot.plot({
    width, height, margin: 0, axis: null, x: { type: 'identity' }, y: { type: 'identity' },
    style: { background: 'none', color: theme.text, fontSize: '12px' },
    marks: all.flatMap(({ x, y, rows, look, line, marker }) => [
      line ? Plot.link([x], {
        x1: x, x2: x + 26, y1: y, y2: y, stroke: look.color, strokeWidth: 2, strokeDasharray: look.dash.join(' '),
      }) : null,
      marker ? Plot.dot([x], { x: x + 13, y, symbol: look.marker, r: 4, fill: look.color, stroke: look.color }) : null,
      Plot.text([rows.join('\n')], {
        text: (each: string) => each, x: x + KEY, y: y + (ROW / 2) * (rows.length - 1), textAnchor: 'start',
        lineHeight: ROW / 12,
      }),
    ]),
  }) as Drawn;
}

/** Charts below each other as one picture with a title, on a ground of its own where it leaves the page. */
export function stacked(parts: SVGSVGElement[], title: string, ground?: string): SVGSVGElement {
  const whole = parts[0]!.cloneNode(false) as SVGSVGElement;
  const add = (name: string, attributes: Record<string, string | number>, inside: ChildNode[] | string): void => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    element.append(...inside);
    whole.append(element);
  };
  const width = parts[0]!.width.baseVal.value;
  const height = parts.reduce((sum, part) => sum + part.height.baseVal.value, 0);
  add('title', {}, title);
  if (ground) add('rect', { width, height, fill: ground, stroke: 'none' }, '');
  let top = 0;
  for (const part of parts) {
    add('g', { transform: `translate(0,${top})` }, [...part.childNodes]);
    top += part.height.baseVal.value;
  }
  const attributes = { height, viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': title };
  for (const [key, value] of Object.entries(attributes)) whole.setAttribute(key, String(value));
  return whole;
}
