// What the page asks of the core, which runs in a worker: what the package (web/package) asks and answers, in full.
import type * as stoss from 'stoss';

export { CoreError, type Deliver, type Refusal } from 'stoss';
export type {
  AnglePoint, BodyFrame, Channel, Collision, Course, CurvePoint, Elastic, Encounter, Frame, Grid, ModeEnergy, Numbers, ObliqueCollision,
  Prediction, Quantities, Quantity, Restitution, Row, RowCollision, RowReturn, Shape, Thresholds, Units,
} from 'stoss';

/** How they meet, in full. */
export type Motion = Required<stoss.Motion>;

/** What the page asks, in full. */
export type Questions = {
  [Name in keyof stoss.Questions]: (
    given: Required<Parameters<stoss.Questions[Name]>[0]>, each: Parameters<stoss.Questions[Name]>[1],
  ) => ReturnType<stoss.Questions[Name]>;
};

/** What it asks about rows. */
export type RowQuestions = {
  [Name in keyof stoss.RowQuestions]: (given: Required<Parameters<stoss.RowQuestions[Name]>[0]>) =>
    ReturnType<stoss.RowQuestions[Name]>;
};

/** A question with all that the core needs for it. */
export interface Call {
  readonly question: keyof Questions | keyof RowQuestions;
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

/** The core, asked about a row in the same way. */
export type RowCore = <Name extends keyof RowQuestions>(
  question: Name, row: stoss.Row, given: Parameters<RowQuestions[Name]>[0], signal?: AbortSignal,
) => Promise<ReturnType<RowQuestions[Name]>>;
