"""Tables that the tool wrote: comments, a header and rows, as text."""


class Unreadable(Exception):
    """A file that is not there or is not what it should be; the message is for the person who gave its name."""


def text_of(path):
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise Unreadable(f"{path}: {getattr(error, 'strerror', None) or error}") from error


class Table:
    """text: as it is in the file. rows: dictionaries by the names of the columns, which come first."""

    def __init__(self, path):
        self.name, self.text = path.stem, text_of(path)
        lines = self.text.split("\n")  # cells may have other characters that end lines elsewhere
        self.comments = [line[1:].strip() for line in lines if line.startswith("#")]
        columns, *body = [line.split("\t") for line in lines if line and not line.startswith("#")] or [[]]
        if not columns:
            raise Unreadable(f"{path}: no header: a table begins with the names of its columns")
        for number, cells in enumerate(body, 1):
            if len(cells) != len(columns):
                raise Unreadable(f"{path}: row {number} has {len(cells)} cells where the header has {len(columns)}")
        self.rows = [dict(zip(columns, cells)) for cells in body]

    def where(self, **cells):
        return [row for row in self.rows if all(row[name] == cell for name, cell in cells.items())]

    def comment(self, key):
        """What follows "# key: ", or ""."""
        return next((line[len(key) + 2 :] for line in self.comments if line.startswith(key + ": ")), "")


class Folder(dict):
    """The tables of a folder by their names, read when they are first asked for."""

    def __init__(self, path):
        super().__init__()
        self.path = path

    def __missing__(self, name):
        return self.setdefault(name, Table(self.path / f"{name}.tsv"))
