// The core of the explorer beside the command: node tests/explorer/core.js CORE.wasm SCALLOP FOLDER
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { Core } from "../../explorer/core.js";
import { Motion } from "../../explorer/motion.js";
import { nextPower, seriesOf, sumOf } from "../../explorer/series.js";
import { finished } from "../../explorer/work.js";
import { NAMES, NUMBERS, crawlers, measuredTable, random, unit } from "./crawlers.js";

const [wasm, scallop, folder] = process.argv.slice(2);
const MOST_UNITS = 8, MOST_BYTES = 228000, COUNT = 1000;
const bytes = readFileSync(wasm), core = new Core(bytes);
mkdirSync(folder, { recursive: true });

function test(name, body) {
  body();
  console.log(`ok ${name}`);
}

test("the core is small, and imports nothing", () => {
  assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
  assert.ok(statSync(wasm).size < MOST_BYTES, `${statSync(wasm).size} bytes`);
});

/** Rows of a table of the command, by the names of its header. */
function rowsOf(text) {
  const [header, ...rows] = text.split("\n").filter((line) => line && !line.startsWith("#")).map((line) => line.split("\t"));
  return rows.map((cells) => Object.fromEntries(header.map((name, i) => [name, cells[i]])));
}

test("1000 crawlers have the numbers of the command", () => {
  const next = random(5), tables = {};
  for (let i = 0; i < 3; i++) {
    const name = `${folder}/gait${i}.tsv`;
    tables[`measured:${name}`] = { name, text: measuredTable(next) };
    writeFileSync(name, tables[`measured:${name}`].text);
  }
  const points = crawlers(COUNT, Object.keys(tables));
  const columns = [...NAMES, "gait"];
  writeFileSync(`${folder}/points.tsv`, [columns, ...points.map((p) => columns.map((name) => p[name]))].map((row) => row.join("\t")).join("\n") + "\n");
  const command = spawnSync(scallop, ["steady", "--points", `${folder}/points.tsv`, "--quiet"], { encoding: "utf8" });
  assert.equal(command.stderr, "");
  const rows = rowsOf(command.stdout);
  assert.equal(rows.length, COUNT);
  let equal = 0, worst = 0, modes = 0;
  points.forEach((point, i) => {
    core.chooseGait(point.gait.startsWith("measured") ? "measured" : point.gait, tables[point.gait]);
    core.chooseCrawler(point);
    const steady = core.steady();
    assert.ok(["ok", "interval"].some((status) => rows[i].status.startsWith(status)), rows[i].status);
    modes += steady.modes === rows[i].modes && steady.regime === rows[i].regime;
    for (const name of NUMBERS) {
      const wanted = Number(rows[i][name]);
      if (Object.is(steady[name], wanted)) {
        equal++;
        continue;
      }
      const apart = Math.abs(steady[name] - wanted) / unit(core, point, name);
      assert.ok(apart <= MOST_UNITS, `${name} of ${JSON.stringify(point)}: ${steady[name]}, not ${wanted}: ${apart} units`);
      worst = Math.max(worst, apart);
    }
  });
  console.log(`  ${equal} of ${COUNT * NUMBERS.length} numbers have the same bits; the others differ by up to ${worst.toFixed(2)} units; ${modes} of ${COUNT} modes are the same`);
  assert.ok(modes >= 0.99 * COUNT);
  assert.ok(equal >= 0.8 * COUNT * NUMBERS.length);
});

test("many at once are those one by one", () => {
  const points = crawlers(500, []).map((point) => ({ ...point, gait: "sinusoidal" }));
  core.chooseGait("sinusoidal");
  core.chooseCrawler(points[0]);
  core.forgetClasses();
  const many = core.steadyStates(points.length, (rows) => points.forEach((p, i) => NAMES.forEach((name, k) => (rows[k][i] = p[name]))), { withWork: true });
  const kept = Object.fromEntries(Object.entries(many).map(([name, row]) => [name, row.slice()]));
  points.forEach((point, i) => {
    core.chooseCrawler(point);
    const one = core.steady();
    for (const name of [...NUMBERS, "friction_work"]) assert.equal(kept[name][i], one[name]);
    assert.equal(core.className(kept.class[i]), `${one.regime}: ${one.modes}`);
  });
});

test("what is not allowed is refused, and the crawler stays", () => {
  core.chooseGait("quadratic");
  const usual = { m1: 1, m2: 1, F1: 4, F2: 1, L: 10, T: 1, alpha: 0.75 };
  core.chooseCrawler(usual);
  const before = core.steady();
  assert.throws(() => core.chooseCrawler({ ...usual, alpha: 1 }), /alpha: a number between 0 and 1/);
  assert.throws(() => core.chooseCrawler({ ...usual, F1: -3 }), /F1: a finite number > 0/);
  assert.throws(() => core.chooseCrawler({ ...usual, T: 1e-300 }), Error);
  assert.throws(() => core.chooseGait("trapezoidal:0.7,0.7"), /UP/);
  assert.throws(() => core.chooseGait("square"), /no gait/);
  assert.throws(() => core.chooseGait("polynomial:1,2"), Error);
  assert.throws(() => core.chooseGait("measured", { name: "<b>x</b>.tsv", text: "0 0\n1 2\n0.5 x\n2 0\n" }), /<b>x<\/b>\.tsv:3: column 2, 'x', is not a finite number/);
  assert.throws(() => core.chooseGait("measured", { name: "x.tsv", text: "0 0\n1\tx\n" }), /x\.tsv:2: /);
  assert.throws(() => core.chooseGait("measured", { name: "x.tsv", text: "" }), /rows/);
  const rows = (count) => Array.from({ length: count }, (_, i) => `${i}\t${Math.min(i, count - 1 - i)}`).join("\n");
  assert.throws(() => core.chooseGait("measured", { name: "x.tsv", text: `t\tl\n${rows(4001)}\n` }), /x\.tsv: 4001 rows; this page takes at most 2000\. Keep one row in 3,/);
  core.chooseGait("measured", { name: "x.tsv", text: `# one more line\nt\tl\n${rows(2000)}\n\n` });
  core.chooseGait("quadratic");
  core.chooseCrawler(usual);
  assert.deepEqual(core.steady(), before);
});

test("a formula beside the command's claim: the error of (28) falls as T^4, for the sinusoidal gait not at all", () => {
  const formula = core.formulas.find(({ name }) => name === "eq28_displacement");
  const slope = (gait) => {
    core.chooseGait(gait);
    core.chooseCrawler({ m1: 1, m2: 1, F1: 4, F2: 1, L: 10, T: 1, alpha: 0.75 });
    const { exact, values: [value] } = core.formulasAlong([formula], 0, 0, [0.1, 0.2]);
    return Math.log2(Math.abs((exact[1] - value[1]) / (exact[0] - value[0])));
  };
  assert.ok(Math.abs(slope("quadratic") - 4) < 0.05);
  assert.ok(Math.abs(slope("sinusoidal")) < 0.05);
});

test("a motion with more modes than there is room for shows whole periods", () => {
  const next = random(4), l = (i) => (i % 999 ? 10 * Math.sin((Math.PI * i) / 999) ** 2 + 0.1 * next() : 0);
  core.chooseGait("measured", { name: "x:monotone", text: Array.from({ length: 1000 }, (_, i) => `${i / 999}\t${l(i)}\n`).join("") });
  const crawler = { m1: 1, m2: 1, F1: 4, F2: 1, L: 10, T: 3, alpha: 0.5 };
  core.chooseCrawler(crawler);
  const motion = new Motion(core, crawler, { start: "rest", v0: 0, periods: 60 }), { begin, end } = motion.walk;
  assert.ok(motion.periods < 60 && motion.asked === 60);
  assert.ok(motion.duration <= end.at(-1) && end.every((t, i) => i === 0 || begin[i] >= begin[i - 1]));
  assert.equal(motion.samples.count, 240 * motion.periods + 1);
});

test("a recording: its samples, and the curve near them", () => {
  const t = Array.from({ length: 40 }, (_, i) => i / 20), l = (x) => 3 - 2 * Math.cos(Math.PI * x);
  core.chooseGait("measured", { name: "x.csv", text: `t [s],l [m]\n${t.map((x) => `${x},${l(x)}`).join("\n")}\n` });
  const { samples, curve, text } = core.recording(101);
  assert.match(text, /^40 rows, closed over a gap of one step after the last, period 2; a .* spline/);
  assert.deepEqual([...samples[0]].map((x) => x.toPrecision(12)), t.map((x) => x.toPrecision(12)));
  curve[0].forEach((x, i) => {
    assert.ok(Math.abs(curve[1][i] - l(x)) < 1e-3);
    assert.ok(Math.abs(curve[2][i] - 2 * Math.PI * Math.sin(Math.PI * x)) < 0.1);
  });
  core.chooseGait("quadratic");
  assert.equal(core.recording(101), null);
});

test("figures 4 and 5 of data/, exact numbers and formulas", () => {
  const near = (got, wanted, where) => assert.ok(Math.abs(got - wanted) <= 1e-11 * Math.max(1, Math.abs(wanted)), `${where}: ${got}, not ${wanted}`);
  const usual = { m1: 1, m2: 1, F1: 1, F2: 1, L: 10, T: 1, alpha: 0.5 }, formula = (name) => core.formulas.find((one) => one.name === name);
  core.chooseGait("quadratic");
  const fourth = rowsOf(readFileSync("data/figure4.tsv", "utf8")), fifth = rowsOf(readFileSync("data/figure5.tsv", "utf8"));
  for (const row of fourth) {
    core.chooseCrawler({ ...usual, F1: Number(row.F1_over_F2) });
    const { exact, values: [value] } = core.formulasAlong([formula("eq21_dxC")], 0, 0, [2 * Number(row.T)]);
    near(exact[0] / 10, Number(row.dxC_over_L), "dxC");
    near(value[0] / 10, Number(row.series_dxC_over_L), "(21)");
  }
  const ends = fifth.map((row) => ({ ...usual, F1: Number(row.F1_over_F2) * Number(row.F2), F2: Number(row.F2), alpha: Number(row.alpha) }));
  const { mean_velocity } = core.steadyStates(ends.length, (rows) => ends.forEach((end, i) => NAMES.forEach((name, k) => (rows[k][i] = end[name]))));
  const exact = mean_velocity.slice(), series = core.formulaOver(formula("eq28_displacement"), ends.length);
  fifth.forEach((row, i) => {
    near(exact[i], Number(row.mean_velocity), "mean velocity");
    near(series[i], Number(row.series_mean_velocity), "(28)");
  });
  assert.ok(fourth.length === 600 && fifth.length > 1000);
});

test("series are those of `scallop series --source derived`, of the steady state, from rest and from a velocity", () => {
  const usual = { m1: 1, m2: 1, F1: 4, F2: 1, L: 10, T: 1, alpha: 0.75 };
  const cases = [
    ["quadratic", {}, "eq28_displacement", 0, 0, { 0: 120 / 37, 4: -711 / 350464, 8: -121581 / 53113520128 }],
    ["quadratic", {}, "eq27_v_start", 0, 0, { "-1": 120 / 37, 1: -117 / 592, 3: -40773 / 1401856, 5: 2133 / 22429696, 7: 262359 / 106227040256 }],
    ["quadratic", {}, "eq21_dxC", 0, 0, { 2: 3 / 4, 6: -9 / 800, 8: 27 / 16000, 10: -243 / 1280000 }],
    ["quadratic", {}, "eq14_dT", 1, 0, { 3: 3 / 40, 5: -9 / 1600, 7: 27 / 64000, 9: -81 / 2560000 }],
    ["quadratic", {}, "eqA24_v_end", 0, 1.5, { 0: 3 / 2, 1: 3 / 2, 2: -3 / 5, 3: -3 / 10, 4: 3 / 25, 5: 9 / 400 }],
    ["quadratic", {}, "eqB13_dxC", 1, 1.5, { 1: 3 / 2, 2: -3 / 4, 3: -3 / 40, 5: 3 / 200 }],
    ["sinusoidal", { F1: 2.385, alpha: 0.6, m2: 3 }, "eq27_v_start", 0, 0,
     { "-1": 1.90837668642696309, 1: -0.0817042637742908323, 3: -0.000297517401627125129, 5: 6.20086529008645854e-6, 7: 1.78935300825690331e-8, 9: 1.77176051288763327e-10 }],
  ];
  for (const [gait, own, name, phase, v0, wanted] of cases) {
    const crawler = { ...usual, ...own }, formula = core.formulas.find((one) => one.name === name);
    core.chooseGait(gait);
    core.chooseCrawler(crawler);
    const duration = formula.setting === 3 ? 1 : phase === 0 ? crawler.alpha : 1 - crawler.alpha; // of the command's T, in periods
    const series = finished(seriesOf(core, formula, phase, v0, 2)), last = Math.max(...Object.keys(wanted).map(Number));
    for (const { power, value } of series.terms.filter(({ power }) => power <= last)) {
      const got = value / (2 * duration) ** power, right = wanted[power] ?? 0;
      assert.ok(Math.abs(got - right) <= 1e-12 * Math.abs(right), `${gait} ${name} T^${power}: ${got}, not ${right}`);
    }
    const [sum] = sumOf(series, last + 1, [0.5]), direct = Object.entries(wanted).reduce((all, [power, c]) => all + c * (0.5 * duration) ** power, 0);
    assert.ok(Math.abs(sum - direct) <= 1e-12 * Math.abs(direct), `${gait} ${name}: the sum is ${sum}, not ${direct}`);
    assert.ok(nextPower(series, last) === last);
  }
});

test("where there is no series, none is found", () => {
  core.chooseGait("minimum-jerk"); // l'' = 0 where a phase begins: fractional powers of T
  core.chooseCrawler({ m1: 1, m2: 1, F1: 4, F2: 1, L: 10, T: 1, alpha: 0.75 });
  const find = (name, unit) => finished(seriesOf(core, core.formulas.find((one) => one.name === name), 0, 0, unit));
  assert.equal(find("eq21_dxC", 2), null);
  assert.equal(find("eq14_dT", 2), null);
  assert.equal(find("eq15_x1_switch", 2), null);
  assert.ok(find("eq28_displacement", 2));
});
