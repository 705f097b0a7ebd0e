"""The table of claims as the page shows it: claims with their formulas, and the rows that decide them."""
import re

SCOPES = {
    "paper": "formulas under the paper’s conditions",
    "words": "statements in words under them",
    "outside": "both outside of them",
    "corrected": "formulas in place of refuted ones",
}
EVIDENCE = ("proven", "certified", "sampled", "measured")  # from the strongest on
VERDICTS = {
    "holds": "hold as printed",
    "sharper": "hold, with an error that falls faster than claimed",
    "refuted": "are refuted",
    "undecided": "are undecided",
}


def scope(row):
    if row["source"] == "corrected":
        return "corrected"
    if row["paper_conditions"] != "yes":
        return "outside"
    return "paper" if is_formula(row) else "words"


def is_formula(row):
    """A formula, of which a power of T is derived; the other claims are statements in words."""
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


def statements(rows):
    """Of the statements in words how many fail in a row, and how many hold in all of theirs, by the weakest evidence."""
    groups, failed, held = {}, 0, dict.fromkeys(EVIDENCE, 0)
    for row in rows:
        groups.setdefault(row["claim"], []).append(row)
    for group in groups.values():
        if any(row["verdict"] == "refuted" for row in group):
            failed += 1
        elif all(row["verdict"] == "holds" for row in group):
            held[max((row["evidence"].split(":")[0].split()[0] for row in group), key=EVIDENCE.index)] += 1
    return failed, held, len(groups)


def holding(rows, gait):
    """How many checks of formulas hold for a gait, and of how many."""
    found = [row["verdict"] for row in rows if is_formula(row) and row["gait"] == gait]
    return sum(verdict in ("holds", "sharper") for verdict in found), len(found)
