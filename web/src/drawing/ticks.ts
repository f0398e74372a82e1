// Numbers as pictures write them, and where an axis has its ticks.

export interface Tick {
  value: number;
  /** '' has no number */
  label: string;
}

const RAISED: Record<string, string> = {
  '-': '⁻', '0': '⁰', '1': '¹', '2': '²', '3': '³', '4': '⁴', '5': '⁵', '6': '⁶', '7': '⁷', '8': '⁸', '9': '⁹',
};

/** 10 to an integer power, with a raised exponent. */
export function powerOfTen(exponent: number): string {
  return '10' + [...String(exponent)].map((each) => RAISED[each] ?? each).join('');
}

/** A number for readers: a few digits, a minus sign, a power of ten where there would be many zeros. */
export function written(value: number, digits = 4): string {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : value > 0 ? '∞' : '−∞';
  const [mantissa, power] = value.toExponential(digits - 1).split('e') as [string, string];
  const exponent = Number(power);
  const plain = exponent >= -3 && exponent < 6;
  const text = plain ? String(Number(value.toPrecision(digits))) : String(Number(mantissa));
  const raised = plain ? '' : text === '1' || text === '-1' ? powerOfTen(exponent) : `×${powerOfTen(exponent)}`;
  return ((plain || raised.startsWith('×') ? text : text.replace('1', '')) + raised).replace('-', '−');
}

/** A unit as readers know it: πRE for the core's piRE, mc²/R for mc^2/R. */
export function unitInWords(unit: string): string {
  const raised = (_: string, power: string): string => [...power].map((each) => RAISED[each]).join('');
  return unit.replace(/^pi/, 'π').replace(/\^(-?\d)/g, raised);
}

/** The least of 1, 2 and 5 times a power of ten that is not below `value`. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  const lead = value / power;
  return (lead <= 1 + 1e-9 ? 1 : lead <= 2 + 1e-9 ? 2 : lead <= 5 + 1e-9 ? 5 : 10) * power;
}

/** The maximum of 1, 2 and 5 times a power of ten that is not above `value`. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  const lead = value / power;
  return (lead < 2 - 1e-9 ? 1 : lead < 5 - 1e-9 ? 2 : 5) * power;
}

/** Ticks at round numbers from `low` to `high`, at most about `count`. */
export function linearTicks(low: number, high: number, count: number): Tick[] {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return [];
  const step = roundUp(span / Math.max(1, count));
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const far = Math.max(Math.abs(low), Math.abs(high));
  const ticks: Tick[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k <= Math.floor(high / step + 1e-9); ++k) {
    const value = k * step;
    const plain = far < 1e5 && step >= 1e-4 * (1 - 1e-9);
    const label = plain ? value.toFixed(decimals).replace('-', '−') : written(value);
    ticks.push({ value, label: k === 0 ? '0' : label });
  }
  return ticks;
}

/** Ticks 1 to 9 times the powers of ten; with numbers at 1, 2 and 5 where `count` of them fit, else at some powers. */
export function logTicks(low: number, high: number, count: number): Tick[] {
  if (!(low > 0) || !(high > low)) return [];
  const decades = Math.log10(high / low);
  const leads = decades * 3 <= count ? [1, 2, 5] : [1];
  const every = Math.max(1, Math.ceil(decades / Math.max(1, count)));
  const name = (value: number, power: number): string => // a row of powers looks best with all written alike
    decades > 4 && (power < -1 || power > 2) ? powerOfTen(power) : written(value);
  const ticks: Tick[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
    for (let lead = 1; lead <= 9; ++lead) {
      const value = Number(`${lead}e${power}`);
      if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
      if (lead > 1 && every > 1) continue;
      const named = leads.includes(lead) && (lead > 1 || power % every === 0);
      ticks.push({ value, label: named ? (lead === 1 ? name(value, power) : written(value)) : '' });
    }
  }
  return ticks;
}
