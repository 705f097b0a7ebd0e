// The page: one state, and all views of it.
import bytes from "core.wasm";
import { Core, PARAMETERS, numberOf } from "./core.js";
import { AXES, LABELS, placed } from "./axes.js";
import { Controls, rounded } from "./controls.js";
import { Drawing } from "./crawler.js";
import { Curve, QUANTITIES } from "./curve.js";
import { Errors } from "./errors.js";
import { CrawlerMap, SHOWN } from "./map.js";
import { Motion } from "./motion.js";
import { Plane } from "./plane.js";
import { PRESETS } from "./presets.js";
import { Recording } from "./recording.js";
import { commandOf, pictureOf, pngOf, save, sceneOf, tsvOf } from "./share.js";
import { History, LONGEST_TABLE, USUAL, crawlerOf, fragmentOf, stateOf } from "./state.js";
import { REGIME_WORDS, modesInWords, shown } from "./words.js";
import { Work, finished } from "./work.js";

const find = (id) => document.getElementById(id);
const core = new Core(bytes);
const drawing = new Drawing(find("crawler"));
const controls = new Controls(find("controls"), core.families, change);
const plane = new Plane(find("plane"));
const recording = new Recording(core, find("recording-section"), [find("recording-length"), find("recording-velocity")], find("recording-note"));
const PICTURES = ["map", "curve", "errors"];
const work = new Work([...PICTURES, "table", "finer"], showWork, (error) => say(error.message));
const map = new CrawlerMap(core, work, find("map"), find("legend"), movedTo);
const curve = new Curve(core, find("curve"), find("curve-note"));
const errors = new Errors(core, find("errors"), find("error-formula"), find("formula"), find("error-note"));
const AMONG = {
  start: ["steady", "rest", "velocity"], x: Object.keys(AXES), y: Object.keys(AXES), show: Object.keys(SHOWN), along: ["x", "y"],
  of: Object.keys(QUANTITIES), phase: ["extension", "contraction"], error: ["absolute", "relative"],
  order: ["none", "4", "6", "8", "10", "12"],
};
let state = ofLink();
const history = new History(state);
let motion = null, took = 0, time = 0, playing = false, before = 0, asked = false;

/** Returns the state in the page's address; two axes of a map never set the same parameter. */
function ofLink() {
  const linked = stateOf(location.hash, AMONG);
  if (AXES[linked.x].sets === AXES[linked.y].sets) Object.assign(linked, { x: USUAL.x, y: USUAL.y });
  return linked;
}

/** Sets fields of the state. done: the drag has ended, and the change can be undone. */
function change(fields, done = true) {
  state = { ...state, ...fields };
  if (fields.table !== undefined) ownOf(fields);
  if (done) {
    history.push(state);
    globalThis.history.replaceState(null, "", `#${fragmentOf(state)}`);
  }
  ask();
}

/** Sets L, T and alpha of a measured gait that was just read. */
function ownOf(fields) {
  try {
    const own = core.chooseGait("measured", { name: fields.table_name, text: fields.table });
    for (const name of ["L", "T", "alpha"]) state[name] = String(own[name]);
  } catch {
    // shown beside the gait
  }
}

function ask() {
  if (!asked) requestAnimationFrame(update);
  asked = true;
}

/** Returns the errors of a state's fields, and the crawler; without errors it is chosen in the core. */
function judged(state) {
  const wrong = {}, crawler = crawlerOf(state);
  for (const name of PARAMETERS)
    if (Number.isNaN(crawler[name])) wrong[name] = `${name}: ${name === "alpha" ? "a number between 0 and 1, both excluded" : "a finite number > 0"}`;
  if (Number.isNaN(numberOf(state.v0))) wrong.v0 = "v0: a finite number";
  if (!/^([1-9]|[1-5][0-9]|60)$/.test(state.periods)) wrong.periods = "periods: a whole number from 1 to 60";
  const attempt = (name, action) => {
    try {
      action();
    } catch (error) {
      const parameter = error.message.split(":")[0];
      wrong[PARAMETERS.includes(parameter) ? parameter : name] = error.message;
    }
  };
  attempt("gait", () => core.chooseGait(state.gait, state.table ? { name: state.table_name, text: state.table } : null));
  if (Object.keys(wrong).length === 0) attempt("T", () => core.chooseCrawler(crawler));
  return { wrong, crawler };
}

/** Shows the state; the last picture stays if the state has errors. */
function update() {
  const begun = performance.now();
  asked = false;
  const { wrong, crawler } = judged(state), right = Object.keys(wrong).length === 0;
  if (right || !motion) {
    try {
      picture(right ? state : USUAL, right ? crawler : judged(USUAL).crawler);
    } catch (error) {
      wrong.T = error.message;
      work.clear();
      map.key = null;
    }
  }
  controls.show(state, wrong);
  document.body.classList.toggle("kept", Object.keys(wrong).length > 0);
  took = performance.now() - begun;
}

/** Shows all views of a crawler. */
function picture(state, crawler) {
  motion = new Motion(core, crawler, { start: state.start, v0: numberOf(state.v0), periods: Number(state.periods) });
  showAnswers();
  showTime();
  recording.show(state.gait === "measured" ? `${state.table_name} ${state.table}` : "");
  if (work.has("table")) say("The table was not saved, as the crawler changed before it was computed");
  work.drop("table");
  const gait = state.gait === "measured" ? `measured ${state.table.length}` : state.gait; // key of measured times
  map.show(crawler, state, `${gait} ${state.show}`);
  work.put("curve", "the curve along one axis", gait, curve.show(crawler, state[state.along], state.of, motion.steady[state.of]));
  work.put("errors", "the errors of the formulas", gait, errors.show(crawler, state, motion.endless ? 0 : motion.v0));
  work.go();
  for (const [id, name] of Object.entries(CHOICES)) find(id).value = state[name];
  find("command").textContent = commandOf(state);
  find("error-phase").parentElement.hidden = motion.endless;
  find("save-table").hidden = state.table === "";
}

/** Handles a move of the crawler in the map. */
function movedTo(places, done) {
  const names = [state.x, state.y], moved = placed(motion.crawler, places.map((x, k) => [names[k], x]));
  change(Object.fromEntries(names.map((name) => [AXES[name].sets, rounded(moved[AXES[name].sets])])), done);
}

function showAnswers() {
  const { steady } = motion;
  const answers = [["Froude number", steady.froude], ["v_start", steady.v_start], ["v_mid", steady.v_mid], ["displacement", steady.displacement],
    ["mean velocity", steady.mean_velocity], ["multiplier", steady.multiplier], ["friction work", steady.friction_work]];
  if (!motion.endless)
    answers.unshift(["first v_mid", motion.first.v_mid], ["first v_end", motion.first.v_end], ["first displacement", motion.first.displacement]);
  find("numbers").replaceChildren(...answers.map(([name, value]) => {
    const group = document.createElement("div"), term = document.createElement("dt"), number = document.createElement("dd");
    term.textContent = name;
    number.textContent = shown(value);
    number.title = shown(value, true);
    group.append(term, number);
    return group;
  }));
  const lines = [`${motion.endless ? "" : "Steady state, "}${steady.regime}: ${REGIME_WORDS[steady.regime]}`, ...modesInWords(steady.modes)];
  if (steady.status === 1) lines.push(`The steady start velocities fill an interval, from ${shown(steady.v_low)} to ${shown(steady.v_high)}.`);
  if (motion.periods < motion.asked) lines.push(`The animation shows ${motion.periods} of ${motion.asked} periods: there is no room for the modes of more.`);
  find("words").replaceChildren(...lines.map((line) => Object.assign(document.createElement("span"), { textContent: line })));
}

const CHOICES = { "map-x": "x", "map-y": "y", "map-show": "show", "curve-along": "along", "curve-of": "of", "error-phase": "phase", "error-size": "error", "error-order": "order" };
const SPEEDS = { "1": "real time", "0.5": "1/2", "0.2": "1/5", "0.05": "1/20", "4s": "a period in 4 s", "12s": "a period in 12 s" };

/** Returns seconds of the motion per second. */
function rate() {
  const chosen = find("speed").value;
  return chosen.endsWith("s") ? motion.crawler.T / parseFloat(chosen) : Number(chosen);
}

function showTime() {
  if (!motion) return;
  const { T } = motion.crawler;
  time = motion.endless ? Math.max(0, time) : Math.min(Math.max(time, 0), motion.duration);
  const now = drawing.show(motion, time);
  plane.show(motion, now);
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

const option = (value, textContent) => Object.assign(document.createElement("option"), { value, textContent });
const options = (id, texts) => find(id).append(...Object.entries(texts).map(([value, text]) => option(value, text)));
options("speed", SPEEDS);
options("map-x", LABELS);
options("map-y", LABELS);
options("map-show", SHOWN);
options("error-order", Object.fromEntries(AMONG.order.map((order) => [order, order === "none" ? order : `terms below T^${order}`])));
options("curve-of", Object.fromEntries(Object.entries(QUANTITIES).map(([name, { title }]) => [name, title])));
for (const [id, name] of Object.entries(CHOICES)) find(id).addEventListener("change", () => choose(name, find(id).value));
find("error-formula").addEventListener("change", (event) => choose("formula", event.target.value));

/** Adds a choice; the other axis changes if both would set the same parameter. */
function choose(name, value) {
  const fields = { [name]: value }, other = { x: "y", y: "x" }[name];
  if (other && AXES[value].sets === AXES[state[other]].sets) fields[other] = AXES[state[name]].sets === AXES[value].sets ? "F1/F2" : state[name];
  change(fields);
}

for (const group of new Set(PRESETS.map((preset) => preset.group))) {
  const made = Object.assign(document.createElement("optgroup"), { label: group });
  PRESETS.forEach((preset, i) => preset.group === group && made.append(option(String(i), preset.name)));
  find("presets").append(made);
}
find("presets").addEventListener("change", (event) => {
  const preset = PRESETS[event.target.value];
  if (!preset) return;
  change({ ...USUAL, ...preset.state });
  find("preset-note").textContent = preset.note;
  find("preset-note").hidden = false;
  time = 0;
  event.target.value = "";
});

/** Shows a message for a few seconds. */
function say(text) {
  find("said").textContent = text;
  clearTimeout(say.later);
  say.later = setTimeout(() => (find("said").textContent = ""), 4000);
}
async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
    say(`${what} copied`);
  } catch {
    say(`${what} could not be copied: this page may not write to the clipboard`);
  }
}
find("link").addEventListener("click", () => {
  const whole = location.href.split("#")[0] + "#" + fragmentOf(state);
  copy(whole, state.table.length > LONGEST_TABLE ? "Link without the measured gait, which is too long for one," : "Link");
});
find("copy-command").addEventListener("click", () => copy(commandOf(state), "Command"));
find("save-scene").addEventListener("click", () => save("explorer.cfg", sceneOf(state), "text/plain"));
find("save-table").addEventListener("click", () => save(state.table_name, state.table, "text/tab-separated-values"));
find("curve-tsv").addEventListener("click", () => {
  work.put("table", "the table of the curve", "", savedCurve(commandOf(state)));
  work.go();
});
/** Calls a function with the pictures once they show the state. */
function ifDone(names, action) {
  if (names.some((name) => work.has(name))) say("This is still to be computed: wait, or press Go on, and try again");
  else action();
}
function* savedCurve(command) {
  save("curve.tsv", tsvOf(yield* curve.table(), command, core.version), "text/tab-separated-values");
}
find("error-tsv").addEventListener("click", () => ifDone(["errors"], () => save("errors.tsv", tsvOf(errors.table(), commandOf(state), core.version), "text/tab-separated-values")));
const seen = () => pictureOf(find("crawler"), ["plane", "map", "curve", "errors"].map((id) => ({
  title: find(id).closest("section").querySelector("h2").textContent, canvas: find(id).querySelector("canvas") })), commandOf(state));
find("save-svg").addEventListener("click", () => ifDone(PICTURES, () => save("explorer.svg", seen(), "image/svg+xml")));
find("save-png").addEventListener("click", () => ifDone(PICTURES, async () => save("explorer.png", await pngOf(seen()))));
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
addEventListener("hashchange", () => {
  goTo(ofLink());
  history.push(state);
});

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

find("work-stop").addEventListener("click", () => (work.stopped ? work.goOn() : stop()));

function stop() {
  work.stop();
  say("Stopped; pale pictures are those from before");
}

/** Shows the progress of computations; pictures of an earlier state are pale. */
function showWork(now) {
  find("work").hidden = !now;
  for (const [name, id] of [["map", "map-section"], ["curve", "curve-section"], ["errors", "error-section"]])
    find(id).classList.toggle("older", now !== null && work.has(name));
  if (!now) return;
  const percent = `${Math.floor(100 * now.part)} %`, then = now.left.length ? ` Then ${now.left.join(", ")}.` : "";
  find("work-said").textContent = now.stopped ? `Stopped at ${percent} of ${now.what}.${then}` : `Computing ${now.what}: ${percent}.${then}`;
  find("work-part").value = now.part;
  find("work-stop").textContent = now.stopped ? "Go on" : "Stop";
}

addEventListener("keydown", (event) => {
  if (event.key === "Escape" && work.jobs.length > 0 && !work.stopped) stop();
  const typing = event.target.matches?.("input:not([type=range]), select, textarea");
  if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && !typing) {
    event.preventDefault();
    goTo(history.go(event.shiftKey ? 1 : -1));
  } else if (!typing && !event.ctrlKey && !event.metaKey && !event.altKey && event.target === document.body) {
    const keys = { " ": () => play(!playing), ArrowLeft: () => step(-0.01), ArrowRight: () => step(0.01) };
    if (keys[event.key]) {
      event.preventDefault();
      keys[event.key]();
    }
  }
});

update();
play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
globalThis.explorer = { core, work, finished, usual: USUAL, map, errors, curve, state: () => state, change, commandOf, sceneOf, picture: seen, png: () => pngOf(seen()), took: () => took };
