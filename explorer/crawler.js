// A drawing of the crawler: the bodies on the ground, the mechanism, velocities, friction, and the path of the centre.
const SPACE = "http://www.w3.org/2000/svg";
const GROUND = 175, TRACE = 340;

function make(parent, tag, attributes = {}, text) {
  const made = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}
const set = (node, attributes) => {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
};

/** Draws an arrow from x along the level y, `length` pixels to the right, unless it is short. */
function arrow(node, x, y, length) {
  const head = Math.min(9, Math.abs(length)) * Math.sign(length), half = 0.55 * Math.abs(head);
  node.setAttribute("d", Math.abs(length) < 1.5 ? "" : `M${x} ${y}h${length}m${-head} ${-half}l${head} ${half}l${-head} ${half}`);
}

export class Drawing {
  constructor(svg) {
    this.svg = svg;
    make(svg, "title", {}, "The crawler");
    this.edges = [];
    new ResizeObserver(() => this.fit()).observe(svg);
    this.ground = make(svg, "path", { class: "ground" });
    this.marks = make(svg, "path", { class: "marks" });
    this.labels = Array.from({ length: 16 }, () => make(svg, "text", { class: "place", y: GROUND + 22, "text-anchor": "middle" }));
    this.traces = ["trace1", "trace2", "trace"].map((name) => make(svg, "path", { class: name }));
    this.mechanism = make(svg, "path", { class: "mechanism" });
    this.bodies = [1, 2].map((number) => this.body(number));
    this.centre = make(svg, "path", { class: "centre" });
    this.phase = make(svg, "text", { class: "phase", x: 12, y: 24 });
    this.edges = [["one period ago", TRACE - 2], ["now", GROUND + 40]].map(([text, y]) => make(svg, "text", { class: "axis", y, "text-anchor": "end" }, text));
    this.fit();
  }

  /** Fits the width of the page; texts keep their size. */
  fit() {
    this.width = Math.min(Math.max(this.svg.clientWidth, 330), 900);
    set(this.svg, { viewBox: `0 0 ${this.width} 360` });
    this.edges.forEach((edge) => set(edge, { x: this.width - 8 }));
    if (this.shown) this.show(...this.shown);
  }

  body(number) {
    const group = make(this.svg, "g", { class: `body body${number}` });
    return {
      group, box: make(group, "rect", { rx: 6 }), name: make(group, "text", { "text-anchor": "middle" }, String(number)),
      state: make(group, "text", { class: "state", "text-anchor": "middle" }),
      velocity: make(group, "path", { class: "velocity" }), friction: make(group, "path", { class: "friction" }),
    };
  }

  /** Shows a motion at a time. */
  show(motion, time) {
    this.shown = [motion, time];
    const { width } = this;
    const { crawler } = motion, now = motion.at(time), { L } = crawler;
    const scale = (width * 0.3) / L, middle = (x) => (x - now.followed) * scale + width / 2;
    const mass = Math.max(crawler.m1, crawler.m2), force = Math.max(crawler.F1, crawler.F2);
    const speed = (0.13 * width) / motion.fastest;
    // The separation is l plus a distance at l = 0 that is not part of the model.
    const apart = 34; // pixels
    const sides = [
      { x: middle(now.x1) - apart, m: crawler.m1, s: now.s1, v: now.v1, f: now.friction[0] },
      { x: middle(now.x2) + apart, m: crawler.m2, s: now.s2, v: now.v2, f: now.friction[1] },
    ];
    sides.forEach((side, i) => this.showBody(this.bodies[i], side, { mass, force, speed }));
    this.showMechanism(sides[0], sides[1]);
    this.showGround(now, scale, middle);
    this.showTraces(motion, now, middle);
    set(this.centre, { d: `M${middle(now.xC)} ${GROUND + 32}l-6 11h12z` });
    this.phase.textContent = now.extends ? "extension" : "contraction";
    return now;
  }

  showBody(drawn, { x, m, s, v, f }, { mass, force, speed }) {
    const size = 22 + 26 * Math.cbrt(m / mass), y = GROUND - size;
    drawn.half = size / 2;
    set(drawn.box, { x: x - size / 2, y, width: size, height: size });
    set(drawn.name, { x, y: y + size / 2 + 6 });
    set(drawn.state, { x, y: 62 });
    drawn.state.textContent = s === 0 ? "sticks" : s > 0 ? "forward" : "back";
    drawn.group.classList.toggle("stuck", s === 0);
    arrow(drawn.velocity, x, 80, v * speed);
    arrow(drawn.friction, x, GROUND + 8, (70 * f) / force);
  }

  showMechanism(left, right) {
    const from = left.x + this.bodies[0].half, to = right.x - this.bodies[1].half, y = GROUND - 16, links = 6;
    const width = (to - from) / links, height = Math.sqrt(Math.max(36, 900 - (width * width) / 4));
    let d = `M${from} ${y}`;
    for (let i = 1; i <= links; i++) d += `L${from + i * width} ${i === links ? y : i % 2 ? y - height / 2 : y + Math.min(12, height / 2)}`;
    set(this.mechanism, { d });
  }

  showGround(now, scale, middle) {
    const { width } = this, range = width / scale, step = 10 ** Math.floor(Math.log10(50 / scale));
    const each = [1, 2, 5, 10].map((k) => k * step).find((one) => one * scale >= 50);
    const first = Math.ceil((now.followed - range / 2) / each);
    let marks = "";
    this.labels.forEach((label, i) => {
      const value = (first + i) * each, x = middle(value), inside = x > 20 && x < width - 20;
      if (x <= width) marks += `M${x} ${GROUND}v8`;
      set(label, { x });
      label.textContent = inside ? String(Number(value.toPrecision(6))) : "";
    });
    set(this.ground, { d: `M0 ${GROUND}H${width}` });
    set(this.marks, { d: marks });
  }

  /** Draws the paths of the bodies and the centre in the last period, downwards. */
  showTraces(motion, now, middle) {
    const count = 120, { T } = motion.crawler, lines = ["", "", ""];
    const time = now.time;
    for (let i = 0; i <= count; i++) {
      const before = time - (i / count) * T;
      if (!motion.endless && before < 0) break;
      const then = motion.at(before), y = GROUND + 45 + (i / count) * (TRACE - GROUND - 50);
      [then.x1, then.x2, then.xC].forEach((x, k) => {
        const shown = middle(x) + (k === 0 ? -34 : k === 1 ? 34 : 0);
        lines[k] += `${i === 0 ? "M" : "L"}${shown.toFixed(1)} ${y.toFixed(1)}`;
      });
    }
    lines.forEach((d, k) => set(this.traces[k], { d }));
  }
}
