// What users call: a method for each question about an encounter or a row.
import { type Ask, type CompiledCore, instantiate } from './core.js';
import type { Encounter } from './generated/documents.js';
import type { Questions, QuickQuestions, Row, RowQuestions } from './questions.js';

type All = Questions & QuickQuestions;

/** What comes one by one is returned as a list, and passed on at once to who waits for it. */
type Method<Question extends (...given: never) => unknown> =
  Parameters<Question> extends [infer Given, infer Each]
    ? (encounter: Encounter | string, given: Given, each?: (each: Each, index: number) => void) => Each[]
    : Parameters<Question> extends [infer Given]
      ? (encounter: Encounter | string, given: Given) => ReturnType<Question>
      : (encounter: Encounter | string) => ReturnType<Question>;

/** A named material, with its source. */
export interface NamedMaterial {
  readonly name: string;
  /** Pa */
  readonly young: number;
  readonly poisson: number;
  /** kg/m³ */
  readonly density: number;
  /** Q, that of one that relaxes at the frequency of its modulus; 0: not known well enough */
  readonly quality: number;
  /** Pa; without it the material is brittle, or it is not known well enough */
  readonly yield_strength?: number;
  readonly source: string;
}

/** The same about a row. */
type RowMethod<Question extends (given: never) => unknown> =
  (row: Row | string, given: Parameters<Question>[0]) => ReturnType<Question>;

/** The core on this thread. An encounter or a row is an object, or its JSON document. Methods compute until they return, and
 *  throw CoreError with one line for what the core cannot do. */
export type Stoss = { readonly [Name in keyof All]: Method<All[Name]> } & {
  readonly [Name in keyof RowQuestions]: RowMethod<RowQuestions[Name]>;
} & {
  /** as the command has it */
  readonly version: string;
  /** The materials that can be named. */
  readonly materials: readonly NamedMaterial[];
  /** The JSON Schema of encounters. */
  schema(): object;
  /** A question by its name; what comes one by one is only passed on. */
  readonly ask: Ask;
};

const questions: readonly (keyof All | keyof RowQuestions)[] = [
  'restitution', 'curve', 'header', 'prediction', 'thresholds', 'oblique', 'obliqueAngles', 'obliqueCollision', 'collision',
  'frames', 'sound', 'shape', 'units', 'row', 'rowAgain', 'rowPitch', 'rowSound',
];

/** How a core is made. */
export interface Options {
  /** what `compile` gave; without it the core is compiled */
  module?: CompiledCore;
  /** is called some four times a second during long computations */
  alive?: () => void;
}

/** What makes cores, where `compile` finds their module. */
export function loader(compile: () => Promise<CompiledCore>) {
  return async ({ module, alive }: Options = {}): Promise<Stoss> =>
    withMethods(await instantiate(module ?? (await compile()), alive));
}

function withMethods(ask: Ask): Stoss {
  const method = (name: keyof All | keyof RowQuestions) =>
    (encounter: unknown, given: object = {}, each?: (each: unknown, index: number) => void): unknown => {
      const all: unknown[] = [];
      const document = typeof encounter === 'string' ? encounter : JSON.stringify(encounter) ?? '';
      const answer = ask(name, { ...given, document }, (one: unknown, index: number) => {
        all[index] = one;
        each?.(one, index);
      });
      return answer ?? all;
    };
  const methods = Object.fromEntries(questions.map((name) => [name, method(name)]));
  const { materials } = JSON.parse(ask('kinds', {}) as string) as { materials: NamedMaterial[] };
  return {
    ...methods, ask, materials, version: ask('version', {}), schema: () => JSON.parse(ask('schema', {}) as string),
  } as unknown as Stoss;
}
