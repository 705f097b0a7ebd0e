"""Tables that the tool wrote: comments, a header and rows, as text."""
import math
import re

MISSING = ("", "-", "nan", "none")
FRACTION = re.compile(r"(-?\d+)/(\d+)")
BALL = re.compile(r"\[(\S+) \+/- \S+\]")


class Unreadable(Exception):
    """A file that is not there or is no table; the message is for the person who gave its name."""


class Table:
    """name: of the file in data/. text: as it is in the file. rows: dictionaries by the names of the columns."""

    def __init__(self, name, text, origin):
        lines = text.splitlines()
        comments = [line[1:].strip() for line in lines if line.startswith("#")]
        body = [line.split("\t") for line in lines if line and not line.startswith("#")]
        if not body:
            raise Unreadable(f"{origin}: no header: a table begins with the names of its columns")
        self.name, self.text, self.comments = name, text, comments
        self.columns = body[0]
        for number, cells in enumerate(body[1:], 1):
            if len(cells) != len(self.columns):
                raise Unreadable(
                    f"{origin}: row {number} has {len(cells)} cells where the header has {len(self.columns)}"
                )
        self.rows = [dict(zip(self.columns, cells)) for cells in body[1:]]

    def __len__(self):
        return len(self.rows)

    def comment(self, key):
        """What follows "# key: ", or None."""
        return next((line[len(key) + 2 :] for line in self.comments if line.startswith(key + ": ")), None)


def read(folder, name):
    path = folder / f"{name}.tsv"
    try:
        return Table(name, path.read_text(encoding="utf-8"), path)
    except (OSError, UnicodeDecodeError) as error:
        raise Unreadable(f"{path}: {getattr(error, 'strerror', None) or error}") from error


def value(cell):
    """The number that a cell stands for: decimal, fraction or the middle of a ball; None where it is none."""
    fraction, ball = FRACTION.fullmatch(cell), BALL.fullmatch(cell)
    if fraction:
        return int(fraction[1]) / int(fraction[2])
    try:
        number = float(ball[1] if ball else cell)
    except ValueError:
        return None
    return None if math.isnan(number) else number


def numeric(cells):
    """Whether a column is sorted as numbers: every cell is one, or missing, and one is there."""
    present = [cell for cell in cells if cell not in MISSING]
    return bool(present) and all(value(cell) is not None for cell in present)
