"""Pieces of HTML: text is escaped here and nowhere else."""
import re
from html import escape as text
from urllib.parse import quote

import tables

PREVIEW = 12  # rows of a long table that are on the page before it is opened
TALL = 24  # rows of a table that is shown at its full height
VERDICTS = ("holds", "sharper", "refuted", "undecided")


def element(name, content="", /, **attributes):
    """<name attributes>content</name>; content is HTML, attributes are text, True for one without a value."""
    pairs = "".join(
        f" {key.rstrip('_').replace('_', '-')}" + ("" if given is True else f'="{text(str(given))}"')
        for key, given in attributes.items()
        if given is not None and given is not False
    )
    return f"<{name}{pairs}>{content}</{name}>"


def paragraph(content, **attributes):
    return element("p", content, **attributes) + "\n"


def order(power):
    """O(T^power) as the paper prints it; the power is what it is sorted by."""
    if power == "inf":
        return element("data", "none: an equality", value=power)
    if tables.value(power) is None:
        return text(power)
    shown = f"{float(power):g}".replace("-", "−")
    exponent = "" if shown == "1" else element("sup", shown)
    return element("data", f"O({element('i', 'T')}{exponent})" if shown != "0" else "O(1)", value=power)


def verdict(word):
    return element("span", text(word), class_=f"verdict {word}") if word in VERDICTS else text(word)


def code_spans(source):
    """Text in which `code` stands between backticks, as in the documents of docs/."""
    parts = re.split(r"`([^`]*)`", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", source))
    return "".join(element("code", text(part)) if i % 2 else text(part) for i, part in enumerate(parts))


def head(columns, numbers, labels=None):
    cells = (
        element(
            "th",
            element("button", text((labels or {}).get(name, name)), type="button"),
            scope="col",
            class_="n" if name in numbers else None,
            data_column=name,
        )
        for name in columns
    )
    return element("thead", element("tr", "".join(cells)))


def row(columns, numbers, cells, **attributes):
    """cells: HTML, by column."""
    return element(
        "tr",
        "".join(element("td", cells[name], class_="n" if name in numbers else None) for name in columns),
        **attributes,
    )


def scrolled(table, label, rows):
    """A table in a box of its own that scrolls, by keyboard too; one with many rows is cut off where the window would be."""
    return (
        element(
            "div",
            table,
            class_="scroll tall" if rows > TALL else "scroll",
            role="region",
            aria_label=label,
            tabindex="0",
        )
        + "\n"
    )


def sortable(identifier, label, columns, cells, labels=None, numbers=None, attributes=None, wide=(), rows=None):
    """A table with headings to sort by. cells: one dictionary of HTML a row; numbers: the columns that hold numbers;
    rows: how many it gets, if not these."""
    lines = (
        row(columns, numbers or (), line, **(attributes[i] if attributes else {})) + "\n"
        for i, line in enumerate(cells)
    )
    body = element("tbody", "\n" + "".join(lines))
    content = element("caption", text(label)) + head(columns, numbers or (), labels) + body
    return scrolled(
        element("table", content, id=identifier, class_=" ".join(["sortable", *wide])), label, rows or len(cells)
    )


def number_columns(table):
    return {name for name in table.columns if tables.numeric([line[name] for line in table.rows])}


def data_link(table, label):
    """The file itself in the page, to download: the one copy that is there, which the script reads as well."""
    # quote() leaves letters, digits and _.-~ alone; these others are as harmless in a quoted attribute
    address = "data:text/tab-separated-values;charset=utf-8," + quote(table.text, safe=" |()+*/:=,;!")
    return f'<a class="download" download="{text(table.name)}.tsv" href="{address}">{text(label)}</a>'


def long_table(table):
    """A table in a <details> element: its first rows, all of them once it is opened, and the file to download."""
    numbers = number_columns(table)
    cells = [{name: text(line[name]) for name in table.columns} for line in table.rows[:PREVIEW]]
    label = f"data/{table.name}.tsv"
    comments = element("pre", text("\n".join(table.comments)), class_="comments", tabindex="0")
    body = (
        comments
        + paragraph(data_link(table, f"Download {table.name}.tsv"), class_="tools")
        + sortable(f"table-{table.name}", label, table.columns, cells, numbers=numbers, rows=len(table))
        + (
            paragraph(
                f"Without scripts the first {PREVIEW} rows are shown; the file has {len(table)}.",
                class_="without-script",
            )
            if len(table) > PREVIEW
            else ""
        )
    )
    summary = element("summary", f"Table {element('code', text(label))}, {len(table)} rows")
    return element("details", summary + body, class_="table", data_rows=len(table)) + "\n"
