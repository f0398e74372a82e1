// Which modes have a bar, and where it stands.

import type { Collision, ModeEnergy } from '../core/protocol';

export type When = 'after' | 'average';

export interface ModeBar {
  mode: ModeEnergy;
  energy: number;
  /** place and width along the axis, as shares of it */
  left: number;
  width: number;
}

export interface ModeGroup {
  order: number;
  center: number;
}

export interface ModeLayout {
  bars: ModeBar[];
  groups: ModeGroup[];
  /** modes without a bar, and what they hold together */
  omitted: number;
  rest: number;
}

const GAP = 0.7; // between groups, in bars

/** The modes of a body with the most energy, at most `count`, in groups of their orders n. */
export function layoutModes(modes: ModeEnergy[], body: 0 | 1, when: When, count: number): ModeLayout {
  const all = modes.filter((each) => each.body === body && each[when] > 0);
  const greatest = [...all].sort((a, b) => b[when] - a[when]).slice(0, count);
  const rest = all.reduce((sum, each) => sum + each[when], 0) - greatest.reduce((sum, each) => sum + each[when], 0);
  const shown = greatest.sort((a, b) => a.order - b.order || a.index - b.index);
  const orders = [...new Set(shown.map((each) => each.order))];
  const pitch = 1 / Math.max(1, shown.length + GAP * orders.length);
  const bars: ModeBar[] = [];
  const groups: ModeGroup[] = [];
  let at = 0;
  for (const order of orders) {
    at += 0.5 * GAP * pitch;
    const begin = at;
    for (const mode of shown.filter((each) => each.order === order)) {
      bars.push({ mode, energy: mode[when], left: at, width: pitch });
      at += pitch;
    }
    groups.push({ order, center: 0.5 * (begin + at) });
    at += 0.5 * GAP * pitch;
  }
  return { bars, groups, omitted: all.length - shown.length, rest: Math.max(0, rest) };
}

/** The vibration after the impact that is in no mode of a body: of a half-space its waves. */
export function energyOfWaves({ vibration, modes }: Pick<Collision, 'vibration' | 'modes'>): number {
  const inside = modes.reduce((sum, each) => sum + each.after, 0);
  return Math.max(0, vibration[vibration.length - 1]! - inside);
}
