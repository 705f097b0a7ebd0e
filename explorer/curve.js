// A quantity along one axis through the crawler.
import { AXES, LABELS, fill, range, valueAt } from "./axes.js";
import { Plot, drawMarks, drawPoint, line, scale } from "./plots.js";
import { shown } from "./words.js";

export const QUANTITIES = {
  mean_velocity: { title: "mean velocity", formula: "text_steady_xC", over: (_, T) => T }, displacement: { title: "displacement", formula: "text_steady_xC" },
  v_start: { title: "v_start", formula: "text_steady_velocity" }, v_mid: { title: "v_mid" }, multiplier: { title: "multiplier" },
  friction_work: { title: "friction work" }, froude: { title: "Froude number" },
};
const COUNT = 401;

export class Curve {
  constructor(core, host, note) {
    Object.assign(this, { core, note, plot: new Plot(host) });
  }

  /** digits: all of them, not what a picture needs. */
  solve(crawler, name, of, digits) {
    const { core } = this, ends = range(name, crawler), { formula, over } = QUANTITIES[of];
    const xs = Float64Array.from({ length: COUNT }, (_, i) => valueAt(name, ends, i / (COUNT - 1)));
    const states = core.steadyStates(COUNT, (rows) => fill(rows, crawler, COUNT, [name], [xs]), { withWork: of === "friction_work", forPicture: !digits });
    const exact = [...states[of]].map((y) => (Number.isFinite(y) ? y : null)), classes = states.class.slice(), T = core.row(5, COUNT).slice();
    const series = formula && core.formulas.find((one) => one.name === formula);
    const published = series ? [...core.formulaOver(series, COUNT)].map((y, i) => (Number.isFinite(y) ? y / (over ? over(crawler, T[i]) : 1) : null)) : null;
    return { ends, xs: [...xs], exact, published, series, classes, names: [name, of, ...(series ? [series.name] : [])] };
  }

  /** For a table: x, the exact number, and that of a formula. */
  table() {
    const { names, xs, exact, published } = this.solve(...this.shown, true);
    return { names, rows: [xs, exact, ...(published ? [published] : [])] };
  }

  show(crawler, name, of) {
    const { core } = this, { title } = QUANTITIES[of], { ends, xs, exact, published, series, classes } = this.solve(crawler, name, of, false);
    this.shown = [crawler, name, of];
    this.changes = xs.filter((_, i) => i > 0 && classes[i] !== classes[i - 1]);
    const [low, high] = extent(exact);
    this.point = [AXES[name].of(crawler), null];
    core.chooseCrawler(crawler);
    this.point[1] = core.steady()[of];
    const hooks = { drawClear: [(u) => drawMarks(u, this.changes)], draw: [(u) => drawPoint(u, ...this.point, "point")] };
    const lines = [line(title, "accent"), ...(series ? [line(`${series.equation}, published`, "friction", { dash: [6, 4] })] : [])];
    this.margins = [low - 0.08 * (high - low || 1), high + 0.08 * (high - low || 1)];
    const scales = { x: scale(AXES[name].log, () => ends), y: scale(false, () => this.margins) };
    this.ends = ends;
    this.plot.show({ key: `${name} ${of} ${ends}`, x: LABELS[name], y: title, series: lines, scales, hooks }, [xs, exact, ...(published ? [published] : [])]);
    this.tell(name, title, xs, exact);
  }

  /** Where it is largest and smallest. */
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
