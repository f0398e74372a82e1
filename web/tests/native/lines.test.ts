// The lines that the page offers, run for real: command and Python take them, and say the same.
import { execFileSync } from 'node:child_process';
import { describe, expect, it } from 'vitest';
import { argumentsOf, curveCsv, pythonLines, ruleArguments } from '../../src/inputs/lines';
import { meetingOf } from '../../src/inputs/document';
import { withError } from '../../src/drawing/numbers';
import { cases, obliqueCases } from '../unit/cases';
import { command, python } from './build';

interface Row {
  restitution: number;
  restitution_error: number;
  speed: number;
}

/** Status 1 is a value that is not as accurate as asked for: a result all the same. */
function run(program: string, args: string[], input = ''): string {
  try {
    return execFileSync(program, args, { encoding: 'utf8', input, stdio: 'pipe' });
  } catch (error) {
    const { status, stdout } = error as { status: number; stdout: string };
    if (status === 1 && stdout !== '') return stdout;
    throw error;
  }
}

function native(index: number, format: string): string {
  const { encounter, speed } = cases[index]!;
  return run(command!, [...argumentsOf(encounter, [speed]), '--tolerance', '0.01', '--format', format]);
}

const indices = cases.map((_, index) => index);

describe.skipIf(command === undefined)('the command', () => {
  it.each(indices)('writes the digits of case %i as the page does', (index) => {
    const [row] = (JSON.parse(native(index, 'json')) as { records: Row[] }).records;
    const [value] = withError(row!.restitution, row!.restitution_error).split(' ±');
    expect(native(index, 'table')).toMatch(new RegExp(`\\b${value}(\\(| ±)`));
  });
  it('has the columns of our CSV in that order', () => {
    for (const index of [0, 4, 7, 12]) {
      const columns = native(index, 'csv').split('\n').find((line) => !line.startsWith('#'))!.split(',');
      const { kind, si } = meetingOf(cases[index]!.encounter);
      const ours = [...(kind === 'rod' ? [] : ['poisson']), 'speed[c]', ...(si ? ['speed_si[m/s]'] : []), 'restitution',
        'restitution_error', 'converged'];
      expect(columns.filter((column) => ours.includes(column))).toEqual(ours);
    }
  });
  it('takes the line of our CSV, and begins its own in the same way', () => {
    const { encounter, speed } = cases[10]!;
    const ours = curveCsv(encounter, [{ speed, restitution: 1, error: 0, converged: true }]).split('\n');
    const theirs = run('sh', ['-c', ours[1]!.replace('# command: stoss', command!)]).split('\n');
    expect(theirs.slice(0, 2)).toEqual(ours.slice(0, 2));
    expect(JSON.parse(theirs[2]!.replace('# first: ', ''))).toEqual(encounter.first);
    expect(theirs).toContain(ours[4]);
  });
});

describe.skipIf(command === undefined || python === undefined)('Python', () => {
  it('gives the numbers of the command', () => {
    const blocks = indices.map((index) => {
      const lines = pythonLines(cases[index]!).trimEnd().split('\n');
      const last = lines.pop()!;
      const call = `${last.slice('print('.length, -2)}, tolerance=0.01)`;
      const attempt = `try:\n    r = ${call}\nexcept stoss.NotConverged as e:\n    r = e.best`;
      return `${lines.join('\n')}\n${attempt}\nprint(repr(float(r.restitution)))`;
    });
    const values = run(python!, ['-'], blocks.join('\n')).trim().split('\n').map(Number);
    indices.forEach((index) => {
      const [row] = (JSON.parse(native(index, 'json')) as { records: Row[] }).records;
      expect(Math.abs(values[index]! - row!.restitution), pythonLines(cases[index]!)).toBeLessThan(1e-12);
    });
  });
  it('gives those of the collision rule', () => {
    const program = obliqueCases.map((inputs) => pythonLines(inputs)
      .replace(/print\((.*)\)/, 'print(repr(float($1.tangential_restitution)))')).join('\n');
    const values = run(python!, ['-'], program).trim().split('\n').map(Number);
    obliqueCases.forEach((inputs, index) => {
      const [row] = (JSON.parse(run(command!, [...ruleArguments(inputs), '--format', 'json'])) as
        { records: Record<string, number>[] }).records;
      expect(Math.abs(values[index]! - row!.tangential_restitution!), `${ruleArguments(inputs)}`).toBeLessThan(1e-12);
    });
  });
});
