// What a drop test of a real ball shows, as the core predicts it.
import type { Quantity } from './answers.js';

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
  /** restitution, by_models, by_constants, models_low, models_high, restitution_without_models, … in SI */
  quantities: Record<string, Quantity>;
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
