// Plots, by uPlot: the library draws axes, lines and cursors.
import uPlot from "uplot";

export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const HEIGHT = 300;

const number = (x) => (x === null ? "" : x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5) ? x.toExponential().replace("e+", "e") : String(Number(x.toPrecision(6))));
const isPower = (x) => Math.abs(Math.log10(x) - Math.round(Math.log10(x))) < 1e-9;
/** Filters grid lines: on a log scale of many decades at powers of ten only. */
const fewer = (u, splits, i) => {
  const { distr, min, max } = u.scales[u.axes[i].scale];
  return distr === 3 && max / min > 1e4 ? splits.map((x) => (isPower(x) ? x : null)) : splits;
};
/** Filters labels: as many of these as fit. */
const labelled = (u, splits, i) => {
  const { distr, min, max } = u.scales[u.axes[i].scale], decades = Math.log10(max / min);
  if (distr !== 3) return splits;
  const room = (i === 0 ? u.bbox.width / 60 : u.bbox.height / 26) / devicePixelRatio, every = Math.max(1, Math.ceil(decades / room));
  const kept = (x) => (decades < 1.5 ? true : isPower(x) && Math.round(Math.log10(x)) % every === 0);
  return splits.map((x) => (kept(x) ? x : null));
};
/** Returns powers of ten, and their multiples if they are few. */
function logSplits(u, i, min, max) {
  const from = Math.floor(Math.log10(min)), to = Math.ceil(Math.log10(max)), few = to - from <= 6, splits = [];
  for (let k = from; k <= to; k++) for (let digit = 1; digit <= (few ? 9 : 1); digit++) splits.push(Number(`${digit}e${k}`));
  return splits.filter((x) => x >= min && x <= max);
}
const axis = (label, grid, log) => ({
  label, filter: labelled, ...(log ? { splits: logSplits } : {}), values: (_, splits) => splits.map(number), stroke: () => colour("ink"), font: "13px system-ui", labelFont: "13px system-ui", labelSize: 22,
  grid: { show: grid ?? true, filter: fewer, stroke: () => colour("line"), width: 1 }, ticks: { stroke: () => colour("line") },
});
export const scale = (log, range) => ({ time: false, distr: log ? 3 : 1, range: range ?? ((_, low, high) => [low, high]) });
/** Returns a line: its label, the name of its colour, and other options of uPlot. */
export const line = (label, name, more = {}) => ({ label, stroke: () => colour(name), width: 2, points: { show: false }, ...more });

/** A plot in a host element: created again if its kind changes, otherwise updated. */
export class Plot {
  constructor(host, { height = HEIGHT, ...more } = {}) {
    Object.assign(this, { host, height, more });
    new ResizeObserver(() => this.plot?.setSize(this.size())).observe(host);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.plot?.redraw());
  }
  size() {
    return { width: Math.max(200, this.host.clientWidth), height: this.height };
  }

  /** what: { key, x, y, series, scales, hooks }; key: equal if only the data differs. */
  show(what, data) {
    if (this.key !== what.key) {
      this.plot?.destroy();
      this.key = what.key;
      this.plot = new uPlot({
        ...this.size(), ...this.more, scales: what.scales, axes: [axis(what.x, what.grid, what.scales.x.distr === 3), { ...axis(what.y, what.grid, what.scales.y.distr === 3), size: 70 }],
        series: [{ label: what.x, value: this.value }, ...what.series.map((one) => ({ value: this.value, ...one }))],
        hooks: what.hooks ?? {}, cursor: { drag: { x: false, y: false }, ...what.cursor }, legend: { live: what.live ?? true, show: what.legend ?? true },
      }, data, this.host);
    } else this.plot.setData(data);
    return this.plot;
  }
  value(_, x) {
    return x === null || x === undefined ? "–" : String(Number(x.toPrecision(5)));
  }
}

/** Draws vertical dashed marks at values of x, behind the lines. */
export function drawMarks(u, places, name = "soft") {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.strokeStyle = colour(name);
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
  ctx.beginPath();
  for (const place of places) {
    const x = u.valToPos(place, "x", true);
    if (!(x >= bbox.left && x <= bbox.left + bbox.width)) continue;
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
  }
  ctx.stroke();
  ctx.restore();
}

/** Draws a disc at a point. */
export function drawPoint(u, x, y, name = "accent") {
  const { ctx, bbox } = u, left = u.valToPos(x, "x", true), top = u.valToPos(y, "y", true);
  if (!(left >= bbox.left && left <= bbox.left + bbox.width && top >= bbox.top && top <= bbox.top + bbox.height)) return;
  ctx.save();
  ctx.beginPath();
  ctx.arc(left, top, 6 * devicePixelRatio, 0, 2 * Math.PI);
  ctx.fillStyle = colour(name);
  ctx.strokeStyle = colour("paper");
  ctx.lineWidth = 2 * devicePixelRatio;
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}
