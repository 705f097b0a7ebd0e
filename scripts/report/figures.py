"""The figures of the page that gnuplot drew: what each is called, shows, and is drawn from."""
from dataclasses import dataclass

from drawing import Panel

LEFT, RIGHT = "0 0 450 380", "450 0 450 380"


@dataclass(frozen=True)
class Figure:
    """A plot of the page. name: of the plot and its identifier; tables: its sources; layout: see drawing.inline."""

    name: str
    title: str
    caption: str
    panels: list
    tables: list
    layout: str = ""


PAPER = [
    Figure(
        "figure2",
        "Figure 2. Positions from rest",
        (
            "With phases of equal duration (<i>α</i> = 1/2) the bodies settle into an oscillation in place; with an"
            " extension of three quarters of the period (<i>α</i> = 3/4) they crawl."
        ),
        [
            Panel(LEFT, "Positions over eight periods, alpha = 1/2: an oscillation"),
            Panel(RIGHT, "Positions over eight periods, alpha = 3/4: locomotion"),
        ],
        ["figure2"],
    ),
    Figure(
        "figure3",
        "Figure 3. One extension from rest",
        (
            "First the bodies are pushed apart and move in opposite directions; in the short interval at the end both"
            " move forward."
        ),
        [
            Panel(LEFT, "Positions of both bodies in one extension"),
            Panel(RIGHT, "Velocities of both bodies in one extension"),
        ],
        ["figure3"],
    ),
    Figure(
        "figure4",
        "Figure 4. What an extension adds to position and velocity",
        (
            "Over the duration of the extension, for three ratios of friction: exact (solid), up to where a body begins"
            " to stick, and the published series (21) and (18) (dashed)."
        ),
        [
            Panel(LEFT, "Change of position over the duration, exact and by series (21)"),
            Panel(RIGHT, "Change of velocity over the duration, exact and by series (18)"),
        ],
        ["figure4"],
    ),
    Figure(
        "figure5",
        "Figure 5. Mean velocity in the steady state",
        (
            "Over the share <i>α</i> of the period that the extension takes, and over the ratio of friction forces:"
            " exact (solid) and the published series (28) (dashed)."
        ),
        [
            Panel(LEFT, "Mean velocity over alpha, exact and by series (28)"),
            Panel(RIGHT, "Mean velocity over F1/F2, exact and by series (28)"),
        ],
        ["figure5"],
    ),
]
ERRORS = Figure(
    "errors",
    "Error of published series against <i>T</i>",
    (
        "Certified errors, under the paper’s conditions. Straight lines down to <i>T</i> = 10<sup>−20</sup>: their"
        " slope is the order of the error."
    ),
    [
        Panel(LEFT, "Error of five formulas for one extension against its duration"),
        Panel(RIGHT, "Error of the steady state, (27) and (28), against the period"),
    ],
    ["errors"],
)
WORKPREC = Figure(
    "workprec",
    "Error against run time",
    (
        "Each mark is one way to get the displacement of a steady state: how long it takes and how wrong it is. Left"
        " and low is good. The grey stairs are the Pareto front: what no other way beats in both. Filled marks and"
        " solid lines find the steady state as a root, open marks and dashed lines by simulating until it settles;"
        " crosses were cut off."
    ),
    [Panel("0 0 1200 900", "Error of the displacement against seconds, two gaits, three periods")],
    ["workprec"],
    "scrolls",
)
MAPS = [
    Figure(
        "map_regimes",
        "Regions of the same sequence of modes",
        (
            "Blue: both bodies always slide; yellow: one sticks for a part of the period; grey: one never moves. A"
            " sequence such as <code>++ -+ ++ | ++ +- ++</code> has the directions of body 1 and body 2, piece by"
            " piece; <code>0</code> is a body that is stuck, <code>|</code> stands between extension and contraction."
            " The expansions describe only the regions that reach to large Froude numbers. The curves are those of the"
            " tables; the colours come from finer grids, which <code>scripts/dev/maps.sh</code> computes."
        ),
        [
            Panel("0 0 625 820", "Regions over Froude number and alpha"),
            Panel("625 0 625 820", "Regions over F1/F2 and Froude number"),
        ],
        ["map_froude_alpha", "map_ratio_froude"],
        "scrolls column",
    ),
    Figure(
        "map_reach",
        "How far a series for the displacement can be trusted",
        (
            "The largest period up to which the relative error stays below 1 % (left) and 10<sup>−6</sup> (right), for"
            " the published formula (28) and for the derived series with all terms below <i>T</i><sup>8</sup>. Grey: as"
            " <i>T</i> tends to 0, the error tends to a limit above that, because the formula is wrong at leading order."
        ),
        [Panel("0 0 1100 900", "Reach of formula (28) and of the derived series over F1/F2 and alpha")],
        ["map_reach"],
        "scrolls",
    ),
    Figure(
        "map_velocity",
        "Mean velocity far beyond the paper’s range",
        (
            "It has its kink where the start velocity vanishes, falls to the onset of sticking, and has a second"
            " maximum in stick-slip before body 1 rests for good."
        ),
        [Panel("0 0 900 800", "Mean velocity over F1/F2 up to ten thousand, for three values of F2")],
        [f"map_{kind}_{F2}" for F2 in ("0.5", "1", "2") for kind in ("velocity", "changes")],
        "scrolls",
    ),
]
FIGURES = [*PAPER, ERRORS, WORKPREC, *MAPS]
NAMES = sorted({name for figure in FIGURES for name in figure.tables} | {"claims", "stress"})
