// The chart of ε against the speed on the page: points fill in, the current one moves, a reader picks a speed.

import { least } from 'd3-array';
import { html } from 'lit-html';
import { rounded, withError, written } from '../drawing/numbers';
import { say } from '../drawing/words';
import { description } from '../inputs/lines';
import { drawCurves, speedUnitOf, speedsOf, type Curve, type CurveContent } from './curve_picture';
import { type ModelPoint, modelInWords } from './model_picture';
import { createPicker } from './picker';

type Current = NonNullable<CurveContent['current']>;

/** Makes an empty chart in an element; `pick` gets a speed that a reader has picked. */
export function createCurveChart(host: HTMLElement, pick: (speed: number) => void) {
  const content: CurveContent = { curves: [], current: undefined, ordinate: 'restitution', model: [] };
  const { update, picture } = createPicker(host, {
    title: say('curve.picture'),
    label: say('curve.pick'),
    words: now,
    draw: (width, theme) => drawCurves(content, width, theme),
    axis: () => ({ ...speedsOf(content), at: content.current?.speed }),
    rounded: (speed) => rounded(speed, 3), // which is what a place on a chart is good for
    note: (pointed) => (pointed === undefined ? [now(), toCome()].filter(Boolean).join('; ') : nearTo(pointed)),
    options(draw) {
      const choose = (event: Event): void => {
        content.ordinate = (event.target as HTMLInputElement).checked ? 'loss' : 'restitution';
        draw();
      };
      return html`<label><input type="checkbox" @change=${choose} />${say('curve.loss')}</label>`;
    },
  }, pick);

  function now(): string {
    return content.current ? inWords(content.current) : '';
  }

  function inWords({ speed, restitution, error }: Current): string {
    const unit = speedUnitOf(content);
    return say('curve.point', { speed: `${written(speed, 3)} ${unit}`, epsilon: withError(restitution, error) });
  }

  function toCome(): string {
    const left = content.curves.reduce((sum, { planned, points }) => sum + planned.length - points.length, 0);
    return left > 0 ? say(left === 1 ? 'curve.one_left' : 'curve.left', { left }) : '';
  }

  /** The points nearest to a speed, by the logarithm. */
  function nearTo(speed: number): string {
    const { curves, model } = content;
    const near = <Point extends { speed: number }>(points: readonly Point[]): Point | undefined =>
      least(points, (each) => Math.abs(Math.log(each.speed / speed)));
    const predicted = near(model);
    return [...curves.flatMap(({ encounter, points }) => {
      const point = near(points);
      return point ? [`${curves.length > 1 ? `${description(encounter)}, ` : ''}${inWords(point)}`] : [];
    }), ...(predicted ? [modelInWords(predicted)] : [])].join('; ');
  }

  return {
    /** With what a model adds to the first; none of what is not predicted. */
    setCurves(curves: Curve[], model: readonly ModelPoint[]): void {
      Object.assign(content, { curves, model });
      update();
    },
    /** Shows the point that the inputs stand for. */
    setCurrent(current: Current): void {
      content.current = current;
      update();
    },
    picture,
  };
}
