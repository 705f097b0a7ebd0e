#!/usr/bin/python3
"""How far the displacement is off that a recording gives, for each kind of curve through its rows: a table in which
`error` is relative to the exact displacement, `stated` is half of the stated interval, and fit is as in crawling_scallop.measured.

    python3 scripts/python/recordings.py [--noise 0.003] [--recordings 20] >recordings.tsv

Crawlers as in docs/reference/gaits.md: recordings of one period from a random start in it, without and with noise."""

import argparse
import sys

import numpy

import crawling_scallop

CRAWLER = dict(m1=0.8, m2=1.7, F1=2.2, F2=0.9)
SIZE = dict(L=3, T=0.5, alpha=0.6)
GAITS = ("quadratic", "sinusoidal", "minimum-jerk")
FITS = ("monotone", "cubic", "smooth", "phases", "chosen")


def lengths(gait, t):
    """l at times t, by the displacement of body 2 relative to body 1"""
    made, period = gait, SIZE["T"]
    motion = crawling_scallop.trajectory(samples=20000, gait=made, **CRAWLER, **SIZE)
    return numpy.interp(numpy.mod(t, period), motion.t, motion.l)


def errors(gait, rows, fit, noise, random):
    """Relative error of the displacement, and what is stated of it"""
    start = random.uniform(0, SIZE["T"])
    t = SIZE["T"] * numpy.arange(rows) / rows
    l = lengths(gait, t + start) + noise * SIZE["L"] * random.standard_normal(rows)
    answer = crawling_scallop.measured(t, l, fit=fit, period=SIZE["T"]).steady(**CRAWLER)
    true = crawling_scallop.steady(gait=gait, **CRAWLER, **SIZE).displacement
    value = answer.value.displacement
    return abs(value / true - 1), (answer.high["displacement"] - value) / abs(true)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--noise", type=float, default=0, help="standard deviation of l, in units of L")
    parser.add_argument("--recordings", type=int, default=20, help="the medians of so many")
    given = parser.parse_args()
    print("gait", "rows", "fit", "error", "stated", sep="\t")
    for gait in GAITS:
        for rows in (20, 50, 100, 200, 500, 1000):
            for fit in FITS:
                random = numpy.random.default_rng(rows)
                both = [errors(gait, rows, fit, given.noise, random) for _ in range(given.recordings)]
                print(gait, rows, fit, *(f"{x:.3g}" for x in numpy.nanmedian(both, axis=0)), sep="\t", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
