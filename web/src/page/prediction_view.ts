// The panel of real materials: ε as predicted beside that of elastic bodies, and what takes the energy.
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { thresholdsOf } from '../core/local';
import type { Channel, Encounter, Prediction } from '../core/protocol';
import { find } from '../drawing/dom';
import { type Word, say } from '../drawing/words';
import { bandInWords, significant, withError, withUnit, written } from '../drawing/numbers';
import { meetingOf, meetsBody } from '../inputs/document';
import type { Impact } from '../inputs/inputs';
import { commandLine, dropArguments } from '../inputs/lines';

/** Whether the page predicts it: a ball of a named material, without friction, that the core predicts. */
export function isPredicted({ encounter, friction }: Pick<Impact, 'encounter' | 'friction'>): boolean {
  return friction === 0 && meetingOf(encounter).first.solid !== undefined && thresholdsOf(encounter) !== undefined;
}

const ROUNDING = 1e-9; // a spread below this is none

/** ε and the height of rebound, with the digits that the largest of their uncertainties leaves; and all three of them
 *  for ε, of which none holds another. */
export function uncertaintiesInWords({ quantities, influences }: Prediction) {
  const { restitution, by_models: models, by_constants: constants, rebound_height: rebound } = quantities;
  const [value, error] = [restitution?.value ?? NaN, restitution?.error ?? 0];
  const varied = influences.length > 0 || (constants?.value ?? 0) > 0;
  const all = [error, models?.value ?? 0, constants?.value ?? 0];
  const most = Math.max(...all);
  const [numerical, byModels, byConstants] =
    all.map((each) => `± ${written(each < ROUNDING ? 0 : each, 2)}`) as [string, string, string];
  return {
    value: most > 0 ? bandInWords(value, value - most, value + most).value : significant(value, 3),
    rebound: heightInWords(rebound?.value ?? NaN, Math.min(4, Math.max(2, 1 + Math.ceil(Math.log10(value / (2 * most)))))),
    numerical, byModels, byConstants: varied ? byConstants : say('prediction.exact'),
  };
}

/** A prediction for screen readers. */
export function spokenOf(prediction: Prediction): string {
  const { value, rebound, numerical, byModels, byConstants } = uncertaintiesInWords(prediction);
  const error = say('spoken.error');
  const [a, b, c] = [numerical, byModels, byConstants].map((each) => each.replace('±', error)) as [string, string, string];
  return say('spoken.prediction', { value, rebound, numerical: a, models: b, constants: c });
}

/** A height of a drop, as a ruler shows it. */
export function heightInWords(height: number, digits = 3): string {
  const [size, unit] = height >= 1 ? [1, 'm'] : height >= 0.01 ? [0.01, 'cm'] : [0.001, 'mm'];
  return `${written(height / size, digits)}\u00a0${unit}`;
}

/** A share of the energy. */
export function shareInWords(share: number): string {
  const least = 1e-5;
  return share > 0 && share < least ? '< 0.001\u00a0%' : `${written(100 * share, 3)}\u00a0%`;
}

/** The influence that matters most; '' without any. */
export function influenceInWords({ influences: [most], quantities }: Prediction): string {
  if (most === undefined || !(Math.abs(most.change) > 0)) return '';
  const [by, change] = [quantities.by_constants?.value ?? 0, most.change].map((each) => written(each, 2)) as [string, string];
  const own = most.constant.replace('against.', '');
  const name = say(`constant.${own}` as Word);
  return say('prediction.influence', {
    by, factor: significant(1 + most.uncertainty, 3), change: most.change > 0 ? `+${change}` : change,
    constant: own === most.constant ? name : say('check.second', { name }),
  });
}

/** @param longest the share of the longest bar */
function row({ name, share, model }: Channel, dominant: string, longest: number): TemplateResult {
  return html`<tr data-channel=${name} data-model=${model} ?data-dominant=${share > 0 && name === dominant}>
    <th scope="row"><i aria-hidden="true"></i>${say(`channel.${name}` as Word)}<span>: ${say(`where.${name}` as Word)}</span></th>
    <td>${say(model ? 'prediction.modelled' : 'prediction.computed')}</td>
    <td class="number">${shareInWords(share)}</td>
    <td class="bar" aria-hidden="true">${share > 0
      ? html`<span style="width: ${(100 * share) / longest}%"></span>` : nothing}</td>
  </tr>`;
}

/** The whole energy as one bar: what comes back, and what takes the rest. */
function energyBar(back: number, channels: readonly Channel[]): TemplateResult {
  const parts = [{ name: 'rebound', share: back, model: false }, ...channels].filter(({ share }) => share > 0);
  return html`<p id="energy-back">${say('prediction.back', { share: shareInWords(back) })}</p>
    <div class="energy" aria-hidden="true">${parts.map(({ name, share, model }) =>
      html`<span data-channel=${name} data-model=${model} style="flex-grow: ${share}"></span>`)}</div>`;
}

const pair = (name: Word, value: unknown, note: unknown = nothing): TemplateResult =>
  html`<div><dt>${say(name)}</dt><dd>${value}</dd>${note === nothing ? note : html`<dd class="note">${note}</dd>`}</div>`;

/** The panel of a prediction. */
function panelOf(encounter: Encounter, prediction: Prediction): TemplateResult {
  const { quantities, channels, dominant, warnings, speed } = prediction;
  const number = (name: keyof typeof quantities): number => quantities[name]?.value ?? NaN;
  const { value, rebound, numerical, byModels, byConstants } = uncertaintiesInWords(prediction);
  const restitution = number('restitution');
  const longest = Math.max(...channels.map(({ share }) => share));
  const { yield: yields, sticking } = thresholdsOf(encounter) ?? { yield: undefined, sticking: 0 };
  const influence = influenceInWords(prediction);
  const alone = quantities.restitution_without_models;
  return html`
    <p class="value"><span class="unseen">${say('result.epsilon')}</span><span class="symbol" aria-hidden="true">ε</span>
      <b id="predicted">${value}</b> ${restitution === 0 ? say('prediction.sticks') : nothing}</p>
    <dl class="quantities uncertainties" aria-label=${say('prediction.uncertainties')}>
      ${pair('prediction.numerical', numerical)} ${pair('prediction.models', byModels)}
      ${pair('prediction.constants', byConstants)}
    </dl>
    <dl class="quantities">
      ${meetsBody(encounter) ? pair('prediction.speed', withUnit(speed, 'm/s'), say('prediction.both'))
        : pair('prediction.rebound', html`<b id="predicted-height">${rebound}</b>`,
          say('prediction.drop', { height: heightInWords(number('drop_height')), speed: withUnit(speed, 'm/s') }))}
      ${pair('prediction.alone', alone ? withError(alone.value, alone.error ?? 0) : '–', say('prediction.alone_note'))}
      ${pair('result.contact_time', Number.isFinite(number('contact_time')) ? withUnit(number('contact_time'), 's') : '–')}
      ${yields === undefined ? nothing : pair('prediction.yields', withUnit(yields, 'm/s', 2))}
      ${sticking > 0 ? pair('prediction.sticking', withUnit(sticking, 'm/s', 2)) : nothing}
    </dl>
    ${energyBar(restitution ** 2, channels)}
    <table class="channels">
      <caption>${longest > 0 ? say('prediction.most', { channel: say(`channel.${dominant}` as Word) })
        : say('prediction.shares')}</caption>
      <tbody>${channels.map((each) => row(each, dominant, longest))}</tbody>
    </table>
    ${influence ? html`<p class="note">${influence}</p>` : nothing}
    <ul class="warnings">${warnings.map((each) => html`<li>${each}</li>`)}</ul>
    <div class="lines"><pre tabindex="0" role="group" aria-label=${say('prediction.command')}><code>${
      commandLine(dropArguments(encounter, speed))}</code></pre></div>`;
}

/** Wire the panel of index.html. */
export function createPredictionView() {
  const panel = find('prediction', HTMLElement);
  const content = find('prediction-content', HTMLElement);
  const state = find('prediction-state', HTMLElement);
  let empty = true;
  const tell = (line: string): void => {
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
      tell(empty ? say('result.computing') : '');
    },
    /** What is shown belongs to earlier inputs. */
    stale: (): void => void (content.dataset.stale = ''),
    show(encounter: Encounter, prediction: Prediction): void {
      empty = false;
      delete content.dataset.stale;
      tell('');
      render(panelOf(encounter, prediction), content);
    },
    /** One line: why there is none. */
    fail(line: string): void {
      empty = true;
      render(nothing, content);
      tell(line);
    },
  };
}
