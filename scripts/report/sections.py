"""The sections of the page about figures and tables: what each shows, what made it, and the rows."""
import drawing
import figures
import found
import ledger
import markup
import stability
from markup import element, paragraph, text

TIMES = {
    "gait": "gait",
    "T": "T",
    "quantity": "quantity",
    "wanted_error": "wanted error",
    "method": "cheapest",
    "setting": "its setting",
    "rival_method": "cheapest general-purpose method",
    "rival_over_exact": "times as long as exact",
    "simulation_method": "cheapest simulation",
    "simulation_over_exact": "times as long as exact, simulated",
}


def made_by(names, inputs):
    """The commands to paste for some tables, the scenes they run, and the tables themselves."""
    commands, scenes = [], []
    for name in names:
        scene = inputs.scenes.get(name)
        if scene is not None:
            commands.append(f"build/scallop run data/scenes/{name}.cfg")
            listing = element("pre", text(scene), class_="scene", tabindex="0")
            scenes.append(
                element("details", element("summary", f"Scene <code>data/scenes/{text(name)}.cfg</code>") + listing)
                + "\n"
            )
        else:
            commands.append(f"build/scallop {inputs.tables[name].comment('command')}")
    shown = element("pre", element("code", text("\n".join(dict.fromkeys(commands)))), class_="command", tabindex="0")
    return (
        element(
            "div",
            shown + "\n" + "".join(scenes) + "".join(markup.long_table(inputs.tables[name]) for name in names),
            class_="made-by",
        )
        + "\n"
    )


def figure(item, inputs):
    picture = drawing.inline(inputs.plots / f"{item.name}.svg", item.name, item.panels, item.layout)
    caption = element("figcaption", f"<b>{item.title}.</b> {item.caption}")
    return element("figure", picture + "\n" + caption, id=item.name) + "\n" + made_by(item.tables, inputs)


def section(identifier, title, content):
    return element("section", element("h2", title) + "\n" + content, id=identifier) + "\n"


def what_was_found(inputs):
    claims = inputs.tables["claims"]
    counts = found.counts(found.chosen(claims, "paper"))
    total = sum(counts.values())
    lead = (
        f"Taken one by one, for both gaits, the formulas and checkable statements of the paper make {total} claims"
        " under the conditions that it states. Of these"
    )
    return section(
        "found",
        "What was found",
        (
            paragraph(lead)
            + ledger.tally(counts)
            + ledger.share_bar(counts)
            + paragraph(
                "A formula <i>holds</i> if its error falls with <i>T</i> as fast as the paper says, is <i>sharper</i>"
                " if it falls faster, and is <i>refuted</i> if it falls more slowly or not at all. A statement in words"
                " holds or is refuted. So "
                + ledger.by_gait(claims)
            )
            + ledger.summary_table(claims)
            + "<h3>The steady state, equations (26) to (28)</h3>\n"
            + ledger.steady_table(claims)
            + "<h3>Formulas that are refuted, and what holds instead</h3>\n"
            + paragraph(
                "For an extension of duration <i>T</i> that begins with velocity <code>x0'</code>: <code>l0/T^2</code>,"
                " <code>lT/T^2</code> are the second and <code>k0/T^4</code>, <code>kT/T^4</code> the fourth"
                " derivatives of the separation at its start and end, <code>M = m1 + m2</code>, and <code>m* = m1"
                " m2/M</code>. A contraction is an extension with the bodies exchanged. <code>docs/errata.md</code> and"
                " <code>docs/theory.md</code> have the rest."
            )
            + ledger.refuted_formulas(claims, inputs.formulas, inputs.warn)
            + "<h3>Statements that are refuted</h3>\n"
            + paragraph("Each opens to the cases in which it fails, with a command that shows it.")
            + ledger.refuted_statements(claims)
        ),
    )


def of_the_paper(inputs):
    return section("figures", "The figures of the paper", "".join(figure(item, inputs) for item in figures.PAPER))


def the_ledger(inputs):
    claims = inputs.tables["claims"]
    return section(
        "ledger",
        "The ledger",
        ledger.legend(claims) + ledger.controls(claims) + ledger.table(claims) + made_by(["claims"], inputs),
    )


def against_period(inputs):
    drawn = {
        (row["claim"], row["gait"], row["conditions"]) for row in inputs.tables["errors"].rows if row["inside"] == "yes"
    }
    rows = [row for row in inputs.tables["claims"].rows if (row["claim"], row["gait"], row["conditions"]) in drawn]
    columns = {
        "equation": "equation",
        "claim": "claim",
        "conditions": "conditions",
        "claimed_order": "claimed order",
        "derived_order": "proven order",
        "order": "measured order",
        "verdict": "verdict",
    }
    cells = [
        {
            **{name: text(row[name]) for name in columns},
            "verdict": markup.verdict(row["verdict"]),
            "claim": element("code", ledger.breakable(row["claim"])),
        }
        for row in rows
    ]
    slopes = markup.sortable(
        "slopes",
        "Slopes: the order of each error in the table, quadratic gait",
        list(columns),
        cells,
        columns,
        {"claimed_order", "derived_order", "order"},
    )
    return section("errors-section", "Error of the series against <i>T</i>", figure(figures.ERRORS, inputs) + slopes)


def against_time(inputs):
    content = figure(figures.WORKPREC, inputs)
    if inputs.cheapest:
        cells = [{name: text(row[name]) for name in TIMES} for row in inputs.cheapest.rows]
        content += paragraph(
            "Who is cheapest for a wanted error. Times are of one machine: only ratios within one run mean anything. "
            "<i>Exact</i> is the certified solver where less than 10<sup>−16</sup> is wanted; <code>nan</code>: no "
            "setting got there."
        )
        content += markup.sortable(
            "cheapest",
            f"Cheapest methods, {len(cells)} rows",
            list(TIMES),
            cells,
            TIMES,
            {name for name in TIMES if name in markup.number_columns(inputs.cheapest)},
        )
        content += element(
            "pre", element("code", "awk -f scripts/plots/cheapest.awk data/workprec.tsv"), class_="command", tabindex="0"
        )
    return section("time", "Error against run time", content)


def steadiness(inputs):
    stress = inputs.tables["stress"]
    error, rounding, perturbed = found.promises(stress)
    cases = sum(int(row["cases"]) for row in stress.rows)
    failed = sum(row["verdict"] != "holds" for row in stress.rows)
    kept = "Every promise held." if failed == 0 else f"Promises were broken in {failed} rows of the table."
    caption = (
        "<b>Largest error of each family of cases.</b> A unit is an ulp times the condition number: what the last place"
        " of the parameters themselves leaves undecided."
    )
    return section(
        "stability",
        "Stability",
        (
            paragraph(
                f"The solver in double precision against the certified one, in {cases:,} cases of"
                f" {len(found.grouped(stress.rows, 'family'))} families that are meant to break it. {kept} The largest"
                f" error is {found.largest(stress, 'units'):g} units of {error:g} promised; the largest spread over the"
                f" four rounding modes {found.largest(stress, 'rounding'):g} of {rounding:g}; over parameters an ulp"
                f" apart {found.largest(stress, 'perturbed'):g} of {perturbed:g}.".replace(",", " ")
            )
            + element("figure", stability.dots(stress) + element("figcaption", caption), id="stress")
            + "\n"
            + made_by(["stress"], inputs)
        ),
    )


def breakdown(inputs):
    lead = paragraph(
        "A series in <i>T</i> fails where its error passes what is wanted, and for good where the motion becomes"
        ' another: a body turns elsewhere, or sticks. The Froude number <span class="formula"><i>M'
        " L</i>/(<i>T</i><sup>2</sup> (<i>F</i><sub>1</sub> + <i>F</i><sub>2</sub>))</span> is large where <i>T</i> is"
        " small."
    )
    return section(
        "breakdown", "Where the expansion breaks down", lead + "".join(figure(item, inputs) for item in figures.MAPS)
    )


SECTIONS = [
    ("found", "What was found", what_was_found),
    ("figures", "The figures of the paper", of_the_paper),
    ("ledger", "The ledger", the_ledger),
    ("errors-section", "Error against T", against_period),
    ("time", "Error against run time", against_time),
    ("stability", "Stability", steadiness),
    ("breakdown", "Breakdown", breakdown),
]
