// The core of the page in Node.js.
import { load } from 'stoss';
import type { Encounter, Questions } from '../../src/core/protocol';
import { documentOf } from '../../src/inputs/document';

export const { ask: core } = await load();

/** The answer to a question, and what it delivered. */
export function ask<Name extends keyof Questions>(
  question: Name, encounter: Encounter, given: Parameters<Questions[Name]>[0],
): { value: ReturnType<Questions[Name]>; all: (Parameters<Questions[Name]>[1] & {})[] } {
  const all: (Parameters<Questions[Name]>[1] & {})[] = [];
  const value = core(question, { ...given, document: documentOf(encounter) },
    (each, index) => void (all[index] = each));
  return { value: value as ReturnType<Questions[Name]>, all };
}
