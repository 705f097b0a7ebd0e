#!/usr/bin/python3
"""Looks at the page in headless Chromium, at the width of a phone, of a tablet and of a desktop, light and dark.

scripts/report/check_report.py build/report/index.html [--quick] [--screenshots FOLDER]

Nothing is said on the console and nothing is asked of the network; every figure is there, painted and not cut off; the page is no
wider than the window; no word of a table is clipped; text has contrast and size; the table of claims shows verdict and conditions of every row, and is filtered; the crawlers
move, and stand still where no motion is wanted.

Exit codes: 0 all is well, 1 something is not (a line for each), 2 bad usage, 3 there is no browser or it fails, 4 no such file.
"""
import argparse
import base64
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import browser  # noqa: E402  (nothing is written beside the sources)

SIZES = {390: 844, 800: 900, 1400: 900}
SCHEMES = ("light", "dark")
TEXT, TEXT_IN_TABLES, TEXT_IN_PLOTS = 14, 12, 9  # least pixels
SLICE = 2000  # pixels of height of a screenshot
REPORTS = {"Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"}


class Check:
    """A page in a browser, and the complaints about it."""

    def __init__(self, page, address):
        self.page, self.address, self.complaints, self.where = page, address, [], ""

    def complain(self, what):
        self.complaints.append(f"{self.where}: {what}")

    def call(self, name, *arguments):
        return self.page.run(f"audit.{name}({', '.join(map(repr, arguments))})")

    def load(self, width, scheme):
        self.where = f"{width} px, {scheme}"
        self.page.show(self.address, width, SIZES[width], scheme)
        self.page.run((Path(__file__).parent / "audit.js").read_text(encoding="utf-8") + "; true")

    def reports(self):
        """What the page said, and what it asked for beside itself."""
        for event in self.page.events:
            method, details = event.get("method"), event.get("params", {})
            if method in REPORTS:
                entry = details.get("entry") or details.get("exceptionDetails") or details
                self.complain(f"{method}: {entry.get('text') or entry.get('args') or entry}")
            elif method == "Network.requestWillBeSent":
                address = details["request"]["url"]
                if address.split("#")[0] != self.address and not address.startswith("data:"):
                    self.complain(f"a request for {address}")
        self.page.events.clear()

    def width(self):
        wide, window = self.call("width")
        if wide > window:
            self.complain(f"the page is {wide} px wide in a window of {window}")

    def figures(self):
        pictures = self.call("pictures")
        if not pictures:
            self.complain("there is no figure")
        for picture in pictures:
            name = picture["name"] or "a figure without a name"
            if not picture["name"]:
                self.complain(name)
            if picture["width"] <= 100 or picture["height"] <= 100:
                self.complain(f"{name}: {picture['width']:.0f} x {picture['height']:.0f} px")
                continue
            if picture["cut"]:
                self.complain(f"{name}: cut off by its frame")
            if picture["box"][2] <= 0:
                self.complain(f"{name}: beside its frame, out of sight")
                continue
            painted = self.call("painted", base64.b64encode(self.page.picture(picture["box"])).decode())
            if painted["colours"] < 3 or painted["common"] > 0.999:
                self.complain(
                    f"{name}: blank, {painted['colours']} colours, one on {100 * painted['common']:.1f} % of it"
                )

    def motion(self, scheme):
        """The crawlers move, unless they are stopped or the reader wants no motion, as from here on."""
        if min(self.call("moved")) < 1:
            self.complain("a crawler does not move")
        self.page.run("document.getElementById('still').click()")
        if max(self.call("moved")) > 0:
            self.complain("a crawler does not stop")
        self.page.prefer(color_scheme=scheme, reduced_motion="reduce")
        self.page.run("document.getElementById('still').click()")
        if max(self.call("moved")) > 0:
            self.complain("a crawler moves where no motion is wanted")

    def filtering(self):
        for verdict in ("holds", "sharper", "refuted"):
            got = self.call("filtered", f'.tally a[data-verdict="{verdict}"]')
            if not got["shown"] == got["wanted"] == got["said"] or not got["says"].startswith(f"{got['shown']} of "):
                self.complain(
                    f"the link to what {verdict} says {got['said']}, the table of claims shows {got['shown']} of "
                    f"{got['wanted']} rows and says '{got['says']}'"
                )

    def screenshots(self, folder, width, scheme):
        size = self.page.ask("Page.getLayoutMetrics")["cssContentSize"]
        folder.mkdir(parents=True, exist_ok=True)
        for number, top in enumerate(range(0, int(size["height"]), SLICE), 1):
            box = (0, top, width, min(SLICE, size["height"] - top))
            (folder / f"{width}-{scheme}-{number:02}.png").write_bytes(self.page.picture(box))

    def all(self, folder, quick):
        """quick: the phone in the dark."""
        for width in SIZES:
            for scheme in SCHEMES:
                if quick and (width, scheme) != (390, "dark"):
                    continue
                self.load(width, scheme)
                self.motion(scheme)
                self.width()
                self.figures()
                if folder:
                    self.screenshots(folder, width, scheme)
                self.call("open")
                self.width()
                for what in (
                    self.call("texts", TEXT, TEXT_IN_TABLES) + self.call("plotTexts", TEXT_IN_PLOTS) + self.call("colours")
                    + self.call("claimTables") + self.call("clipped") + self.call("overlaps")
                ):
                    self.complain(what)
                self.filtering()
                self.reports()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("page", type=Path)
    parser.add_argument(
        "--quick", action="store_true", help="at the width of a phone, dark"
    )
    parser.add_argument(
        "--screenshots", type=Path, metavar="FOLDER", help="write what was seen as WIDTH-SCHEME-NUMBER.png"
    )
    options = parser.parse_args()
    if not options.page.is_file():
        print(f"check_report.py: {options.page}: there is no such file", file=sys.stderr)
        return 4
    program = browser.installed()
    if program is None:
        print("check_report.py: there is no Chromium (Debian: chromium)", file=sys.stderr)
        return 3
    try:
        with browser.Browser(program) as page:
            check = Check(page, options.page.resolve().as_uri())
            check.all(options.screenshots, options.quick)
    except browser.Trouble as error:
        print(f"check_report.py: {error}", file=sys.stderr)
        return 3
    for complaint in check.complaints:
        print(f"{options.page}: {complaint}")
    return 1 if check.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
