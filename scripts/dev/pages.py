#!/usr/bin/python3
"""Parts of the pages that follow from data/claims.tsv, data/stress.tsv and asymptotics/published/paper.cfg: the counts of evidence.md,
the tables of errata.md, the families of stability.md; and the quantities of columns.md, from what --help prints of them.

scripts/dev/pages.py           writes them anew, each between its comments <!-- NAME --> and <!-- end of NAME -->
scripts/dev/pages.py --check   prints the parts that differ; exit code 1 if there is one
"""
import csv
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts/report"))
import formula_file  # noqa: E402  (beside the report, which typesets the same formulas)

PAGES = [f"docs/{name}.md" for name in ("background/errata", "background/evidence", "background/stability", "reference/columns")]
# The values of the column evidence begin with these; the words are those of the page
EVIDENCE = {
    "proven": "proven for all parameters",
    "certified": "certified for one crawler",
    "sampled": "sampled",
    "measured": "measured in doubles",
}


def read_table(name):
    with open(ROOT / "data" / name, encoding="utf-8") as lines:
        return list(csv.DictReader((line for line in lines if line[0] != "#"), delimiter="\t"))


def is_formula(claim):
    """A statement in words claims no remainder: nan, or the negative power with which the quantity itself grows."""
    return claim["claimed_order"] != "nan" and not claim["claimed_order"].startswith("-")


def how_known(claim):
    """The place of its evidence in EVIDENCE."""
    return next(k for k, word in enumerate(EVIDENCE) if claim["evidence"].startswith(word))


def cell(text):
    return text.replace("|", "\\|").replace("*", "\\*")


def table(head, rows):
    return "\n".join(f"| {' | '.join(row)} |" for row in [head, ["---"] * len(head), *rows]).replace("| --- ", "|---").replace("--- |", "---|")


def remainder(power):
    return {"inf": "`=`", "1": "`O(T)`"}.get(power, f"`O(T^{power})`")


def refuted_formulas(claims):
    groups = {}
    for c in claims:
        if c["source"] == "paper" and is_formula(c) and c["verdict"] == "refuted" and c["paper_conditions"] == "yes":
            key = (c["claim"], c["claimed_order"], c["derived_order"], c["corrected"].split(":")[0], c["evidence"])
            groups.setdefault(key, {})[c["gait"]] = c["equation"]
    rows = []
    for (name, claimed, derived, corrected, evidence), found in sorted(groups.items(), key=lambda group: -len(group[1])):
        power = {"0": "does not fall", "-1": "grows as `1/T`"}.get(derived, f"`T^{derived}`")
        rows.append([next(iter(found.values())), f"`{name}`", ", ".join(found), remainder(claimed), power,
                     evidence.replace("the crawler named", "one crawler"), f"`{corrected}`"])  # fmt: skip
    return table(["equation", "claim", "gait", "printed remainder", "error", "how it is known", "holds instead"], rows)


def corrections(_):
    formulas = [c for c in formula_file.read(ROOT / "asymptotics/published/paper.cfg").values() if c["name"].startswith("corrected_")]
    remainders = ["exact" if c["claimed"] == "equality" else remainder(c["claimed"]) for c in formulas]
    return table(["formula", "instead of", "text", "remainder"],
                 [[f"`{c['name']}`", c["equation"], f"`{c['text']}`", power] for c, power in zip(formulas, remainders)])  # fmt: skip


def refuted_statements(claims):
    first = {}
    for c in claims:
        if c["source"] == "paper" and not is_formula(c) and c["verdict"] == "refuted" and c["paper_conditions"] == "yes":
            first.setdefault(c["claim"], c)
    return table(["section", "claim", "fails for", "what was found"],
                 [[c["equation"], f"`{name}`", cell(c["conditions"]), cell(c["summary"])] for name, c in first.items()])  # fmt: skip


def counts(claims):
    """Checks of formulas under the paper's conditions, and statements. A statement that fails counts with the evidence of its first failure,
    one that holds with the weakest of its checks, as `claims --summary` counts them."""
    inside = [c for c in claims if c["source"] == "paper" and c["paper_conditions"] == "yes"]
    statements = {}
    for c in inside:
        if not is_formula(c):
            statements.setdefault(c["claim"], []).append(c)
    decisive = [next((c for c in checks if c["verdict"] == "refuted"), max(checks, key=how_known)) for checks in statements.values()]
    columns = [[c for c in inside if is_formula(c) and c["verdict"] == verdict] for verdict in ("holds", "sharper", "refuted")]
    columns += [[c for c in decisive if c["verdict"] == verdict] for verdict in ("holds", "refuted")]
    rows = [[words, *(str(sum(how_known(c) == k for c in column)) for column in columns)] for k, words in enumerate(EVIDENCE.values())]
    rows.append(["all", *(str(len(column)) for column in columns)])
    return table(["how it is known", "formula holds", "error falls faster", "formula refuted", "statement holds", "statement fails"], rows)


def stress(_):
    """A row for each family: the largest of its gaits."""
    families, rows = {}, []
    for row in read_table("stress.tsv"):
        families.setdefault(row["family"], []).append(row)
    for name, gaits in families.items():
        worst = max(gaits, key=lambda row: float(row["error_units"]))
        most = [f"{max(float(row[column]) for row in gaits):g}" for column in ("spread_rounding", "change_per_ulp")]
        total = [str(sum(int(row[column]) for row in gaits)) for column in ("cases", "refused", "other_modes")]
        rows.append([f"`{name}`", total[0], worst["error_units"], worst["quantity"], *("-" if x == "nan" else x for x in most), *total[1:]])
    return table(["family", "cases", "error (bound: 8)", "of", "spread (32)", "change per ulp (17)", "refused", "other modes"], rows)


def quantities(_):
    """The numbers that docs/reference/commands.md lists among the columns; t1 to dxC are of a phase."""
    listed = (ROOT / "docs/reference/commands.md").read_text(encoding="utf-8").split("\n**Numbers [units]")[1].split("\n\n")[0]
    rows = [[f"`{name}`", *row] for name, *row in re.findall(r"^\* `(\w+)`: (.*) \[(.*)\]$", listed.replace("\n  ", " "), re.M)]
    names = [row[0] for row in rows]
    of_phase = names[names.index("`t1`"):names.index("`dxC`") + 1]
    rows = [row + ["a phase" if row[0] in of_phase else "the steady state"] for row in rows]
    return table(["quantity", "meaning", "unit", "of"], sorted(rows, key=lambda row: row[-1], reverse=True))


PARTS = {
    "refuted formulas": refuted_formulas,
    "corrections": corrections,
    "refuted statements": refuted_statements,
    "counts": counts,
    "stress": stress,
    "quantities": quantities,
}


def main():
    claims, found, differs = read_table("claims.tsv"), set(), False
    for page in PAGES:
        text = fresh = (ROOT / page).read_text(encoding="utf-8")
        for name, part in PARTS.items():
            pattern = re.compile(f"(<!-- {name} -->\n).*?(<!-- end of {name} -->)", re.S)
            found |= {name} if pattern.search(fresh) else set()
            fresh = pattern.sub(lambda match, part=part: f"{match[1]}{part(claims)}\n{match[2]}", fresh)
        if fresh != text and "--check" in sys.argv:
            differs = True
            print(f"{page}: {next(a for a, b in zip(text.split(chr(10)), fresh.split(chr(10))) if a != b)[:100]}")
        elif fresh != text:
            (ROOT / page).write_text(fresh, encoding="utf-8")
    if found != set(PARTS):
        print("no page has:", *sorted(set(PARTS) - found))
    return differs or found != set(PARTS)


if __name__ == "__main__":
    sys.exit(main())
