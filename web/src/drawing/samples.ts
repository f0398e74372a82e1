// A sampled function.
import { bisectRight } from 'd3-array';

/** A sampled function at a place between its samples, by lines; beyond them its first or last value. */
export function interpolate(places: ArrayLike<number>, values: ArrayLike<number>, place: number): number {
  const k = bisectRight(places, place) - 1;
  if (k < 0) return values[0] ?? NaN;
  if (k >= places.length - 1) return values[places.length - 1]!;
  const share = (place - places[k]!) / (places[k + 1]! - places[k]!);
  return values[k]! + share * (values[k + 1]! - values[k]!);
}
