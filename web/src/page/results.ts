// ε and what belongs to it, as text.
import { html, nothing, render } from 'lit-html';
import type { Encounter, Quantities, Quantity, Restitution } from '../core/protocol';
import { find } from '../drawing/dom';
import { prefixFor, significant, withError } from '../drawing/numbers';
import { say } from '../drawing/words';
import { meetingOf, meetsBody } from '../inputs/document';
import { gravity } from '../inputs/inputs';

export type Stage = 'first' | 'final';

/** A quantity of a result, which may be there in SI too. */
type Name = keyof Quantities<Quantity>;

/** What becomes of the motion along the surface and of the energy. */
const afterwards: readonly Name[] = [
  'sliding', 'tangential_after', 'spin_after', 'second_spin_after', 'friction_loss', 'vibration', 'dissipated',
  'translation', 'across', 'rotation', 'second_rotation',
];

/** A number of the core, or of one's own. */
type Number = Omit<Quantity, 'help'>;

/** Whether what is shown belongs to the inputs (''), or why not. */
type Age = '' | 'wrong' | 'computing';

/** A quantity with a readable unit and the digits that its error allows, or some others. */
function shown(quantity: Number, digits = shownNumber): string {
  const { size, unit } = prefixFor(quantity.value, quantity.unit);
  return `${digits(quantity, 1 / size)}${unit === '' ? '' : `\u00a0${unit}`}`;
}

/** A quantity of a result, in SI where it is known. */
export function shownQuantity(result: Restitution, name: Name): string {
  const quantity = result.quantities[`${name}_si`] ?? result.quantities[name];
  return quantity === undefined ? '–' : shown(quantity);
}

function shownNumber({ value, error }: Number, factor: number): string {
  return error === undefined ? significant(value * factor, 6) : withError(value * factor, error * factor);
}

/** As far as a class needs it. */
function threeDigits({ value }: Number, factor = 1): string {
  return (value * factor).toPrecision(3);
}

/** How high a body bounces that falls on what rests: ε²h, from the height h = v²/2g of its drop, both in m; without SI
 *  in units of the drop. Undefined for one that meets another body, which moves too. */
export function reboundOf(encounter: Encounter, speed: number, restitution: Number) {
  if (meetsBody(encounter)) return undefined;
  const { si } = meetingOf(encounter);
  const { value, error } = restitution;
  const drop = si ? speed ** 2 / (2 * gravity) : undefined;
  const unit = drop ?? 1;
  const height: Number = { value: value ** 2 * unit, unit: si ? 'm' : '' };
  if (error !== undefined) height.error = 2 * value * error * unit;
  return { drop, height };
}

/** The height of rebound, whole and in three digits, of that of the fall; '' for what meets another body. */
export function reboundInWords(encounter: Encounter, result: Restitution): { full: string; short: string } {
  const { restitution } = result.quantities;
  const rebound = restitution && reboundOf(encounter, result.speed, restitution);
  if (rebound === undefined) return { full: '', short: '' };
  const { drop, height } = rebound;
  const of = drop === undefined ? '\u00a0h' : say('result.of', { drop: shown({ value: drop, unit: 'm' }, threeDigits) });
  return { full: shown(height) + of, short: shown(height, threeDigits) + of };
}

/** Up to where ε is more than a bound; '' without SI. */
export function yieldInWords(encounter: Encounter, result: Restitution): string {
  const { yieldSpeed, yieldWarning, quantities: { dent, yielded } } = result;
  if (dent && dent.value > 0) {
    return say('result.dent', { depth: shownQuantity(result, 'dent'), share: significant(100 * yielded!.value, 3) });
  }
  if (!meetingOf(encounter).si) return '';
  if (yieldWarning !== undefined) return `${yieldWarning[0]!.toUpperCase()}${yieldWarning.slice(1)}.`;
  if (yieldSpeed === undefined) return say('result.yield_unknown');
  return say('result.yields', { speed: significant(yieldSpeed, 2) });
}

/** A change of ε_t of which the page speaks; its error is about as large. */
const noticeableCoupling = 0.01;

/** What a reader should know about a result, one line each. */
export function flags(
  { reason, converged, note, beyondSmallStrain, beyondSmallTurn, materialWarnings, quantities }: Restitution,
): string[] {
  // The core's advice is about a tolerance, which is no input here.
  const why = reason.replace(/; try an? [^;]*$/, '') || say('result.tolerance');
  const digits = (name: Name, count: number): string => significant(quantities[name]?.value ?? NaN, count);
  const coupling = Math.abs(quantities.coupling_tangential_restitution?.value ?? 0);
  return [
    coupling <= noticeableCoupling ? ''
      : say('result.coupling', { change: Number.isFinite(coupling) ? significant(coupling, 2) : say('result.unknown_amount') }),
    note && `${note.charAt(0).toUpperCase()}${note.slice(1).replace('eps', 'ε')}.`,
    ...(materialWarnings ?? []).map((line) => `${line.charAt(0).toUpperCase()}${line.slice(1)}.`),
    converged ? '' : say('result.inaccurate', { why }),
    beyondSmallStrain
      ? say('result.strain', { strain: digits('strain', 3) }) : '',
    beyondSmallTurn
      ? say('result.turn', { angle: digits('turned', 2) }) : '',
  ].filter(Boolean);
}

/** A computation shorter than this, in ms, is not announced. */
const noticeable = 200;

/** Wire the results of index.html. */
export function createResults() {
  const section = find('result', HTMLElement);
  const spoken = find('spoken', HTMLOutputElement);
  const state = find('result-state', HTMLElement);
  const rows = find('afterwards', HTMLElement);
  let reached = '';
  let timer: number | undefined;
  let soon: number | undefined;

  const spokenOf = (id: string): string => find(id, HTMLElement).textContent?.replace('±', say('spoken.error')) ?? '';
  const put = (texts: Record<string, string>): void => {
    for (const [id, text] of Object.entries(texts)) find(id, HTMLElement).textContent = text;
  };

  const mark = (why: Age): void => {
    if (why === '') delete section.dataset.stale;
    else section.dataset.stale = why;
    clearTimeout(soon);
    if (why !== '') clearTimeout(timer);
    delete section.dataset.slow;
    if (why === '') state.textContent = reached;
  };

  /** Tell screen readers, once it stays. */
  const speak = (line: string): void => {
    clearTimeout(timer);
    timer = window.setTimeout(() => (spoken.textContent = line), 800);
  };

  return {
    speak,
    /** Show a result; of the final one screen readers are told, unless there is a prediction to tell. */
    show(encounter: Encounter, result: Restitution, stage: Stage, aloud: boolean): void {
      const { si } = meetingOf(encounter);
      const epsilon: Number = result.quantities.restitution ?? { value: NaN, unit: '' };
      const { full, short } = reboundInWords(encounter, result);
      const { tangential_restitution: tangential } = result.quantities;
      render(tangential ? afterwards.filter((name) => result.quantities[name]?.value).map((name) =>
        html`<div><dt>${result.quantities[name]!.help}</dt><dd>${shownQuantity(result, name)}</dd></div>`) : nothing, rows);
      put({
        epsilon: withError(epsilon.value, epsilon.error ?? 0),
        'epsilon-short': threeDigits(epsilon),
        lost: shownQuantity(result, 'lost_fraction'),
        'contact-time': shownQuantity(result, 'contact_time'),
        'max-force': shownQuantity(result, 'max_force'),
        'max-compression': shownQuantity(result, 'max_compression'),
        'rebound-name': say(si ? 'result.rebound_si' : 'result.rebound'),
        rebound: full,
        'rebound-short': short,
        tangential: tangential ? withError(tangential.value, tangential.error ?? 0) : '',
        'tangential-short': tangential ? threeDigits(tangential) : '',
        yield: yieldInWords(encounter, result),
      });
      find('rebound-row', HTMLElement).hidden = full === '';
      find('yield', HTMLElement).classList.toggle('problem', result.yieldWarning !== undefined);
      section.dataset.stage = stage;
      const aim = say(tangential ? 'result.aim_tangential' : 'result.aim');
      reached = stage === 'first' ? say('result.first') : say(result.converged ? 'result.reached' : 'result.not_reached', { aim });
      mark(section.dataset.stale === 'wrong' ? 'wrong' : '');
      const lines = flags(result);
      find('flags', HTMLElement).replaceChildren(...lines.flatMap((line) => [line, document.createElement('br')]));
      if (stage === 'first' || !aloud) return;
      const speed = `${significant(result.speed, 4)} ${si ? say('spoken.speed') : 'c'}`;
      speak([
        say('spoken.restitution', { value: spokenOf('epsilon'), speed }),
        tangential ? say('spoken.tangential', { value: spokenOf('tangential') }) : say('spoken.lost', { value: spokenOf('lost') }), ...lines,
      ].join(' '));
    },
    /** Say that what is shown belongs to earlier inputs: because some are wrong, or because new ones are computed. */
    stale(why: Age): void {
      mark(why);
      if (why === 'wrong') state.textContent = say(reached === '' ? 'result.none' : 'result.last');
      if (why === 'computing') soon = window.setTimeout(() => {
        state.textContent = say(reached === '' ? 'result.computing' : 'result.computing_again');
        section.dataset.slow = '';
      }, noticeable);
    },
    /** One line that is not about a field; '' takes it away. */
    say(line: string): void {
      const notice = find('notice', HTMLElement);
      notice.textContent = line;
      notice.hidden = line === '';
    },
  };
}
