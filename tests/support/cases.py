"""Cases of the command line: cases.py SCALLOP FILE. Prints "ok NAME" or "FAIL NAME: what" for each group of cases.

A line without blanks in front begins a group with its name; those below it, two blanks in, are run in a scratch folder:

  ARGUMENT... [<FILE] [>FILE] [=> WANTED [&& WANTED]...]
      scallop with these arguments, in the words of a shell; {a,b} stands for a, then b, and {1} in what is wanted for the first of those
  file NAME [= EXPRESSION]
      the lines below it, four blanks in, become this file, in NAME.tsv with tabs for blanks; or the value of EXPRESSION
  python
      the lines below it: bad(...) says what is wrong, run(ARGUMENT..., code=0) runs scallop, table(FILE) has the rows of a table; names
      stay for what follows

WANTED is one of these; two dots in a TEXT stand for whatever is between:
  CODE [TEXT]             the exit code (0 where none is given), and in standard error the text; of code 2 and 4 that is one line, and there is
                          nothing on standard output unless something is wanted there
  quiet                   nothing on standard error
  out TEXT | no out TEXT  in standard output
  COLUMN...: CELL...; CELL...    these columns, row by row
  rows N                  so many rows
  like ARGUMENT...        the same bytes as with these arguments; or after a name: COLUMN... like ARGUMENT..., rows like ARGUMENT...
  ? EXPRESSION            true, with rows (of texts), col("NAME") (numbers), out and err
"""
import itertools
import json
import math
import os
import re
import shlex
import subprocess
import sys
import tempfile


class Wrong(Exception):
    pass


def bad(*what):
    raise Wrong(" ".join(map(str, what)))


def rows_of(text):
    lines = [line.split("\t") for line in text.splitlines() if not line.startswith("#")]
    return [dict(zip(lines[0], line)) for line in lines[1:]]


def table(name):
    return rows_of(open(name, encoding="utf-8").read())


def number(row, *names):
    values = [float(row[name]) for name in names]
    return values[0] if len(values) == 1 else values


def near(a, b, tolerance):
    return abs(a - b) <= tolerance * max(abs(a), abs(b))


def without_comments(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


class Run:
    """What scallop said."""

    def __init__(self, words):
        self.words = [w for w in words if w[:1] not in "<>" or not w]
        files = {w[0]: w[1:] for w in words if w[:1] in ("<", ">")}
        with open(files.get("<", os.devnull), "rb") as given:
            done = subprocess.run([TOOL, *self.words], stdin=given, capture_output=True, timeout=600)
        self.code = done.returncode
        self.out, self.err = (text.decode("utf-8", "surrogateescape") for text in (done.stdout, done.stderr))
        if ">" in files:
            open(files[">"], "wb").write(done.stdout)

    @property
    def rows(self):
        return rows_of(self.out)

    def col(self, name):
        return [float(row[name]) for row in self.rows]

    def cells(self, columns):
        return "; ".join(" ".join(row[name] for name in columns.split()) for row in self.rows)


def run(*words, code=0):
    said = Run(words)
    if said.code != code:
        bad("scallop", shlex.join(words), "gives exit code", said.code, "not", code, said.err[:300])
    return said


def has(text, wanted):
    return re.search(".*".join(map(re.escape, wanted.split(".."))), text) is not None


def hold(run_, wanted, alone=True):
    """Complains where what is wanted is not there; alone: nothing else is wanted."""
    code, _, text = wanted.partition(" ")
    columns, colon, cells = wanted.partition(":")
    of, like, words = wanted.partition("like ")
    if code.isdigit():
        if not has(run_.err, text):
            bad(f"not {text!r} but {run_.err[:400]!r}")
        if code in "24" and (run_.out and alone or run_.err.count("\n") != 1 or not run_.err.startswith("scallop")):
            bad(f"not one line on standard error{' alone' * alone}: {run_.out[:200]!r} {run_.err[:400]!r}")
    elif wanted == "quiet":
        run_.err == "" or bad("on standard error:", run_.err[:300])
    elif wanted.startswith(("out ", "no out ")):
        text = wanted[4:] if code == "out" else wanted[7:]
        has(run_.out, text) == (code == "out") or bad(f"not '{wanted}': {run_.out[:400]!r}")
    elif wanted.startswith("? "):
        NAMES.update(rows=run_.rows if run_.out[:1] != "{" else [], col=run_.col, out=run_.out, err=run_.err)
        eval(wanted[2:], NAMES) or bad(f"not {wanted[2:]}: {run_.out[-400:]!r} {run_.err[-200:]!r}")
    elif re.fullmatch(r"rows \d+", wanted):
        len(run_.rows) == int(wanted[5:]) or bad(len(run_.rows), "rows, not", wanted[5:])
    elif like:
        other = Run(shlex.split(words))
        pick = {"": lambda r: r.out, "rows ": lambda r: without_comments(r.out)}.get(of, lambda r: r.cells(of))
        pick(run_) == pick(other) or bad(f"{pick(run_)[:300]!r} is not like {words}: {pick(other)[:300]!r}")
    elif colon:
        run_.cells(columns) == cells.strip() or bad(f"{columns}: {run_.cells(columns)!r}, not {cells.strip()!r}")
    else:
        bad("what is wanted is not understood:", wanted)


def case(line):
    command, _, wanted = line.partition(" => ")
    choices = re.split(r"\{([^{}]*,[^{}]*)\}", command)
    for chosen in itertools.product(*(part.split(",") for part in choices[1::2])):
        words = "".join(map("".join, itertools.zip_longest(choices[::2], chosen, fillvalue="")))
        wants = wanted
        for i, text in enumerate(chosen):
            wants = wants.replace("{%d}" % (i + 1), shlex.split(text)[0] if text else "")
        wants = [w.strip() for w in wants.split(" && ") if w.strip()]
        codes = [int(w.split()[0]) for w in wants if w.split()[0].isdigit()] or [0]
        try:
            said = run(*shlex.split(words), code=codes[0])
            for one in wants:
                hold(said, one, all(w.split()[0].isdigit() or w[0] == "?" for w in wants))
        except Wrong as wrong:
            bad(f"scallop {words}: {wrong}")


def write(head, lines):
    name, _, expression = head.partition(" = ")
    text = eval(expression, NAMES) if expression else "".join(line + "\n" for line in lines)
    if name.endswith(".tsv") and not expression:
        text = re.sub(" +", "\t", text)
    open(name, "wb").write(text if isinstance(text, bytes) else text.encode())


def perform(line, lines):
    if line.startswith("file "):
        write(line[5:], lines)
    elif line == "python":
        exec(compile("\n".join(lines), "the case", "exec"), NAMES)
    else:
        case(line)


def main():
    failed, name, wrong = False, None, None

    def finish():
        if name:
            print(f"FAIL {name}: {wrong}" if wrong else f"ok {name}", flush=True)
    lines = open(sys.argv[2], encoding="utf-8").read().split("\n") + ["end"]
    place = 0
    while place < len(lines):
        line, place = lines[place], place + 1
        if not line.strip() or line.startswith(("#", "  #")):
            continue
        if not line.startswith(" "):
            finish()
            failed, name, wrong = failed or bool(wrong), line, None
            continue
        below = []
        while place < len(lines) and (lines[place].startswith("    ") or (not lines[place] and below)):
            below.append(lines[place][4:])
            place += 1
        try:
            perform(line[2:], "\n".join(below).rstrip("\n").split("\n"))
        except Exception as error:  # the other cases of the group are run all the same
            wrong = (f"{wrong}; " if wrong else "") + str(error if isinstance(error, Wrong) else repr(error))
    sys.exit(failed)


TOOL = os.path.abspath(sys.argv[1])
sys.argv[2] = os.path.abspath(sys.argv[2])
ROOT = os.getcwd()
NAMES = globals().copy()  # of the Python in the file: what one block defines the later ones have
with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    sys.dont_write_bytecode = True
    sys.path.insert(0, ".")
    main()
