// The series of an exact number in powers of T: the polynomial through the exact numbers at a few small T, in binary128 (core_formulas.c). It is
// computed twice, from periods up to one and up to half of it: if the two differ, shorter periods are tried.
const MOST = 12; // terms below T^MOST, and the next
const NODES = { 1: 24, 2: 14 }, LONGEST = 0.4, SHORTEST = 1e-3, ROUNDING = 2 ** -52;
const LENGTHS = ["displacement", "dxC", "rear_at_end", "front_at_end"]; // even powers in a steady state and from rest; all others odd

/** Returns periods up to reach times unit, dense at both ends in T^step. */
const periodsUpTo = (reach, unit, step) => Float64Array.from({ length: NODES[step] }, (_, k) => unit * reach * ((1 - Math.cos((Math.PI * (k + 0.5)) / NODES[step])) / 2) ** (1 / step));

/** Returns the series of a formula's quantity, for the chosen crawler; null if not found. unit: a period similar to those at
 * which modes change. terms: powers of T/unit with their coefficients, 0 if one is not significantly different. */
export function* seriesOf(core, formula, phase, v0, unit) {
  const step = formula.setting === 1 || formula.setting === 2 ? 1 : 2, shift = LENGTHS.includes(formula.quantity) ? 0 : 1;
  const count = 1 + Math.ceil((MOST + shift) / step);
  let before = null;
  for (let reach = LONGEST; reach > SHORTEST; reach /= 2) {
    const now = (yield* core.seriesOf(formula, phase, v0, unit, { step, shift }, periodsUpTo(reach, unit, step)))?.subarray(0, count);
    if (before && now && agree(before, now, step)) return { unit, terms: Array.from(before, (c, k) => ({ power: step * k - shift, value: distinct(before, now, k) ? c : 0 })) };
    before = now;
  }
  return null;
}

const largest = (numbers, count) => numbers.subarray(0, count).reduce((most, c) => Math.max(most, Math.abs(c)), 0);
/** Returns true if all coefficients except the last agree to rounding, relative to lower powers, and the one of T^12 to 5e-7. */
const agree = (one, other, step) => one.subarray(0, -1).every((c, k) => Math.abs(c - other[k]) <= ROUNDING * 6 ** (step * k) * Math.max(largest(one, k + 1), 1e-10 * largest(one)));
const distinct = (one, other, k) => Math.abs(one[k]) > 4 * Math.abs(one[k] - other[k]) + ROUNDING * largest(one);

/** Returns the sum of the terms below T^order. */
export function sumOf({ unit, terms }, order, T) {
  const below = terms.filter(({ power }) => power < order);
  return Float64Array.from(T, (t) => below.reduceRight((sum, { power, value }) => sum + value * (t / unit) ** power, 0));
}

/** Returns the power of the first omitted term; undefined if it is not known. */
export const nextPower = ({ terms }, order) => terms.find(({ power, value }) => power >= order && value !== 0)?.power;
