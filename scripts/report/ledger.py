"""What was found, and the ledger of claims."""
import re

import found
import markup
import tables
from markup import element, order, paragraph, sortable, text, verdict

SCOPES = {
    "paper": "under the paper’s conditions",
    "outside": "outside of them",
    "corrected": "formulas in place of refuted ones",
}
COLUMNS = {
    "verdict": "verdict",
    "claim": "claim",
    "equation": "where",
    "quantity": "quantity",
    "gait": "gait",
    "claimed_order": "claimed order",
    "derived_order": "proven order",
    "order": "measured order",
    "coefficient": "coefficient",
    "corrected": "holds instead",
    "conditions": "conditions",
    "measured": "measured",
    "reason": "reason or command",
    "scope": "belongs to",
}
EXCHANGED = {"contraction": "with the bodies exchanged", "mirrored": "exchanged and seen in a mirror"}


def breakable(name):
    return text(name).replace("_", "_<wbr>").replace(":", ":<wbr>")


def filtered(content, **filters):
    """A link to the ledger that shows only some of its rows: verdict, scope, search."""
    return element("a", content, href="#ledger", **{f"data_{key}": given for key, given in filters.items()})


def pasted(command):
    """A command of the ledger as it is typed in the checkout."""
    return re.sub(r"(^|\| )scallop ", r"\1build/scallop ", command)


def place(equation):
    return text(equation) if equation.startswith("(") else f"section {text(equation)}"


def share_bar(counts):
    """How a number of claims divides, as a bar; the numbers beside it say the same."""
    total, x, parts = sum(counts.values()), 0.0, []
    for name, count in counts.items():
        width = 100 * count / total
        if count:
            parts.append(f'<rect class="{name}" x="{x:.3f}" y="0" width="{max(width - 0.4, 0.1):.3f}" height="4"/>')
        x += width
    return (
        f'<svg class="share" viewBox="0 0 100 4" preserveAspectRatio="none" aria-hidden="true">{"".join(parts)}</svg>\n'
    )


def tally(counts):
    words = {
        "holds": "hold as printed",
        "sharper": "hold, with an error that falls faster than claimed",
        "refuted": "are refuted",
        "undecided": "are undecided",
    }
    items = (
        element("li", filtered(element("b", count) + " " + words[name], verdict=name, scope="paper"), class_=name)
        for name, count in counts.items()
    )
    return element("ul", "".join(items), class_="tally") + "\n"


def by_gait(ledger):
    """How many formulas hold for each gait, in a sentence."""
    formulas = found.grouped([row for row in found.chosen(ledger, "paper") if found.is_formula(row)], "gait")
    parts = []
    for (gait,), rows in sorted(formulas.items()):
        counts = found.counts(rows)
        parts.append(f"{counts['holds'] + counts['sharper']} of {len(rows)} formulas hold for the {text(gait)} gait")
    return ", ".join(parts) + "." if parts else ""


def summary_table(ledger):
    columns = ["claims", *markup.VERDICTS]
    cells = [
        {
            "claims": text(label),
            **{
                name: filtered(count, verdict=name, scope=scope) if label.startswith("All") else str(count)
                for name, count in counts.items()
            },
        }
        for label, counts, scope in found.summary(ledger)
    ]
    return sortable("counts", "Claims by verdict", columns, cells, numbers=set(markup.VERDICTS))


def steady_table(ledger):
    """The paper's result, equations (26) to (28), under its conditions."""
    columns = {
        "equation": "equation",
        "quantity": "quantity",
        "gait": "gait",
        "claimed_order": "claimed error",
        "derived_order": "proven error",
        "verdict": "verdict",
    }
    rows = [
        row
        for row in found.chosen(ledger, "paper")
        if found.is_formula(row) and row["claim"].startswith("text_steady_")
    ]
    quantities = {"v_start": "velocity at the start of a period", "displacement": "displacement in a period"}
    cells = [
        {
            **{name: text(row[name]) for name in columns},
            "quantity": text(quantities.get(row["quantity"], row["quantity"])),
            "claimed_order": order(row["claimed_order"]),
            "derived_order": order(row["derived_order"]),
            "verdict": verdict(row["verdict"]),
        }
        for row in rows
    ]
    return sortable("steady", "The steady state: the error as claimed and as proven", list(columns), cells, columns)


def instead(corrected, texts, warn):
    """The formula that holds: its name, a link to its rows, and its text."""
    name, *changes = corrected.split(":")
    link = filtered(element("code", breakable(corrected)), scope="corrected", search=corrected)
    words = "; ".join(EXCHANGED.get(change, change) for change in changes)
    if name not in texts:
        warn(f"no text of the formula {name}")
        return link
    return markup.code_spans(texts[name][1]) + f'<br><span class="note">{link}{", " + words if words else ""}</span>'


def refuted_formulas(ledger, texts, warn):
    rows = [row for row in found.chosen(ledger, "paper", verdict="refuted") if found.is_formula(row)]
    keys = ("equation", "quantity", "claimed_order", "derived_order", "corrected", "claim")
    columns = {
        "equation": "equation",
        "quantity": "quantity",
        "gait": "gait",
        "claimed_order": "claimed error",
        "derived_order": "proven error",
        "corrected": "holds instead",
    }
    cells = []
    for (equation, quantity, claimed, derived, corrected, _), group in found.grouped(rows, *keys).items():
        cells.append(
            {
                "equation": text(equation),
                "quantity": text(quantity),
                "gait": text(", ".join(row["gait"] for row in group)),
                "claimed_order": order(claimed),
                "derived_order": order(derived),
                "corrected": instead(corrected, texts, warn),
            }
        )
    return sortable(
        "refuted-formulas",
        "Refuted formulas, under the paper’s conditions",
        list(columns),
        cells,
        columns,
        wide=("reads",),
    )


def case(row):
    """One case in which a statement fails: where, what was measured, and the command that shows it."""
    shown = re.match(r"(?:(.*?): )?((?:printf|scallop) .*)", row["reason"])
    said = row["reason"] if row["reason"] != "-" and not shown else shown and shown[1]
    words = element("dt", f"<b>{text(row['gait'])} gait</b>: {text(row['conditions'])}") + element(
        "dd", text(row["measured"]) + (f" ({text(said)})" if said else "")
    )
    return words + (
        element("dd", element("pre", element("code", text(pasted(shown[2]))), class_="command")) if shown else ""
    )


def refuted_statements(ledger):
    inside = [row for row in found.chosen(ledger, "paper") if not found.is_formula(row)]
    shown = []
    for (claim, equation), group in found.grouped(inside, "claim", "equation").items():
        refuted = [row for row in group if row["verdict"] == "refuted"]
        if refuted:
            name = element("b", text(claim.replace("_", " ").replace("v start", "v_start")))
            summary = (
                f'{name} <span class="note">{place(equation)}; cases refuted: {len(refuted)} of {len(group)}</span>'
            )
            shown.append(
                element("details", element("summary", summary) + element("dl", "".join(map(case, refuted)))) + "\n"
            )
    return "".join(shown)


def cells_of(row):
    cells = {name: text(row[name]) for name in COLUMNS if name in row}
    cells["verdict"] = verdict(row["verdict"])
    cells["claim"] = element("code", breakable(row["claim"]))
    cells["scope"] = SCOPES[found.scope(row)]
    if row["corrected"] != "-":
        cells["corrected"] = filtered(element("code", breakable(row["corrected"])), search=row["corrected"])
    if re.search(r"(printf|scallop) ", row["reason"]):
        cells["reason"] = element("code", text(pasted(row["reason"])))
    return cells


def controls(ledger):
    counted = found.counts(ledger.rows)
    boxes = "".join(
        element(
            "label", f'<input type="checkbox" name="verdict" value="{name}" checked> {verdict(name)} {counted[name]}'
        )
        for name in markup.VERDICTS
    )
    options = "".join(element("option", text(label), value=name) for name, label in {"": "all rows", **SCOPES}.items())
    return (
        element(
            "div",
            element("fieldset", element("legend", "Verdict") + boxes)
            + element("label", f"Rows {element('select', options, name='scope')}")
            + element(
                "label",
                'Containing <input type="search" name="search" placeholder="(28), sinusoidal, T^3 …" size="24">',
            )
            + element("output", f"{len(ledger)} of {len(ledger)} rows", aria_live="polite"),
            class_="controls",
            id="ledger-controls",
        )
        + "\n"
    )


def table(ledger):
    columns = list(COLUMNS)
    numbers = {
        name for name in columns if name in ledger.columns and tables.numeric([row[name] for row in ledger.rows])
    }
    attributes = [{"data_verdict": row["verdict"], "data_scope": found.scope(row)} for row in ledger.rows]
    return sortable(
        "ledger-table",
        f"The ledger, {len(ledger)} rows",
        columns,
        [cells_of(row) for row in ledger.rows],
        COLUMNS,
        numbers,
        attributes,
        wide=("ledger",),
    )


def legend(ledger):
    said = ledger.comment("parameters")
    return paragraph(
        "A formula’s verdict is a proof: <i>proven order</i> is the first power of <i>T</i> that the formula leaves out"
        " of the derived expansion, and <i>coefficient</i> stands there, exact or as a ball that does not hold 0;"
        " <i>none</i>: no power below <i>T</i><sup>48</sup> is left out. <i>Measured order</i> is fitted to certified"
        " errors down to <i>T</i> = 10<sup>−20</sup>. Statements in words have the figure that decides them under"
        " <i>measured</i>, and a command that shows where one fails. "
        + (
            f"Where nothing else is said the crawler has {text(said.replace(' ', ', ').replace('=', ' = '))}."
            if said
            else ""
        )
    ) + paragraph(
        "Columns of the file that are not in this table: "
        + ", ".join(element("code", text(name)) for name in ledger.columns if name not in COLUMNS)
        + ". The last two are put together under <i>belongs to</i>.",
        class_="note",
    )
