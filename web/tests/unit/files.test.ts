// Bodies of files: what stands for them, in the document, in words, in lines and in the address.
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { unitsOf } from '../../src/core/local';
import type { ModeEnergy } from '../../src/core/protocol';
import { fromAddress, toAddress } from '../../src/inputs/address';
import { problemsOf, refusal } from '../../src/inputs/check';
import { documentOf, equal, hasFile, meetingOf } from '../../src/inputs/document';
import { fieldsOf } from '../../src/inputs/fields';
import { fileNamed, openFile, withFile } from '../../src/inputs/files';
import { type Inputs, defaults, withAgainst, withKind } from '../../src/inputs/inputs';
import { bodyKinds, fileKind } from '../../src/inputs/kinds';
import { argumentsOf, commandLine, description, pythonLines } from '../../src/inputs/lines';
import { withSi, withoutSi } from '../../src/inputs/units';
import { mixed, pace } from '../../src/page/sound';

const text = readFileSync(new URL('ball.json', import.meta.url), 'utf8');

describe('a body of a file', () => {
  let file: object;
  let first: Inputs;
  let second: Inputs;
  beforeAll(() => {
    file = openFile('my ball.json', text);
    first = withFile(defaults, false, file);
    second = withFile(withSi({ ...defaults, encounter: withKind(defaults.encounter, 'sphere') }), true, file);
  });

  it('is no kind of the form', () => {
    expect(bodyKinds).toEqual(['disk', 'sphere', 'hollow-sphere', 'rod']);
    expect(fileKind.name).toBe('modal');
  });
  it('is in the document as it is, and in SI', () => {
    expect(JSON.parse(documentOf(first.encounter))).toEqual(
      { first: { kind: 'modal', body: JSON.parse(text) }, against: 'wall' });
    expect(JSON.parse(documentOf(second.encounter)).against).toEqual({ kind: 'modal', body: JSON.parse(text) });
    expect(meetingOf(first.encounter).first.body.radius).toBeCloseTo(0.01, 12);
    expect(unitsOf(first.encounter).speed).toBeCloseTo(5172.194, 3);
    expect([...problemsOf(first), ...problemsOf(second)]).toEqual([]);
  });
  it('has no numbers to type, and no friction', () => {
    expect(fieldsOf({ ...first, friction: 0.3 })).toEqual(['speed']);
    expect(fieldsOf(second)).not.toContain('radius2');
  });
  it('goes with another kind, partner or system of units', () => {
    expect(hasFile(withKind(first.encounter, 'disk'))).toBe(false);
    expect(hasFile(withAgainst(first.encounter, 'half-space'))).toBe(true);
    expect(hasFile(withAgainst(second.encounter, 'half-space'))).toBe(false);
    expect(hasFile(withoutSi(first).encounter)).toBe(false);
  });
  it('has its name in words and in lines', () => {
    expect(description(first.encounter)).toBe('“steel ball”');
    expect(description(second.encounter)).toMatch(/ at “steel ball”$/);
    expect(commandLine(argumentsOf(first.encounter, [1]))).toBe('stoss restitution --body @my_ball.json --speed 1');
    expect(commandLine(argumentsOf(second.encounter, [1]))).toMatch(
      /^stoss restitution --body sphere .* --against @my_ball.json --speed 1$/);
    expect(pythonLines(first)).toContain('body = stoss.ModalBody.read("my_ball.json")\nprint(stoss.restitution(body, ');
    expect(pythonLines(second)).toContain('other = stoss.ModalBody.read("my_ball.json")');
  });
  it('is named in the address, which gives it back while it is open', () => {
    for (const inputs of [first, second]) {
      const { inputs: back, problem } = fromAddress(`?${toAddress(inputs)}`);
      expect(problem).toBe('');
      expect(equal(back.encounter, inputs.encounter)).toBe(true);
    }
    expect(fileNamed('my_ball.json')).toBe(file);
    expect(toAddress(first)).toBe('body=sphere&file=my_ball.json&units=SI&v=0.1');
    const { inputs, problem } = fromAddress('?body=sphere&file=bell.json&units=SI&v=1');
    expect(problem).toContain('file: open “bell.json” again');
    expect(hasFile(inputs.encounter)).toBe(false);
  });
  it.each([['{', 'bell.json: got no JSON document'], ['{}', 'first body format: got'], ['3', 'first body'],
    [text.replace('"poisson":0.3', '"poisson":0.6'), 'first body poisson: got 0.6'],
    [text.replace('"poisson":0.3', '"poisson":0.3,"poisson":0.4'), 'got the key "poisson" twice']])(
    'that is none is refused in one line: %s', (wrong, line) => {
      const said = refusal(() => openFile('bell.json', wrong))?.message;
      expect(said).toContain(line);
      expect(said).not.toContain('\n');
    });
});

describe('the sound', () => {
  const modes = [0, 1].map((index): ModeEnergy => ({ body: 0, order: 0, index, omega: 2 + index, after: index, average: 0 }));
  const si = withSi(defaults).encounter;
  it('is played as it is where one hears it, else at concert pitch', () => {
    expect(pace(si, modes, 1000)).toEqual({ interval: 1 / 44100, words: 'Played as it sounds.' });
    const slow = pace(si, modes, 1e6)!;
    expect((3e6 * slow.interval * 44100) / (2 * Math.PI)).toBeCloseTo(440, 9);
    expect(slow.words).toBe('Played 1090 times slower, with its lowest mode at 440 Hz.');
    expect(pace(defaults.encounter, modes, 1)!.words).toBe('Played with its lowest mode at 440 Hz.');
    expect(pace(si, modes.slice(0, 1), 1)).toBe(undefined);
  });
  it('of two bodies is their sum', () => {
    const all = mixed([Float32Array.of(1, 2), Float32Array.of(1, -4)]);
    expect(all.length).toBe(88200);
    expect(all[0]).toBeCloseTo(0.9, 6);
    expect(all[1]).toBeCloseTo(-0.9, 6);
  });
});
