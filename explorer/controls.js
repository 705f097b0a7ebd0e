// Controls of the parameters: a slider on a log scale, and a field for any valid value.
import { numberOf } from "./core.js";

const FIELDS = [
  { name: "m1", title: "mass of body 1", from: 0.01, to: 100 },
  { name: "m2", title: "mass of body 2", from: 0.01, to: 100 },
  { name: "F1", title: "friction of body 1", from: 0.01, to: 1000 },
  { name: "F2", title: "friction of body 2", from: 0.01, to: 1000 },
  { name: "L", title: "amplitude of the separation", from: 0.1, to: 1000 },
  { name: "T", title: "period", from: 0.001, to: 1000 },
  { name: "alpha", title: "part of the period that the extension takes", from: 0.005, to: 0.995, linear: true },
];
const STEPS = 1000;

const toSlider = (field, x) =>
  STEPS * (field.linear ? (x - field.from) / (field.to - field.from) : Math.log(x / field.from) / Math.log(field.to / field.from));
const ofSlider = (field, s) =>
  field.linear ? field.from + ((field.to - field.from) * s) / STEPS : field.from * (field.to / field.from) ** (s / STEPS);
/** Returns a number in few digits, for a slider. */
export const rounded = (x, digits = 4) => String(Number(x.toPrecision(digits)));

function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Fills the form; calls change(fields, done) with the fields that the reader sets, done = false during a drag. */
export class Controls {
  constructor(form, families, change) {
    this.change = change;
    this.fields = {};
    form.addEventListener("submit", (event) => event.preventDefault());
    form.append(element("h2", { textContent: "Parameters" }), ...FIELDS.map((field) => this.parameter(field)));
    form.append(this.gait(families), this.start());
  }

  /** Adds a text field, and a message of its error. */
  input(name, title) {
    const id = `field-${name}`;
    const text = element("input", { id, type: "text", inputMode: "decimal", spellcheck: false });
    const wrong = element("p", { className: "wrong", id: `${id}-wrong` });
    text.setAttribute("aria-describedby", wrong.id);
    text.setAttribute("aria-label", title);
    text.addEventListener("input", () => this.change({ [name]: text.value.trim() }, false));
    text.addEventListener("change", () => this.change({ [name]: text.value.trim() }, true));
    this.fields[name] = { text, wrong };
    return [text, wrong];
  }

  parameter(field) {
    const [text, wrong] = this.input(field.name, `${field.name}, ${field.title}`);
    const slider = element("input", { type: "range", min: 0, max: STEPS, step: 1, id: `slider-${field.name}` });
    slider.setAttribute("aria-label", `${field.name}, ${field.title}`);
    const set = (done) => this.change({ [field.name]: rounded(ofSlider(field, Number(slider.value))) }, done);
    slider.addEventListener("input", () => set(false));
    slider.addEventListener("change", () => set(true));
    Object.assign(this.fields[field.name], { slider, field });
    const label = element("label", { htmlFor: text.id, title: field.title });
    label.innerHTML = field.name.replace(/^([a-zA-Z])([12])$/, "$1<sub>$2</sub>").replace("alpha", "&alpha;");
    return element("div", { className: "parameter" }, label, slider, text, wrong);
  }

  gait(families) {
    const names = [...families.map((family) => family.name), "measured"];
    const select = element("select", { id: "gait-family" }, ...names.map((name) => element("option", { value: name, textContent: name })));
    const field = element("input", { id: "field-gait", type: "text", spellcheck: false });
    const wrong = element("p", { className: "wrong", id: "field-gait-wrong" });
    field.setAttribute("aria-label", "numbers of the gait");
    field.setAttribute("aria-describedby", wrong.id);
    const file = element("input", { type: "file", id: "gait-file", accept: ".tsv,.txt,.csv,.dat,text/*" });
    const sentence = element("p", { className: "note", id: "gait-sentence" });
    const text = () => (field.value.trim() && !field.hidden ? `${select.value}:${field.value.trim()}` : select.value);
    select.addEventListener("change", () => {
      const family = families.find(({ name }) => name === select.value);
      field.value = family ? (family.usual ?? "") : "";
      if (family?.name === "constant") field.value = "0.1";
      if (family?.name === "polynomial") field.value = "0,3,-2";
      field.hidden = !family?.numbers;
      if (select.value === "measured" && !this.hasTable) file.click();
      this.change({ gait: text() }, true);
    });
    field.addEventListener("input", () => this.change({ gait: text() }, false));
    field.addEventListener("change", () => this.change({ gait: text() }, true));
    file.addEventListener("change", () => file.files[0] && this.read(file.files[0]));
    this.fields.gait = { text: field, wrong, select, families, file, sentence };
    return element("fieldset", {}, element("legend", { textContent: "Gait" }), select, field, wrong, sentence,
      element("label", { className: "file", textContent: "Measured: a recording, t and l " }, file));
  }

  /** Reads a chosen or dropped file as the gait. */
  async read(file) {
    const table = await file.text();
    this.change({ gait: "measured", table, table_name: file.name }, true);
  }

  start() {
    const kinds = { steady: "steady state", rest: "from rest", velocity: "from a velocity" };
    const select = element("select", { id: "start" }, ...Object.entries(kinds).map(([value, textContent]) => element("option", { value, textContent })));
    select.setAttribute("aria-label", "start");
    const [v0, v0_wrong] = this.input("v0", "start velocity");
    const [periods, periods_wrong] = this.input("periods", "number of periods shown");
    select.addEventListener("change", () => this.change({ start: select.value }, true));
    const row = (title, ...inputs) => element("div", { className: "field" }, element("label", { htmlFor: inputs[0].id, textContent: title }), ...inputs);
    const velocity = row("v0", v0, v0_wrong), count = row("periods", periods, periods_wrong);
    this.fields.start = { select, velocity, count };
    return element("fieldset", {}, element("legend", { textContent: "Start" }), select, velocity, count);
  }

  /** Shows a state, and the error beside each field of `wrong`. */
  show(state, wrong) {
    for (const [name, { text, slider, field, wrong: note }] of Object.entries(this.fields)) {
      if (name === "gait" || name === "start") continue;
      if (document.activeElement !== text || numberOf(text.value) !== numberOf(state[name])) if (text.value.trim() !== state[name]) text.value = state[name];
      const x = numberOf(state[name]);
      if (slider && document.activeElement !== slider && x > 0) slider.value = toSlider(field, x);
      this.tell(text, note, wrong[name]);
    }
    this.showGait(state, wrong.gait);
    const { select, velocity, count } = this.fields.start;
    select.value = state.start;
    velocity.hidden = state.start !== "velocity";
    count.hidden = state.start === "steady";
  }

  showGait(state, wrong) {
    const { text, select, families, sentence, wrong: note } = this.fields.gait;
    const [name, numbers] = state.gait.split(/:(.*)/s);
    const family = families.find((one) => one.name === name);
    this.hasTable = state.table !== "";
    select.value = name;
    text.hidden = !family?.numbers;
    if (document.activeElement !== text) text.value = numbers ?? family?.usual ?? "";
    text.title = family?.allowed ?? "";
    sentence.textContent = name === "measured"
      ? (state.table_name ? `${state.table_name}: a curve through its rows; L, T and alpha are its own` : "a curve through a table of t and l, or of t, x1 and x2")
      : (family?.sentence ?? "") + (family?.numbers ? `. Numbers: ${family.numbers}` : "");
    this.tell(text, note, wrong);
  }

  tell(input, note, wrong) {
    note.textContent = wrong ?? "";
    input.setAttribute("aria-invalid", wrong ? "true" : "false");
  }
}
