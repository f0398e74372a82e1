// Colours, dashes and markers of every picture, and the reader's wishes: dark or light, motion or none.

const NAMES = ['text', 'muted', 'line', 'background', 'panel', 'accent'] as const;

/** Colours of one picture, concrete: a picture that is downloaded has them too. */
export type Theme = Record<(typeof NAMES)[number], string> & { dark: boolean };

/** How one of several curves looks: no two share a colour, a dash or a marker. */
export interface Look {
  color: string;
  dash: number[];
  marker: Marker;
}

export type Marker = 'circle' | 'square' | 'triangle' | 'diamond' | 'star' | 'times';

const DASHES: number[][] = [[], [6, 3], [2, 3], [8, 3, 2, 3], [12, 3], [4, 2, 1, 2, 1, 2]];
const MARKERS: Marker[] = ['circle', 'square', 'triangle', 'diamond', 'star', 'times'];
// Okabe and Ito's; the first two a little lighter on a dark ground, where they would have too little contrast.
const ON_LIGHT = ['#0072b2', '#d55e00', '#009e73', '#b8608f', '#b37a00', '#2f8fc4'];
const ON_DARK = ['#56b4e9', '#ff8a3d', '#2fc79b', '#e59fc4', '#e69f00', '#8fc7ff'];

/** The look of curve number `index`. */
export function look(index: number, theme: Theme): Look {
  const colors = theme.dark ? ON_DARK : ON_LIGHT;
  const k = index % colors.length;
  return { color: colors[k]!, dash: DASHES[k]!, marker: MARKERS[k]! };
}

/** The theme where an element stands: the custom properties of style.css. */
export function readTheme(element: Element): Theme {
  const style = getComputedStyle(element);
  const colors = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  return { ...colors as Omit<Theme, 'dark'>, dark: matchMedia('(prefers-color-scheme: dark)').matches };
}

/** Whether the reader has asked for less motion. */
export function motionIsReduced(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
