#!/usr/bin/python3
"""Figure 4 of the paper from Python: change of position and velocity of the centre over an extension from rest against
its duration T, for F1/F2 = 2, 10 and 40, exact up to where a body sticks, and by the series (21) and (18).

    python3 scripts/figure4.py --output figure4.svg

An example of crawling_scallop; the numbers are those of `scallop figure 4`. Needs gnuplot.
"""

import argparse
import os
import subprocess
import sys

import numpy

import crawling_scallop

RATIOS = numpy.array([2.0, 10.0, 40.0])
STEPS = 200
L = 10  # and m1 = m2 = 1, F2 = 1, quadratic
COLUMNS = ("F1_over_F2", "T", "dxC_over_L", "series_dxC_over_L", "dvC_T_over_L", "series_dvC_T_over_L")


def extension(ratios, durations):
    """The parameters of crawlers whose extensions have these durations: an extension is half of a symmetric period."""
    return dict(F1=ratios, T=2 * durations, L=L, alpha=0.5)


def slides(ratios, durations):
    return crawling_scallop.phase("extension", **extension(ratios, durations)).regime == "sliding"


def onset_of_sticking(ratios):
    """The longest extensions from rest in which no body sticks, by bisection to the last bit."""
    sliding, sticking = numpy.zeros_like(ratios), numpy.ones_like(ratios)
    while (longer := slides(ratios, sticking)).any():
        sticking[longer] *= 2
    while True:
        middle = sliding + (sticking - sliding) / 2
        if ((middle <= sliding) | (middle >= sticking)).all():
            return sliding
        inside = slides(ratios, middle)
        sliding, sticking = numpy.where(inside, middle, sliding), numpy.where(inside, sticking, middle)


def table():
    """The rows of the figure, one after the other: an array with the COLUMNS."""
    onset = onset_of_sticking(RATIOS)
    T = numpy.linspace(onset / STEPS, onset, STEPS, axis=1)
    ratios = numpy.broadcast_to(RATIOS[:, numpy.newaxis], T.shape)
    crawlers = extension(ratios, T)
    exact = crawling_scallop.phase("extension", **crawlers)
    columns = (ratios, T, exact.dxC / L, crawling_scallop.published("eq21_dxC", **crawlers) / L, exact.v_end * T / L,
               crawling_scallop.published("eq18_v_end", **crawlers) * T / L)
    return numpy.stack(columns, axis=-1).reshape(-1, len(COLUMNS))


def svg(rows):
    """The picture, drawn by gnuplot from what it is given through a pipe."""
    here = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
    data = "\n".join("\t".join(map(repr, row)) for row in rows.tolist())
    script = "\n".join(["$rows << END", "\t".join(COLUMNS), data, "END", "table = '$rows'", "output_file = '/dev/stdout'",
                        "kind = 'svg'", "load 'plots/common.gp'", "load 'plots/figure4.gp'"])
    return subprocess.run(["gnuplot"], input=script.encode(), stdout=subprocess.PIPE, cwd=here, check=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--output", metavar="FILE", required=True, help="the SVG file to write")
    output = parser.parse_args().output
    try:
        picture = svg(table())
    except FileNotFoundError:
        return fail(3, "gnuplot is not installed (Debian: gnuplot-nox)")
    except (OSError, subprocess.CalledProcessError) as error:  # no library, or gnuplot failed
        return fail(3, error)
    try:
        with open(output, "wb") as file:
            file.write(picture)
    except OSError as error:
        return fail(4, error)
    return 0


def fail(code, error):
    print(f"figure4.py: {error}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
