// Limits of the inputs: those of the command, said in its manner.
import type { Body, Encounter } from '../core/protocol';
import { type BodyField, type Field, fieldsOf, labelOf, ofSecond, owner, unitOf, valueOf, withValue } from './fields';
import { type Inputs, secondBody } from './inputs';
import { displayed, parseNumber } from './number';
import { barSpeed, barTime, modulus } from './scales';
import { significant } from './digits';

/** What was typed, checked: the new inputs, or for every wrong field one line that says what is wrong. */
export type Checked = { inputs: Inputs } | { problems: Map<Field, string> };

/** Read all fields that count; a field whose text is missing keeps its number. */
export function check(inputs: Inputs, texts: ReadonlyMap<Field, string>): Checked {
  const problems = new Map<Field, string>();
  let { encounter, speed } = inputs;
  for (const field of fieldsOf(encounter)) {
    const text = texts.get(field);
    if (text === undefined || text === displayed(valueOf(encounter, speed, field))) continue;
    const parsed = parseNumber(nameOf(encounter, field), text);
    if ('problem' in parsed) problems.set(field, parsed.problem);
    else if (field === 'speed') speed = parsed.value;
    else encounter = withValue(encounter, field, parsed.value);
  }
  const next = { ...inputs, encounter, speed };
  for (const [field, problem] of problemsOf(next)) if (!problems.has(field)) problems.set(field, problem);
  return problems.size > 0 ? { problems } : { inputs: next };
}

/** The numbers out of range, by field. */
export function problemsOf(inputs: Inputs): Map<Field, string> {
  const { encounter, speed } = inputs;
  const problems = new Map<Field, string>();
  const second = secondBody(encounter.against);
  const kinds = fieldsOf(encounter);
  const require = (field: Field, value: number, low: number, high: number, hint: string, unit = ''): void => {
    if (!kinds.includes(field) || problems.has(field) || (value >= low && value <= high)) return;
    const allowed = `${shown(low)} to ${shown(high)}${unit === '' ? '' : ` ${unit}`}`;
    problems.set(field, `${nameOf(encounter, field)}: got ${shown(value)}, allowed ${allowed} (${hint})`);
  };
  requireBody(encounter, encounter.first, (name) => name, require);
  if (second !== undefined) {
    requireBody(encounter, second, ofSecond, require);
    if (problems.size === 0) requireRatios(encounter, second, require);
  }
  const c = barSpeed(encounter);
  if (problems.size === 0 || !encounter.si) {
    const hint = encounter.si ? `1e-8 to 1 c; here c = ${significant(c, 4)} m/s` : 'in units of c = √(E/ρ)';
    require('speed', speed, 1e-8 * c, c, hint, unitOf(encounter, 'speed'));
  }
  return problems;
}

type Require = (field: Field, value: number, low: number, high: number, hint: string, unit?: string) => void;

function requireBody(encounter: Encounter, body: Body, named: (name: BodyField) => Field, require: Require): void {
  const { kind, si, plane } = encounter;
  if (kind === 'sphere') require(named('poisson'), body.poisson, -0.95, 0.4999, 'at 0.5 it would be incompressible');
  else if (!si) require(named('poisson'), body.poisson, -0.95, 0.995, 'in plane strain ν/(1−ν) of the solid');
  else if (plane === 'stress') require(named('poisson'), body.poisson, -0.95, 0.4999, 'of the solid; steel has 0.3');
  else require(named('poisson'), body.poisson, -0.9999, 0.4987, 'of the solid; steel has 0.3');
  const hints = {
    young: 'steel has 2.1e11', density: 'steel has 7850', radius: 'a marble has 0.008', area: '1 cm² is 1e-4',
  };
  for (const name of ['young', 'density', 'radius', 'area'] as const) {
    const hint = si ? hints[name] : 'in units of the first body';
    require(named(name), body[name], 1e-30, 1e30, hint, unitOf(encounter, named(name)));
  }
  const own = si ? ownTime(encounter, body) : barTime(encounter);
  const unit = unitOf(encounter, 'lossTime');
  require(named('lossTime'), body.lossTime, 0, 1e5 * own, 'stress = (1 + η ∂/∂t) elastic stress; 0: no loss', unit);
}

function requireRatios(encounter: Encounter, second: Body, require: Require): void {
  const { first, kind, against } = encounter;
  const young = modulus(encounter, second) / modulus(encounter, first);
  const density = second.density / first.density;
  const between = (field: Field, of: string, to: string, ratio: number, most: number): void =>
    require(field, ratio, 1e-3 * (1 - 1e-9), most * (1 + 1e-9), `ratio of the ${of}, ${to}`);
  if (against.kind === 'half-space') {
    between('young2', 'moduli', 'half-space to body', young, 1e6);
    between('density2', 'densities', 'half-space to body', density, 1e6);
    return;
  }
  const length = second.radius / first.radius;
  between('radius2', kind === 'rod' ? 'lengths' : 'radii', 'second to first', length, 1e3);
  if (kind === 'rod') {
    between('radius2', 'transit times', 'second to first', length * Math.sqrt(density / young), 1e3);
    const impedance = (second.area / first.area) * Math.sqrt(density * young);
    between('area2', 'impedances', 'second to first', impedance, 1e3);
  } else {
    between('young2', 'moduli', 'second to first', young, 1e3);
    between('density2', 'densities', 'second to first', density, 1e3);
  }
}

function ownTime(encounter: Encounter, body: Body): number {
  const density = body.density / (modulus(encounter, body) || 1);
  const alone = encounter.against.kind === 'half-space' ? encounter.first.radius : body.radius;
  return alone * Math.sqrt(density);
}

/** A field's name in a message: without its symbol. */
function nameOf(encounter: Encounter, field: Field): string {
  const name = labelOf(encounter, field).replace(/ (ν|[EρRLAηv]|\S₂\S*)$/, '');
  return owner(field)?.second === true ? `${name} of what it meets` : name;
}

function shown(value: number): string {
  return significant(value, 6);
}

