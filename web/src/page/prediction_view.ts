// The panel of real materials: ε as predicted beside that of elastic bodies, and what takes the energy.
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { thresholdsOf } from '../core/local';
import type { Channel, Encounter, Prediction } from '../core/protocol';
import { find } from '../drawing/dom';
import { bandInWords, significant, withError, withUnit, written } from '../drawing/numbers';
import { meetingOf, meetsBody } from '../inputs/document';
import type { Impact } from '../inputs/inputs';
import { argumentsOf, commandLine } from '../inputs/lines';

/** Where the energy goes, by the names of the core. */
const whereTo: Record<string, string> = {
  ringing: 'bodies vibrate', radiation: 'waves run away', material: 'inner friction', yield: 'plastic flow',
  adhesion: 'surfaces are torn apart',
};

/** Whether the page predicts it: a ball of a named material, without friction, that the core predicts. */
export function isPredicted({ encounter, friction }: Pick<Impact, 'encounter' | 'friction'>): boolean {
  return friction === 0 && meetingOf(encounter).first.solid !== undefined && thresholdsOf(encounter) !== undefined;
}

/** ε with as many digits as its largest uncertainty leaves, and all three of them: none holds another. */
export function uncertaintiesInWords({ quantities, influences }: Prediction): { value: string; uncertain: string } {
  const { restitution, by_models: models, by_constants: constants } = quantities;
  const [value, error] = [restitution?.value ?? NaN, restitution?.error ?? 0];
  const varied = influences.length > 0 || (constants?.value ?? 0) > 0;
  const all = [error, models?.value ?? 0, constants?.value ?? 0];
  const most = Math.max(...all);
  const [numerical, byModels, byConstants] = all.map((each) => written(each, 2));
  return {
    value: most > 0 ? bandInWords(value, value - most, value + most).value : significant(value, 3),
    uncertain: `± ${numerical} numerical, ± ${byModels} spread of models, `
      + (varied ? `± ${byConstants} constants` : 'constants taken as exact'),
  };
}

/** A share of the energy. */
export function shareInWords(share: number): string {
  const least = 1e-5;
  return share > 0 && share < least ? '< 0.001 %' : `${written(100 * share, 3)} %`;
}

/** The influence that matters most; '' without any. */
export function influenceInWords({ influences: [most], quantities }: Prediction): string {
  if (most === undefined || !(Math.abs(most.change) > 0)) return '';
  const [by, change] = [quantities.by_constants?.value ?? 0, most.change].map((each) => written(each, 2));
  const sign = most.change > 0 ? '+' : '';
  const constant = most.constant.replace(/^against\.(.*)/, '$1 of what it meets').replaceAll('_', ' ');
  return `± ${by} in all; ${constant} × ${significant(1 + most.uncertainty, 3)}: ${sign}${change}`;
}

/** @param longest the share of the longest bar */
function row({ name, share, model }: Channel, dominant: string, longest: number): TemplateResult {
  return html`<tr data-model=${model} ?data-dominant=${share > 0 && name === dominant}>
    <th scope="row">${name}<span>: ${whereTo[name]}</span></th><td>${model ? 'model' : 'computed'}</td>
    <td class="number">${shareInWords(share)}</td>
    <td class="bar" aria-hidden="true">${share > 0
      ? html`<span style="width: ${(100 * share) / longest}%"></span>` : nothing}</td>
  </tr>`;
}

const pair = (name: string, value: unknown, note: unknown = nothing): TemplateResult =>
  html`<div><dt>${name}</dt><dd>${value}</dd>${note === nothing ? note : html`<dd class="note">${note}</dd>`}</div>`;

/** The panel of a prediction. */
function panelOf(encounter: Encounter, prediction: Prediction): TemplateResult {
  const { quantities, channels, dominant, warnings } = prediction;
  const number = (name: keyof typeof quantities): number => quantities[name]?.value ?? NaN;
  const height = (name: keyof typeof quantities): string => withUnit(number(name), 'm');
  const { value, uncertain } = uncertaintiesInWords(prediction);
  const sticks = number('restitution') === 0;
  const longest = Math.max(...channels.map(({ share }) => share));
  const { yield: yields, sticking } = thresholdsOf(encounter) ?? { yield: undefined, sticking: 0 };
  const influence = influenceInWords(prediction);
  const alone = quantities.restitution_without_models;
  return html`
    <dl class="quantities">
      ${pair('ε as predicted', html`<b id="predicted">${value}</b>`, html`${uncertain}${sticks ? ': they stick' : ''}`)}
      ${pair('ε without yield and adhesion', alone ? withError(alone.value, alone.error ?? 0) : '–',
        'waves and the material, with one Q at all frequencies')}
      ${meetsBody(encounter) ? nothing
        : pair('Height of rebound', height('rebound_height'), `of a drop from ${height('drop_height')}`)}
      ${pair('Contact time', Number.isFinite(number('contact_time')) ? withUnit(number('contact_time'), 's') : '–')}
      ${yields === undefined ? nothing : pair('Yields above', `${significant(yields, 2)} m/s`)}
      ${sticking > 0 ? pair('Sticks below', `${written(sticking, 2)} m/s`) : nothing}
    </dl>
    <table class="channels">
      <caption>Share of the energy${longest > 0 ? html`, most of it to <b>${dominant}</b>` : nothing}</caption>
      <tbody>${channels.map((each) => row(each, dominant, longest))}</tbody>
    </table>
    ${influence ? html`<p class="note">The constants are not known exactly. ε: ${influence}.</p>` : nothing}
    <ul class="warnings">${warnings.map((each) => html`<li>${each}</li>`)}</ul>
    <div class="lines"><pre tabindex="0" role="group" aria-label="Command line of the prediction"><code>${
      commandLine(argumentsOf(encounter, [prediction.speed], 'predict'))}</code></pre></div>`;
}

/** Wire the panel of index.html. */
export function createPredictionView() {
  const panel = find('prediction', HTMLElement);
  const content = find('prediction-content', HTMLElement);
  const state = find('prediction-state', HTMLElement);
  let empty = true;
  const say = (line: string): void => {
    state.textContent = line;
    state.hidden = line === '';
  };
  return {
    /** Before a prediction of inputs, or none. */
    begin(inputs: Pick<Impact, 'encounter' | 'friction'>): void {
      panel.hidden = !isPredicted(inputs);
      if (panel.hidden) empty = true;
      if (empty) render(nothing, content);
      content.dataset.stale = '';
      say(empty ? 'computing' : '');
    },
    show(encounter: Encounter, prediction: Prediction): void {
      empty = false;
      delete content.dataset.stale;
      say('');
      render(panelOf(encounter, prediction), content);
    },
    /** One line: why there is none. */
    fail(line: string): void {
      empty = true;
      render(nothing, content);
      say(line);
    },
  };
}
