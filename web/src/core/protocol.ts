// What the page asks of the core, which runs in a worker, and what it gets back.
// Words are those of the command: docs/architecture.md, stoss --help.

import type { Block, BodyField, BodyKind } from '../inputs/kinds';
import type { AnglePoint, Motion, ObliqueCollision } from './oblique';
import type { Prediction } from './prediction';

export type { AnglePoint, Motion, ObliqueCollision, Prediction };

/** A body as a user gives it: in SI, or in units of the first body, which are all 1. What its kind does not have is not
 *  used. */
export type Body = Record<BodyField, number>;

/** What the first body meets: a rigid wall, its like, another of its kind, or a block by its name for a sphere. */
export type Against = 'wall' | 'same' | 'body' | Block;

/** A body by its modes at a point, of a file that the user has opened. */
export interface BodyFile {
  /** of the file */
  readonly name: string;
  /** of the body */
  readonly title: string;
  readonly document: unknown;
}

/** Who meets whom. */
export interface Encounter {
  kind: BodyKind;
  first: Body;
  against: Against;
  /** of a body or a half-space */
  second: Body;
  /** Whether bodies and speeds are in SI. */
  si: boolean;
  /** of a disk in SI */
  plane: 'stress' | 'strain';
  /** in place of the first, a sphere in SI of its curvature and material */
  firstFile?: BodyFile;
  /** in place of another body, such a sphere too */
  secondFile?: BodyFile;
}

/** What an encounter's numbers are measured in. */
export interface Units {
  /** c, R/c and c/R of the first body: 1 or in SI */
  speed: number;
  time: number;
  frequency: number;
  /** E of the first body, of a disk in the plane: only in SI, Pa */
  modulus?: number;
  first: Elastic;
  second?: Elastic;
}

/** Of a body that the core computes with; E in that of the first. */
export interface Elastic {
  young: number;
  /** not of a rod */
  poisson?: number;
}

/** A number as the core gives it, in `unit` ('' for a pure number); without `error` where there is none. An infinite
 *  error is unknown. */
export interface Quantity {
  value: number;
  unit: string;
  error?: number;
}

/** ε of one speed: what `stoss restitution --format json` prints, by the same names. */
export interface Restitution {
  speed: number;
  /** restitution, lost_fraction, contact_time, max_force, max_compression, … in units of the first body; with `si`
   *  besides contact_time_si, … */
  quantities: Record<string, Quantity>;
  converged: boolean;
  /** why not converged; '' */
  reason: string;
  /** of the finest impact, c/R: `stoss impact --cutoff` repeats it */
  cutoff: number;
  /** Whether linear elasticity has lost its meaning. */
  beyondSmallStrain: boolean;
  /** of spheres in SI, one of which has a yield strength: the speed in m/s at which it begins to yield */
  yieldSpeed?: number;
}

/** What a collision has for every instant; energies are shares of the initial one. */
type Instants = 'time' | 'velocity' | 'force' | 'contact_half_width'
  | 'translation' | 'vibration' | 'stored' | 'dissipated' | 'unresolved';

/** One impact in time, at a cutoff: `stoss impact --cutoff` computes the same. Times are in
 *  `units.time`, from the start of the impact, just out of contact. */
export interface Collision extends Record<Instants, Float64Array> {
  units: Record<'time' | 'velocity' | 'force', string>;
  /** of the bodies; the waves of a half-space are none of them */
  modes: ModeEnergy[];
  /** first and last instant in contact, in units.time */
  begin: number;
  end: number;
}

/** What collisions of both kinds have. */
export type Course = Pick<Collision, 'time' | 'velocity' | 'force' | 'units' | 'begin' | 'end'>;

export interface ModeEnergy {
  /** 0: of the first body, 1: of the second */
  body: 0 | 1;
  order: number;
  index: number;
  /** in units of frequency of the first */
  omega: number;
  /** shares of the initial energy */
  after: number;
  average: number;
}

/** Points of a body at rest: every radius (0 … 1 of its own) with every angle; angle 0 points to what it meets. Of a
 *  rod `radius` is the place along it (0: the struck end), and all angles are alike. `below`: of a half-space, with
 *  which frames need it, every depth with every distance from the axis, in radii of the first; both begin with 0. */
export interface Grid {
  radius: Float32Array;
  angle: Float32Array;
  below?: { depth: Float32Array; distance: Float32Array };
}

/** A body at one instant, at the points of a grid: radii × angles, of a half-space depths × distances, row-major. */
export interface BodyFrame {
  /** place of its centre, of a half-space of its surface, in radii of the first; at rest, bodies would first touch at
   *  0 */
  center: number;
  /** displacement in units of its own radius: along the radius, and along the angle; of a rod towards what it meets; of
   *  a half-space into it and away from the axis, in radii of the first */
  radial: Float32Array;
  tangential: Float32Array;
  /** von Mises stress and difference of the principal stresses in the plane, in units of the first body's modulus */
  vonMises: Float32Array;
  fringes: Float32Array;
}

/** What meets at one instant. x points from the first body to what it meets; the first body's centre is at x < 0. */
export interface Frame {
  /** in units.time of the collision, from its start: that of the step nearest to what was asked for */
  time: number;
  /** 1 at a wall, 2 for a pair or a half-space. Of a large one only the near side is computed: it is as at rest */
  bodies: BodyFrame[];
}

/** Shape of one mode of a body at the points of a grid, maximum displacement 1. */
export interface Shape {
  radial: Float32Array;
  tangential: Float32Array;
}

export interface CurvePoint {
  speed: number;
  restitution: number;
  error: number;
  converged: boolean;
}

/** What the core cannot do: one line for the user, with the name of the argument first where there is one. */
export class CoreError extends Error {}

export type Deliver = (each: never, index: number) => void;

/** What can be asked about an encounter. */
export interface Questions {
  /** ε at one speed (c, or m/s with si), relative to 1 − ε² to `tolerance` where that can be reached. */
  restitution(given: { speed: number; tolerance: number }): Restitution;
  /** One impact in time, at a cutoff in c/R: that of a Restitution. */
  collision(given: { speed: number; cutoff: number }): Collision;
  /** Frames of that collision at given times, which ascend. */
  frames(given: { speed: number; cutoff: number; times: number[]; grid: Grid }, each: Frame): void;
  /** What is heard of a body after that collision: the velocity of the struck point, so many samples at an interval in
   *  units.time. The quality is that of modes of a material without loss. */
  sound(given: {
    speed: number; cutoff: number; body: 0 | 1; interval: number; count: number; quality: number;
  }): Float32Array;
  shape(given: { body: 0 | 1; order: number; index: number; grid: Grid }): Shape;
  /** ε at many speeds, from a worker of its own. */
  curve(given: { speeds: number[]; tolerance: number }, each: CurvePoint): void;
  /** What a drop test of a ball of a material shows, at many speeds in m/s, from a worker of its own; with `constants`
   *  the influences of those that are not known exactly, which takes longer. */
  prediction(given: { speeds: number[]; tolerance: number; constants: boolean }, each: Prediction): void;
  /** The collision rule, to `tolerance` of the velocity at which the surfaces slide: as a Restitution, with the
   *  quantities of `stoss oblique`. */
  oblique(given: Motion & { tolerance: number }): Restitution;
  /** The rule at many angles in place of its own. */
  obliqueAngles(given: Motion & { angles: number[]; tolerance: number }, each: AnglePoint): void;
  obliqueCollision(given: Motion & { cutoff: number }): ObliqueCollision;
  /** The C header that `stoss table --format c` writes. */
  header(given: { slowest: number; fastest: number; error: number }): string;
}

export interface Asking<Each> {
  /** gets each frame or point when it is there */
  deliver?: (each: Each, index: number) => void;
  signal?: AbortSignal;
}

/** The core, seen from the page. It answers from a worker; it rejects with CoreError for what the core cannot do, with
 *  another Error if its worker died twice. A call whose signal is aborted rejects with the signal's reason, and its
 *  work ends soon. */
export type Core = <Name extends keyof Questions>(
  question: Name, encounter: Encounter, given: Parameters<Questions[Name]>[0],
  asking?: Asking<Parameters<Questions[Name]>[1] & {}>,
) => Promise<ReturnType<Questions[Name]>>;
