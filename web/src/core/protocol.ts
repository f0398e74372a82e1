// What the page asks of the core, which runs in a worker: what the package (web/package) asks and answers, in full.
import type * as stoss from 'stoss';

export { CoreError, type Deliver, type Refusal } from 'stoss';
export type {
  AnglePoint, BodyFrame, Channel, Collision, Course, CurvePoint, Elastic, Encounter, Frame, Grid, ModeEnergy, ObliqueCollision,
  Prediction, Quantities, Quantity, Restitution, Shape, Thresholds, Units,
} from 'stoss';

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
  question: Name, encounter: stoss.Encounter, given: Parameters<Questions[Name]>[0],
  asking?: Asking<Parameters<Questions[Name]>[1] & {}>,
) => Promise<ReturnType<Questions[Name]>>;
