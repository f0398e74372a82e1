// The worksheet of a lesson: what a real ball is, room for what a class measures, the prediction, and some questions. It
// is what the view of a real ball prints.
import { html, render } from 'lit-html';
import type { Encounter, Prediction } from '../core/protocol';
import { find } from '../drawing/dom';
import { withUnit } from '../drawing/numbers';
import { type Word, say } from '../drawing/words';
import { toAddress } from '../inputs/address';
import { meetingOf, meetsBody } from '../inputs/document';
import type { Inputs } from '../inputs/inputs';
import { heightInWords, shareInWords, uncertaintiesInWords } from './prediction_view';

const RUNS = 5;
const questions = ['worksheet.question1', 'worksheet.question2', 'worksheet.question3', 'worksheet.question4'] as const;
const columns = ['worksheet.run', 'worksheet.from', 'worksheet.to', 'worksheet.ratio'] as const;

/** What falls, and on what. */
function partsOf(encounter: Encounter) {
  const { against, first, second } = meetingOf(encounter);
  const ball = say('worksheet.ball', { material: first.solid!.name, diameter: withUnit(2 * first.body.radius, 'm', 4) });
  const thickness = second ? withUnit(second.body.thickness, 'm', 4) : '';
  return { ball, ground: say(`ground.${against}` as Word, { material: second?.solid?.name ?? '', thickness }) };
}

/** Wire the sheet and its button of index.html. */
export function createWorksheet() {
  const sheet = find('worksheet', HTMLElement);
  const button = find('print', HTMLButtonElement);
  button.addEventListener('click', () => print());
  const line = (name: Word, value: string) => html`<div><dt>${say(name)}</dt><dd>${value}</dd></div>`;

  return {
    /** What is shown is of earlier inputs. */
    wait: (): void => void (button.disabled = true),
    show(inputs: Inputs, prediction: Prediction): void {
      const { encounter } = inputs;
      const { quantities, channels, dominant } = prediction;
      const { value, rebound, numerical, byModels, byConstants } = uncertaintiesInWords(prediction);
      const from = heightInWords(quantities.drop_height?.value ?? NaN);
      const share = channels.find(({ name }) => name === dominant)?.share ?? 0;
      render(html`
        <h1 id="worksheet-title">${say('worksheet.title')}</h1>
        <p class="names">${say('worksheet.names')}</p>
        <p>${say('worksheet.task', { ...partsOf(encounter), height: from })}</p>
        <h2>${say('worksheet.measure')}</h2>
        <p>${say('worksheet.how')}</p>
        <table>
          <thead><tr>${columns.map((name) => html`<th scope="col">${say(name)}</th>`)}</tr></thead>
          <tbody>${Array.from({ length: RUNS }, (_, k) =>
            html`<tr><td>${k + 1}</td><td>${meetsBody(encounter) ? '' : from}</td><td></td><td></td></tr>`)}
            <tr><th scope="row" colspan="3">${say('worksheet.mean')}</th><td></td></tr>
          </tbody>
        </table>
        <h2>${say('worksheet.prediction')}</h2>
        <dl>
          ${line('worksheet.epsilon', value)} ${meetsBody(encounter) ? '' : line('prediction.rebound', rebound)}
          ${line('prediction.numerical', numerical)} ${line('prediction.models', byModels)}
          ${line('prediction.constants', byConstants)}
          ${line('worksheet.most', say('worksheet.share', { channel: say(`where.${dominant}` as Word), share: shareInWords(share) }))}
        </dl>
        <h2>${say('worksheet.questions')}</h2>
        <ol>${questions.map((name) => html`<li>${say(name)}</li>`)}</ol>
        <p class="note">${say('worksheet.source', { address: new URL(`?${toAddress(inputs)}`, location.href).href })}</p>`, sheet);
      button.disabled = false;
    },
  };
}
