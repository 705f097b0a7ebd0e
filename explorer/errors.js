// Errors of formulas against T, on log scales, beside what is claimed of them.
import { mathOf } from "./formula.js";
import { Plot, drawMarks, line, scale } from "./plots.js";
import { shown } from "./words.js";

const COUNT = 241, DECADES = [-3.5, 1.5]; // around the period at which the Froude number is 1
const ROUNDING = 64 * 2 ** -52; // of the exact number: below that an error is the rounding of doubles
const TOLERANCE = 0.01;
const COLOURS = ["accent", "body2", "centre", "friction", "body1", "soft"];
const STEADY = 3;
const FIRST = ["text_steady_xC", "rest_xC_end", "text_extension_xC_end", "text_contraction_xC_end"]; // where another setting's was chosen

/** Of which settings formulas are, of what is shown: a steady state, or a phase from rest or from a velocity. */
function applies(formula, start, phase) {
  if (start === "steady") return formula.setting === STEADY && formula.turns === 0;
  if (start === "rest") return formula.setting === 0;
  return formula.setting === (phase === "extension" ? 1 : 2) || (formula.setting === 1 && formula.name.startsWith("corrected"));
}

export class Errors {
  constructor(core, host, select, formula, note) {
    Object.assign(this, { core, select, formula, note, plot: new Plot(host, { height: 340 }) });
  }

  /** What can be asked about in a state. */
  list(state) {
    const claimed = (one) => this.core.formulaAlong(one, 0, 0, []).claimed;
    return this.core.formulas.filter((one) => applies(one, state.start, state.phase) && one.remainder !== 0 && claimed(one));
  }

  show(crawler, state, v0) {
    const all = this.list(state), key = all.map(({ name }) => name).join();
    if (this.listed !== key) {
      this.listed = key;
      this.select.replaceChildren(...all.map(({ name, equation, quantity }) => Object.assign(document.createElement("option"), { value: name, textContent: `${name.startsWith("corrected") ? "right for " : ""}${equation} ${quantity}: ${name}` })));
    }
    const chosen = all.find(({ name }) => name === state.formula) ?? all.find(({ name }) => FIRST.includes(name)) ?? all[0];
    this.select.value = chosen.name;
    const T = this.periods(crawler), phase = state.phase === "extension" ? 0 : 1;
    const shownOnes = all.filter(({ quantity }) => quantity === chosen.quantity).slice(0, 6);
    this.curves = shownOnes.map((formula) => this.curve(formula, phase, v0, T));
    const main = this.curves[shownOnes.indexOf(chosen)] ?? this.curves[0];
    Object.assign(this, { T, main, crawlerT: crawler.T, ofPhase: state.start !== "steady", size: state.error });
    this.changes = [...T].filter((_, i) => i > 0 && main.modes[i] !== main.modes[i - 1]);
    this.exceeds = firstAbove(main, T);
    this.draw(state);
    this.formula.replaceChildren(mathOf(main.formula));
    this.tell(null);
  }

  periods(crawler) {
    const middle = Math.sqrt(((crawler.m1 + crawler.m2) * crawler.L) / (crawler.F1 + crawler.F2));
    return Float64Array.from({ length: COUNT }, (_, i) => middle * 10 ** (DECADES[0] + ((DECADES[1] - DECADES[0]) * i) / (COUNT - 1)));
  }

  /** A formula, with along(T): what is exact, its value, and its errors, null where they are those of rounding. */
  curve(formula, phase, v0, T) {
    const along = (periods) => withErrors(this.core.formulaAlong(formula, phase, v0, periods));
    const label = `${formula.equation}${formula.name.startsWith("corrected") ? " corrected" : ""}`;
    return { formula, label, along, ...along(T) };
  }

  draw(state) {
    const { curves, main, size, T } = this, series = curves.map((curve, k) => line(curve.label, COLOURS[k], { width: curve === main ? 3 : 1.5 }));
    series.push(line(size === "absolute" ? "1 % of the exact value" : "1 %", "wrong", { width: 1, dash: [2, 4] }));
    const tolerated = [...main.exact].map((exact) => (exact === 0 || !Number.isFinite(exact) ? null : TOLERANCE * (size === "absolute" ? Math.abs(exact) : 1)));
    const hooks = {
      drawClear: [(u) => (drawMarks(u, this.changes), this.exceeds && drawMarks(u, [this.exceeds], "wrong"), drawMarks(u, [this.crawlerT], "point"))],
      setCursor: [(u) => this.tell(u.cursor.idx)],
    };
    const scales = { x: scale(true, () => [this.T[0], this.T.at(-1)]), y: scale(true, (u, low, high) => decades(low, high)) };
    const key = `${series.map(({ label, width }) => label + width)} ${state.start} ${state.phase} ${size}`;
    this.plot.show({ key, x: "T", y: size === "absolute" ? "|formula − exact|" : "|formula/exact − 1|", series, scales, hooks }, [[...T], ...curves.map((curve) => curve[size]), tolerated]);
  }

  /** Slope at the cursor, or at the crawler's period, beside the claimed one. */
  tell(index) {
    const { T, main, size } = this, i = index ?? nearest(T, this.crawlerT), { formula, absolute } = main;
    const claim = formula.remainder > 0 ? `claimed: ${formula.remainder}` : "claimed: an equality";
    const slope = slopeAt(T, absolute, i), other = size === "relative" ? ` (of the relative error ${slopeAt(T, main.relative, i).toFixed(2)})` : "";
    const measured = Number.isNaN(main.value[i]) ? "the formula has no value, as l″ = 0 where a phase of this gait begins or ends" : Number.isNaN(main.exact[i]) ? "no such event" : absolute[i] === null ? "the error is that of rounding" : Number.isNaN(slope) ? "no slope" : `slope of the absolute error ${slope.toFixed(2)}${other}`;
    const limit = this.exceeds === T[0] ? "The relative error exceeds 1 % at every T shown." : this.exceeds ? `The relative error exceeds 1 % from T = ${shown(this.exceeds)} on.` : absolute.every((off) => off === null) ? "" : "The relative error stays below 1 %.";
    const duration = this.ofPhase ? " T is the period; the phase is a part of it." : "";
    const derived = "Derived series are in the command (scallop series), not in this page.";
    this.note.textContent = `${formula.equation} at T = ${shown(Number(T[i].toPrecision(3)))}: ${measured}; ${claim}. ${limit} Dashed: the modes change.${duration} ${derived}`;
  }

  /** For a table: T, and exact, formula and error of each. */
  table() {
    const names = ["T"], rows = [[...this.T]];
    for (const { formula, exact, value, absolute, relative } of this.curves) {
      names.push(`${formula.name}.exact`, formula.name, `${formula.name}.error`, `${formula.name}.relative`);
      rows.push([...exact], [...value], absolute, relative);
    }
    return { names, rows };
  }
}

/** Whole decades around a range. */
const decades = (low, high) => (low > 0 ? [10 ** Math.floor(Math.log10(low)), 10 ** (Math.floor(Math.log10(high)) + 1)] : [1e-16, 1]);

const nearest = (T, x) => T.reduce((best, t, i) => (Math.abs(Math.log(t / x)) < Math.abs(Math.log(T[best] / x)) ? i : best), 0);

function withErrors({ exact, value, modes }) {
  const off = (i) => Math.abs(value[i] - exact[i]);
  const absolute = Array.from(exact, (x, i) => (off(i) > ROUNDING * Math.abs(x) && Number.isFinite(off(i)) ? off(i) : null));
  return { exact, value, modes, absolute, relative: absolute.map((off, i) => (off === null ? null : off / Math.abs(exact[i]))) };
}

function slopeAt(T, error, i) {
  const a = Math.max(0, i - 2), b = Math.min(T.length - 1, i + 2);
  return error[a] > 0 && error[b] > 0 ? Math.log(error[b] / error[a]) / Math.log(T[b] / T[a]) : NaN;
}

/** The T from which a relative error exceeds the tolerance, null where it never does: between two T of a list, and then ever closer. */
function firstAbove(curve, T) {
  let relative = curve.relative, i;
  for (let round = 0; round < 7; round++) {
    i = relative.findIndex((off) => off > TOLERANCE);
    if (i < 0) return null;
    if (i === 0) return T[0];
    const low = T[i - 1], ratio = T[i] / low;
    T = Float64Array.from({ length: 17 }, (_, k) => low * ratio ** (k / 16));
    ({ relative } = curve.along(T));
  }
  return T[0];
}
