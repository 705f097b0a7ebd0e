// The map: crawlers over two axes, as regions of equal modes with names, or as a heat map. The crawler is a point that can be dragged.
import { AXES, LABELS, fill, range, valueAt } from "./axes.js";
import { classColour, css, heatColour } from "./colours.js";
import { Plot, colour, drawPoint, scale } from "./plots.js";
import { shown } from "./words.js";
import { finished, inParts, within } from "./work.js";

export const SHOWN = {
  modes: "regimes and modes", displacement: "displacement", mean_velocity: "mean velocity", error: "relative error of a formula", friction_work: "friction work",
};
const SIDES = [100, 50, 25, 12]; // cells per side, from fine to coarse
const FULL = SIDES[0], BUDGET = 7, MOST = 30, REST = 75; // milliseconds of a frame, of the coarsest map in it, and until the legend is drawn
const NAMED = 12; // regions at the top of the legend

export class CrawlerMap {
  constructor(core, work, host, legend, moved) {
    Object.assign(this, { core, work, host, legend, moved, perCell: {}, plot: new Plot(host, { height: 420 }), image: document.createElement("canvas") });
    host.addEventListener("keydown", (event) => this.press(event));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.classes && (this.paint(this.n), this.draw(), this.explain()));
  }

  /** Shows the map around a crawler; keeps the map if the crawler has only moved in it. gait: key of the time per cell. */
  show(crawler, { x, y, show, formula }, gait) {
    Object.assign(this, { crawler, names: [x, y], what: show, gait });
    const steady = this.core.formulas.filter(({ setting, turns }) => setting === 3 && turns === 0);
    this.formula = steady.find(({ name }) => name === formula) ?? steady.find(({ name }) => name === "eq28_displacement");
    this.ranges = this.names.map((name) => range(name, crawler));
    this.sized();
    const fixed = { ...crawler, [AXES[x].sets]: 0, [AXES[y].sets]: 0 };
    const key = JSON.stringify([this.core.chosen.key, fixed, x, y, show, this.formula.name, this.ranges]);
    if (this.key === key) return this.shown?.redraw(false);
    this.key = key;
    ["map", "finer"].forEach((name) => this.work.drop(name));
    const n = this.side();
    if (n) finished(this.solve(n));
    else this.work.put("map", "the map", gait, this.solve(SIDES.at(-1)));
    if (n !== FULL) this.work.put("finer", "a finer map", gait, this.refine());
  }

  /** Returns cells per side that a frame has time for, more than `from`; undefined if the gait's time is unknown. */
  side(from = 0) {
    return SIDES.find((n) => n > from && n * n * this.perCell[this.gait] < (n === SIDES.at(-1) ? MOST : BUDGET));
  }

  *refine() {
    while (this.n < FULL) {
      const n = this.side(this.n) ?? SIDES.findLast((n) => n > this.n), part = (n) => (n / FULL) ** 2;
      yield* within(part(this.n), part(n) - part(this.n), this.solve(n));
    }
  }

  /** Solves and shows n cells per side. */
  *solve(n) {
    const made = blank(n);
    let took = 0;
    this.place(n);
    yield* inParts(n * n, (from, to) => {
      const begun = performance.now();
      this.cells(made, from, to);
      took += performance.now() - begun;
    });
    const each = took / n ** 2, before = this.perCell[this.gait] ?? each;
    this.perCell[this.gait] = each < before ? (before + each) / 2 : Math.min(each, 1.2 * before); // limits the effect of a pause of the machine
    Object.assign(this, made, { took });
    this.paint(n);
    this.draw();
    clearTimeout(this.later);
    this.later = setTimeout(() => this.explain(), REST);
  }

  /** Returns the centres of the cells. */
  place(n) {
    const key = `${n} ${this.names} ${this.ranges}`, count = n * n;
    if (this.places?.key === key) return;
    const xs = [new Float64Array(count), new Float64Array(count)];
    for (let i = 0; i < count; i++) {
      xs[0][i] = valueAt(this.names[0], this.ranges[0], ((i % n) + 0.5) / n);
      xs[1][i] = valueAt(this.names[1], this.ranges[1], 1 - (Math.floor(i / n) + 0.5) / n);
    }
    this.places = { key, xs };
  }

  cells({ classes, values }, from, to) {
    const { core, what, names, crawler } = this, count = to - from, xs = this.places.xs.map((row) => row.subarray(from, to));
    const states = core.steadyStates(count, (rows) => fill(rows, crawler, count, names, xs), { withWork: what === "friction_work", digits: "picture" });
    classes.set(states.class, from);
    if (what === "error") {
      const exact = states[this.formula.quantity].slice(), value = core.formulaOver(this.formula, count);
      for (let i = 0; i < count; i++) values[from + i] = Math.log10(Math.max(Math.abs(value[i] / exact[i] - 1), 1e-16));
    } else if (what !== "modes") values.set(states[what], from);
  }

  paint(n) {
    this.image.width = this.image.height = n;
    const context = this.image.getContext("2d"), pixels = context.createImageData(n, n);
    const colours = new Uint32Array(pixels.data.buffer), packed = ([red, green, blue]) => (255 << 24) | (blue << 16) | (green << 8) | red;
    if (this.what === "modes") {
      const known = [];
      this.classes.forEach((id, i) => {
        colours[i] = id < 0 ? 0 : (known[id] ??= packed(classColour(this.core.className(id), id)));
      });
    } else {
      this.scale = heatScale(this.values, this.what);
      const table = Array.from({ length: 256 }, (_, i) => packed(heatColour(i / 255, this.scale.both)));
      const { values, scale: { place } } = this;
      for (let i = 0; i < values.length; i++) colours[i] = Number.isFinite(values[i]) ? table[Math.round(255 * place(values[i]))] : 0;
    }
    context.putImageData(pixels, 0, 0);
  }

  draw() {
    const [x, y] = this.names;
    const scales = { x: scale(AXES[x].log, () => this.ranges[0]), y: scale(AXES[y].log, () => this.ranges[1]) };
    const hooks = { drawClear: [(u) => this.drawImage(u)], draw: [(u) => this.drawOver(u)], ready: [(u) => this.listen(u)] };
    const what = { key: `${x} ${y}`, x: LABELS[x], y: LABELS[y], series: [{ show: false }], scales, hooks, legend: false, grid: false, cursor: { show: false } };
    this.shown = this.plot.show(what, [this.ranges[0], [null, null]]);
  }

  drawImage(u) {
    const { left, top, width, height } = u.bbox;
    u.ctx.imageSmoothingEnabled = false;
    u.ctx.drawImage(this.image, left, top, width, height);
  }

  drawOver(u) {
    if (this.what === "modes" && this.names_in) this.drawNames(u);
    drawPoint(u, AXES[this.names[0]].of(this.crawler), AXES[this.names[1]].of(this.crawler), "point");
  }

  drawNames(u) {
    const { ctx, bbox } = u, pixel = devicePixelRatio;
    ctx.save();
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    ctx.fillStyle = colour("ink");
    for (const { number, regime, x, y, size } of this.names_in) {
      const wide = size * bbox.width > 80 * pixel;
      ctx.font = `${wide ? 13 * pixel : 12 * pixel}px system-ui`;
      if (size * bbox.height > 14 * pixel) ctx.fillText(wide ? `${number} ${regime}` : String(number), bbox.left + x * bbox.width, bbox.top + y * bbox.height);
    }
    ctx.restore();
  }

  /** Draws legend and names, after the map has come to rest. */
  explain() {
    if (this.what === "modes") this.explainModes();
    else this.explainHeat();
    this.shown.redraw(false);
  }

  explainModes() {
    const n = this.n, known = [...widest(this.classes, n)].filter(([id]) => id >= 0).sort((a, b) => b[1].cells - a[1].cells);
    this.names_in = [];
    const items = known.map(([id, place], i) => {
      const name = this.core.className(id), item = document.createElement("span"), swatch = document.createElement("i");
      this.names_in.push({ number: i + 1, regime: name.split(":")[0], x: (place.i % n + 0.5) / n, y: (Math.floor(place.i / n) + 0.5) / n, size: (2 * place.reach) / n });
      swatch.style.background = css(classColour(name, id));
      item.append(swatch, `${i + 1} ${name}`);
      return item;
    });
    const others = known.slice(NAMED).reduce((sum, [, { cells }]) => sum + cells, 0) / (n * n);
    const folded = items.length > NAMED + 1 ? [this.folded(items.splice(NAMED), others)] : [];
    this.legend.replaceChildren(...items, ...folded);
  }

  /** Lists the smaller regions on request; the list stays open. */
  folded(items, part) {
    const made = document.createElement("details"), head = document.createElement("summary");
    head.textContent = `others (${items.length}), ${Number((100 * part).toPrecision(2))} % of the map`;
    made.open = this.legend.querySelector("details")?.open ?? false;
    made.append(head, ...items);
    return made;
  }

  explainHeat() {
    const { low, high, both, invert } = this.scale, bar = document.createElement("b"), parts = [0, 0.25, 0.5, 0.75, 1];
    bar.style.background = `linear-gradient(to right, ${Array.from({ length: 9 }, (_, i) => css(heatColour(i / 8, both))).join(", ")})`;
    const ticks = parts.map((part) => Object.assign(document.createElement("span"), { textContent: this.what === "error" ? `1e${shown(Number(invert(part).toFixed(1)))}` : String(Number(invert(part).toPrecision(3))) }));
    this.legend.replaceChildren(Object.assign(document.createElement("div"), { className: "heat" }));
    const row = document.createElement("div");
    row.className = "ticks";
    row.append(...ticks);
    this.legend.firstChild.append(bar, row);
    if (this.what === "error") row.append(`error of ${this.formula.equation} for ${this.formula.quantity}, relative`);
    this.legend.firstChild.setAttribute("aria-label", `${SHOWN[this.what]} from ${shown(low)} to ${shown(high)}`);
  }

  listen(u) {
    const at = (event) => {
      const box = u.over.getBoundingClientRect(), part = [event.clientX - box.left, event.clientY - box.top];
      const within = (k, size) => Math.min(Math.max(part[k] / size, 0), 1);
      return [valueAt(this.names[0], this.ranges[0], within(0, box.width)), valueAt(this.names[1], this.ranges[1], 1 - within(1, box.height))];
    };
    u.over.style.touchAction = "none";
    u.over.addEventListener("pointerdown", (event) => {
      u.over.setPointerCapture(event.pointerId);
      this.dragged = true;
      this.moved(at(event), false);
    });
    u.over.addEventListener("pointermove", (event) => this.dragged && this.moved(at(event), false));
    for (const kind of ["pointerup", "pointercancel"])
      u.over.addEventListener(kind, (event) => {
        if (this.dragged) this.moved(at(event), true);
        this.dragged = false;
      });
  }

  press(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
    if (!steps || !this.crawler) return;
    event.preventDefault();
    event.stopPropagation();
    this.moved(this.names.map((name, k) => {
      const x = AXES[name].of(this.crawler), [from, to] = this.ranges[k], part = steps[k] * (event.shiftKey ? 0.1 : 0.01);
      return Math.min(Math.max(AXES[name].log ? x * (to / from) ** part : x + part * (to - from), from), to);
    }), true);
  }

  sized() {
    this.plot.height = innerWidth < 760 ? 320 : 420;
  }
}

/** Returns the scale of values from 0 to 1: linear, or, if they span decades, logarithmic on either side of 0. */
function heatScale(values, what) {
  const sorted = values.filter(Number.isFinite).sort(), low = sorted[0] ?? 0, high = sorted.at(-1) ?? 1;
  const both = low < 0 && high > 0 && what !== "error", most = Math.max(Math.abs(low), Math.abs(high));
  const typical = Math.abs(sorted[sorted.length >> 1] ?? 0) || most / 100;
  const knee = what === "error" || most < 50 * typical ? Infinity : typical;
  const bend = (x) => (knee === Infinity ? x : Math.asinh(x / knee)), unbend = (x) => (knee === Infinity ? x : knee * Math.sinh(x));
  const from = both ? -bend(most) : bend(low), to = both ? bend(most) : bend(high), span = to - from || 1;
  return { low, high, both, place: (x) => (bend(x) - from) / span, invert: (part) => unbend(from + part * span) };
}

const blank = (n) => ({ n, classes: new Int16Array(n * n), values: new Float64Array(n * n) });

/** Returns for each class the count of its cells, and the cell farthest from all other classes, by the distance in steps. */
function widest(classes, n) {
  const reach = new Int16Array(n * n), found = new Map();
  const other = (i, j) => j < 0 || j >= n * n || classes[j] !== classes[i];
  for (let i = 0; i < n * n; i++)
    reach[i] = other(i, i - n) || i % n === 0 || other(i, i - 1) ? 1 : 1 + Math.min(reach[i - n], reach[i - 1]);
  for (let i = n * n - 1; i >= 0; i--) {
    const edge = other(i, i + n) || i % n === n - 1 || other(i, i + 1);
    reach[i] = edge ? 1 : Math.min(reach[i], 1 + Math.min(reach[i + n], reach[i + 1]));
  }
  for (let i = 0; i < n * n; i++) {
    const place = found.get(classes[i]) ?? { cells: 0, reach: 0, i };
    place.cells++;
    if (reach[i] > place.reach) Object.assign(place, { reach: reach[i], i });
    found.set(classes[i], place);
  }
  return found;
}
