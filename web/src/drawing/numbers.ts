// Numbers and units as readers know them.

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

const PREFIXES: [number, string][] = [
  [1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'], [1e-12, 'p'],
];
const PREFIXED = new Set(['s', 'm', 'N', 'N/m', 'Pa', 'Hz']);

/** A unit with the prefix that suits values up to `greatest`, and its size in the unit without; units that are not of
 *  SI stay what they are. */
export function prefixFor(greatest: number, unit: string): { size: number; unit: string } {
  if (!PREFIXED.has(unit) || !(Math.abs(greatest) > 0)) return { size: 1, unit: unitInWords(unit) };
  const fitting = PREFIXES.find(([size]) => Math.abs(greatest) >= size * (1 - 1e-9)) ?? PREFIXES[PREFIXES.length - 1]!;
  return { size: fitting[0], unit: fitting[1] + unit };
}

/** A value with its unit, whose prefix suits `greatest`. */
export function withUnit(value: number, unit: string, digits = 3, greatest = value): string {
  const prefix = prefixFor(greatest, unit);
  const number = written(value / prefix.size, digits);
  return prefix.unit ? `${number} ${prefix.unit}` : number;
}
