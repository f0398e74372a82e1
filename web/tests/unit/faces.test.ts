// Rough and coated faces, and materials that relax: in fields, addresses, units, lines and documents.
import { describe, expect, it } from 'vitest';
import { fromAddress, toAddress } from '../../src/inputs/address';
import { check } from '../../src/inputs/check';
import { encounterOf, meetingOf } from '../../src/inputs/document';
import { type Field, fieldsOf, hasLossOrFace, placedFieldsOf, shownOf, textOf, valueOf, withValue, wordsOf } from '../../src/inputs/fields';
import { type Inputs, defaults, firstBall } from '../../src/inputs/inputs';
import { argumentsOf, commandLine, description, pythonLines } from '../../src/inputs/lines';
import { withSi, withoutSi } from '../../src/inputs/units';
import { cases } from './cases';

const [plain, real] = [cases[18]!, cases[19]!];
const typed = (inputs: Inputs, field: Field, text: string) => check(inputs, new Map([[field, text]]));
const after = (inputs: Inputs, field: Field, text: string): Inputs => typed(inputs, field, text).inputs;
const problem = (inputs: Inputs, field: Field, text: string): string => typed(inputs, field, text).problems.get(field) ?? '';

describe('fields of losses and faces', () => {
  it('are those of both bodies, and of a coat where there is one', () => {
    const names = ['loss_time', 'quality', 'relaxation', 'roughness', 'coat'] as const;
    const ofCoat = ['coat_young', 'coat_poisson', 'coat_quality'] as const;
    expect(placedFieldsOf(defaults.encounter)).toEqual(['poisson', ...names]);
    expect(placedFieldsOf(plain.encounter).slice(-9)).toEqual([...names, ...ofCoat, 'yield_strength'].map((name) => `${name}2`));
    const coated = after(firstBall, 'coat', '1e-5');
    expect(fieldsOf(coated)).toEqual(expect.arrayContaining(ofCoat.map((name) => name)));
    expect(valueOf(coated, 'coat_young')).toBe(7e8); // a hundredth of that of glass
    expect(fieldsOf(after(coated, 'coat', '0'))).toEqual(fieldsOf(firstBall));
  });
  it('have the units of the document, and words of the core', () => {
    const units = (inputs: Inputs) => ['relaxation', 'roughness', 'coat', 'coat_young'].map((name) =>
      wordsOf(inputs.encounter, name as Field).unit);
    expect(units(after(plain, 'coat', '0.001'))).toEqual(['R/c', 'R', 'R', 'E']);
    expect(units(after(real, 'coat', '1e-6'))).toEqual(['s', 'm', 'm', 'Pa']);
    expect(wordsOf(defaults.encounter, 'roughness').help).toMatch(/^rms height of the asperities/);
  });
  it('show a relaxation as it is typed', () => {
    expect(textOf(shownOf(plain, 'relaxation'))).toBe('0.5:1+0.2:10');
    const inputs = after(defaults, 'relaxation', ' 0.25:1e+3+0.5:0.1 ');
    expect(inputs.encounter.first).toEqual({ kind: 'disk', poisson: 0.33, relaxation: [[0.25, 1000], [0.5, 0.1]] });
    expect(after(inputs, 'relaxation', '').encounter).toEqual(defaults.encounter);
    expect(after(inputs, 'quality', '30').encounter.first).toEqual({ kind: 'disk', poisson: 0.33, quality: 30 });
  });
  it('are refused as the core refuses them', () => {
    expect(problem(defaults, 'relaxation', '0.5')).toMatch(/^Relaxation: got '0\.5', allowed SHARE:TIME/);
    expect(problem(defaults, 'relaxation', '0.7:1+0.5:2')).toMatch(/^Relaxation: got /);
    expect(problem(defaults, 'roughness', '-1')).toMatch(/^Roughness: got -1, allowed 0 /);
    expect(problem(defaults, 'roughness', '3')).toMatch(/^Roughness: got 3, allowed 0 to 2\.22/);
    expect(problem(real, 'coat2', '1')).toMatch(/^Coat of what it meets: got 1, allowed 0 to 0\.005/);
    expect(problem(real, 'coat_young2', '0')).toMatch(/^Coat’s modulus of what it meets: /);
    expect(problem(plain, 'coat_quality2', '2')).toMatch(/^Coat’s quality of what it meets: got 2, /);
  });
  it('say whether there is anything beside the loss of a named material', () => {
    for (const inputs of [plain, real, cases[1]!]) expect(hasLossOrFace(inputs.encounter)).toBe(true);
    for (const inputs of [defaults, firstBall, cases[10]!]) expect(hasLossOrFace(inputs.encounter)).toBe(false);
  });
});

describe('addresses of them', () => {
  it('have their keys', () => {
    expect(toAddress(plain)).toBe('body=sphere&nu=0.3&relax=0.5:1+0.2:10&rough=0.002&against=half-space' +
      '&nu2=0.33&E2=0.5&rho2=1&coat2=0.001&Ec2=0.02&nuc2=0.4&Qc2=10&v=0.01');
    const ball = after(after(firstBall, 'roughness', '1e-7'), 'relaxation2', '0.1:1e-5');
    expect(toAddress(ball)).toBe('view=ball&material=glass&R=0.008&rough=1e-7&material2=granite&relax2=0.1:1e-5&drop=0.3');
    expect(fromAddress(toAddress(ball))).toEqual({ inputs: ball, problem: '' });
    const kept = `body=disk&nu=0.33&v=0.1&keep=body:disk,nu:0.33,relax:0.5:1+0.2:10,rough:0.01`;
    expect(toAddress(fromAddress(kept).inputs)).toBe(kept);
  });
  it.each([
    ['body=disk&nu=0.33&v=0.1&relax=1', 'body=disk&nu=0.33&v=0.1', "relax: got '1', allowed SHARE:TIME"],
    ['body=disk&nu=0.33&v=0.1&rough=9', 'body=disk&nu=0.33&v=0.1', 'Roughness: got 9, allowed 0 to 2.22'],
    ['body=disk&nu=0.33&v=0.1&coat=0.01', 'body=disk&nu=0.33&coat=0.01&Ec=0.01&v=0.1', 'Ec: got none, allowed a number'],
    ['body=disk&nu=0.33&v=0.1&Ec=2', 'body=disk&nu=0.33&v=0.1', 'Ec: got a key that this encounter does not have'],
  ])('say what is wrong with %s', (query, used, line) => {
    const { inputs, problem: told } = fromAddress(query);
    expect(toAddress(inputs)).toBe(used);
    expect(told).toContain(line);
  });
});

describe('units of them', () => {
  it('change with those of the rest', () => {
    const { encounter } = withoutSi(real);
    const { second } = meetingOf(encounter);
    expect(encounter.first).toHaveProperty('roughness', 4.8e-6);
    expect(second!.body).toMatchObject({ roughness: 2e-5, coat: 2e-4, coat_poisson: 0.3, coat_quality: 0 });
    expect(second!.body.coat_young).toBeCloseTo(2e9 / 2.1e11, 4); // E at once is a little more than at 10 kHz
    const back = meetingOf(withSi(withoutSi(real)).encounter).second!.body;
    expect(back.coat).toBeCloseTo(2e-4 * 0.01, 12); // of the ball of a bearing, R = 10 mm
    expect(back.coat_young / 2e9).toBeCloseTo(1, 3);
    const slow = withValue(real.encounter, 'relaxation2', [[0.5, 1e-4]]);
    expect(meetingOf(withoutSi({ ...real, encounter: slow }).encounter).second!.body.relaxation[0]![1]).toBeCloseTo(103.8, 0);
  });
});

describe('lines of them', () => {
  it('are those of the command and of Python', () => {
    expect(commandLine(argumentsOf(plain.encounter, [0.01]))).toBe(
      'stoss restitution --body sphere --poisson 0.3 --relaxation 0.5:1+0.2:10 --roughness 0.002 --against ' +
      'half-space,poisson=0.33,young=0.5,density=1,coat=0.001,coat_young=0.02,coat_poisson=0.4,coat_quality=10 --speed 0.01');
    expect(pythonLines(plain)).toContain('sphere = stoss.Sphere(poisson=0.3, relaxation=[(0.5, 1), (0.2, 10)], roughness=0.002)');
    expect(pythonLines(real)).toContain(
      'block = stoss.Plate(thickness=0.01, roughness=1e-7, coat=1e-6, coat_young=2e9, material=stoss.materials["glass"])');
  });
  it('are said in a few words', () => {
    expect(description(plain.encounter)).toBe('sphere ν 0.3 E(t) 0.5:1+0.2:10 rough 0.002 at half-space ν 0.33 E 0.5 coat 0.001');
    expect(description(real.encounter)).toBe('bearing steel sphere R 5 mm rough 24 nm at glass plate h 10 mm rough 100 nm coat 1 µm');
  });
});

describe('documents of them', () => {
  it('have what is unusual only, and come back', () => {
    expect(real.encounter).toEqual({
      first: { kind: 'sphere', radius: 0.005, material: 'bearing steel', roughness: 2.4e-8 },
      against: { kind: 'plate', thickness: 0.01, material: 'glass', roughness: 1e-7, coat: 1e-6, coat_young: 2e9 },
    });
    const { first, second, ...choice } = meetingOf(real.encounter);
    expect(encounterOf(choice, first.body, second!.body)).toEqual(real.encounter);
  });
});
