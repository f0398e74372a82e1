// One chart in time, drawn by uPlot, with a cursor line of its own.

import uPlot from 'uplot';
import { linearTicks } from '../drawing/ticks';
import { look, type Theme } from '../drawing/theme';
import { panelLabel, type Panel } from './series';

export interface TimePlot {
  setCursor(time: number): void;
  /** The time at a place of the window, within those shown. */
  timeAt(clientX: number): number;
  over: HTMLElement;
  destroy(): void;
}

const AXIS = 62; // width of the vertical axis: the same in all, so that times stand above each other

/** Makes a chart. `lowest`: it has the axis of time. */
export function createTimePlot(
  host: HTMLElement, time: Float64Array, timeLabel: string, panel: Panel, height: number, width: number,
  lowest: boolean, theme: Theme,
): TimePlot {
  const font = '12px system-ui, sans-serif';
  const common = { stroke: theme.muted, font, grid: { stroke: theme.line, width: 0.7 } };
  const ticks = { stroke: theme.muted, width: 0.8, size: 5 };
  const [first, last] = [time[0] ?? 0, time[time.length - 1] ?? 1];
  let cursor = NaN;
  const line = document.createElement('div');
  line.className = 'chart-cursor';
  const place = (): void => {
    const x = plot.valToPos(cursor, 'x');
    line.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    line.style.transform = `translateX(${x}px)`;
  };
  const plot: uPlot = new uPlot({
    width, height,
    padding: [8, 14, lowest ? 0 : 6, 0],
    cursor: { show: false },
    legend: { show: false },
    hooks: { draw: [() => place()] }, // only then has the chart its size
    scales: { x: { time: false, range: [first, last] }, y: { range: [panel.low, panel.high] } },
    axes: [
      {
        ...common, ticks, size: lowest ? 24 : 8, gap: 3, labelFont: font, labelSize: 20, labelGap: 0,
        ...(lowest ? { label: timeLabel } : {}),
        splits: (self) => linearTicks(first, last, self.bbox.width / devicePixelRatio / 55).map((each) => each.value),
        values: (_self, splits) => splits.map((each) => (lowest ? labelOf(splits, each) : '')),
      },
      {
        ...common, ticks, size: AXIS, gap: 3,
        splits: () => linearTicks(panel.low, panel.high, height / 28).map((each) => each.value),
        values: (_self, splits) => splits.map((each) => labelOf(splits, each)),
      },
    ],
    series: [
      {},
      ...panel.series.map(({ label }, k) => {
        const { color, dash } = look(k, theme);
        const dense = dash.map((each) => each * devicePixelRatio);
        return { label, stroke: color, width: 1.8, dash: dense, points: { show: false }, pxAlign: 0 };
      }),
    ],
  }, [time, ...panel.series.map((each) => each.values)] as unknown as uPlot.AlignedData, host);
  plot.root.setAttribute('aria-hidden', 'true');
  plot.root.title = panelLabel(panel);
  plot.over.append(line);
  return {
    over: plot.over,
    setCursor(at) {
      cursor = at;
      place();
    },
    timeAt(clientX) {
      const bounds = plot.over.getBoundingClientRect();
      const share = Math.min(1, Math.max(0, (clientX - bounds.left) / bounds.width));
      const { min, max } = plot.scales['x']!;
      return min! + share * (max! - min!);
    },
    destroy: () => plot.destroy(),
  };
}

function labelOf(splits: number[], value: number): string {
  if (splits.length < 2) return String(value);
  const ticks = linearTicks(splits[0]!, splits[splits.length - 1]!, splits.length);
  const near = 1e-6 * (splits[1]! - splits[0]!);
  return ticks.find((each) => Math.abs(each.value - value) < near)?.label ?? '';
}
