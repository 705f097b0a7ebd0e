#!/usr/bin/python3
"""Writes the page that shows every figure, the ledger and the measurements, as one file that asks the network for nothing.

scripts/report/report.py --tables data --plots build/plots --scenes data/scenes --output build/report/index.html

Tables are read (tables), counted (found), drawn (figures, drawing, stability), marked up (markup), and put into sections (ledger,
sections) and a page (page). check_report.py drives a browser (browser) over the result.

The same input gives the same bytes. Exit codes: 0 done, 2 bad usage, 3 scripts/plots/cheapest.awk failed, 4 a file could
not be read or written.
"""
import argparse
import os
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import figures  # noqa: E402  (nothing is written beside the sources)
import found  # noqa: E402
import page  # noqa: E402
import tables  # noqa: E402


class Inputs:
    """What the page is made of. scenes: texts by the names of their tables; formulas: see found.formula_texts."""

    def __init__(self, options):
        self.warned = set()
        self.plots = options.plots
        self.tables = {name: tables.read(options.tables, name) for name in figures.NAMES}
        self.scenes = self.read_scenes(options.scenes)
        self.formulas = found.formula_texts(options.errata)
        self.cheapest = cheapest(options.tables)

    def warn(self, message):
        if message not in self.warned:
            print(f"report.py: {message}", file=sys.stderr)
        self.warned.add(message)

    def read_scenes(self, folder):
        if not folder.is_dir():
            self.warn(f"{folder}: there is no such folder: the page shows no scene")
            return {}
        scenes = {}
        for name in figures.NAMES:
            try:
                scenes[name] = (folder / f"{name}.cfg").read_text(encoding="utf-8")
            except FileNotFoundError:
                self.warn(f"{folder / name}.cfg: there is no such scene: left out")
        return scenes


class Failed(Exception):
    """scripts/plots/cheapest.awk could not be run, or did not do what was asked."""


def cheapest(folder):
    """The summary of workprec.tsv: the cheapest method for each wanted error."""
    command = ["awk", "-f", str(Path(__file__).parents[1] / "plots" / "cheapest.awk"), str(folder / "workprec.tsv")]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise Failed(f"awk: {error.strerror}") from error
    if done.returncode != 0:
        raise Failed(f"{' '.join(command)} ends with exit code {done.returncode}: {done.stderr.strip()}")
    return tables.Table("cheapest", done.stdout, " ".join(command))


def write(path, content):
    """The file takes its name when all of it is written: an earlier one stays if that fails."""
    path.parent.mkdir(parents=True, exist_ok=True)
    aside = path.with_name(path.name + ".part")
    try:
        aside.write_bytes(content.encode())
        os.replace(aside, path)
    finally:
        aside.unlink(missing_ok=True)


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--tables", type=Path, required=True, metavar="FOLDER", help="the tables, NAME.tsv")
    parser.add_argument(
        "--plots", type=Path, required=True, metavar="FOLDER", help="the plots that scripts/plots/draw.sh drew, NAME.svg"
    )
    parser.add_argument("--scenes", type=Path, required=True, metavar="FOLDER", help="the scenes, NAME.cfg")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE", help="the page")
    parser.add_argument(
        "--errata",
        type=Path,
        metavar="FILE",
        default=Path(__file__).parents[2] / "docs" / "errata.md",
        help="the document with the formulas that hold instead of refuted ones (docs/errata.md)",
    )
    return parser.parse_args()


def main():
    options = read_options()
    try:
        write(options.output, page.page(Inputs(options)))
    except tables.Unreadable as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 4
    except Failed as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"report.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
