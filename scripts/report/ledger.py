"""The ledger as the page shows it: claims with their formulas, and the rows that decide them."""
import re

SCOPES = {
    "paper": "under the paper’s conditions",
    "outside": "outside of them",
    "corrected": "formulas in place of refuted ones",
}
VERDICTS = {
    "holds": "hold as printed",
    "sharper": "hold, with an error that falls faster than claimed",
    "refuted": "are refuted",
    "undecided": "are undecided",
}


def scope(row):
    if row["source"] == "corrected":
        return "corrected"
    return "paper" if row["inside"] == "yes" else "outside"


def is_formula(row):
    """A formula with a remainder, whose order is proven; the other claims are statements in words."""
    return row["derived_order"] != "-"


def place(row):
    return row["equation"] if row["equation"].startswith("(") else f"section {row['equation']}"


def reason(row):
    """What is said of a row, and the command to paste that shows it, "" where there is none."""
    found = re.fullmatch(r"(.*?)(?:(?:^|: )((?:printf|scallop) .*))?", row["reason"])
    said, command = (found[1] if found[1] != "-" else ""), found[2] or ""
    return said, re.sub(r"(^|\| )scallop ", r"\1build/scallop ", command)


def claims(rows, formulas):
    """Rows of one name and place together: (the first, the formula or None, rows), in the order in which they first appear."""
    groups = {}
    for row in rows:
        groups.setdefault((row["claim"], row["equation"]), []).append(row)
    for (name, _), group in groups.items():
        formula = formulas.get(name.split(":")[0])
        yield group[0], formula and formula["text"], group


def counts(rows):
    return {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS}


def holding(rows, gait):
    """How many formulas hold for a gait, and of how many."""
    found = [row["verdict"] for row in rows if is_formula(row) and row["gait"] == gait]
    return sum(verdict in ("holds", "sharper") for verdict in found), len(found)
