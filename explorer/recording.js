// A measured gait: its samples, and l and l' of the curve through them.
import { Plot, line, scale } from "./plots.js";

const PLACES = 600;

export class Recording {
  constructor(core, section, hosts, note) {
    Object.assign(this, { core, section, note, plots: hosts.map((host) => new Plot(host, { height: 200 })) });
  }

  /** Shows the chosen gait, identified by name; hides the view if the gait is not measured. */
  show(name) {
    const recording = name && this.core.recording(PLACES);
    this.section.hidden = !recording;
    if (!recording || name === this.shown) return;
    this.shown = name;
    const { samples: [t, l], curve: [at, length, velocity], text } = recording;
    const all = [...t, ...at].map((x, i) => ({ x, sample: l[i] ?? null, length: i < t.length ? null : length[i - t.length] })).sort((a, b) => a.x - b.x);
    const dots = line("rows", "friction", { width: 0, points: { show: true, size: 5 } }), ends = { x: scale(false), y: scale(false) };
    const [lengths, velocities] = this.plots;
    lengths.show({ key: name, x: "t", y: "l", series: [dots, line("curve", "accent", { spanGaps: true })], scales: ends }, [all.map(({ x }) => x), all.map(({ sample }) => sample), all.map(({ length: y }) => y)]);
    velocities.show({ key: name, x: "t", y: "l'", series: [line("l'", "accent")], scales: ends }, [[...at], [...velocity]]);
    this.note.textContent = `${text}.`;
  }
}
