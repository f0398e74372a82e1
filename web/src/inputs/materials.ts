// Typical materials: the table of stoss.materials in Python, which a test compares with this one.
import type { Body, Encounter } from '../core/protocol';
import { withSecond } from './inputs';

export interface Material {
  readonly name: string;
  /** Pa */
  readonly young: number;
  readonly poisson: number;
  /** kg/m³ */
  readonly density: number;
  /** Pa; without it the material is brittle, or it is not known well enough */
  readonly yieldStrength?: number;
  /** at `frequency`; without it the loss is not known well enough */
  readonly quality?: number;
  /** at which the quality is meant, rad/s: of contacts that last 50 µs, of rubber 1 ms */
  readonly frequency: number;
}

const hard = 2 * Math.PI * 1e4;
const soft = 2 * Math.PI * 500;

export const materials: readonly Material[] = [
  { name: 'steel', young: 2.1e11, poisson: 0.3, density: 7850, quality: 3000, frequency: hard },
  { name: 'glass', young: 7.0e10, poisson: 0.22, density: 2500, quality: 1000, frequency: hard },
  { name: 'ice', young: 9.3e9, poisson: 0.33, density: 917, quality: 200, frequency: hard },
  { name: 'rubber', young: 2e6, poisson: 0.49, density: 1100, quality: 10, frequency: soft },
  { name: 'bearing steel', young: 2.1e11, poisson: 0.3, density: 7810, yieldStrength: 1.7e9, quality: 3000,
    frequency: hard },
  { name: 'brass', young: 1.1e11, poisson: 0.33, density: 8530, yieldStrength: 4.3e8, quality: 2000,
    frequency: hard },
  { name: 'aluminium', young: 6.9e10, poisson: 0.33, density: 2700, yieldStrength: 2.8e8, quality: 10000,
    frequency: hard },
  { name: 'tungsten carbide', young: 6.2e11, poisson: 0.22, density: 14900, frequency: hard },
  { name: 'granite', young: 5e10, poisson: 0.25, density: 2650, quality: 100, frequency: hard },
  { name: 'PMMA', young: 3.2e9, poisson: 0.37, density: 1190, quality: 30, frequency: hard },
];

/** Loss time η = 1/(Qω) in s, 0 where the quality is not known. */
export function lossTimeOf(material: Material): number {
  return material.quality === undefined ? 0 : 1 / (material.quality * material.frequency);
}

/** The body made of a material, of the same size. */
export function madeOf(material: Material, body: Body): Body {
  const { young, poisson, density } = material;
  return { ...body, young, poisson, density, lossTime: lossTimeOf(material) };
}

/** The material that has the elastic constants and the density of a body in SI. */
function solidOf(body: Body, kind: Encounter['kind']): Material | undefined {
  return materials.find(
    ({ young, density, poisson }) =>
      young === body.young && density === body.density && (kind === 'rod' || poisson === body.poisson),
  );
}

/** The material that a body of an encounter in SI is made of; undefined for numbers of one's own. */
export function materialOf(body: Body, kind: Encounter['kind']): Material | undefined {
  const solid = solidOf(body, kind);
  const lossy = solid !== undefined && Math.abs(lossTimeOf(solid) - body.lossTime) <= 1e-9 * body.lossTime;
  return lossy ? solid : undefined;
}

/** The material of a name. */
export function materialNamed(name: string): Material {
  const found = materials.find((material) => material.name === name);
  if (found === undefined) throw new Error(`there is no material “${name}”`);
  return found;
}

/** Yield strength in Pa of a body in SI; undefined where that of its material is not known. */
export function yieldStrengthOf(body: Body, kind: Encounter['kind']): number | undefined {
  return solidOf(body, kind)?.yieldStrength;
}

/** The same encounter, its bodies with the `yieldStrength` of their material in Pa, as far as that is known. */
export function withStrengths(encounter: Encounter): Encounter {
  if (!encounter.si) return encounter;
  const strong = (body: Body): Body & { yieldStrength?: number } => {
    const yieldStrength = yieldStrengthOf(body, encounter.kind);
    return yieldStrength === undefined ? body : { ...body, yieldStrength };
  };
  return withSecond({ ...encounter, first: strong(encounter.first) }, strong);
}
