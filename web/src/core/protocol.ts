// What the page asks of the core, which runs in a worker: who meets whom as the page has it. What the core is asked and
// answers is that of the package (web/package).
import type * as stoss from 'stoss';
import type { Block, BodyField, BodyKind } from '../inputs/kinds';

export { CoreError, type Deliver } from 'stoss';
export type {
  AnglePoint, BodyFrame, Channel, Collision, Course, CurvePoint, Elastic, Frame, Grid, ModeEnergy, ObliqueCollision,
  Prediction, Quantity, Restitution, Shape, Thresholds, Units,
} from 'stoss';

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

/** How they meet, in full. */
export type Motion = Required<stoss.Motion>;

/** What the page asks, in full. */
export type Questions = {
  [Name in keyof stoss.Questions]: (
    given: Required<Parameters<stoss.Questions[Name]>[0]>, each: Parameters<stoss.Questions[Name]>[1],
  ) => ReturnType<stoss.Questions[Name]>;
};

/** A question with all that the core needs for it. */
export interface Call {
  readonly question: keyof Questions;
  readonly given: object;
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
