// What can be asked about an encounter. What is optional has the value of the command where it is left out.
import type {
  AnglePoint, Collision, CurvePoint, Frame, Grid, Motion, ObliqueCollision, Prediction, Restitution, RowCollision, RowReturn,
  Shape, Thresholds, Units,
} from './answers.js';
import type { Against, First } from './generated/documents.js';

/** Those that take their time. Speeds are in c of the first body, or in m/s if it has a material. */
export interface Questions {
  /** ε at one speed, relative to 1 − ε² to `tolerance` where that can be reached: by default 10⁻³. */
  restitution(given: { speed: number; tolerance?: number }): Restitution;
  /** ε at many speeds. */
  curve(given: { speeds: readonly number[]; tolerance?: number }, each: CurvePoint): void;
  /** The C header that `stoss table --format c` writes: ε between two speeds, by default to 10⁻³. */
  header(given: { slowest: number; fastest: number; error?: number }): string;
  /** What a drop test of a ball of a material shows, at many speeds in m/s; by default with `constants`, the influences
   *  of those that are not known exactly, which takes longer. */
  prediction(given: { speeds: readonly number[]; tolerance?: number; constants?: boolean }, each: Prediction): void;
  /** The collision rule with friction, to `tolerance` of the velocity at which the surfaces slide: by default 10⁻². As
   *  a Restitution, with the quantities of `stoss oblique`. */
  oblique(given: Motion & { tolerance?: number }): Restitution;
  /** The rule at many angles in place of its own. */
  obliqueAngles(
    given: Omit<Motion, 'angle'> & { angles: readonly number[]; tolerance?: number }, each: AnglePoint): void;
  /** One impact with friction in time, at a cutoff in c/R. */
  obliqueCollision(given: Motion & { cutoff: number }): ObliqueCollision;
  /** One impact in time, at a cutoff in c/R: that of a Restitution. */
  collision(given: { speed: number; cutoff: number }): Collision;
  /** Frames of that collision at given times, which ascend. */
  frames(given: { speed: number; cutoff: number; times: readonly number[]; grid: Grid }, each: Frame): void;
  /** What is heard of a body after that collision: the velocity of the struck point, so many samples at an interval in
   *  units.time. The quality is that of modes of a material without loss. */
  sound(given: {
    speed: number; cutoff: number; body: 0 | 1; interval: number; count: number; quality: number;
  }): Float32Array;
  /** The shape of a mode: its order n and index l are those of `stoss modes`. */
  shape(given: { body: 0 | 1; order: number; index: number; grid: Grid }): Shape;
}

/** Those that are answered at once. */
export interface QuickQuestions {
  /** What the numbers of an encounter are measured in; refuses what cannot meet. */
  units(): Units;
  /** At what speeds models of real materials begin to matter. */
  thresholds(): Thresholds;
}

/** Bodies on one line, from left to right: the document of `stoss row --bodies`. */
export interface Row {
  readonly bodies: readonly First[];
  readonly before?: 'wall';
  readonly after?: Against;
  /** between neighbours, what stands at an end included; without it all touch */
  readonly gaps?: readonly number[];
}

/** What can be asked about a row. Speeds are those of the bodies to the right, in c of the first or in m/s; those that are
 *  left out rest. */
export interface RowQuestions {
  /** The velocities after all contacts, to `tolerance` of the greatest difference of speeds: by default 10⁻³. */
  row(given: { speeds: readonly number[]; tolerance?: number }): RowCollision;
  /** The next collision of bodies that hang on strings of one length, without a wall: after `pause`, R/c or s, all come
   *  back at once, with what is left of their vibration. The cutoff is that of the first collision. */
  rowAgain(given: { speeds: readonly number[]; cutoff: number; pause: number; tolerance?: number }): RowReturn;
  /** The lowest frequency of what still vibrates, c/R of the first or rad/s. */
  rowPitch(given: { speeds: readonly number[]; cutoff: number }): number;
  /** What is heard of a body after the collision, as `sound` of an impact. */
  rowSound(given: {
    speeds: readonly number[]; cutoff: number; body: number; interval: number; count: number; quality: number;
  }): Float32Array;
}
