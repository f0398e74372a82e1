// Browsers compile what has run often once more, for all workers of a module: a first value that takes long on a
// fresh page takes half as long after another one like it, in any worker.
import { encounterOf, unitBody } from '../inputs/document';
import type { Core } from './protocol';

/** Those whose values take the longest. */
const encounters = (['sphere', 'disk'] as const).map((kind) =>
  encounterOf({ kind, si: false, plane: 'stress', against: 'half-space' }, unitBody));

/** What a first value may be. */
const values: ReadonlySet<string> = new Set(['restitution', 'prediction', 'oblique']);

/** The core, which computes values of its own, where curves are computed, as soon as it has answered the first; `answered`
 *  is called before. */
export function withWarmUp(core: Core, answered: () => void): Core {
  let cold = true;
  return async (question, ...rest) => {
    const result = await core(question, ...rest);
    if (cold && values.has(question)) {
      cold = false;
      answered();
      // Whatever fails here fails again where it is asked for.
      for (const encounter of encounters) core('curve', encounter, { speeds: [0.1], tolerance: 1e-2 }).catch(() => {});
    }
    return result;
  };
}
