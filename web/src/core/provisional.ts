// What the page takes for granted until the core is there, so that its form can be filled in: the core checks it then.
import { CoreError } from 'stoss';
import { say } from '../drawing/words';
import { materialNamed } from '../inputs/kinds';
import type { Units } from './protocol';

type Material = Readonly<Record<'young' | 'density' | 'poisson', number>>;

const answers: Record<string, (given: never) => unknown> = {
  number: ({ name, text }: { name: string; text: string }): number => {
    if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) throw new CoreError(say('check.no_number', { name, got: text }));
    return Number(text);
  },
  relaxation: ({ text }: { text: string }): number[][] => text.split('+').map((term) => term.split(':').map(Number)),
  units: ({ document }: { document: string }): Units => {
    const { material } = (JSON.parse(document) as { first: { material?: string | Material } }).first;
    const { young, density, poisson } =
      typeof material === 'string' ? materialNamed(material) : material ?? { young: 1, density: 1, poisson: 0.3 };
    const speed = Math.sqrt(young / density);
    return { speed, time: 1 / speed, frequency: speed, first: { young: 1, poisson } };
  },
  speed: () => undefined,
  motion: () => undefined,
};

/** Answers what the form asks; all else is not there yet. */
export function provisional(question: string, given: object): unknown {
  const answer = answers[question];
  if (!answer) throw new CoreError(question);
  return answer(given as never);
}
