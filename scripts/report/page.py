"""The whole page: one file that asks for nothing else, as its content security policy demands."""
import base64
import hashlib
from pathlib import Path

import sections
from markup import element, text

HERE = Path(__file__).parent
TITLE = "Crawling scallop: the paper against the exact motion"
PAPER = "https://arxiv.org/abs/1303.2669"


def fingerprint(source):
    return "'sha256-" + base64.b64encode(hashlib.sha256(source.encode()).digest()).decode() + "'"


def head(style, script):
    policy = (
        f"default-src 'none'; img-src data:; style-src {fingerprint(style)}; script-src {fingerprint(script)}; "
        "base-uri 'none'; form-action 'none'"
    )
    return element(
        "head",
        f"""
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<title>{text(TITLE)}</title>
<link rel="icon" href="data:,">
<style>{style}</style>
""",
    )


def contents():
    links = "".join(element("li", element("a", text(label), href="#" + name)) for name, label, _ in sections.SECTIONS)
    return element("nav", element("ol", links), aria_label="Contents") + "\n"


def opening():
    return (
        element(
            "header",
            f"""
<h1>Crawling scallop</h1>
<p class="subtitle">The paper against the exact motion</p>
<p>Two bodies on dry friction, joined by a mechanism that pushes them apart and pulls them together, can crawl, although they
have one degree of freedom and friction is the same in both directions. Wagner &amp; Lauga
(<a href="{PAPER}">arXiv:1303.2669</a>) explain it by expansions in the period <i>T</i>. Here their formulas stand beside the
motion solved exactly, event by event: which of them hold, what holds instead of the others, and how far any of them can be
trusted.</p>
""",
        )
        + "\n"
    )


def closing(version):
    return (
        element(
            "footer",
            f"""
<p>Made by <code>make reproduce</code> from the tables in <code>data/</code>{" of " + text(version) if version else ""}.
Commands are to be pasted in the folder that holds them. Every table can be sorted by its headings; missing numbers stay
last. This file asks the network for nothing.</p>
""",
        )
        + "\n"
    )


def page(inputs):
    style = (HERE / "page.css").read_text(encoding="utf-8")
    script = (HERE / "page.js").read_text(encoding="utf-8")
    comments = inputs.tables["claims"].comments
    body = contents() + element(
        "main",
        opening()
        + "".join(make(inputs) for _, _, make in sections.SECTIONS)
        + closing(comments[0] if comments else ""),
    )
    document = head(style, script) + "\n" + element("body", "\n" + body + f"\n<script>{script}</script>\n")
    return "<!DOCTYPE html>\n" + element("html", "\n" + document + "\n", lang="en") + "\n"
