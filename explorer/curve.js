// A quantity along one axis through the crawler.
import { AXES, LABELS, fill, range, valueAt } from "./axes.js";
import { Plot, drawMarks, drawPoint, line, scale } from "./plots.js";
import { shown } from "./words.js";
import { inParts } from "./work.js";

export const QUANTITIES = {
  mean_velocity: { title: "mean velocity", formula: "eq28_displacement", over: (_, T) => T }, displacement: { title: "displacement", formula: "eq28_displacement" },
  v_start: { title: "v_start", formula: "eq27_v_start" }, v_mid: { title: "v_mid" }, multiplier: { title: "multiplier" },
  friction_work: { title: "friction work" }, froude: { title: "Froude number" },
};
const COUNT = 401;

export class Curve {
  constructor(core, host, note) {
    Object.assign(this, { core, note, plot: new Plot(host) });
  }

  /** digits: as in core.steadyStates */
  *solve(crawler, name, of, digits) {
    const { core } = this, ends = range(name, crawler), { formula, over } = QUANTITIES[of];
    const xs = Float64Array.from({ length: COUNT }, (_, i) => valueAt(name, ends, i / (COUNT - 1)));
    const series = formula && core.formulas.find((one) => one.name === formula);
    const exact = [], classes = [], published = series ? [] : null, finite = (y) => (Number.isFinite(y) ? y : null);
    yield* inParts(COUNT, (from, to) => {
      const count = to - from, options = { withWork: of === "friction_work", digits };
      const states = core.steadyStates(count, (rows) => fill(rows, crawler, count, [name], [xs.subarray(from, to)]), options), T = core.row(5, count);
      exact.push(...Array.from(states[of], finite));
      classes.push(...states.class);
      published?.push(...Array.from(core.formulaOver(series, count), (y, i) => finite(y / (over ? over(crawler, T[i]) : 1))));
    });
    return { ends, xs: [...xs], exact, published, series, classes, names: [name, of, ...(series ? [series.name] : [])] };
  }

  /** Returns rows of a table: x, the exact number, and the formula's. */
  *table() {
    const [crawler, name, of] = this.shown, { names, xs, exact, published } = yield* this.solve(crawler, name, of, of === "multiplier" ? "all" : "no multiplier");
    return { names, rows: [xs, exact, ...(published ? [published] : [])] };
  }

  /** Returns the work to show it. own: the quantity of the crawler itself. */
  show(crawler, name, of, own) {
    this.shown = [crawler, name, of];
    return this.drawn(crawler, name, of, own);
  }

  *drawn(crawler, name, of, own) {
    const { title } = QUANTITIES[of], { ends, xs, exact, published, series, classes } = yield* this.solve(crawler, name, of, "picture");
    this.changes = xs.filter((_, i) => i > 0 && classes[i] !== classes[i - 1]);
    const [low, high] = extent(exact);
    this.point = [AXES[name].of(crawler), own];
    const hooks = { drawClear: [(u) => drawMarks(u, this.changes)], draw: [(u) => drawPoint(u, ...this.point, "point")] };
    const lines = [line(title, "accent"), ...(series ? [line(`${series.equation}, published`, "friction", { dash: [6, 4] })] : [])];
    this.margins = [low - 0.08 * (high - low || 1), high + 0.08 * (high - low || 1)];
    const scales = { x: scale(AXES[name].log, () => ends), y: scale(false, () => this.margins) };
    this.ends = ends;
    this.plot.show({ key: `${name} ${of} ${ends}`, x: LABELS[name], y: title, series: lines, scales, hooks }, [xs, exact, ...(published ? [published] : [])]);
    this.tell(name, title, xs, exact);
  }

  /** Shows a sentence about the maxima. */
  tell(name, title, xs, values) {
    const peaks = [];
    for (let i = 1; i + 1 < values.length; i++) if (values[i] > values[i - 1] && values[i] >= values[i + 1]) peaks.push(i);
    const places = peaks.slice(0, 4).map((i) => `${shown(Number(xs[i].toPrecision(3)))} (${shown(Number(values[i].toPrecision(4)))})`);
    const inside = peaks.length ? `The ${title} has a maximum inside at ${LABELS[name]} = ${places.join(" and ")}.` : `The ${title} has no maximum inside.`;
    this.note.textContent = `${inside} Dashed verticals: the modes change.`;
  }
}

function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const y of values) if (y !== null) [low, high] = [Math.min(low, y), Math.max(high, y)];
  return low <= high ? [low, high] : [0, 1];
}
