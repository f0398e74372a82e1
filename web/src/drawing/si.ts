// The units of the core's own numbers where bodies are in SI.

import type { Encounter } from '../core/protocol';
import { withUnit } from './prefix';
import { written } from './ticks';

/** Modulus of the first body in Pa: E, or of a disk in plane strain E/(1 − ν²); undefined where units are its own. */
export function modulus({ kind, first, plane, si }: Encounter): number | undefined {
  if (!si) return undefined;
  return kind === 'disk' && plane === 'strain' ? first.young / (1 - first.poisson ** 2) : first.young;
}

/** A frequency in words: ω in c/R, or in SI ω/2π in Hz. */
export function frequencyInWords(omega: number, encounter: Encounter): string {
  const own = modulus(encounter);
  if (own === undefined) return `ω = ${written(omega)} c/${encounter.kind === 'rod' ? 'L' : 'R'}`;
  const hertz = (omega * Math.sqrt(own / encounter.first.density)) / encounter.first.radius / (2 * Math.PI);
  return withUnit(hertz, 'Hz', 4);
}
