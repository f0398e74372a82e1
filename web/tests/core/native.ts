// The native command, which must say the same as the core of the page.
import { execFileSync } from 'node:child_process';
import { argumentsOf, ruleArguments } from '../../src/inputs/lines';
import { shortest } from '../../src/drawing/numbers';
import type { Encounter, Prediction } from '../../src/core/protocol';
import type { Inputs } from '../../src/inputs/inputs';
import { command } from '../native/build';

/** Whether the command is built. */
export const hasCommand = command !== undefined;

/** What the command writes; with status 1 a value is not as accurate as asked for. */
export function run(args: string[]): string {
  try {
    return execFileSync(command!, args, { encoding: 'utf8', stdio: 'pipe', maxBuffer: 1 << 28 });
  } catch (error) {
    const { status, stdout } = error as { status: number; stdout: string };
    if (status === 1 && stdout !== '') return stdout;
    throw error;
  }
}

export type Row = Record<string, number | string | boolean>;

/** The record of `stoss restitution` for one speed. */
export function restitution(encounter: Encounter, speed: number, tolerance: number): Row {
  return record(argumentsOf(encounter, [speed]), tolerance);
}

/** The record of `stoss oblique`. */
export function oblique(inputs: Inputs, tolerance: number): Row {
  return record(ruleArguments(inputs), tolerance);
}

/** That of `stoss predict`. */
export function prediction(encounter: Encounter, speed: number, tolerance: number) {
  return record(argumentsOf(encounter, [speed], 'predict'), tolerance) as Row & Pick<Prediction, 'influences' | 'warnings'>;
}

function record(args: string[], tolerance: number): Row {
  const text = run([...args, '--tolerance', shortest(tolerance), '--format', 'json']);
  return (JSON.parse(text) as { records: Row[] }).records[0]!;
}
