// The charts of one collision in time as one SVG.

import type { Collision } from '../core/protocol';
import { across, axes, legend, up, type Box } from '../drawing/axes';
import { element, pathThrough, svgDocument } from '../drawing/svg';
import { look, type Theme } from '../drawing/theme';
import { unitInWords } from '../drawing/ticks';
import { panelLabel, panelsOf, thinned } from './series';

const HEIGHTS = [130, 130, 190];
const LEFT = 66;
const RIGHT = 16;
const GAP = 34;

/** Force, velocity and energies above each other. */
export function timeSvg(collision: Collision, width: number, theme: Theme): string {
  const x = {
    scale: { low: collision.time[0] ?? 0, high: collision.time[collision.time.length - 1] ?? 1, log: false },
    label: `time since first contact (${unitInWords(collision.units.time)})`,
  };
  const panels = panelsOf(collision);
  const parts: string[] = [];
  let top = 28;
  panels.forEach((panel, n) => {
    const box: Box = { left: LEFT, top, width: width - LEFT - RIGHT, height: HEIGHTS[n]! };
    const y = { scale: { low: panel.low, high: panel.high, log: false }, label: panelLabel(panel) };
    const last = n === panels.length - 1;
    parts.push(axes(box, x, y, theme, last));
    panel.series.forEach(({ values }, k) => {
      const thin = thinned(collision.time, values, box.width);
      const { color, dash } = look(k, theme);
      parts.push(element('path', {
        d: pathThrough(thin.x.map((each) => across(box, x.scale, each)), thin.y.map((each) => up(box, y.scale, each))),
        fill: 'none', stroke: color, 'stroke-width': 1.8, 'stroke-linejoin': 'round',
        'stroke-dasharray': dash.join(' ') || undefined,
      }));
    });
    top += box.height + GAP;
  });
  const entries = panels[2]!.series.map(({ label }, k) => ({ label, look: look(k, theme), line: true, marker: false }));
  const [key, height] = legend(entries, LEFT, top + 20, width - LEFT - RIGHT, theme);
  return svgDocument(width, top + 20 + height, 'Force, velocity and energies in time', theme.background,
    parts.join('') + key);
}
