#!/usr/bin/python3
"""Looks at the explorer in headless Chromium: its numbers beside those of the command, and what a reader does with it.

scripts/report/check_explorer.py build/explorer/index.html build/scallop [--screenshots FOLDER]

Exit codes: 0 all is well, 1 something is not (a line for each), 3 there is no browser or it fails, 4 no such file.
"""
import argparse
import json
import math
import random
import re
import shlex
import statistics
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree
from pathlib import Path
from urllib.parse import urlencode

sys.dont_write_bytecode = True
import browser  # noqa: E402  (nothing is written beside the sources)

COUNT, UNITS = 1000, 8  # crawlers; the bound of the error
REPORTS = {"Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"}
NAMES = ("froude", "v_start", "v_mid", "displacement", "mean_velocity", "multiplier")
CRAWLERS = Path(__file__).parents[2] / "tests/explorer/crawlers.js"
SIZES = {360: 740, 1280: 900}
LONGEST_WORK = 3000  # seconds of patience until the errors and the map of a long table are drawn
BEAT = """globalThis.beat = { last: performance.now(), gap: 0 }; setInterval(() => { const now = performance.now();
  beat.gap = Math.max(beat.gap, now - beat.last); beat.last = now; }, 20); 1"""
WORK = """(() => { const bar = document.getElementById('work'); return { shown: bar !== null && !bar.hidden,
  said: bar?.querySelector('span').textContent ?? '', part: bar?.querySelector('progress').value ?? 0, loud: document.getElementById('said').textContent }; })()"""
BUSY = "['map', 'curve', 'errors'].some((name) => globalThis.explorer?.work?.has(name))"
EVIL = "<img src=x onerror=document.title='broken'>.tsv"
SOLVE = """(() => { const { core } = explorer, tables = TABLES; return POINTS.map((p) => {
  core.chooseGait(p.gait.startsWith('measured') ? 'measured' : p.gait, { name: 'x', text: tables[p.gait] });
  core.chooseCrawler(p); const s = core.steady(); return [...NAMES.map((name) => s[name]), s.regime, s.modes]; }); })()"""


class Check:
    """The page in a browser, the command beside it, and the complaints."""

    def __init__(self, page, address, scallop):
        self.page, self.address, self.scallop, self.complaints, self.measured = page, address, scallop, [], []

    def expect(self, right, what):
        if not right:
            self.complaints.append(what)

    def load(self, fragment="", width=1280, scheme="light"):
        self.page.show("about:blank", width, SIZES[width], scheme)
        self.page.show(self.address + fragment, width, SIZES[width], scheme)
        self.settle()

    def settle(self, seconds=0.3):
        """Waits that long, and until all but a finer map is drawn."""
        self.page.run(
            f"new Promise((done) => {{ const look = () => {BUSY} ? setTimeout(look, 20) : requestAnimationFrame(() => done(1));"
            f" setTimeout(look, {1000 * seconds}); }})"
        )

    def reports(self, where):
        for event in self.page.events:
            method, details = event.get("method"), event.get("params", {})
            if method in REPORTS:
                entry = details.get("entry") or details.get("exceptionDetails") or details
                said = entry.get("exception", {}).get("description") or entry.get("text") or entry
                self.complaints.append(f"{where}: {method}: {str(said)[:300]}")
            elif method == "Network.requestWillBeSent":
                address = details["request"]["url"].split("#")[0]
                if address != self.address and not address.startswith(("data:", "blob:", "about:")):
                    self.complaints.append(f"{where}: a request for {address}")
        self.page.events.clear()

    def command(self, *arguments, **more):
        done = subprocess.run([self.scallop, *arguments, "--quiet"], capture_output=True, text=True, check=False, **more)
        self.expect(done.returncode == 0, f"scallop {shlex.join(arguments)}: {done.stderr.strip()}")
        header, *rows = [line.split("\t") for line in done.stdout.splitlines() if not line.startswith("#")]
        return [dict(zip(header, row)) for row in rows]

    def answers(self):
        """The steady state as the page shows it: number by name."""
        shown = self.page.run("[...document.querySelectorAll('#numbers div')].map((d) => [d.children[0].textContent, d.children[1].title])")
        return {name.replace(" ", "_").replace("Froude_number", "froude"): float(value) for name, value in shown}

    def same_as_command(self, where):
        """The page's numbers are those of the command that it shows."""
        words = shlex.split(self.page.run("explorer.commandOf({ ...explorer.state(), start: 'steady' })"))
        row, shown = self.command(*words[1:])[0], self.answers()
        for name in NAMES:
            wanted = float(row[name])
            near = abs(shown[name] - wanted) <= 1e-13 * max(abs(wanted), 1e-3)
            self.expect(near, f"{where}: {name} is {shown[name]}, of the command {wanted}")

    def numbers(self):
        """1000 random crawlers of all gaits, in the page and by the command."""
        text = CRAWLERS.read_text(encoding="utf-8").replace("export ", "")
        self.page.run(f"globalThis.tests = (() => {{ {text}; return {{ crawlers, measuredTable, random, unit }}; }})(); 1")
        with tempfile.TemporaryDirectory() as folder:
            gait = f"measured:{folder}/gait.tsv"
            table = self.page.run("tests.measuredTable(tests.random(9))")
            Path(folder, "gait.tsv").write_text(table, encoding="utf-8")
            points = self.page.run(f"tests.crawlers({COUNT}, [{json.dumps(gait)}], 4)")
            names = list(points[0])
            rows = ["\t".join(names), *("\t".join(repr(p[n]) if n != "gait" else p[n] for n in names) for p in points)]
            wanted = self.command("steady", "--points", "-", input="\n".join(rows) + "\n")
        tables = json.dumps({gait: table})
        parts = {"TABLES": tables, "POINTS": json.dumps(points), "NAMES": json.dumps(NAMES)}
        got = self.page.run(re.sub("TABLES|POINTS|NAMES", lambda match: parts[match[0]], SOLVE))
        self.expect(len(got) == len(wanted) == COUNT, f"{len(got)} crawlers of {len(wanted)}")
        equal = 0
        for point, row, answer in zip(points, wanted, got):
            for k, name in enumerate(NAMES):
                equal += answer[k] == float(row[name])
                if answer[k] != float(row[name]):
                    gait_of = json.dumps("measured" if point["gait"] == gait else point["gait"])
                    unit = self.page.run(
                        f"(explorer.core.chooseGait({gait_of}, {{ name: 'x', text: {json.dumps(table)} }}),"
                        f" tests.unit(explorer.core, {json.dumps(point)}, '{name}'))"
                    )
                    apart = abs(answer[k] - float(row[name])) / unit
                    self.expect(apart <= UNITS, f"{name} of {point}: {answer[k]}, {apart:.2f} units from the command's")
        self.measured.append(f"{equal} of {COUNT * len(NAMES)} numbers have the bits of the command")

    def box(self, selector):
        return self.page.run(
            f"(() => {{ const n = document.querySelector({json.dumps(selector)}); n.scrollIntoView({{ block: 'center' }});"
            " const b = n.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()"
        )

    def mouse(self, kind, x, y):
        buttons = {"mousePressed": 1, "mouseMoved": 1, "mouseReleased": 0}[kind]
        self.page.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=buttons, clickCount=1)

    def key(self, key, code, number, text=""):
        for kind in ("keyDown", "keyUp"):
            more = {"text": text} if kind == "keyDown" and text else {}
            self.page.ask("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=number, **more)

    def drag(self, selector, path):
        """Presses at the first of the places, parts of a box, and lets go at the last."""
        x, y, width, height = self.box(selector)
        places = [(x + a * width, y + b * height) for a, b in path]
        self.mouse("mousePressed", *places[0])
        for place in places:
            self.mouse("mouseMoved", *place)
        self.mouse("mouseReleased", *places[-1])
        self.settle()

    def state(self):
        return self.page.run("explorer.state()")

    def drags(self):
        before = self.state()
        self.drag("#slider-T", [(0.5, 0.5), (0.6, 0.5), (0.7, 0.5)])
        self.expect(self.state()["T"] != before["T"], "the slider of T cannot be dragged")
        self.same_as_command("after a drag of T")
        self.drag("#map .u-over", [(0.3 + k / 100, 0.6 - k / 200) for k in range(30)])
        after = self.state()
        self.expect(after["F1"] != before["F1"], "the crawler cannot be dragged in the map")
        self.same_as_command("after a drag in the map")
        self.page.run("document.getElementById('undo').click()")
        self.settle()
        self.expect(self.state()["F1"] == before["F1"], "a drag in the map cannot be undone")
        self.reports("drags")

    def solved(self, gait="quadratic"):
        """Milliseconds that a steady state of the command takes on this machine, with what reading and writing it takes."""
        begun, count = time.monotonic(), 50000
        self.command("steady", "--T", f"0.5:1.5:{count}", "--gait", gait, "--columns", "T,displacement")
        return 1000 * (time.monotonic() - begun) / count

    def frames(self, gait):
        """Measures, and does not judge: milliseconds that an update takes while alpha is dragged, and between frames; a cell of the map beside
        a steady state of the command."""
        solved = self.solved(gait)
        self.load(f"#gait={gait}")
        self.settle(2)
        self.page.run("document.getElementById('map-section').scrollIntoView({ block: 'center' })")
        took = self.page.run(
            "new Promise((done) => { const took = [], maps = [], between = []; let k = 0, last = performance.now(); const step = () => {"
            " const now = performance.now(); between.push(now - last); last = now; if (k) { took.push(explorer.took()); maps.push([explorer.map.n, explorer.map.took]); }"
            " if (k++ < 180) { explorer.change({ alpha: String(0.55 + 0.002 * k) }, false); requestAnimationFrame(step); }"
            " else done([took, maps, between]); }; requestAnimationFrame(step); })"
        )
        updates, maps, between = took
        update, each, frame = (statistics.median(x) for x in (updates[30:], [ms for _, ms in maps[30:]], between[30:]))
        side = maps[-1][0]
        self.measured.append(
            f"dragging alpha, {gait}, {side} cells a side: map {each:.1f} ms, all {update:.1f} ms, {frame:.1f} ms between frames (medians);"
            f" a cell takes {each / side**2 / solved:.2f} of what a steady state of the command takes"
        )
        self.until_fine()

    def until_fine(self):
        self.settle()
        self.expect(any(self.page.run("explorer.map.n") == 100 or self.settle() for _ in range(1000)), "the map stays coarse")

    def maps(self):
        """A map after each of many changes is that of a page that begins with them; and it is solved anew only where it changes."""
        seen = "(({ classes, values, what, n }) => [n, ...(what === 'modes' ? Array.from(classes, (id) => explorer.core.className(id)) : values)].filter((_, i) => i % 37 === 0))(explorer.map)"
        self.load()
        for change in ({"m2": "2"}, {"y": "alpha"}, {"T": "3"}, {"gait": "sinusoidal"}, {"show": "error"}, {"formula": "eq27_v_start"}, {"x": "m1/m2"}, {"F1": "9"}, {"gait": "skewed:0.2"}):
            self.page.run(f"explorer.change({json.dumps(change)})")
            self.until_fine()
            after, fragment = self.page.run(f"[{seen}, location.hash]")
            self.page.run(f"globalThis.classes = explorer.map.classes; explorer.change({{ m1: '{1 + len(change)}.5' }}, false)")
            self.settle()
            moved = "x=m1" in fragment
            self.expect(self.page.run("classes === explorer.map.classes") == moved, f"after {change} the map is {'' if moved else 'not '}solved again")
            self.page.run("explorer.change({ m1: '1' }, false)")
            self.load(fragment)
            self.until_fine()
            self.expect(self.page.run(seen) == after, f"the map after {change} is another than that of {fragment}")
        self.reports("maps")

    def keyboard(self):
        """Sliders, the map and the animation without a mouse; and no motion where none is wanted."""
        self.load()
        for focus, field in (("slider-T", "T"), ("map", "F1")):
            before = self.state()
            self.page.run(f"document.getElementById('{focus}').focus()")
            self.key("ArrowRight", "ArrowRight", 39)
            self.settle()
            self.expect(float(self.state()[field]) > float(before[field]), f"the right arrow in #{focus} does not change {field}")
        self.same_as_command("after keys")
        self.page.run("document.activeElement.blur()")
        self.expect(self.page.run("document.getElementById('play').textContent") == "Pause", "the crawler does not move at first")
        self.key(" ", "Space", 32, " ")
        self.expect(self.page.run("document.getElementById('play').textContent") == "Play", "the space bar does not pause")
        self.page.prefer(reduced_motion="reduce")
        self.page.ask("Page.reload")
        self.settle(1)
        self.expect(self.page.run("document.getElementById('play').textContent") == "Play", "the crawler moves where no motion is wanted")
        self.reports("keyboard")

    def presets(self):
        count = self.page.run("document.querySelectorAll('#presets option').length - 1")
        for i in range(count):
            self.page.run(f"(() => {{ const s = document.getElementById('presets'); s.value = '{i}'; s.dispatchEvent(new Event('change')); }})()")
            self.settle()
            where = f"preset {i}"
            self.expect(self.page.run("!document.getElementById('preset-note').hidden"), f"{where}: nothing is said")
            self.expect(not self.page.run("document.body.classList.contains('kept')"), f"{where}: a value is refused")
            self.same_as_command(where)
            self.reports(where)
        self.expect(count >= 10, f"{count} presets")

    def links(self):
        self.load("#F1=17.53&gait=sinusoidal&alpha=0.6&show=displacement&x=alpha&start=velocity&v0=2.5&formula=eqA25_dxC")
        first, numbers = self.state(), self.answers()
        fragment = self.page.run("explorer.change({ m1: '2.385' }); location.hash")
        self.settle()
        state = self.state()
        self.load(fragment)
        self.expect(self.state() == state and state["m1"] == "2.385", "a link does not restore the state")
        self.expect(first["gait"] == "sinusoidal" and numbers["first_v_end"] != 0, "a link is not taken")
        self.page.run("history.back !== undefined && explorer.change({ m1: '3' })")
        self.load("#F1=abc&T=&gait=%3Cimg%20src%3Dx%3E&nothing=1&x=T&y=nowhere&show=__proto__")
        self.expect("no gait" in self.page.run("document.getElementById('field-gait-wrong').textContent"), "an unknown gait in a link")
        self.load("#start=rest&periods=8;touch%20/tmp/X&order=%3Cb%3E&v0=$(id)")
        self.expect(self.state()["periods"] == "8" and self.state()["order"] == "8" and self.state()["v0"] == "0", "a link sets what is no number")
        evil = json.dumps({"start": "rest", "periods": "8;touch /tmp/X", "v0": "0;id"})
        words = shlex.split(self.page.run(f"explorer.commandOf({{ ...explorer.usual, ...{evil} }})"))
        self.expect(words[-1] == "8;touch /tmp/X", f"a value is several words of the command: {words}")
        self.expect("touch" not in self.page.run(f"explorer.sceneOf({{ ...explorer.usual, ...{evil} }})"), "a value is a member of the scene")
        self.reports("links")

    def choose(self, name, text):
        self.page.run(
            "(() => { const i = document.getElementById('gait-file'), d = new DataTransfer();"
            f" d.items.add(new File([{json.dumps(text)}], {json.dumps(name)})); i.files = d.files; i.dispatchEvent(new Event('change')); }})()"
        )

    def read(self, name, text):
        self.choose(name, text)
        self.settle()

    def measured_gaits(self):
        self.load()
        before = self.answers()
        self.read(EVIL, "0 0\n1 2\n0.5 x\n2 0\n")
        wrong = self.page.run("document.getElementById('field-gait-wrong').textContent")
        self.expect(wrong == f"{EVIL}:3: column 2, 'x', is not a finite number", f"a broken table: {wrong}")
        self.expect(self.answers() == before, "a broken table changes the answers")
        self.read(EVIL, "0 0\n1 1\n3 2\n4 0\n")
        self.settle()
        self.expect(self.state()["T"] == "4", "a table's own T is not taken")
        self.expect(not self.page.run("document.getElementById('recording-section').hidden"), "the recording is not shown")
        self.expect(self.page.run("document.querySelectorAll('img').length") == 0, "the name of a file became markup")
        self.expect(self.page.run("document.title") != "broken", "the name of a file was run")
        words = shlex.split(self.page.run("explorer.commandOf(explorer.state())"))
        self.expect(f"measured:{EVIL}" in words, f"the command has not the file: {words}")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, EVIL).write_text("0 0\n1 1\n3 2\n4 0\n", encoding="utf-8")
            row = self.command(*words[1:], cwd=folder)[0]
        shown = self.answers()
        self.expect(self.state()["L"] == row["L"], "a table's own L is not taken")
        # the curve through the rows is computed in long double, which has 113 bits in the page and 64 in the command
        self.expect(all(math.isclose(shown[n], float(row[n]), rel_tol=1e-12) for n in NAMES), f"a measured gait: {shown}, of the command {row}")
        state = self.state()
        self.load(self.page.run("location.hash"))
        self.expect(self.state() == state and self.answers() == shown, "a link does not restore a measured gait")
        picture = self.page.run("explorer.picture()")
        xml.etree.ElementTree.fromstring(picture)
        self.expect("<img" not in picture, "the name of a file became markup in the picture")
        self.reports("measured gaits")

    def watched(self, until, seconds=LONGEST_WORK):
        """What is said of the work, again and again until something is true of it."""
        seen, end = [self.page.run(WORK)], time.monotonic() + seconds
        while not until(seen) and time.monotonic() < end:
            self.pause(0.1)
            seen.append(self.page.run(WORK))
        return seen

    def pause(self, seconds):
        self.page.run(f"new Promise((done) => setTimeout(() => done(1), {1000 * seconds}))")

    def long_tables(self):
        """Measured gaits of 1000 rows, smooth and noisy: the page answers all the time, shows how far it is, and what it does can be stopped."""
        for noise in (0, 0.003):
            where, pick = f"1000 rows, noise {noise}", random.Random(3)
            inner = (10 * math.sin(math.pi * i / 999) ** 2 + 10 * noise * pick.gauss(0, 1) for i in range(1, 999))
            self.load()
            self.page.run(BEAT)
            self.choose("long.tsv", "".join(f"{i / 999!r}\t{l!r}\n" for i, l in enumerate((0.0, *inner, 0.0))))
            seen = self.watched(lambda seen: "Computing the errors" in seen[-1]["said"] or (len(seen) > 50 and not seen[-1]["shown"]), 60)
            seen += self.watched(lambda seen: not seen[-1]["shown"])
            gap = self.page.run("beat.gap")
            self.measured.append(f"{where}: {gap:.0f} ms is the longest time without an answer, {gap / self.solved():.0f} steady states of the command")
            parts = {one["part"] for one in seen if one["shown"] and "Computing" in one["said"]}
            self.expect(len(parts) > 2, f"{where}: {len(parts)} states of progress are shown: {seen[-1]}")
            self.expect(not seen[-1]["shown"], f"{where}: after {LONGEST_WORK} s it says {seen[-1]['said']}")
            self.reports(where)
        self.stopped()

    def stopped(self):
        """Escape and the button stop the work on a long table, the button goes on with it, and another input takes its place."""
        running = lambda seen: seen[-1]["shown"] and "Computing" in seen[-1]["said"]  # noqa: E731
        self.page.run("explorer.change({ m2: '5' })")  # a new map as well: the longest work
        self.expect(running(self.watched(running, 5)), "no progress is shown after another input")
        for m2, stop in (6, lambda: self.key("Escape", "Escape", 27)), (7, lambda: self.page.run("document.getElementById('work-stop')?.click()")):
            stop()
            self.pause(0.5)
            first = self.page.run(WORK)
            self.pause(1)
            later, pale = self.page.run(f"[{WORK}, document.querySelectorAll('section.older').length]")
            self.expect(first["said"].startswith("Stopped at ") and "Stopped" in first["loud"], f"the work is not stopped, or not said to be: {first}")
            self.expect(first["part"] == later["part"] and later["shown"], f"the work goes on after it was stopped: {first}, {later}")
            self.expect(pale > 0, "pictures from before look like those of the crawler")
            self.page.run("document.getElementById('work-stop')?.click()")
            goes_on = self.watched(lambda seen: not seen[-1]["said"].startswith("Stopped at "), 5)[-1]
            self.expect(not goes_on["said"].startswith("Stopped at "), f"the work does not go on: {goes_on}")
            self.page.run(f"explorer.change({{ m2: '{m2}' }})")
            self.expect(running(self.watched(running, 5)), "no progress is shown after a third input")
        before = self.answers()
        self.page.run("document.getElementById('usual').click()")
        self.settle()
        self.expect(self.answers() != before and self.page.run("!document.querySelector('section.older')"), "another input does not take the place of the work")
        self.same_as_command("after a long table")
        self.reports("stopped")

    def refused(self):
        self.load()
        before, picture = self.answers(), self.page.run("document.querySelector('.body1 rect').outerHTML.length")
        for name, text, said in (("alpha", "1", "between 0 and 1"), ("F1", "-3", "> 0"), ("T", "abc", "> 0"), ("m1", "1e999", "> 0"), ("T", "1e-200", "")):
            self.page.run(f"(() => {{ const f = document.getElementById('field-{name}'); f.value = '{text}'; f.dispatchEvent(new Event('change')); }})()")
            self.settle(0.1)
            wrong = self.page.run(f"document.getElementById('field-{name}-wrong').textContent")
            self.expect(wrong and said in wrong, f"{name} = {text}: it says '{wrong}'")
            self.expect(self.answers() == before and picture > 0, f"{name} = {text} changes the picture")
            self.page.run("document.getElementById('undo').click()")
            self.settle(0.1)
        self.reports("what is refused")

    def taken_along(self):
        for state in ({}, {"start": "rest", "periods": "3"}, {"start": "steady", "gait": "trapezoidal:0.2,0.3", "F1": "2.385", "m2": "0.7"}):
            self.page.run(f"explorer.change({json.dumps(state)})")
            self.settle()
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, "explorer.cfg").write_text(self.page.run("explorer.sceneOf(explorer.state())"), encoding="utf-8")
                done = subprocess.run([Path(self.scallop).resolve(), "run", "explorer.cfg", "--quiet"], cwd=folder, capture_output=True, text=True, check=False)
                self.expect(done.returncode == 0, f"the scene of {state}: {done.stderr}")
                if done.returncode != 0:
                    continue
                lines = [line.split("\t") for line in Path(folder, "explorer.tsv").read_text(encoding="utf-8").splitlines() if line[0] != "#"]
            if "v_start" in lines[0]:
                row, shown = dict(zip(*lines[:2])), self.answers()
                self.expect(all(abs(shown[n] - float(row[n])) <= 1e-11 * abs(shown[n]) for n in NAMES), f"the scene of {state}: {row}")
            self.command(*shlex.split(self.page.run("explorer.commandOf(explorer.state())"))[1:])
        self.reports("what is taken along")

    def legend(self):
        """Every region of a map is in its legend, the smaller ones under a heading that opens and stays open."""
        self.load("#gait=trapezoidal:0.1,0.3&F1=20&alpha=0.6&m2=3")
        self.settle(1)
        count = "new Set(explorer.map.classes.filter((id) => id >= 0)).size"
        regions, listed, head = self.page.run(f"[{count}, document.querySelectorAll('#legend span').length, document.querySelector('#legend summary')?.textContent]")
        self.expect(regions == listed > 13 and head.startswith(f"others ({regions - 12}), "), f"{regions} regions, {listed} in the legend, {head}")
        self.page.run("document.querySelector('#legend summary').click(); explorer.change({ alpha: '0.61' })")
        self.settle(1)
        self.expect(self.page.run(f"document.querySelector('#legend details').open && {count} === document.querySelectorAll('#legend span').length"), "the others do not stay open")
        self.reports("legend")

    def errors(self):
        """The T from which a formula and the derived series are off by 1 %, drawn absolutely and relatively, beside those of the command."""
        named = ("gait", "F1", "m2", "alpha", "order")
        for state in ({}, {"formula": "eq27_v_start", "order": "12"}, {"gait": "skewed:0.3", "F1": "2.385", "order": "6"},
                      {"gait": "sinusoidal", "alpha": "0.6", "m2": "3", "T": "0.3", "error": "relative"}):
            self.load("#" + urlencode(state))
            curves, quantity = self.page.run(
                "[[explorer.errors.main, explorer.errors.derived].map(({ exceeds, name, exact, value, absolute, relative }) =>"
                " ({ exceeds, name, exact: [...exact], value: [...value], absolute, relative })), explorer.errors.main.formula.quantity]"
            )
            rows = self.command("breakdown", "--only", "reach", "--quantity", quantity, "--tol", "0.01", *[f"--{n}={v}" for n, v in state.items() if n in named])
            note = self.page.run("document.getElementById('error-note').textContent")
            for curve in curves:
                series = "derived" if curve["name"].startswith("derived") else curve["name"]
                wanted = next(float(row["T"]) for row in rows if row["series"] == series)
                where = f"{state}, {curve['name']}"
                self.expect(wanted == 0 or abs(curve["exceeds"] / wanted - 1) < 1e-6, f"{where}: 1 % at T = {curve['exceeds']}, of the command {wanted}")
                self.expect((f"exceeds 1 % from T = {wanted:.6g} on" if wanted else "exceeds 1 % at every T shown") in note, f"{where}: the note has not T = {wanted}: {note}")
                drawn = curve[state.get("error", "absolute")]
                kept = [(d * (abs(x) if "error" in state else 1), abs(v - x)) for d, v, x in zip(drawn, curve["value"], curve["exact"]) if d is not None]
                self.expect(len(kept) > 50 and all(abs(d - off) <= 1e-12 * off for d, off in kept), f"{where}: other errors are drawn, {len(kept)}")
        self.reports("errors")

    def extremes(self):
        """Parameters of any size, gaits of all kinds and every choice: nothing breaks, and what is shown are the command's numbers."""
        self.load()
        choices = self.page.run("Object.fromEntries(['map-x', 'map-y', 'map-show', 'curve-of', 'start', 'gait-family'].map((id) => [id, [...document.getElementById(id).options].map((o) => o.value)]))")
        pick, shown = random.Random(11), 0
        for _ in range(20):
            state = {name: repr(10 ** pick.uniform(-30, 30)) for name in ("m1", "m2", "F1", "F2", "L", "T") if pick.random() < 0.6}
            state.update(alpha=repr(pick.choice((1e-9, 0.5, 0.999999, pick.random()))), start=pick.choice(choices["start"]), v0=repr(pick.gauss(0, 100)))
            state.update(gait=pick.choice(("quadratic", "sinusoidal", "trapezoidal:0.1,0.9", "skewed:0.01", "constant:0", "minimum-jerk", "polynomial:0,3,-2")))
            state.update(show=pick.choice(choices["map-show"]), of=pick.choice(choices["curve-of"]), x=pick.choice(("F1/F2", "m1/m2", "alpha")), y=pick.choice(("T", "froude")))
            self.page.run(f"explorer.change({{ ...explorer.usual, ...{json.dumps(state)} }})")
            self.settle(0.2)
            if not self.page.run("document.body.classList.contains('kept')"):
                shown += 1
                if state["gait"] not in ("minimum-jerk", "polynomial:0,3,-2"):  # evaluated in double, to 8 units
                    self.same_as_command(f"extremes {state}")
            self.reports(f"extremes {state}")
        self.expect(shown >= 10, f"{shown} of 20 extreme states are shown")

    def tables(self):
        """The curve as a table, of a crawler whose displacements cancel; and the picture as PNG."""
        self.load("#F1=79.8&x=alpha&y=T&of=displacement")
        table = self.page.run("explorer.finished(explorer.curve.table())")
        self.expect(table["names"][:2] == ["alpha", "displacement"], f"a table of {table['names']}")
        picked = list(zip(*table["rows"]))[::5]
        rows = self.command("steady", "--points", "-", "--F1", "79.8", input="\n".join(["alpha", *(repr(row[0]) for row in picked)]) + "\n")
        for row, wanted in zip(picked, rows):
            self.expect(abs(row[1] - float(wanted["displacement"])) <= 1e-13 * abs(row[1]), f"the curve at {row[0]}: {row[1]}, of the command {wanted}")
        self.expect(len(rows) == len(picked) > 25, "few rows")
        self.expect(self.page.run("explorer.png().then((blob) => blob.size)") > 20000, "no picture as PNG")
        self.reports("tables")

    def looks(self, folder):
        for width in SIZES:
            for scheme in ("light", "dark"):
                for name, fragment in (("steady", ""), ("rest", "#start=rest&T=4&gait=sinusoidal&show=displacement"), ("stuck", "#T=10&show=error")):
                    self.load(fragment, width, scheme)
                    self.settle(0.7)
                    wide = self.page.run("document.documentElement.scrollWidth")
                    self.expect(wide <= width, f"{width} px, {scheme}: the page is {wide} px wide")
                    if folder:
                        folder.mkdir(parents=True, exist_ok=True)
                        (folder / f"{width}-{scheme}-{name}.png").write_bytes(self.page.picture())
                    self.reports(f"{width} px, {scheme}")

    def unnamed(self):
        """Controls without a name for those who cannot see them."""
        names = self.page.run(
            "[...document.querySelectorAll('input, select, button, svg[role=img], [role=application]')].filter((n) => !n.getAttribute('aria-label')"
            " && !n.labels?.length && !n.textContent.trim()).map((n) => n.outerHTML.slice(0, 80))"
        )
        self.expect(not names, f"without a name: {names}")

    def all(self, folder):
        self.load()
        self.reports("at first")
        self.unnamed()
        self.numbers()
        self.drags()
        self.keyboard()
        self.frames("quadratic")
        self.frames("minimum-jerk")
        self.maps()
        self.presets()
        self.links()
        self.measured_gaits()
        self.long_tables()
        self.refused()
        self.taken_along()
        self.tables()
        self.legend()
        self.errors()
        self.extremes()
        self.looks(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("page", type=Path)
    parser.add_argument("scallop")
    parser.add_argument("--screenshots", type=Path, metavar="FOLDER", help="write what was seen as WIDTH-SCHEME-STATE.png")
    options = parser.parse_args()
    if not options.page.is_file():
        print(f"check_explorer.py: {options.page}: there is no such file", file=sys.stderr)
        return 4
    program = browser.installed()
    if program is None:
        print("check_explorer.py: there is no Chromium (Debian: chromium)", file=sys.stderr)
        return 3
    begun = time.monotonic()
    try:
        with browser.Browser(program) as page:
            check = Check(page, options.page.resolve().as_uri(), str(Path(options.scallop).resolve()))
            check.all(options.screenshots)
    except browser.Trouble as error:
        print(f"check_explorer.py: {error}", file=sys.stderr)
        return 3
    for line in check.measured:
        print(line)
    for complaint in check.complaints:
        print(f"{options.page}: {complaint}")
    print(f"{len(check.complaints)} complaints, {time.monotonic() - begun:.0f} s")
    return 1 if check.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
