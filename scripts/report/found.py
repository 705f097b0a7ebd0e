"""What the tables say, counted from their rows."""
import tables
from markup import VERDICTS


def is_formula(row):
    """A formula with a remainder, whose order is proven; the other claims are statements in words."""
    return row["derived_order"] != "-"


def scope(row):
    if row["source"] == "corrected":
        return "corrected"
    return "paper" if row["inside"] == "yes" else "outside"


def chosen(ledger, wanted, **cells):
    return [
        row for row in ledger.rows if scope(row) == wanted and all(row[name] == cell for name, cell in cells.items())
    ]


def counts(rows):
    return {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS}


def grouped(rows, *columns):
    """Rows with the same cells in these columns, together and in the order in which they first appear."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[name] for name in columns), []).append(row)
    return groups


def summary(ledger):
    """(label, counts, scope) of the groups of claims that the page counts, the total of the paper's conditions first."""
    inside = chosen(ledger, "paper")
    lines = [("All claims under the paper’s conditions", inside, "paper")]
    for words, kind in (("Formulas", True), ("Statements in words", False)):
        for (gait,), rows in sorted(grouped([row for row in inside if is_formula(row) == kind], "gait").items()):
            lines.append((f"{words}, {gait} gait", rows, "paper"))
    lines.append(("The same formulas and statements outside these conditions", chosen(ledger, "outside"), "outside"))
    lines.append(("Formulas put in the place of refuted ones", chosen(ledger, "corrected"), "corrected"))
    return [(label, counts(rows), wanted) for label, rows, wanted in lines if rows]


def formula_texts(path):
    """The corrected formulas by their names in the ledger: (instead of, holds), from the table "What holds instead"."""
    texts = {}
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise tables.Unreadable(f"{path}: {error.strerror}") from error
    for line in lines:
        cells = [cell.strip() for cell in line.strip().strip("|").split(" | ")]
        if len(cells) == 3 and cells[0].startswith("`"):
            for name in cells[0].split("`")[1::2]:
                texts[name] = (cells[1], cells[2])
    return texts


def promises(stress):
    """The bounds that stress.tsv says are promised: error, spread over the rounding modes, over parameters an ulp apart."""
    line = stress.comment("promised, in units") or ""
    found = [tables.value(word) for word in line.replace(",", " ").split()]
    numbers = [number for number in found if number is not None]
    if len(numbers) != 3:
        raise tables.Unreadable("stress.tsv: no comment 'promised, in units: error E, spread ... R, ... P'")
    return numbers


def largest(table, column):
    return max(value for value in (tables.value(row[column]) for row in table.rows) if value is not None)
