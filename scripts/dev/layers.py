"""Which folder uses which, from the code, against the list of what is allowed: layers.py BUILD [--size]

A folder is model, asymptotics, numerics, a folder in one of them, a folder of compare/, or explorer. A folder uses another one if a file includes one of its headers, or if an
object file takes a function or data from one of its objects, so that a table of function pointers counts too. A header named like its
folder, numerics/numerics.h, is what the folders within that folder all speak of: they may include it. The list is layers.txt
beside this script. Refused are: an arrow that is not in the list, a circle among folders, a circle among the units of one folder of
compare/ (a unit is a .c with its .h), headers with the same include guard, a line of C over 120 columns, more lines in a folder than the list
allows, and more than the limits below. Exit code 1 if something is refused. --size prints sizes beside what is allowed."""
import collections
import glob
import os
import re
import statistics
import subprocess
import sys

MOST_FILES, MOST_LINES, MOST_FUNCTION, MOST_COLUMNS = 25, 450, 60, 120  # files of a folder of compare/, lines of a file there, of any function
LIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), "layers.txt")
COMPARE = sorted(f.rstrip("/") for f in glob.glob("compare/*/"))
FOLDERS = [f for top in ("model", "asymptotics", "numerics") for f in (top, *(n.rstrip("/") for n in sorted(glob.glob(top + "/*/"))))] + COMPARE + ["explorer", "bench"]


def sources(folder):
    return sorted(glob.glob(folder + "/*.[ch]"))


def lines_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read().split("\n")[:-1]


def folder(path):
    """model/law.c: model; compare/tables/table.h: tables; None outside of the folders"""
    return os.path.basename(os.path.dirname(path)) if os.path.dirname(path) in FOLDERS else None


def is_face_of(header, path):
    """numerics/numerics.h for the folders within numerics/: what they all speak of"""
    folder = os.path.dirname(header)
    return os.path.basename(header) == os.path.basename(folder) + ".h" and path.startswith(folder + "/")


def functions(path):
    """Name and length of each function, signature included. In a file that clang-format wrote, { and } of a body are in column 0."""
    begin, inside = 0, False
    for number, line in enumerate(lines_of(path), 1):
        if not begin and re.match(r"[A-Za-z].*\w\(", line) and not line.endswith(";"):
            begin, name = number, re.search(r"(\w+)\(", line)[1]
        inside = inside or line == "{"
        if begin and (line == "}" or number == begin and line.endswith("}")):
            yield name, number - begin + 1
        if line == "}" or not inside and (line == "" or line.endswith((";", "}")) or line[0] == "#"):
            begin, inside = 0, False


def symbols(build):
    """The files in which each symbol is defined (several, where a program takes one or the other), and what each file takes."""
    defined, taken = collections.defaultdict(list), {}
    for path in (p for f in FOLDERS for p in sources(f)):
        made = os.path.join(build, path[:-1] + "o")
        if path.endswith(".c") and os.path.exists(made):
            listing = subprocess.run(["nm", "-P", "-g", made], check=True, capture_output=True, text=True).stdout
            kinds = [line.split()[:2] for line in listing.splitlines()]
            taken[path] = [name for name, kind in kinds if kind == "U"]
            for name in (name for name, kind in kinds if kind not in "Uw"):
                defined[name].append(path)
    return defined, taken


def arrows(build, allowed):
    """(from, to, why): from and to are files."""
    for path in (p for f in FOLDERS for p in sources(f)):
        for number, line in enumerate(lines_of(path), 1):
            for name in re.findall(r'^\s*#\s*include "(.*)"', line):
                beside = os.path.normpath(os.path.join(os.path.dirname(path), name))
                header = beside if os.path.exists(beside) else name
                if folder(header) and not is_face_of(header, path):
                    yield path, header, f"{path}:{number} includes {header}"
    defined, taken = symbols(build)
    for path, names in taken.items():
        uses = collections.defaultdict(list)
        for name in (n for n in names if n in defined):
            permitted = [d for d in defined[name] if folder(d) in allowed.get(folder(path), ())]
            uses[(permitted or defined[name])[0]].append(name)
        for maker, used in uses.items():
            yield path, maker, f"{path} uses {', '.join(used)} of {maker}"


def read_list():
    """What each folder may use, itself included: the folders on the right of its row, and what those may use. And its lines of C."""
    rows = [re.match(r"(\w+)\s+(\d+)\s*->\s*(.*)", l).groups() for l in lines_of(LIST) if l and l[0] != "#"]
    graph = {name: set(to.split()) for name, _, to in rows}
    return {name: reached(name, graph) | {name} for name in graph}, {name: int(most) for name, most, _ in rows}


def reached(start, graph):
    """What can be reached from start by one arrow or several."""
    found, left = set(), [start]
    while left:
        new = graph.get(left.pop(), set()) - found
        found |= new
        left += new
    return found


def circles(edges):
    """edges: {(from, to): why}. The reasons of one shortest circle for each set of nodes that need each other."""
    graph = collections.defaultdict(set)
    for a, b in edges:
        graph[a].add(b)
    done = set()
    for node in sorted(graph):
        members = {n for n in reached(node, graph) if node in reached(n, graph)} - done
        done |= members
        ways = collections.deque([[node]] if members else [])
        while ways and (ways[0][-1] != node or len(ways[0]) == 1):
            way = ways.popleft()
            ways.extend(way + [n] for n in sorted(graph[way[-1]] & members) if n not in way[1:])
        if ways:
            yield sorted(members), [edges[step] for step in zip(ways[0], ways[0][1:])]


def refusals(build):
    allowed, budget = read_list()
    graphs = collections.defaultdict(dict)  # of folders in the program, and of units in each folder of compare/
    for a, b, why in arrows(build, allowed):
        if folder(a) != folder(b):
            graphs["the program"].setdefault((folder(a), folder(b)), why)
            if folder(b) not in allowed.get(folder(a), ()):
                yield f"{folder(a)} must not use {folder(b)}: {why}"
        elif a.startswith("compare/") and a[:-2] != b[:-2]:
            graphs[os.path.dirname(a)].setdefault((a[:-2], b[:-2]), why)
    for name in (folder(f + "/") for f in FOLDERS):
        if name not in allowed or any(name in allowed[other] for other in allowed[name] - {name}):
            yield f"{name}: {'in a circle of' if name in allowed else 'not in'} {os.path.basename(LIST)}"
    for place, edges in graphs.items():
        for members, why in circles(edges):
            yield f"circle in {place}, of {', '.join(map(os.path.basename, members))}:\n  " + "\n  ".join(why)
    sizes = [(f, len(sources(f)), "files", MOST_FILES) for f in COMPARE]
    sizes += [(p, len(lines_of(p)), "lines", MOST_LINES) for f in COMPARE for p in sources(f)]
    sizes += [(f, lines_in([f]), "lines", budget.get(folder(f + "/"), 0)) for f in FOLDERS]
    sizes += [(f"{p}: {n}", lines, "lines", MOST_FUNCTION) for f in FOLDERS for p in sources(f) for n, lines in functions(p)]
    guards = collections.defaultdict(list)
    mine = [p for p in sorted(glob.glob("**/*.[ch]", recursive=True)) if not p.startswith("build/")]
    for p in [p for p in mine if p.endswith(".h")]:
        for guard in re.findall(r"^#ifndef (\w+)\n#define \1\n", "\n".join(lines_of(p)) + "\n", re.M)[:1]:
            guards[guard].append(p)
    for guard, paths in guards.items():
        if len(paths) > 1:
            yield f"{guard} guards {' and '.join(paths)}"
    for p in mine:
        yield from (f"{p}:{n}: {len(l)} columns" for n, l in enumerate(lines_of(p), 1) if len(l) > MOST_COLUMNS)
    for what, count, of, most in sizes:
        if count > most:
            yield f"{what}: {count} {of}, {most} are allowed"


def lines_in(folders):
    return sum(len(lines_of(p)) for f in folders for p in sources(f))


def size():
    budget = read_list()[1]
    yield "folder                 files   lines  allowed  functions  median  longest"
    for name, folders in [*((f, [f]) for f in FOLDERS), ("compare", COMPARE), ("tests", [f.rstrip("/") for f in glob.glob("tests/**/", recursive=True)])]:
        paths = [p for f in folders for p in sources(f)]
        lengths = [length for p in paths for _, length in functions(p)]
        middle, most = (round(statistics.median(lengths)), max(lengths)) if lengths else (0, 0)
        allowed = budget.get(os.path.basename(name)) or sum(budget[os.path.basename(f)] for f in folders if f in COMPARE) or "-"
        yield f"{name:20}{len(paths):6}{lines_in(folders):8}{allowed:>9}{len(lengths):11}{middle:8}{most:9}"


told = list(size() if "--size" in sys.argv else refusals(sys.argv[1]))
sys.stdout.writelines(row + "\n" for row in told)
sys.exit(1 if told and "--size" not in sys.argv else 0)
