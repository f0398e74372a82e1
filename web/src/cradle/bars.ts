// Velocities after a collision as bars: of each ball what is computed, with its error, beside what rules say.
import { html, render } from 'lit-html';
import { Plot } from '../drawing/library';
import { chartIn } from '../drawing/pictures';
import { type Drawn, draw, drawLegend, stacked } from '../drawing/plot';
import { type Theme, look } from '../drawing/theme';
import { say } from '../drawing/words';

/** Velocities of all balls by one account, over the speed at the bottom. */
export interface Account {
  label: string;
  velocities: readonly number[];
  errors?: readonly number[];
}

interface Bar {
  ball: number;
  account: number;
  velocity: number;
  error: number;
}

const SLOW = 0.25; // velocities below it are shown again, enlarged
const SHARE = 0.8; // of the room of a ball is for its bars
const HEIGHT = 190;
const LOW = 120;

/** Balls that are slow by all accounts, where there are others. */
export function slowBalls(accounts: readonly Account[]): number[] {
  const all = accounts[0]!.velocities.map((_, ball) => ball);
  const slow = all.filter((ball) => accounts.every(({ velocities }) => Math.abs(velocities[ball]!) < SLOW));
  const moves = slow.some((ball) => accounts.some(({ velocities }) => velocities[ball] !== 0));
  return moves && slow.length < all.length ? slow : [];
}

function axes(bars: readonly Bar[], label: string) {
  const ends = bars.flatMap(({ velocity, error }) => [velocity - error, velocity + error]);
  const [low, high] = [Math.min(0, ...ends), Math.max(0, ...ends)];
  const margin = 0.06 * (high - low || 1);
  return { low: low < 0 ? low - margin : 0, high: high + margin, log: false, label };
}

/** Makes an empty chart in an element. */
export function createBars(host: HTMLElement, title: string) {
  let [accounts, names] = [[] as readonly Account[], [] as readonly string[]];

  function chart(balls: readonly number[], height: number, label: string, bottom: boolean, width: number, theme: Theme): Drawn {
    const each = SHARE / accounts.length;
    const bars = accounts.flatMap(({ velocities, errors }, account): Bar[] => balls.map((ball) =>
      ({ ball, account, velocity: velocities[ball]!, error: errors?.[ball] ?? 0 })));
    const left = ({ ball, account }: Bar): number => ball - SHARE / 2 + account * each;
    return draw({
      width, height, bottom, x: { low: -0.5, high: names.length - 0.5, log: false, label: say('cradle.balls') },
      y: axes(bars, label), ticks: { places: names.map((_, ball) => ball), words: (ball) => names[ball] ?? '' },
      marks: [
        Plot.rect(bars, {
          x1: (bar: Bar) => left(bar) + 0.04 * each, x2: (bar: Bar) => left(bar) + 0.96 * each, y1: 0, y2: 'velocity',
          fill: ({ account }: Bar) => look(account, theme).color,
        }),
        Plot.ruleX(bars.filter(({ error }) => error > 0), {
          x: (bar: Bar) => left(bar) + each / 2, y1: ({ velocity, error }: Bar) => velocity - error,
          y2: ({ velocity, error }: Bar) => velocity + error, stroke: theme.text, strokeWidth: 2,
        }),
        Plot.ruleY([0], { stroke: theme.muted }),
      ],
    }, theme);
  }

  const { update, picture } = chartIn(host, title, (width, theme) => {
    if (accounts.length === 0) return [];
    const slow = slowBalls(accounts);
    return [
      drawLegend(accounts.map(({ label }, account) => ({ label, color: look(account, theme).color, marker: 'square' })), width, theme),
      chart(names.map((_, ball) => ball), HEIGHT, say('cradle.axis'), slow.length === 0, width, theme),
      ...(slow.length > 0 ? [chart(slow, LOW, say('cradle.enlarged'), true, width, theme)] : []),
    ];
  }, (parts) => render(html`<div class="chart"><div class="chart-area">${stacked(parts, title)}</div></div>`, host));

  return {
    show(next: readonly Account[], called: readonly string[]): void {
      [accounts, names] = [next, called];
      update();
    },
    picture,
  };
}
