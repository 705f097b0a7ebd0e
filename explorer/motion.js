// The displayed motion: samples and modes of some periods, from the core, at any time.
const SAMPLES = 240; // of a period
const MOST_PERIODS = 60;

export class Motion {
  /** crawler: numbers; start: "steady", "rest" or "velocity" */
  constructor(core, crawler, { start, v0, periods }) {
    this.crawler = crawler;
    this.steady = core.steady();
    this.endless = start === "steady";
    this.periods = this.endless ? 1 : Math.min(Math.max(1, periods), MOST_PERIODS);
    this.v0 = this.endless ? this.steady.v_start : start === "rest" ? 0 : v0;
    this.first = core.period(this.v0);
    this.walk = core.walk(this.v0, this.periods);
    this.asked = this.periods;
    if (this.walk.count === core.most) this.periods = Math.max(1, Math.floor(this.walk.end.at(-1) / crawler.T)); // the core stores no more modes
    this.samples = core.trajectory(this.v0, this.periods, SAMPLES);
    this.duration = this.periods * crawler.T;
    this.fastest = [this.samples.v1, this.samples.v2].reduce((most, row) => row.reduce((a, v) => Math.max(a, Math.abs(v)), most), 0) || 1;
  }

  /** Returns all quantities at a time: any time for the steady state, else within the duration. */
  at(time) {
    const { crawler, samples, walk } = this, { T, m1, m2 } = crawler;
    const rounds = this.endless ? Math.floor(time / this.duration) : 0;
    const t = Math.min(Math.max(time - rounds * this.duration, 0), this.duration), shift = rounds * this.steady.displacement;
    const place = (t / T) * SAMPLES, i = Math.min(Math.floor(place), samples.count - 2), part = place - i;
    const between = (row) => row[i] + part * (row[i + 1] - row[i]);
    let k = this.last ?? 0;
    if (!(walk.begin[k] <= t)) k = 0;
    while (k + 1 < walk.count && walk.end[k] <= t) k++;
    this.last = k;
    const s1 = walk.s1[k] ?? 0, s2 = walk.s2[k] ?? 0, v1 = s1 === 0 ? 0 : between(samples.v1), v2 = s2 === 0 ? 0 : between(samples.v2);
    const period = Math.min(Math.floor(t / T), this.periods - 1);
    const from = samples.xC[period * SAMPLES], to = samples.xC[(period + 1) * SAMPLES];
    return {
      time, t, s1, s2, v1, v2, x1: between(samples.x1) + shift, x2: between(samples.x2) + shift, xC: between(samples.xC) + shift,
      c: (m1 * between(samples.v1) + m2 * between(samples.v2)) / (m1 + m2), l: between(samples.l),
      followed: from + (to - from) * (t / T - period) + shift, friction: this.friction(k, i), extends: (t / T) % 1 < crawler.alpha,
    };
  }

  /** Returns friction forces in interval k near sample i: -F s of a sliding body; of a stuck body m l'' + F s of the other. */
  friction(k, i) {
    const { m1, m2, F1, F2, T } = this.crawler, { v1, v2 } = this.samples, s1 = this.walk.s1[k], s2 = this.walk.s2[k];
    const rate = (v) => ((v[i + 1] - v[i]) * SAMPLES) / T, within = (F, force) => Math.min(Math.max(force, -F), F);
    if (s1 === 0 && s2 === 0) return [0, 0];
    return [s1 === 0 ? within(F1, m2 * rate(v2) + F2 * s2) : -F1 * s1, s2 === 0 ? within(F2, m1 * rate(v1) + F1 * s1) : -F2 * s2];
  }

  /** Returns line and curves of the plane over period n: times in T, c, (m2/M) l', -(m1/M) l'. */
  plane(n) {
    const { m1, m2, T } = this.crawler, M = m1 + m2, { samples } = this, rows = [[], [], [], []];
    for (let i = n * SAMPLES; i <= (n + 1) * SAMPLES; i++) {
      const speed = samples.v2[i] - samples.v1[i];
      rows[0].push(samples.t[i] / T);
      rows[1].push((m1 * samples.v1[i] + m2 * samples.v2[i]) / M);
      rows[2].push((m2 / M) * speed);
      rows[3].push(-(m1 / M) * speed);
    }
    return rows;
  }
}
