"""Counts wordings that are hard to read, in comments of C and in documents.

prose.txt beside this script lists the wordings and the limit of each. The exit code is 1 if a count exceeds its limit.
--counts prints all counts beside their limits, --folders the counts of each folder and document, --show each place of
one wording (or of `all`). The script reads the tree in the current folder: the comments of C files outside tests/ and
bench/; README.md and the like; docs/, without blocks of code; docs/help/. A wording may continue on the next line."""
import argparse
import bisect
import collections
import glob
import os
import re
import sys

LIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), "prose.txt")
FOLDERS = ("model", "asymptotics", "numerics", "compare", "explorer")
GENERATED = "commands.md"  # made from docs/help/
TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|/\*.*?\*/|//[^\n]*', re.S)
KINDS = ("comments", "documents")
Wording = collections.namedtuple("Wording", "limits expression instead")
# words: the text, single-spaced; starts, lines: the offset in words at which each line of the file begins, its number
Text = collections.namedtuple("Text", "kind path words starts lines")


def read_list():
    """{name: Wording} from prose.txt, whose head describes the format."""
    rows, last = {}, ""
    with open(LIST, encoding="utf-8") as file:
        for line in (each.rstrip("\n") for each in file if each.strip() and each[0] != "#"):
            if line[0] != " ":
                last, *limits = line.split()
                row = rows[last] = {"limits": [int(n) for n in limits]}
            else:
                key, value = line.strip().split(": ", 1)
                row[key] = row.get(key, "") + value
    return {name: Wording(row["limits"], re.compile(row["find"], re.I), row["write"]) for name, row in rows.items()}


def joined(kind, path, numbered):
    """The Text of [(line number, line)]"""
    words, starts, lines = "", [], []
    for number, line in ((n, " ".join(each.split())) for n, each in numbered):
        if line:
            starts.append(len(words))
            lines.append(number)
            words += line + " "
    return Text(kind, path, words.strip(), starts, lines)


def comments(path):
    """The Text of each comment; // in the same column of consecutive lines is one comment."""
    with open(path, encoding="utf-8") as file:
        source = file.read()
    newlines = [m.start() for m in re.finditer("\n", source)]
    group, place = [], None
    for token in (t for t in TOKEN.finditer(source) if t[0][0] == "/"):
        number = bisect.bisect_left(newlines, token.start()) + 1
        here = (number, token.start() - source.rfind("\n", 0, token.start())) if token[0][1] == "/" else None
        if not here or not place or here != (place[0] + 1, place[1]):
            yield joined(0, path, group)
            group = []
        body = token[0][2:] if here else token[0][2:-2]
        group += [(number + i, re.sub(r"^[\s*]+", "", line)) for i, line in enumerate(body.split("\n"))]
        place = here
    yield joined(0, path, group)


def paragraphs(path):
    """The Text of each paragraph, heading, item of a list and row of a table"""
    group, in_code = [], False
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            fence = line.lstrip().startswith("```")
            in_code ^= fence
            if fence or in_code or not line.strip() or re.match(r"\s*([-*|#]|\d+\.) ?", line):
                yield joined(1, path, group)
                group = []
            if not fence and not in_code:
                line = re.sub(r"^(#.*)\?$", r"\1", line.rstrip())  # a heading may be a question
                group.append((number, re.sub(r"^\s*[-*#|]+ ", "", line)))
    yield joined(1, path, group)


def texts():
    for path in sorted(p for f in FOLDERS for p in glob.glob(f + "/**/*.[ch]", recursive=True)) + ["scallop.h"]:
        yield from comments(path)
    for path in sorted(glob.glob("*.md") + glob.glob("docs/**/*.md", recursive=True) + glob.glob("docs/help/*.txt")):
        if os.path.basename(path) != GENERATED:
            yield from paragraphs(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", action="store_true")
    parser.add_argument("--folders", action="store_true")
    wordings = read_list()
    parser.add_argument("--show", choices=[*wordings, "all"])
    options = parser.parse_args()
    found = [(t, name, match) for t in texts() for name, w in wordings.items() for match in w.expression.finditer(t.words)]
    for text, name, match in (each for each in found if options.show in (each[1], "all")):
        line = text.lines[bisect.bisect_right(text.starts, match.start()) - 1]
        print(f"{text.path}:{line}: {name}: {text.words[max(0, match.start() - 30):match.end() + 40]}")
    if options.folders:
        each = collections.Counter((t.path if t.kind else os.path.dirname(t.path) or t.path, name) for t, name, _ in found)
        for place in sorted({p for p, _ in each}):
            print(place, sum(each[place, n] for n in wordings), *(f"{n} {each[place, n]}" for n in wordings if each[place, n]))
    counts, above = collections.Counter((name, text.kind) for text, name, _ in found), False
    for name, w in wordings.items():
        if options.counts:
            print(name, *(f"{counts[name, k]} in {KINDS[k]} (limit {w.limits[k]})" for k in (0, 1)), sep="  ")
        for kind in (k for k in (0, 1) if counts[name, k] > w.limits[k]):
            above = True
            print(f"prose.py: {name}: {counts[name, kind]} in {KINDS[kind]}, the limit is {w.limits[kind]};",
                  f"`python3 scripts/dev/prose.py --show {name}` lists them. Write: {w.instead}", file=sys.stderr)
    return above


sys.exit(main())
