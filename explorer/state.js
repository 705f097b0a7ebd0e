// What the page shows is one flat object of texts: its fields are what a link has in its fragment.
import { PARAMETERS, numberOf } from "./core.js";

export const USUAL = {
  m1: "1", m2: "1", F1: "4", F2: "1", L: "10", T: "1", alpha: "0.75", gait: "quadratic",
  start: "steady", v0: "0", periods: "8",
  x: "F1/F2", y: "T", show: "modes", along: "x", of: "mean_velocity", formula: "eq28_displacement",
  phase: "extension", error: "absolute", order: "8", table_name: "", table: "",
};
export const LONGEST_TABLE = 20000; // characters of a measured gait that go into a link

/** The crawler of a state: numbers, NaN where a field is none. */
export const crawlerOf = (state) => Object.fromEntries(PARAMETERS.map((name) => [name, numberOf(state[name])]));

/** The fragment of a link: fields that are not the usual ones. */
export function fragmentOf(state) {
  const fields = new URLSearchParams();
  for (const [name, usual] of Object.entries(USUAL))
    if (state[name] !== usual && (name !== "table" || state.table.length <= LONGEST_TABLE)) fields.set(name, state[name]);
  return fields.toString();
}

const WHOLE = ["periods", "order"], NUMBERS = ["v0"]; // a parameter that is no number is shown, and refused beside its field

const isAllowed = (name, value, choices) => choices[name]?.includes(value)
  ?? (WHOLE.includes(name) ? /^[1-9][0-9]{0,3}$/.test(value) : !NUMBERS.includes(name) || Number.isFinite(numberOf(value)));

/** The state of a fragment. Fields that there are not are passed over, and so is what is none of the choices of a field, or no number. */
export function stateOf(fragment, choices) {
  const state = { ...USUAL };
  for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, "")))
    if (Object.hasOwn(USUAL, name) && isAllowed(name, value, choices)) state[name] = value;
  return state;
}

/** States gone through, to be gone back to. */
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
