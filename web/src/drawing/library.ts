// Observable Plot, which draws the charts: larger than the rest of the page, so that a first value does not wait for it.
import type * as Marks from './marks';

/** Undefined until it is there: `hasPlot`. */
export let Plot: typeof Marks;

let wanted = false;
let loading: Promise<void> | undefined;
const waiting = new Set<() => void>();

/** Loads it; then what waits for it is drawn. Where it cannot be loaded, the next chart tries again. */
export function loadPlot(): Promise<void> {
  wanted = true;
  return (loading ??= import('./marks').then((marks) => {
    Plot = marks;
    for (const draw of waiting) draw();
    waiting.clear();
  }, () => void (loading = undefined)));
}

/** Whether it is there; if not, `draw` is called as soon as it is. */
export function hasPlot(draw: () => void): boolean {
  if (Plot) return true;
  waiting.add(draw);
  if (wanted) void loadPlot();
  return false;
}
