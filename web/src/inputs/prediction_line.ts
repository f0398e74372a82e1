// The command line that predicts what the page predicts: its materials by their names.
import type { Encounter } from '../core/protocol';
import { shortest } from '../drawing/numbers';
import { type Side, poissonOf, sidesOf } from './document';

function pairsOf(side: Side): [string, string][] {
  const { kind, body, fields, solid, material } = side;
  const [own, sizes] = [true, false].map((wanted) =>
    kind.parameters.filter(({ name, ofMaterial }) => ofMaterial === wanted && fields.includes(name)));
  const numbers = [...(solid ? [] : own!), ...sizes!].map(({ name }) => name).filter((name) => name !== 'loss_time');
  return [
    ...(solid ? [['material', solid.name] as [string, string]] : []),
    ...numbers.map((name): [string, string] => [name, shortest(name === 'poisson' ? poissonOf(side) : body[name])]),
    ...(material ? [] : [['loss_time', shortest(body.loss_time)] as [string, string]]),
  ];
}

/** Arguments of `stoss` for a prediction at a speed in m/s. */
export function predictionArguments(encounter: Encounter, speed: number): string[] {
  const [first, second] = sidesOf(encounter);
  const other = second ? [second.kind.name, ...pairsOf(second).map((pair) => pair.join('='))].join(',')
    : encounter.against;
  return [
    'predict', '--body', encounter.kind,
    ...pairsOf(first).flatMap(([key, value]) => [`--${key.replace('_', '-')}`, value]),
    ...(other === 'wall' ? [] : ['--against', other]), '--speed', shortest(speed),
  ];
}

/** The same as a line to be pasted into a shell. */
export function predictionLine(encounter: Encounter, speed: number): string {
  return ['stoss', ...predictionArguments(encounter, speed).map((each) => (/\s/.test(each) ? `'${each}'` : each))]
    .join(' ');
}
