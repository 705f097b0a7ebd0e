// The page: one state, and everything that follows it.
import bytes from "core.wasm";
import { Core, PARAMETERS, numberOf } from "./core.js";
import { Controls } from "./controls.js";
import { Drawing } from "./crawler.js";
import { Motion } from "./motion.js";
import { History, USUAL, crawlerOf, fragmentOf, stateOf } from "./state.js";
import { REGIME_WORDS, modesInWords, shown } from "./words.js";

const find = (id) => document.getElementById(id);
const core = new Core(bytes);
const drawing = new Drawing(find("crawler"));
const controls = new Controls(find("controls"), core.families, change);
let state = stateOf(location.hash);
const history = new History(state);
let motion = null, time = 0, playing = false, before = 0, asked = false;

/** Sets fields of the state. done: the reader let go, and it can be undone. */
function change(fields, done = true) {
  state = { ...state, ...fields };
  if (fields.table !== undefined) ownOf(fields);
  if (done) {
    history.push(state);
    globalThis.history.replaceState(null, "", `#${fragmentOf(state)}`);
  }
  ask();
}

/** A measured gait that was just read brings its own L, T and alpha. */
function ownOf(fields) {
  try {
    const own = core.chooseGait("measured", { name: fields.table_name, text: fields.table });
    for (const name of ["L", "T", "alpha"]) state[name] = String(own[name]);
  } catch {
    // said beside the gait
  }
}

function ask() {
  if (!asked) requestAnimationFrame(update);
  asked = true;
}

/** What is wrong with each field; the crawler, where nothing is. */
function judged() {
  const wrong = {}, crawler = crawlerOf(state);
  for (const name of PARAMETERS)
    if (Number.isNaN(crawler[name])) wrong[name] = `${name}: ${name === "alpha" ? "a number between 0 and 1, both excluded" : "a finite number > 0"}`;
  if (Number.isNaN(numberOf(state.v0))) wrong.v0 = "v0: a finite number";
  if (!(numberOf(state.periods) >= 1 && numberOf(state.periods) <= 60)) wrong.periods = "periods: a whole number from 1 to 60";
  try {
    core.chooseGait(state.gait, state.table ? { name: state.table_name, text: state.table } : null);
  } catch (error) {
    wrong.gait = error.message;
  }
  if (Object.keys(wrong).length === 0) {
    try {
      core.chooseCrawler(crawler);
    } catch (error) {
      const name = error.message.split(":")[0];
      wrong[PARAMETERS.includes(name) ? name : "T"] = error.message;
    }
  }
  return { wrong, crawler };
}

function update() {
  asked = false;
  const { wrong, crawler } = judged();
  controls.show(state, wrong);
  document.body.classList.toggle("kept", Object.keys(wrong).length > 0);
  if (Object.keys(wrong).length > 0) return;
  try {
    motion = new Motion(core, crawler, { start: state.start, v0: numberOf(state.v0), periods: Math.floor(numberOf(state.periods)) });
  } catch (error) {
    controls.show(state, { T: error.message });
    return;
  }
  showAnswers();
  showTime();
}

function showAnswers() {
  const { steady } = motion;
  const answers = [["Froude number", steady.froude, ""], ["v_start", steady.v_start, "L/T"], ["v_mid", steady.v_mid, "L/T"],
    ["displacement", steady.displacement, "L"], ["mean velocity", steady.mean_velocity, "L/T"], ["multiplier", steady.multiplier, ""],
    ["friction work", steady.friction_work, ""]];
  find("numbers").replaceChildren(...answers.map(([name, value]) => {
    const group = document.createElement("div"), term = document.createElement("dt"), number = document.createElement("dd");
    term.textContent = name;
    number.textContent = shown(value);
    number.title = shown(value, true);
    group.append(term, number);
    return group;
  }));
  const lines = [`${steady.regime}: ${REGIME_WORDS[steady.regime]}`, ...modesInWords(steady.modes)];
  if (steady.status === 1) lines.push(`The steady start velocities fill an interval, from ${shown(steady.v_low)} to ${shown(steady.v_high)}.`);
  find("words").replaceChildren(...lines.map((line) => Object.assign(document.createElement("span"), { textContent: line })));
}

const SPEEDS = { "1": "real time", "0.5": "1/2", "0.2": "1/5", "0.05": "1/20", "4s": "a period in 4 s", "12s": "a period in 12 s" };

/** Seconds of the motion that pass in a second. */
function rate() {
  const chosen = find("speed").value;
  return chosen.endsWith("s") ? motion.crawler.T / parseFloat(chosen) : Number(chosen);
}

function showTime() {
  if (!motion) return;
  const { T } = motion.crawler;
  time = motion.endless ? Math.max(0, time) : Math.min(Math.max(time, 0), motion.duration);
  const now = drawing.show(motion, time);
  find("time").max = motion.periods;
  find("time").value = now.t / T;
  find("clock").textContent = `t = ${(time / T).toFixed(2)} T`;
  find("now").textContent = `Body 1 ${["goes back", "sticks", "goes forward"][now.s1 + 1]}, body 2 ${["goes back", "sticks", "goes forward"][now.s2 + 1]}.`;
}

function frame(when) {
  if (!playing) return;
  time += Math.min(0.1, (when - before) / 1000) * rate();
  before = when;
  if (!motion.endless && time >= motion.duration) time = 0;
  showTime();
  requestAnimationFrame(frame);
}

function play(on) {
  playing = on;
  find("play").textContent = on ? "Pause" : "Play";
  find("play").setAttribute("aria-pressed", String(on));
  before = performance.now();
  if (on) requestAnimationFrame(frame);
}

function step(part) {
  play(false);
  time += part * motion.crawler.T;
  showTime();
}

for (const [value, textContent] of Object.entries(SPEEDS)) find("speed").append(Object.assign(document.createElement("option"), { value, textContent }));
find("speed").value = "4s";
find("play").addEventListener("click", () => play(!playing));
find("back").addEventListener("click", () => step(-0.01));
find("forth").addEventListener("click", () => step(0.01));
find("time").addEventListener("input", (event) => {
  play(false);
  time = Number(event.target.value) * motion.crawler.T;
  showTime();
});
find("undo").addEventListener("click", () => goTo(history.go(-1)));
find("redo").addEventListener("click", () => goTo(history.go(1)));
find("usual").addEventListener("click", () => change({ ...USUAL }));
addEventListener("hashchange", () => goTo(stateOf(location.hash)));

function goTo(other) {
  state = other;
  globalThis.history.replaceState(null, "", `#${fragmentOf(state)}`);
  ask();
}

for (const kind of ["dragover", "drop"])
  addEventListener(kind, (event) => {
    event.preventDefault();
    find("drop").hidden = kind === "drop";
    if (kind === "drop" && event.dataTransfer.files[0]) controls.read(event.dataTransfer.files[0]);
  });
addEventListener("dragleave", (event) => {
  if (!event.relatedTarget) find("drop").hidden = true;
});

update();
play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
globalThis.explorer = { core, state: () => state, change };
