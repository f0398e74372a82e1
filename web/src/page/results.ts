// ε and what belongs to it, as text.
import type { Encounter, Quantity, Restitution } from '../core/protocol';
import { prefixed, significant, withError } from '../inputs/digits';
import { find } from './dom';

export type Stage = 'first' | 'final';

export interface Results {
  /** Show a result; of the final one screen readers are told, once it stays. */
  show(encounter: Encounter, result: Restitution, stage: Stage): void;
  /** Say that what is shown belongs to earlier inputs: because some are wrong, or because new ones are computed. */
  stale(why: '' | 'wrong' | 'computing'): void;
  /** One line that is not about a field; '' takes it away. */
  say(line: string): void;
}

const units: Record<string, string> = { piRE: 'πRE', 'mc^2/R': 'mc²/R' };

/** A quantity of a result, in SI where it is known, with the digits that its error allows and a readable unit. */
export function shownQuantity(result: Restitution, name: string): string {
  const quantity = result.quantities[`${name}_si`] ?? result.quantities[name];
  if (quantity === undefined) return '–';
  const { factor, unit } = prefixed(quantity.value, quantity.unit);
  return `${shownNumber(quantity, factor)}${unit === '' ? '' : ` ${units[unit] ?? unit}`}`;
}

function shownNumber({ value, error }: Quantity, factor: number): string {
  return error === undefined ? significant(value * factor, 6) : withError(value * factor, error * factor);
}

/** What a reader should know about a result, one line each. */
export function flags(result: Restitution): string[] {
  const lines: string[] = [];
  // The core's advice is about a tolerance, which is no input here.
  const reason = result.reason.replace(/ \(use a larger tolerance[^()]*\)$/, '') || 'tolerance not reached';
  if (!result.converged) lines.push(`Not as accurate as asked for: ${reason}.`);
  if (result.beyondSmallStrain) {
    lines.push('Beyond small strain: above 0.5 c or a compression of 0.5 R linear elasticity has lost its meaning.');
  }
  return lines;
}

/** A computation shorter than this, in ms, is not announced. */
const noticeable = 200;

/** Wire the results of index.html. */
export function createResults(): Results {
  const section = find('result', HTMLElement);
  const value = find('epsilon', HTMLElement);
  const bar = find('error-bar', HTMLElement);
  const spoken = find('spoken', HTMLOutputElement);
  const state = find('result-state', HTMLElement);
  let reached = '';
  let timer: number | undefined;
  let soon: number | undefined;

  /** Logarithmic: an error of 10⁻² of ε fills the bar, one of 10⁻⁸ empties it. */
  const share = (error: number): number => Math.min(Math.max((Math.log10(error || 1e-12) + 8) / 6, 0.02), 1);

  return {
    show(encounter, result, stage) {
      const epsilon = result.quantities.restitution ?? { value: NaN, unit: '' };
      value.textContent = withError(epsilon.value, epsilon.error ?? 0);
      bar.style.transform = `scaleX(${share(epsilon.error ?? 0)})`;
      section.dataset.stage = stage;
      if (section.dataset.stale !== 'wrong') delete section.dataset.stale;
      for (const [id, name] of quantities) find(id, HTMLElement).textContent = shownQuantity(result, name);
      clearTimeout(soon);
      const missed = result.converged ? '' : ' not reached';
      reached = stage === 'first' ? 'tolerance 10⁻², refining' : `tolerance 10⁻³${missed}`;
      if (section.dataset.stale !== 'wrong') state.textContent = reached;
      const lines = flags(result);
      find('flags', HTMLElement).replaceChildren(...lines.flatMap((line) => [line, document.createElement('br')]));
      clearTimeout(timer);
      if (stage === 'first') return;
      const speed = `${significant(result.speed, 4)} ${encounter.si ? 'metres per second' : 'c'}`;
      timer = window.setTimeout(() => {
        spoken.textContent = [
          `Restitution ${value.textContent?.replace('±', 'plus or minus') ?? ''} at ${speed}.`,
          `Lost share ${find('lost', HTMLElement).textContent?.replace('±', 'plus or minus') ?? ''}.`, ...lines,
        ].join(' ');
      }, 800);
    },
    stale(why) {
      if (why === '') delete section.dataset.stale;
      else section.dataset.stale = why;
      clearTimeout(soon);
      if (why === '') state.textContent = reached;
      if (why === 'wrong') state.textContent = reached === '' ? 'no result yet' : 'of the last inputs in range';
      if (why === 'computing') soon = window.setTimeout(() => (state.textContent = 'computing'), noticeable);
      clearTimeout(timer);
    },
    say(line) {
      const notice = find('notice', HTMLElement);
      notice.textContent = line;
      notice.hidden = line === '';
    },
  };
}

const quantities: readonly [string, string][] = [
  ['lost', 'lost_fraction'],
  ['contact-time', 'contact_time'],
  ['max-force', 'max_force'],
  ['max-compression', 'max_compression'],
];
