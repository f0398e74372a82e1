// Impacts that a class can see for itself, each with all of its inputs.
import type { Body, Encounter } from '../core/protocol';
import { madeOf } from './document';
import { type Inputs, defaults, equal, unitBody } from './inputs';
import { materialNamed } from './kinds';

export interface Preset {
  readonly name: string;
  readonly encounter: Encounter;
  readonly speed: number;
}

/** A ball that falls on a block: radius in m, speed in m/s. */
function drop(name: string, material: string, radius: number, block: string, speed: number): Preset {
  const made = (of: string, size: number): Body => madeOf(materialNamed(of), { ...unitBody, radius: size, area: 1e-4 });
  const against = { kind: 'half-space', body: made(block, radius) } as const;
  const encounter: Encounter = { kind: 'sphere', first: made(material, radius), against, si: true, plane: 'stress' };
  return { name, encounter, speed };
}

export const presets: readonly Preset[] = [
  { name: 'Elastic disk at a wall', encounter: defaults.encounter, speed: defaults.speed },
  drop('Glass marble on a granite table', 'glass', 0.008, 'granite', 1),
  drop('Rubber ball on a granite floor', 'rubber', 0.02, 'granite', 2),
  drop('Steel ball on glass', 'bearing steel', 0.005, 'glass', 1),
];

/** The preset that inputs are; undefined for those of one's own. */
export function presetOf({ encounter, speed }: Inputs): Preset | undefined {
  return presets.find((preset) => preset.speed === speed && equal(preset.encounter, encounter));
}
