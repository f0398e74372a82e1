// A sampled function.

/** The index of the last value of a sorted array that is not above `value`; −1 below the first. */
export function lastNotAbove(values: ArrayLike<number>, value: number): number {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle]! <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** A sampled function at a place between its samples, by lines; beyond them its first or last value. */
export function interpolate(places: ArrayLike<number>, values: ArrayLike<number>, place: number): number {
  const k = lastNotAbove(places, place);
  if (k < 0) return values[0] ?? NaN;
  if (k >= places.length - 1) return values[places.length - 1]!;
  const share = (place - places[k]!) / (places[k + 1]! - places[k]!);
  return values[k]! + share * (values[k + 1]! - values[k]!);
}
