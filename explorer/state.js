// The state of the page: one flat object of texts, written to the fragment of a link.
import { PARAMETERS, numberOf } from "./core.js";

export const USUAL = {
  m1: "1", m2: "1", F1: "4", F2: "1", L: "10", T: "1", alpha: "0.75", gait: "quadratic",
  start: "steady", v0: "0", periods: "8",
  x: "F1/F2", y: "T", show: "modes", along: "x", of: "mean_velocity", formula: "eq28_displacement",
  phase: "extension", error: "absolute", order: "8", table_name: "", table: "",
};
export const LONGEST_TABLE = 20000; // most characters of a measured gait in a link

/** Returns the crawler of a state: numbers, NaN for a field without a number. */
export const crawlerOf = (state) => Object.fromEntries(PARAMETERS.map((name) => [name, numberOf(state[name])]));

/** Returns the fragment of a link: fields that differ from the defaults. */
export function fragmentOf(state) {
  const fields = new URLSearchParams();
  for (const [name, usual] of Object.entries(USUAL))
    if (state[name] !== usual && (name !== "table" || state.table.length <= LONGEST_TABLE)) fields.set(name, state[name]);
  return fields.toString();
}

const WHOLE = ["periods", "order"], NUMBERS = ["v0"]; // an invalid parameter is shown, with an error beside its field

const isAllowed = (name, value, choices) => choices[name]?.includes(value)
  ?? (WHOLE.includes(name) ? /^[1-9][0-9]{0,3}$/.test(value) : !NUMBERS.includes(name) || Number.isFinite(numberOf(value)));

/** Returns the state of a fragment. Unknown fields, choices and numbers are ignored. */
export function stateOf(fragment, choices) {
  const state = { ...USUAL };
  for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, "")))
    if (Object.hasOwn(USUAL, name) && isAllowed(name, value, choices)) state[name] = value;
  return state;
}

/** Past states, for undo. */
export class History {
  constructor(state) {
    this.states = [state];
    this.at = 0;
  }
  push(state) {
    if (fragmentOf(state) === fragmentOf(this.states[this.at])) return;
    this.states = [...this.states.slice(Math.max(0, this.at - 199), this.at + 1), { ...state }];
    this.at = this.states.length - 1;
  }
  go(step) {
    this.at = Math.min(Math.max(this.at + step, 0), this.states.length - 1);
    return { ...this.states[this.at] };
  }
}
