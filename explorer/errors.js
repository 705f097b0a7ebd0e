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
    this.ofPhase = state.start !== "steady";
    const main = this.curves[shownOnes.indexOf(chosen)] ?? this.curves[0];
    Object.assign(this, { T, main, crawlerT: crawler.T });
    this.changes = [...T].filter((_, i) => i > 0 && main.modes[i] !== main.modes[i - 1]);
    this.exceeds = firstAbove(T, main.relative);
    this.draw(state);
    this.formula.replaceChildren(mathOf(main.formula));
    this.tell(null);
  }

  periods(crawler) {
    const middle = Math.sqrt(((crawler.m1 + crawler.m2) * crawler.L) / (crawler.F1 + crawler.F2));
    return Float64Array.from({ length: COUNT }, (_, i) => middle * 10 ** (DECADES[0] + ((DECADES[1] - DECADES[0]) * i) / (COUNT - 1)));
  }

  curve(formula, phase, v0, T) {
    const { exact, value, modes } = this.core.formulaAlong(formula, phase, v0, T);
    const error = [...T].map((_, i) => {
      const off = Math.abs(value[i] - exact[i]);
      return off > ROUNDING * Math.abs(exact[i]) && Number.isFinite(off) ? off : null;
    });
    return { formula, exact, value, modes, error, relative: error.map((off, i) => (off === null ? 0 : off / Math.abs(exact[i]))) };
  }

  draw(state) {
    const series = this.curves.map(({ formula }, k) =>
      line(`${formula.equation}${formula.name.startsWith("corrected") ? " corrected" : ""}`, COLOURS[k], { width: formula === this.main.formula ? 3 : 1.5 }));
    const hooks = {
      drawClear: [(u) => (drawMarks(u, this.changes), this.exceeds && drawMarks(u, [this.exceeds], "wrong"), drawMarks(u, [this.crawlerT], "point"))],
      setCursor: [(u) => this.tell(u.cursor.idx)],
    };
    const scales = { x: scale(true, () => [this.T[0], this.T.at(-1)]), y: scale(true, (u, low, high) => decades(low, high)) };
    const key = `${series.map(({ label, width }) => label + width)} ${state.start} ${state.phase}`;
    this.plot.show({ key, x: "T", y: "|error|", series, scales, hooks }, [[...this.T], ...this.curves.map(({ error }) => error)]);
  }

  /** Slope at the cursor, or at the crawler's period, beside the claimed one. */
  tell(index) {
    const { T, main } = this, i = index ?? nearest(T, this.crawlerT), { formula, error } = main;
    const claim = formula.remainder > 0 ? `claimed: ${formula.remainder}` : "claimed: an equality";
    const slope = slopeAt(T, error, i);
    const measured = Number.isNaN(main.value[i]) ? "the formula has no value, as l″ = 0 where a phase of this gait begins or ends" : Number.isNaN(main.exact[i]) ? "no such event" : error[i] === null ? "the error is that of rounding" : Number.isNaN(slope) ? "no slope" : `slope ${slope.toFixed(2)}`;
    const limit = this.exceeds === T[0] ? "It exceeds 1 % at every T shown." : this.exceeds ? `It exceeds 1 % from T = ${shown(Number(this.exceeds.toPrecision(3)))} on.` : error.every((off) => off === null) ? "" : "It stays below 1 %.";
    const duration = this.ofPhase ? " T is the period; the phase is a part of it." : "";
    const derived = "Derived series are in the command (scallop series), not in this page.";
    this.note.textContent = `${formula.equation} at T = ${shown(Number(T[i].toPrecision(3)))}: ${measured}; ${claim}. ${limit} Dashed: the modes change.${duration} ${derived}`;
  }

  /** For a table: T, and exact, formula and error of each. */
  table() {
    const names = ["T"], rows = [[...this.T]];
    for (const { formula, exact, value, error } of this.curves) {
      names.push(`${formula.name}.exact`, formula.name, `${formula.name}.error`);
      rows.push([...exact], [...value], error);
    }
    return { names, rows };
  }
}

/** Whole decades around a range. */
const decades = (low, high) => (low > 0 ? [10 ** Math.floor(Math.log10(low)), 10 ** (Math.floor(Math.log10(high)) + 1)] : [1e-16, 1]);

const nearest = (T, x) => T.reduce((best, t, i) => (Math.abs(Math.log(t / x)) < Math.abs(Math.log(T[best] / x)) ? i : best), 0);

function slopeAt(T, error, i) {
  const a = Math.max(0, i - 2), b = Math.min(T.length - 1, i + 2);
  return error[a] > 0 && error[b] > 0 ? Math.log(error[b] / error[a]) / Math.log(T[b] / T[a]) : NaN;
}

function firstAbove(T, relative) {
  const i = relative.findIndex((off) => off > TOLERANCE);
  return i < 0 ? null : T[i];
}
