// What the core is asked of a motion, and what it answers. Words are those of the command: stoss --help.
import type { Quantities } from './generated/quantities.js';

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
  /** what it is */
  help: string;
  error?: number;
}

/** The quantities of a result: in units of the first body; with a material, where they have a dimension, besides in SI. */
export type Numbers = Quantities<Quantity> & { readonly [Name in `${keyof Quantities<0>}_si`]?: Quantity };

/** ε of one speed: what `stoss restitution --format json` prints, by the same names. */
export interface Restitution {
  speed: number;
  quantities: Numbers;
  converged: boolean;
  /** why not converged; '' */
  reason: string;
  /** of the finest impact, c/R: `stoss impact --cutoff` repeats it */
  cutoff: number;
  /** what to know of a body that stays on a plate; '' */
  note: string;
  /** Whether strains are above 0.1, the quantity `strain`: linear elasticity is no longer accurate. */
  beyondSmallStrain: boolean;
  /** Of an oblique impact: whether the contact rolls by more than its half-width, as bodies turn by the angle `turned`. */
  beyondSmallTurn?: boolean;
  /** of spheres in SI, one of which has a yield strength: the speed in m/s at which it begins to yield */
  yieldSpeed?: number;
  /** beyond that speed: how far, in one line, which the command prints as a warning */
  yieldWarning?: string;
  /** what else the command warns of the materials: a shell that bends by more than its thickness, a loss that is off in
   *  contacts as long as this, samples that are not sound */
  materialWarnings?: string[];
}

/** What a collision has for every instant; energies are shares of the initial one. */
type Instants = 'time' | 'velocity' | 'force' | 'contact_half_width'
  | 'translation' | 'vibration' | 'stored' | 'dissipated' | 'yielded' | 'unresolved';

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

/** How they meet: the speed of approach is that along the normal. With friction the first body comes in at an angle. */
export interface Motion {
  /** c of the first body, or m/s in SI */
  readonly speed: number;
  /** μ of Coulomb's law, by default that of the encounter; without it nothing along the surface counts */
  readonly friction?: number;
  /** between its velocity, relative to what it meets, and the normal, in degrees */
  readonly angle: number;
  /** of both bodies, in c/R of the first, or rad/s in SI, by default 0; they move what touches as the angle does */
  readonly spin?: number;
  readonly second_spin?: number;
}

/** ε_t of one angle, with ε. */
export interface AnglePoint {
  angle: number;
  restitution: number;
  error: number;
  tangential: number;
  tangentialError: number;
  converged: boolean;
}

/** What an oblique collision has for every instant: what is along the normal and along the surface, and shares of
 *  the energy. */
type ObliqueInstants = 'time' | 'velocity' | 'tangential' | 'force' | 'friction'
  | 'translation' | 'across' | 'rotation' | 'second_rotation' | 'elastic' | 'friction_loss';

/** One oblique impact in time, at a cutoff. */
export interface ObliqueCollision extends Record<ObliqueInstants, Float64Array> {
  units: Record<'time' | 'velocity' | 'force', string>;
  begin: number;
  end: number;
  /** what moves, as its centre of mass, or the wall or half-space that it meets, sees it: places of centres in radii of
   *  the first, bodies at rest would first touch at x = 0; and by how much they have turned counterclockwise */
  bodies: Record<'x' | 'y' | 'angle', Float64Array>[];
  /** of the contact points along the surface, in radii of the first, in their order; those of rings are their radii */
  places: Float64Array;
  /** what they do, instants × places: 0 stick, 1 and −1 slip along and against y, 2 carry no pressure */
  grips: Int8Array;
}

/** What takes energy; ringing, radiation and material are computed, the others are models. */
export interface Channel {
  /** as the command has it */
  name: string;
  /** of the energy before the impact */
  share: number;
  model: boolean;
}

/** By what ε changes where a constant of a material is larger, by the factor within which it is known. */
export interface Influence {
  constant: string;
  /** that factor is 1 + this */
  uncertainty: number;
  change: number;
}

/** ε of one speed with all channels: what `stoss predict --format json` prints. */
export interface Prediction {
  speed: number;
  /** in SI */
  quantities: Quantities<Quantity>;
  channels: Channel[];
  /** the name of the one with the largest share */
  dominant: string;
  /** the largest change first; none where constants are taken as exact */
  influences: Influence[];
  warnings: string[];
}

/** Speeds in m/s at which models begin to matter. */
export interface Thresholds {
  /** it yields above; undefined where no strength is known */
  yield?: number;
  /** it sticks below; 0: never */
  sticking: number;
}

/** One collision of all bodies of a row: what `stoss row --format json` prints, by the same names. */
export interface RowCollision {
  readonly quantities: Numbers;
  /** from left to right: `velocity`, and `velocity_after` with its error */
  readonly bodies: readonly Numbers[];
  /** from left to right: when, how often and how hard */
  readonly contacts: readonly Numbers[];
  readonly converged: boolean;
  /** why not converged; '' */
  readonly reason: string;
  /** of the finest motion, c/R of the first body */
  readonly cutoff: number;
  readonly beyondSmallStrain: boolean;
  readonly materialWarnings: readonly string[];
}

/** The next collision of pendulums. */
export interface RowReturn extends RowCollision {
  /** energy of the vibration that is left then, over that of the centres before the first collision */
  readonly left: number;
}
