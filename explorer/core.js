// The core, in WebAssembly: core.h describes its functions. Its numbers equal the numbers of the command `scallop`.
export const PARAMETERS = ["m1", "m2", "F1", "F2", "L", "T", "alpha"];
export const REGIMES = ["sliding", "stick-slip", "at-rest"];
const COLUMNS = ["froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier", "class", "friction_work"];
const DIGITS = ["all", "no multiplier", "picture"]; // as in core.h
const NUMBER = /^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$/;

/** Returns the number in a text, or NaN: finite, in the decimal notation of the command. */
export function numberOf(text) {
  const trimmed = String(text).trim();
  const x = NUMBER.test(trimmed) ? Number(trimmed) : NaN;
  return Number.isFinite(x) ? x : NaN;
}
const MOST_ROWS = 2000; // most rows of a measured gait: the page responds between two steady states, and each reads all rows
const tooMany = (name, rows) => `${name}: ${rows} rows; this page takes at most ${MOST_ROWS}. Keep one row in ${Math.ceil(rows / (MOST_ROWS - 1))}, with the first and the last, or use the command scallop, which takes 100,000`;

export class Core {
  constructor(bytes) {
    this.calls = new WebAssembly.Instance(new WebAssembly.Module(bytes), {}).exports;
    this.families = [];
    for (let i = 0; this.calls.describe_family(i); i++) {
      const [name, numbers, usual, allowed, sentence] = this.text().split("\n");
      this.families.push({ name, numbers, usual, allowed, sentence });
    }
    this.formulas = [];
    for (let i = 0; this.calls.describe_formula(i); i++) this.formulas.push(this.formula(i));
    this.most = this.calls.most();
    this.version = this.string(this.calls.version());
  }

  string(at) {
    if (!at) return null;
    const bytes = new Uint8Array(this.calls.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
  text() {
    return this.string(this.calls.text());
  }
  numbers() {
    return new Float64Array(this.calls.memory.buffer, this.calls.numbers(), 64);
  }
  row(i, count = this.calls.most()) {
    return new Float64Array(this.calls.memory.buffer, this.calls.row(i), count);
  }
  rows(count, ...numbers) {
    return numbers.map((i) => this.row(i, count).slice());
  }

  formula(index) {
    const [name, equation, text, quantity, setting, remainder, turns, ...more] = this.text().split("\n");
    const parts = Object.fromEntries(more.flatMap((part, k) => (k % 2 === 0 ? [[part, more[k + 1]]] : [])));
    return { index, name, equation, text, quantity, setting: Number(setting), remainder: Number(remainder), turns: Number(turns), parts };
  }

  /** Chooses a gait, "trapezoidal:0.1,0.2", or a measured one from a table { name, text }. Returns null or, for a table, its { L, T, alpha };
   * throws an Error that states the domain. */
  chooseGait(text, table) {
    const key = `${text}\n${text === "measured" && table ? `${table.name}\n${table.text}` : ""}`;
    if (this.chosen?.key === key) return this.chosen.own;
    this.chosen = null;
    const own = this.makeGait(text, table);
    this.chosen = { key, own };
    return own;
  }

  makeGait(text, table) {
    const [name, numbers] = text.split(/:(.*)/s);
    if (name === "measured") return this.chooseTable(table);
    const i = this.families.findIndex((family) => family.name === name);
    if (i < 0) throw new Error(`there is no gait '${name}'`);
    const family = this.families[i];
    if (!family.allowed && numbers !== undefined) throw new Error(`${name} takes no numbers`);
    const parts = numbers ?? family.usual ?? "", given = parts ? parts.split(",").map(numberOf) : [];
    if (given.length > 16 || given.some(Number.isNaN)) throw new Error(`it takes ${family.allowed}`);
    this.numbers().set(given);
    if (this.calls.choose_gait(i, given.length) < 0) throw new Error(this.text());
    return null;
  }

  chooseTable(table) {
    if (!table) throw new Error("a measured gait needs its file: choose it, or drop it on the page");
    const name = table.name.replace(/[\x00-\x1f\x7f]/g, " ");
    const bytes = new TextEncoder().encode(`${name}\n${table.text}\0`);
    const rows = table.text.split("\n").filter((line) => /^\s*[-+.\d]/.test(line)).length;
    if (rows > MOST_ROWS) throw new Error(tooMany(name, rows));
    if (bytes.length > this.calls.text_size()) throw new Error(`${name}: a table of more than a million characters`);
    if (bytes.indexOf(0) < bytes.length - 1) throw new Error(`${name}: this is not a text file`);
    new Uint8Array(this.calls.memory.buffer, this.calls.text()).set(bytes);
    if (this.calls.choose_table() < 0) throw new Error(this.text());
    const [L, T, alpha] = this.numbers();
    return { L, T, alpha };
  }

  /** Returns a measured gait { samples: [t, l], curve: [t, l, l'], text }, the curve at `places` times; null if it is not measured. */
  recording(places) {
    const count = this.calls.recording(places);
    if (!count) return null;
    const copy = (i, length) => this.row(i, length).slice();
    return { samples: [0, 1].map((i) => copy(i, count)), curve: [2, 3, 4].map((i) => copy(i, places)), text: this.text() };
  }

  /** Chooses the crawler { m1, m2, F1, F2, L, T, alpha }; throws an Error that states the domain. */
  chooseCrawler(crawler) {
    this.numbers().set(PARAMETERS.map((name) => crawler[name]));
    if (this.calls.choose_crawler() < 0) throw new Error(this.text());
  }

  /** Returns the steady state of the crawler. */
  steady() {
    const status = this.calls.steady();
    if (status < 0) throw new Error(this.text());
    const [froude, v_start, v_mid, displacement, mean_velocity, multiplier, v_low, v_high, regime, friction_work] = this.numbers();
    const modes = this.text();
    return { status, froude, v_start, v_mid, displacement, mean_velocity, multiplier, v_low, v_high, friction_work,
             regime: REGIMES[regime], modes };
  }

  /** Returns one period from v0. */
  period(v0) {
    if (this.calls.period(v0) < 0) throw new Error(this.text());
    const [v_mid, v_end, displacement, multiplier, regime] = this.numbers();
    return { v_mid, v_end, displacement, multiplier, regime: REGIMES[regime], modes: this.text() };
  }

  /** Returns the intervals of constant mode: t_begin, t_end, s1, s2 of each. */
  walk(v0, periods) {
    const count = this.calls.walk(v0, periods);
    if (count < 0) throw new Error(this.text());
    const [begin, end, s1, s2] = this.rows(count, 0, 1, 2, 3);
    return { count, begin, end, s1, s2 };
  }

  /** Returns samples: t, x1, x2, xC, v1, v2, l. */
  trajectory(v0, periods, samples) {
    const count = this.calls.trajectory(v0, periods, samples);
    if (count < 0) throw new Error(this.text());
    const [t, x1, x2, xC, v1, v2, l] = this.rows(count, 0, 1, 2, 3, 4, 5, 6);
    return { count, t, x1, x2, xC, v1, v2, l };
  }

  /** Returns the steady states of many crawlers with the gait: fill(rows) writes m1, m2, F1, F2, L, T, alpha. Views, valid until the next call. */
  steadyStates(count, fill, { withWork = false, digits = "all" } = {}) {
    fill(PARAMETERS.map((_, i) => this.row(i, count)));
    this.calls.steady_states(count, withWork ? 1 : 0, DIGITS.indexOf(digits));
    return Object.fromEntries(COLUMNS.map((name, i) => [name, this.row(PARAMETERS.length + i, count)]));
  }
  /** Returns a formula of the steady state for the crawlers in the rows. */
  formulaOver(formula, count) {
    this.calls.formula_over(formula.index, count);
    return this.row(15, count);
  }
  className(i) {
    return this.string(this.calls.class_name(i));
  }
  forgetClasses() {
    this.calls.forget_classes();
  }

  isClaimed(formula) {
    return this.calls.formula_is_claimed(formula.index) === 1;
  }

  /** Returns formulas of one quantity at the periods T, and the exact values; phase: 0 extension, 1 contraction. */
  formulasAlong(formulas, phase, v0, T) {
    this.numbers().set(formulas.map(({ index }) => index));
    this.row(0, T.length).set(T);
    this.calls.formulas_along(formulas.length, phase, v0, T.length);
    const [exact, modes, ...values] = this.rows(T.length, 1, 2, ...formulas.map((_, j) => 3 + j));
    return { exact, modes, values };
  }

  /** Computes coefficients of (T/unit)^(step k - shift) of a formula's quantity, from the exact numbers at the periods T, one period after the other;
   * null if they do not exist. */
  *seriesOf(formula, phase, v0, unit, { step, shift }, T) {
    for (let k = 0; k < T.length; k++) {
      this.row(0, T.length).set(T);
      if (this.calls.series_of(formula.index, phase, v0, unit, step, shift, k, T.length) !== 1) return null;
      if (k + 1 < T.length) yield;
    }
    return this.row(1, T.length).slice();
  }
}
