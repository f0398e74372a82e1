import { describe, expect, it } from 'vitest';
import { defaults } from '../../src/inputs/inputs';
import { argumentsOf, commandLine, curveCsv, description, pythonLines, ruleArguments, version } from '../../src/inputs/lines';
import { cases, obliqueCases } from './cases';

const lines = cases.map(({ encounter, speed }) => commandLine(argumentsOf(encounter, [speed])));

describe('the command line', () => {
  it('has what is not usual only', () => {
    expect(lines[0]).toBe('stoss restitution --body disk --poisson 0.33 --speed 0.1');
    expect(lines[3]).toBe('stoss restitution --body disk --poisson 0.33 ' +
      '--against half-plane,poisson=0.2,young=0.5,density=1,loss_time=0.02 --speed 0.05');
    expect(lines[6]).toBe(
      'stoss restitution --body rod --against rod,young=1,density=3,length=2.5,area=0.5 --speed 0.1');
  });
  it('has the thickness of a plate', () => {
    expect(lines[13]).toBe('stoss restitution --body sphere --poisson 0.3 ' +
      '--against plate,poisson=0.2,young=0.5,density=1,thickness=2 --speed 0.1');
    expect(lines[14]).toBe("stoss restitution --body disk --material 'structural steel' --radius 0.01 --plane strain " +
      '--against strip,poisson=0.25,young=1.5e11,density=5000,thickness=0.03,loss_time=1e-9 --speed 1');
  });
  it('is that of the collision rule where there is friction', () => {
    expect(commandLine(ruleArguments(defaults))).toBe(lines[0]);
    expect(commandLine(ruleArguments(obliqueCases[1]!))).toBe('stoss oblique --body disk --poisson 0.33 --against ' +
      'disk,poisson=0.2,young=2,density=3,radius=0.5 --speed 0.1 --angle -20 --friction 0.2 ' +
      '--spin 0.05 --second-spin -0.1');
    expect(pythonLines(obliqueCases[2]!).trimEnd().split('\n').at(-1)).toBe(
      'print(stoss.oblique(sphere, speed=0.01, angle=70, friction=1, spin=-0.02))');
  });
  it('names materials, as one word of a shell', () => {
    expect(lines[10]).toBe("stoss restitution --body sphere --material 'bearing steel' --radius 0.005 " +
      '--against half-space,material=glass --speed 1');
    for (const line of lines) expect(line).toMatch(/^([a-zA-Z0-9 .,:+=_-]|'[a-zA-Z0-9 .,=_-]+')+$/);
  });
});

describe('the Python lines', () => {
  it('name a known material', () => {
    const { encounter, speed } = cases[10]!;
    expect(pythonLines({ ...defaults, encounter, speed })).toBe(
      [
        'import stoss', '', 'sphere = stoss.Sphere(radius=0.005, material=stoss.materials["bearing steel"])',
        'block = stoss.HalfSpace(material=stoss.materials["glass"])',
        'print(stoss.restitution(sphere, against=block, speed=1))', '',
      ].join('\n'));
  });
});

describe('a quality', () => {
  it('is in the lines, and the loss time is not', () => {
    expect(lines[16]).toBe('stoss restitution --body sphere --poisson 0.3 --quality 30 ' +
      '--against half-space,poisson=0.33,young=0.5,density=1,loss_time=0.02 --speed 0.01');
    expect(lines[17]).toBe("stoss restitution --body sphere --material 'bearing steel' --radius 0.005 --quality 50 " +
      '--against half-space,poisson=0.25,young=1.5e11,density=5000,quality=12 --speed 1');
    expect(pythonLines(cases[17]!)).toContain(
      'sphere = stoss.Sphere(radius=0.005, quality=50, material=stoss.materials["bearing steel"])');
  });
  it('is said in a few words', () => {
    expect(description(cases[16]!.encounter)).toBe('sphere ν 0.3 Q 30 at half-space ν 0.33 E 0.5 η 0.02');
  });
});

describe('plates', () => {
  const { encounter, speed } = cases[15]!;
  it('are blocks with a thickness in Python', () => {
    expect(pythonLines({ ...defaults, encounter, speed }).split('\n')[3]).toBe(
      'block = stoss.Plate(thickness=0.01, material=stoss.materials["glass"])');
    expect(pythonLines(cases[14]!)).toContain('block = stoss.Strip(thickness=0.03, loss_time=1e-9, material=stoss.Material(');
  });
  it('are said in a few words', () => {
    expect(description(encounter)).toBe('bearing steel sphere R 5 mm at glass plate h 10 mm');
    expect(description(cases[13]!.encounter)).toBe('sphere ν 0.3 at plate ν 0.2 E 0.5 h 2');
  });
});

describe('the CSV of a curve', () => {
  const points = [
    { speed: 0.1, restitution: 0.94706, error: 3.1e-5, converged: true },
    { speed: 0.01, restitution: 0.98, error: Infinity, converged: false },
  ];
  it('has the command’s names, slowest first', () => {
    expect(curveCsv(cases[0]!.encounter, points)).toBe([
      `# stoss ${version}: restitution`,
      '# command: stoss restitution --body disk --poisson 0.33 --speed 0.01,0.1 --format csv',
      '# first: {"kind":"disk","poisson":0.33,"loss_time":0}', '# against: wall', '# tolerance: 0.001',
      'poisson,speed[c],restitution,restitution_error,converged',
      '0.33,0.01,0.98,unknown,false', '0.33,0.1,0.94706,3.1e-5,true', '',
    ].join('\n'));
  });
  it('has both speeds in SI, and no Poisson’s ratio for a rod', () => {
    const { encounter } = cases[12]!;
    const text = curveCsv(encounter, points);
    expect(text).toContain('\nspeed[c],speed_si[m/s],restitution,');
    expect(text).toContain(' --material aluminium ');
  });
});
