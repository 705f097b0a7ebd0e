// Errors of formulas against T, on log scales, beside the claimed orders.
import { mathOf } from "./formula.js";
import { Plot, drawMarks, line, scale } from "./plots.js";
import { nextPower, seriesOf, sumOf } from "./series.js";
import { shown } from "./words.js";
import { inParts, within } from "./work.js";

const COUNT = 241, DECADES = [-3.5, 1.5]; // around the period at which the Froude number is 1
const ROUNDING = 64 * 2 ** -52; // relative: smaller errors are rounding of doubles
const TOLERANCE = 0.01, HALVINGS = 28;
const COLOURS = ["accent", "body2", "centre", "friction", "body1", "soft"];
const STEADY = 3;
const FIRST = ["eq28_displacement", "eq21_dxC", "eq23_dxC", "eq25_dxC"]; // after a change of the setting

/** Returns true if a formula is about the displayed motion: a steady state, or a phase from rest or from a velocity. */
function applies(formula, start, phase) {
  if (start === "steady") return formula.setting === STEADY && formula.turns === 0;
  if (start === "rest") return formula.setting === 0;
  return formula.setting === (phase === "extension" ? 1 : 2) || (formula.setting === 1 && formula.name.startsWith("corrected"));
}

export class Errors {
  constructor(core, host, select, formula, note) {
    Object.assign(this, { core, select, formula, note, plot: new Plot(host, { height: 340 }) });
  }

  /** Returns the quantities available in a state. */
  list(state) {
    return this.core.formulas.filter((one) => applies(one, state.start, state.phase) && one.remainder !== 0 && this.core.isClaimed(one));
  }

  *show(crawler, state, v0) {
    const all = this.list(state), key = all.map(({ name }) => name).join();
    if (this.listed !== key) {
      this.listed = key;
      this.select.replaceChildren(...all.map(({ name, equation, quantity }) => Object.assign(document.createElement("option"), { value: name, textContent: `${name.startsWith("corrected") ? "right for " : ""}${equation} ${quantity}: ${name}` })));
    }
    const chosen = all.find(({ name }) => name === state.formula) ?? all.find(({ name }) => FIRST.includes(name)) ?? all[0];
    this.select.value = chosen.name;
    const T = this.periods(crawler), phase = state.phase === "extension" ? 0 : 1;
    const shownOnes = all.filter(({ quantity }) => quantity === chosen.quantity).slice(0, 6);
    const curves = yield* within(0, 0.6, this.solve(shownOnes, phase, v0, T)), main = curves[shownOnes.indexOf(chosen)] ?? curves[0], { order } = state;
    const derived = order === "none" || chosen.quantity.startsWith("v_at") ? null
      : yield* within(0.6, 0.1, this.derivedCurve(main, phase, v0, naturalPeriod(crawler), T, Number(order)));
    main.exceeds = yield* within(0.7, 0.15, firstAbove(main, T));
    if (derived) derived.exceeds = yield* within(0.85, 0.15, firstAbove(derived, T));
    const changes = [...T].filter((_, i) => i > 0 && main.modes[i] !== main.modes[i - 1]);
    Object.assign(this, { curves: derived ? [...curves, derived] : curves, T, main, derived, changes, crawlerT: crawler.T, ofPhase: state.start !== "steady", size: state.error, order });
    this.draw(state);
    this.formula.replaceChildren(mathOf(main.formula));
    this.tell(null);
  }

  periods(crawler) {
    return Float64Array.from({ length: COUNT }, (_, i) => naturalPeriod(crawler) * 10 ** (DECADES[0] + ((DECADES[1] - DECADES[0]) * i) / (COUNT - 1)));
  }

  /** Returns formulas, each with along(T): exact values, its values, and its errors, null if they are rounding. */
  *solve(formulas, phase, v0, T) {
    const { core } = this, exact = [], modes = [], values = formulas.map(() => []);
    yield* inParts(T.length, (from, to) => {
      const part = core.formulasAlong(formulas, phase, v0, T.subarray(from, to));
      exact.push(...part.exact);
      modes.push(...part.modes);
      values.forEach((value, j) => value.push(...part.values[j]));
    });
    return formulas.map((formula, j) => {
      const label = `${formula.equation}${formula.name.startsWith("corrected") ? " corrected" : ""}`;
      const along = (T) => {
        const { exact, values: [value] } = core.formulasAlong([formula], phase, v0, T);
        return withErrors({ exact, value });
      };
      return { formula, name: formula.name, label, along, modes, ...withErrors({ exact, value: values[j] }) };
    });
  }

  /** Returns the same for the series of a formula's quantity; null if it does not exist. */
  *derivedCurve({ formula, exact, modes }, phase, v0, unit, T, order) {
    const series = yield* seriesOf(this.core, formula, phase, v0, unit), value = (periods) => sumOf(series, order, periods);
    if (!series) return null;
    const along = (periods) => withErrors({ exact: this.core.formulasAlong([formula], phase, v0, periods).exact, value: value(periods) });
    return { series, name: `derived_${order}`, label: `derived, below T^${order}`, along, modes, ...withErrors({ exact, value: value(T) }) };
  }

  draw(state) {
    const { curves, main, size, T } = this, series = curves.map((curve, k) => line(curve.label, curve === this.derived ? "ink" : COLOURS[k], { width: curve === main ? 3 : 1.5 }));
    series.push(line(size === "absolute" ? "1 % of the exact value" : "1 %", "wrong", { width: 1, dash: [2, 4] }));
    const tolerated = [...main.exact].map((exact) => (exact === 0 || !Number.isFinite(exact) ? null : TOLERANCE * (size === "absolute" ? Math.abs(exact) : 1)));
    const hooks = {
      drawClear: [(u) => (drawMarks(u, this.changes), drawMarks(u, [this.main.exceeds, this.derived?.exceeds].filter(Boolean), "wrong"), drawMarks(u, [this.crawlerT], "point"))],
      setCursor: [(u) => this.tell(u.cursor.idx)],
    };
    const scales = { x: scale(true, () => [this.T[0], this.T.at(-1)]), y: scale(true, (u, low, high) => decades(low, high)) };
    const key = `${series.map(({ label, width }) => label + width)} ${state.start} ${state.phase} ${size}`;
    this.plot.show({ key, x: "T", y: size === "absolute" ? "|formula − exact|" : "|formula/exact − 1|", series, scales, hooks }, [[...T], ...curves.map((curve) => curve[size]), tolerated]);
  }

  /** Shows slopes at the cursor, or at the crawler's period, beside the claimed ones. */
  tell(index) {
    const { T, main, derived, order } = this, i = index ?? nearest(T, this.crawlerT), { formula } = main;
    const said = [`${formula.equation} at T = ${shown(Number(T[i].toPrecision(3)))}: ${this.measured(main, i)}; claimed: ${formula.remainder > 0 ? formula.remainder : "an equality"}.`, this.limit(main)];
    if (derived) {
      const next = nextPower(derived.series, Number(order));
      said.push(`Derived, all terms below T^${order}: ${this.measured(derived, i)}; ${next === undefined ? "the next term is beyond those known here" : `the next term has T^${next}`}.`, this.limit(derived));
    } else if (order !== "none") said.push("No series in powers of T was found.");
    said.push("Dashed: the modes change.", this.ofPhase ? "T is the period; the phase is a part of it." : "");
    this.note.textContent = said.filter(Boolean).join(" ");
  }

  measured({ value, exact, absolute, relative }, i) {
    const slope = slopeAt(this.T, absolute, i);
    if (Number.isNaN(value[i])) return "the formula has no value, as l″ = 0 where a phase of this gait begins or ends";
    if (Number.isNaN(exact[i])) return "no such event";
    if (absolute[i] === null) return "the error is that of rounding";
    if (Number.isNaN(slope)) return "no slope";
    return `slope of the absolute error ${slope.toFixed(2)}${this.size === "relative" ? ` (of the relative error ${slopeAt(this.T, relative, i).toFixed(2)})` : ""}`;
  }

  limit({ exceeds, absolute }) {
    if (exceeds === this.T[0]) return "The relative error exceeds 1 % at every T shown.";
    if (exceeds) return `The relative error exceeds 1 % from T = ${shown(exceeds)} on.`;
    return absolute.every((off) => off === null) ? "" : "The relative error stays below 1 %.";
  }

  /** Returns rows of a table: T, and exact value, formula and error of each. */
  table() {
    const names = ["T"], rows = [[...this.T]];
    for (const { name, exact, value, absolute, relative } of this.curves) {
      names.push(`${name}.exact`, name, `${name}.error`, `${name}.relative`);
      rows.push([...exact], [...value], absolute, relative);
    }
    return { names, rows };
  }
}

/** Returns the period at which the Froude number is 1. */
const naturalPeriod = ({ m1, m2, F1, F2, L }) => Math.sqrt(((m1 + m2) * L) / (F1 + F2));

/** Returns whole decades around a range. */
const decades = (low, high) => (low > 0 ? [10 ** Math.floor(Math.log10(low)), 10 ** (Math.floor(Math.log10(high)) + 1)] : [1e-16, 1]);

const nearest = (T, x) => T.reduce((best, t, i) => (Math.abs(Math.log(t / x)) < Math.abs(Math.log(T[best] / x)) ? i : best), 0);

function withErrors({ exact, value }) {
  const off = (i) => Math.abs(value[i] - exact[i]);
  const absolute = Array.from(exact, (x, i) => (off(i) > ROUNDING * Math.abs(x) && Number.isFinite(off(i)) ? off(i) : null));
  return { exact, value, absolute, relative: absolute.map((off, i) => (off === null ? null : off / Math.abs(exact[i]))) };
}

function slopeAt(T, error, i) {
  const a = Math.max(0, i - 2), b = Math.min(T.length - 1, i + 2);
  return error[a] > 0 && error[b] > 0 ? Math.log(error[b] / error[a]) / Math.log(T[b] / T[a]) : NaN;
}

/** Returns the T from which a relative error exceeds the tolerance, by bisection between two T of a list; null if it never does. */
function* firstAbove({ relative, along }, T) {
  const i = relative.findIndex((off) => off > TOLERANCE);
  if (i <= 0) return i < 0 ? null : T[0];
  let low = T[i - 1], high = T[i];
  for (let round = 0; round < HALVINGS; round++) {
    const middle = Math.sqrt(low * high);
    yield round / HALVINGS;
    if (along(Float64Array.of(middle)).relative[0] > TOLERANCE) high = middle;
    else low = middle;
  }
  return high;
}
