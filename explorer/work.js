// Long work: generators that yield the completed fraction run in slices, and the page responds in between.
const SLICE = 30, PART = 5; // milliseconds of a slice, and of a part of a loop
const QUICK = 8, PATIENCE = 150, VISIBLE = 300; // of work that starts at once, until other work begins, and until its progress is shown

/** Runs a generator to its end, and returns its result. */
export function finished(steps) {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/** Calls action(from, to) over all of 0, ..., count - 1, as many at a time as a part allows. */
export function* inParts(count, action) {
  for (let from = 0, size = 1; from < count;) {
    const begun = performance.now(), to = Math.min(count, from + size);
    action(from, to);
    size = performance.now() - begun < PART / 2 ? 2 * size : Math.max(1, size >> 1);
    from = to;
    yield from / count;
  }
}

/** Yields the progress of steps as a share of the whole, from a fraction on. */
export function* within(from, share, steps) {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
    yield from + share * (value ?? 0);
  }
}

export class Work {
  /** order: names of jobs. show({ what, part, left, stopped }): the current job, its progress, and the remaining jobs; null: idle.
   * failed(error): a job failed. */
  constructor(order, show, failed) {
    Object.assign(this, { order, show, failed, jobs: [], costs: {}, stopped: false, began: 0 });
  }

  /** Replaces the job of this name, which stops at once. what: words for it; key: identifies its cost. */
  put(name, what, key, steps) {
    this.drop(name);
    if (this.jobs.length === 0) this.began = performance.now();
    this.jobs.push({ name, what, key: `${name} ${key}`, steps, part: 0, took: 0 });
    this.jobs.sort((a, b) => this.order.indexOf(a.name) - this.order.indexOf(b.name));
    this.stopped = false;
  }
  drop(name) {
    this.jobs = this.jobs.filter((job) => job.name !== name);
  }
  clear() {
    this.jobs = [];
    this.go();
  }
  has(name) {
    return this.jobs.some((job) => job.name === name);
  }

  /** Continues: at once with jobs that were always short, with the others after a pause without changes. */
  go() {
    this.slice(this.jobs.filter(({ key }) => (this.costs[key] ?? 0) < QUICK), PATIENCE);
  }

  slice(jobs = [...this.jobs], pause = 0) {
    clearTimeout(this.later);
    const until = performance.now() + SLICE;
    for (const job of jobs) while (!this.stopped && this.jobs.includes(job) && performance.now() < until) this.step(job);
    if (this.jobs.length > 0 && !this.stopped) this.later = setTimeout(() => this.slice(), pause);
    this.tell();
  }

  step(job) {
    const begun = performance.now();
    let done = true;
    try {
      const step = job.steps.next();
      done = step.done;
      job.part = step.value ?? job.part;
    } catch (error) {
      this.failed(error);
    }
    job.took += performance.now() - begun;
    this.costs[job.key] = done ? job.took : Math.max(job.took, this.costs[job.key] ?? 0);
    if (done) this.jobs = this.jobs.filter((other) => other !== job);
  }

  stop() {
    clearTimeout(this.later);
    this.stopped = this.jobs.length > 0;
    this.tell();
  }
  goOn() {
    this.stopped = false;
    this.slice();
  }

  tell() {
    const [job, ...left] = this.jobs, soon = performance.now() - this.began < VISIBLE;
    this.show(job && (this.stopped || !soon) ? { what: job.what, part: job.part, left: left.map(({ what }) => what), stopped: this.stopped } : null);
  }
}
