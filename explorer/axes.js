// Axes of a map, and the crawlers along them, as in `scallop breakdown --map`: F1 = x F2, m1 = x m2, T from the Froude number.
export const AXES = {
  "F1/F2": { from: 0.1, to: 1000, log: true, sets: "F1", of: (c) => c.F1 / c.F2, value: (c, x) => x * c.F2 },
  "m1/m2": { from: 0.01, to: 100, log: true, sets: "m1", of: (c) => c.m1 / c.m2, value: (c, x) => x * c.m2 },
  alpha: { from: 0.01, to: 0.99, log: false, sets: "alpha", of: (c) => c.alpha, value: (_, x) => x },
  T: { from: 0.01, to: 100, log: true, sets: "T", of: (c) => c.T, value: (_, x) => x },
  froude: { from: 0.01, to: 100, log: true, sets: "T", of: froude, value: (c, x) => Math.sqrt(((c.m1 + c.m2) * c.L) / (x * (c.F1 + c.F2))) },
};
export const LABELS = { "F1/F2": "F1/F2", "m1/m2": "m1/m2", alpha: "alpha", T: "T", froude: "Froude number" };
const FIELDS = ["m1", "m2", "F1", "F2", "L", "T", "alpha"];

function froude(c) {
  return ((c.m1 + c.m2) * c.L) / (c.T * c.T * (c.F1 + c.F2));
}

/** Returns the ends of an axis, wide enough for the crawler. */
export function range(name, crawler) {
  const { from, to, log, of } = AXES[name], x = of(crawler);
  if (!log) return [Math.min(from, x), Math.max(to, x)];
  return [Math.min(from, 10 ** Math.floor(Math.log10(x) + 1e-9)), Math.max(to, 10 ** Math.ceil(Math.log10(x) - 1e-9))];
}

/** Returns the value at a fraction of an axis, 0 to 1. */
export const valueAt = (name, [from, to], part) => (AXES[name].log ? from * (to / from) ** part : from + (to - from) * part);

/** Returns the crawler's fields at places on axes; the Froude number last, because it depends on the others. */
export function placed(crawler, places) {
  const made = { ...crawler };
  for (const [name, x] of places.filter(([name]) => name !== "froude")) made[AXES[name].sets] = AXES[name].value(made, x);
  for (const [name, x] of places.filter(([name]) => name === "froude")) made[AXES[name].sets] = AXES[name].value(made, x);
  return made;
}

/** Writes count crawlers, at places(i), to rows of the core. */
export function fill(rows, crawler, count, names, xs) {
  FIELDS.forEach((field, k) => rows[k].fill(crawler[field]));
  const order = names[0] === "froude" ? [1, 0] : [0, 1], [m1, m2, F1, F2, L, T] = rows;
  for (const k of order) {
    if (k >= names.length) continue;
    const x = xs[k], name = names[k];
    if (name === "F1/F2") for (let i = 0; i < count; i++) F1[i] = x[i] * F2[i];
    else if (name === "m1/m2") for (let i = 0; i < count; i++) m1[i] = x[i] * m2[i];
    else if (name === "froude") for (let i = 0; i < count; i++) T[i] = Math.sqrt(((m1[i] + m2[i]) * L[i]) / (x[i] * (F1[i] + F2[i])));
    else rows[FIELDS.indexOf(name)].set(x);
  }
}
