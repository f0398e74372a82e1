// What is computed of a row, as tables, charts and a few words.
import { html, nothing, render, type TemplateResult } from 'lit-html';
import type { Numbers, RowCollision } from '../core/protocol';
import { find } from '../drawing/dom';
import { withError, withUnit, written } from '../drawing/numbers';
import { say } from '../drawing/words';
import { shareInWords } from '../page/prediction_view';
import { type Account, createBars } from './bars';
import { type CradleInputs, massesOf, speedAt, speedsOf } from './inputs';
import { pairwise, textbook } from './rules';

/** Velocities of a collision with their errors, in m/s: to the right, or up. */
export function velocitiesOf({ scene }: CradleInputs, { bodies }: Pick<RowCollision, 'bodies'>) {
  const sign = scene === 'drop' ? -1 : 1;
  const its = (each: Numbers) => each.velocity_after_si ?? { value: NaN, error: NaN };
  return { values: bodies.map((each) => sign * its(each).value), errors: bodies.map((each) => its(each).error ?? 0) };
}

/** ε of neighbours as pairs, and of the lower ball on the floor. */
export interface Epsilons {
  pair: number;
  floor?: number;
}

/** What is computed of a collision, and what the rules say, over the speed at the bottom.
 *  @param speeds before, to the right or down, m/s */
export function accountsOf(
  inputs: CradleInputs, collision: RowCollision, { pair, floor }: Epsilons, speeds: readonly number[] = speedsOf(inputs),
): Account[] {
  const unit = speedAt(inputs);
  const sign = inputs.scene === 'drop' ? -1 : 1;
  const share = (velocities: readonly number[], by = sign): number[] => velocities.map((each) => (by * each) / unit + 0);
  const points = { masses: massesOf(inputs), speeds, restitution: pair, ...(floor === undefined ? {} : { wall: floor }) };
  const { values, errors } = velocitiesOf(inputs, collision);
  return [
    { label: say('cradle.computed'), velocities: share(values, 1), errors: errors.map((each) => each / unit) },
    { label: say('cradle.textbook'), velocities: share(textbook(points)) },
    { label: say('cradle.pairwise'), velocities: share(pairwise(points)) },
  ];
}

/** Names of the balls. */
export function ballsOf({ scene, balls }: CradleInputs): string[] {
  return scene === 'drop' ? [say('cradle.upper'), say('cradle.lower')] : Array.from({ length: balls }, (_, k) => String(k + 1));
}

const ROUNDING = 1e-9; // of the speed: what is below is 0

function table(caption: string, names: readonly string[], accounts: readonly Account[]): TemplateResult {
  const number = ({ velocities, errors }: Account, ball: number): string => {
    const value = Math.abs(velocities[ball]!) < ROUNDING ? 0 : velocities[ball]!;
    return errors ? withError(value, errors[ball]!).replace('-', '−') : written(value, 4);
  };
  return html`<table class="velocities"><caption>${caption}</caption>
    <thead><tr><th scope="col">${say('cradle.ball')}</th>${accounts.map(({ label }) => html`<th scope="col">${label}</th>`)}</tr></thead>
    <tbody>${names.map((name, ball) => html`<tr><th scope="row">${name}</th>${accounts.map((each) =>
      html`<td>${number(each, ball)}</td>`)}</tr>`)}</tbody></table>`;
}

/** What a reader should know of a collision, one line each. */
function warningsOf({ converged, reason, beyondSmallStrain, materialWarnings }: RowCollision): string[] {
  return [
    ...materialWarnings.map((line) => `${line.charAt(0).toUpperCase()}${line.slice(1)}.`),
    converged ? '' : say('result.inaccurate', { why: reason }),
    beyondSmallStrain ? say('cradle.strain') : '',
  ].filter(Boolean);
}

function factsOf(its: RowCollision, left?: number): TemplateResult {
  const number = (name: keyof Numbers): number => its.quantities[name]?.value ?? NaN;
  const pair = (name: string, value: string): TemplateResult => html`<div><dt>${name}</dt><dd>${value}</dd></div>`;
  return html`<dl class="quantities">
    ${left === undefined ? pair(say('cradle.duration'), withUnit(number('duration_si'), 's')) : pair(say('cradle.left'), shareInWords(left))}
    ${pair(say('cradle.translation'), shareInWords(number('translation')))}
    ${pair(say('cradle.vibrating'), shareInWords(number('vibration')))}
    ${pair(say('cradle.heat'), shareInWords(number('dissipated')))}</dl>`;
}

/** Wire one of the two panels of cradle.html, `after` and `again`. */
export function createPanel(id: 'after' | 'again', title: string) {
  const host = find(`${id}-table`, HTMLElement);
  const bars = createBars(find(`${id}-bars`, HTMLElement), title);
  const panel = find(id, HTMLElement);
  return {
    stale: (): void => void (panel.dataset.stale = ''),
    hide: (): void => void (panel.hidden = true),
    show(inputs: CradleInputs, collision: RowCollision, accounts: readonly Account[], left?: number): void {
      panel.hidden = false;
      delete panel.dataset.stale;
      const names = ballsOf(inputs);
      const caption = say(inputs.scene === 'drop' ? 'cradle.caption_drop' : 'cradle.caption', { speed: withUnit(speedAt(inputs), 'm/s') });
      const warnings = warningsOf(collision);
      render(html`${table(caption, names, accounts)} ${factsOf(collision, left)}
        ${warnings.length > 0 ? html`<ul class="warnings">${warnings.map((line) => html`<li>${line}</li>`)}</ul>` : nothing}`, host);
      bars.show(accounts, names);
    },
  };
}
