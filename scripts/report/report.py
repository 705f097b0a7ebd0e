#!/usr/bin/python3
"""Writes the page that shows what was found, every figure and the table of claims, as one file that asks the network for nothing.

scripts/report/report.py --tables data --plots build/plots --scenes data/scenes --output build/report/index.html

page.html is the page, filled in by Jinja, which escapes whatever comes from a file (tables, scenes) unless it was built as markup:
plots (plots), formulas (formula_file). check_report.py drives a browser (browser) over the result.

The same input gives the same bytes. Exit codes: 0 done, 2 bad usage, 4 a file could not be read or written.
"""
import argparse
import base64
import hashlib
import os
import re
import sys
from pathlib import Path
from urllib.parse import quote

sys.dont_write_bytecode = True
import jinja2  # noqa: E402  (nothing is written beside the sources)
from markupsafe import Markup  # noqa: E402

import formula_file  # noqa: E402
import journey  # noqa: E402
import verdicts  # noqa: E402
import plots  # noqa: E402
import tables  # noqa: E402

HERE = Path(__file__).parent
CONTROL = re.compile("[\0-\x08\x0b-\x1f\x7f-\x9f]")
EXPLORER = "../explorer/index.html"  # beside the page's folder; linked where it is there


def shown(value):
    """What Jinja writes of a value: a control character, which HTML does not allow, is a question mark."""
    return type(value)(CONTROL.sub("?", value)) if isinstance(value, str) else value


def fingerprint(source):
    return "'sha256-" + base64.b64encode(hashlib.sha256(source.encode()).digest()).decode() + "'"


def inside(text):
    """The inside of a <math>; text that is no formula stays text."""
    return formula_file.typeset(text) or Markup("<mtext>{}</mtext>").format(text)


def typeset(text):
    """A formula within a line, or the text itself."""
    shown = formula_file.typeset(text)
    return Markup("<math>{}</math>").format(shown) if shown else text


def order(power):
    """T^power, of the error of a formula; what is no number stays as it is."""
    words = {"inf": "exact", "nan": "-", "0": typeset("T^0")}
    return words.get(power) or (typeset(f"T^{power}") if power.lstrip("-").isdigit() else power)


def remainder(claimed):
    """What the paper prints behind a formula: + O(T^claimed), or nothing where it is an equality."""
    return Markup("<mo>+</mo>{}").format(formula_file.typeset(f"O(T^{claimed})")) if claimed.lstrip("-").isdigit() else ""


def breakable(name):
    return Markup("").join(letter + Markup("<wbr>") if letter in "_:" else letter for letter in name)


def download(table):
    # quote() leaves letters, digits and _.-~ alone; these others are as harmless in a quoted attribute
    return "data:text/tab-separated-values;charset=utf-8," + quote(table.text, safe=" |()+*/:=,;!")


def fragment(table, also):
    """The parameters of a table's crawler, and others, as the explorer takes them: F1=4&T=1"""
    given = dict(pair.split("=") for pair in f"{table.comment('parameters')} {also}".split())
    return "&".join(f"{name}={quote(value, safe=':,')}" for name, value in given.items())


def page(options):
    """The page as text."""
    read = tables.Folder(options.tables)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, finalize=shown, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    for function in (order, typeset, inside, remainder, breakable, download, fragment):
        environment.filters[function.__name__] = function
    figure2 = read["figure2"]
    kinds = ("symmetric", "asymmetric")
    style = tables.text_of(HERE / "page.css") + "".join(journey.style(figure2, kind) for kind in kinds)
    script = tables.text_of(HERE / "page.js")
    return environment.get_template("page.html").render(
        style=Markup(style),
        script=Markup(script),
        policy=f"default-src 'none'; img-src data:; style-src {fingerprint(style)}; script-src {fingerprint(script)}; "
        "base-uri 'none'; form-action 'none'",
        marks={kind: journey.marks(figure2, kind) for kind in kinds},
        stroke=journey.STROKE,
        tables=read,
        scene=lambda name: tables.text_of(options.scenes / f"{name}.cfg"),
        drawing=lambda name: plots.drawing(options.plots / f"{name}.svg", name),
        formulas=formula_file.read(options.formulas),
        verdicts=verdicts,
        **{scope: [row for row in read["claims"].rows if verdicts.scope(row) == scope] for scope in ("paper", "words")},
        explorer=EXPLORER if (options.output.parent / EXPLORER).resolve().is_file() else None  # the page's folder may not be there yet,
    )


def write(path, content):
    """The file takes its name when all of it is written: an earlier one stays if that fails."""
    path.parent.mkdir(parents=True, exist_ok=True)
    aside = path.with_name(path.name + ".part")
    try:
        aside.write_bytes(content.encode())
        os.replace(aside, path)
    finally:
        aside.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    for name, what in (("tables", "the tables, NAME.tsv"), ("plots", "their plots, NAME.svg"), ("scenes", "their scenes, NAME.cfg")):
        parser.add_argument(f"--{name}", type=Path, required=True, metavar="FOLDER", help=what)
    parser.add_argument("--output", type=Path, required=True, metavar="FILE", help="the page")
    published = HERE.parents[1] / "asymptotics" / "published" / "paper.cfg"
    parser.add_argument("--formulas", type=Path, default=published, metavar="FILE", help="the formula file (paper.cfg)")
    options = parser.parse_args()
    try:
        write(options.output, page(options))
    except tables.Unreadable as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 4
    except OSError as error:
        print(f"report.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
