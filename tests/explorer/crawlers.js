// Random crawlers of all families of gaits, and how far two answers are apart in units.
export const NAMES = ["m1", "m2", "F1", "F2", "L", "T", "alpha"];
export const NUMBERS = ["froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier"];

/** splitmix64 (Steele, Lea & Flood 2014): a number in [0, 1) at each call */
export function random(seed) {
  let state = BigInt(seed);
  const mask = (1n << 64n) - 1n;
  return () => {
    state = (state + 0x9e3779b97f4a7c15n) & mask;
    let z = state;
    z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & mask;
    z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & mask;
    return Number((z ^ (z >> 31n)) >> 11n) / 2 ** 53;
  };
}

/** A table of t and l that is no known gait: the sum of two waves. */
export function measuredTable(next) {
  const rows = 12 + Math.floor(40 * next()), skew = 0.3 * next(), lines = ["t\tl"];
  for (let i = 0; i <= rows; i++) {
    const s = 2 * Math.PI * ((i % rows) / rows);
    lines.push(`${(i * 3) / rows}\t${1 - Math.cos(s + skew * Math.sin(s)) + 0.05 * skew * Math.sin(2 * s)}`);
  }
  return lines.join("\n") + "\n";
}

const part = (next, most) => (most * (0.02 + 0.98 * next())).toPrecision(6);
const GAITS = [
  () => "quadratic",
  () => "sinusoidal",
  (next) => `trapezoidal:${part(next, 0.5)},${part(next, 0.5)}`,
  (next) => `trapezoidal:${part(next, 0.5)},${part(next, 0.5)},${part(next, 0.5)},${part(next, 0.5)}`,
  (next) => `skewed:${part(next, 0.9)}`,
  (next) => `skewed:${part(next, 0.9)},${part(next, 0.9)}`,
  (next) => `constant:${part(next, 0.5)}`,
  () => "constant:0",
  () => "minimum-jerk",
  () => "polynomial:0,3,-2",
  () => "polynomial:0,0,0,35,-84,70,-20",
];

/** count crawlers { gait, m1, ... }, of which some have the gaits of `measured`. */
export function crawlers(count, measured, seed = 20) {
  const next = random(seed), decades = (from, to) => from * (to / from) ** next();
  return Array.from({ length: count }, (_, i) => {
    const kinds = GAITS.length + measured.length, kind = i % kinds;
    const crawler = { gait: kind < GAITS.length ? GAITS[kind](next) : measured[kind - GAITS.length] };
    for (const name of NAMES) crawler[name] = name === "alpha" ? 0.05 + 0.9 * next() : name === "T" ? decades(1e-3, 1e2) : decades(0.1, 10);
    if (i % 10 === 3) crawler.m2 = crawler.m1;
    if (i % 10 === 7) crawler.alpha = 0.75;
    return crawler;
  });
}

function ulp(x) {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, Math.abs(x));
  bits.setBigUint64(0, bits.getBigUint64(0) + 1n);
  return bits.getFloat64(0) - Math.abs(x);
}

/** What one ulp of each argument changes the number by, or an ulp of the number if that is more. */
export function unit(core, crawler, name) {
  const h = 2 ** -28;
  const solved = (parameter, factor) => {
    core.chooseCrawler({ ...crawler, [parameter]: crawler[parameter] * factor });
    return core.steady()[name];
  };
  const sum = NAMES.reduce((all, parameter) => {
    const slope = (solved(parameter, 1 + h) - solved(parameter, 1 - h)) / (2 * h * crawler[parameter]);
    return all + Math.abs(slope) * ulp(crawler[parameter]);
  }, 0);
  core.chooseCrawler(crawler);
  return Math.max(sum, ulp(core.steady()[name]));
}
