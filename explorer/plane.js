// The plane of time and c: one line and two curves, with the instant of the animation.
import { Plot, line, scale } from "./plots.js";

export class Plane {
  constructor(host) {
    this.plot = new Plot(host, { height: 280 });
    this.instant = Object.assign(document.createElement("div"), { className: "instant" });
  }

  show(motion, now) {
    const n = motion.endless ? 0 : Math.min(Math.floor(now.t / motion.crawler.T), motion.periods - 1);
    if (this.motion !== motion || this.period !== n) {
      Object.assign(this, { motion, period: n });
      const series = [line("c", "centre", { width: 3 }), line("(m2/M) l′", "body1"), line("−(m1/M) l′", "body2")];
      this.shown = this.plot.show({ key: "plane", x: "t/T", y: "velocity", series, scales: { x: scale(false), y: { auto: true } } }, motion.plane(n));
      this.shown.over.append(this.instant);
    }
    this.instant.style.left = `${this.shown.valToPos(now.t / motion.crawler.T, "x")}px`;
  }
}
