#!/bin/sh
# The page of all results: scripts/report/report.py. Usage: sh tests/compare/command/cli_report.sh build/scallop
# With Chromium installed it is looked at as well; `make check-report` looks at the real one, with the plots of gnuplot.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

figures='figure2 figure3 figure4 figure5 errors workprec stress map_regimes map_reach map_velocity
found_order found_zero found_peak found_froude found_alpha found_sign'
mkdir plots scenes
for name in $figures; do # with the names that gnuplot gives in every file, a colour it sets, what must be escaped, and what must not be there
  cat >"plots/$name.svg" <<'END'
<?xml version="1.0" encoding="utf-8" standalone="no"?>
<svg width="900" height="380" viewBox="0 0 900 380"
  xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink">
<title>Gnuplot</title>
<g id="gnuplot_canvas"><rect x="0" y="0" width="900" height="380" fill="#ffffff"/>
<defs><circle id='gpPt5' stroke-width='0.222' stroke='currentColor' cx='0' cy='0' r='1'/>
<use xlink:href='#gpPt5' id='gpPt6' fill='currentColor'/></defs>
<g fill="none" color="#FFFFFF" stroke="currentColor" stroke-width="1.00"></g>
<g id="gnuplot_plot_1" ><title>one</title><g fill="none" color="black" stroke="currentColor" stroke-width="2.00">
<path stroke='rgb( 11,  60, 140)'  d='M20.00,20.00 L800.25,360.55  '/>
<path stroke='black'  d='M20.00,360.00 L800.25,20.55  '/>
<use xlink:href='#gpPt6' transform='translate(121.64,106.80) scale(4.50)' color='rgb(200,  16,  46)'/></g></g>
<g stroke='none'><polygon fill = 'rgb(217, 231, 247)' points = '100,80 200,80 200,40 100,40 '/>
<polygon fill = 'rgb(217, 231, 247)' points = '190,80 300,80 300,40 190,40 '/></g>
<g transform="translate(64.14,326.30)" stroke="none" fill="black" font-family="DejaVu Sans" font-size="12.00">
<text onclick="alert(1)"><tspan font-family="DejaVu Sans" >a &lt; b &amp; c</tspan></text></g>
<script>alert(2)</script><a href="https://example.org/"><text>away</text></a><use xlink:href="https://example.org/#a"/>
</g></svg>
END
  case $name in found_* | stress) sed -i 's/"900"/"450"/g; s/0 0 900/0 0 450/' "plots/$name.svg" ;; esac # one panel
done
for table in "$root"/data/*.tsv; do
  printf '# of %s, with <b> & "quotes"\n' "$(basename "$table")" >"scenes/$(basename "$table" .tsv).cfg"
done
report() { # CODE OPTION...
  wanted=$1
  shift
  /usr/bin/python3 "$root/scripts/report/report.py" "$@" >out 2>err
  code=$?
  [ "$code" = "$wanted" ] || note "report.py $* gives exit code $code, not $wanted: $(tail -n 2 err)"
}
say() { grep -q -e "$1" err || note "no '$1' on standard error: $(tail -n 1 err)"; }

report 0 --tables "$root/data" --plots plots --scenes scenes --output page/index.html
[ ! -s err ] || note "on standard error: $(head -n 2 err)"
[ ! -s out ] || note "on standard output: $(head -n 2 out)"
finish 'report: written, without a word'

cat >parse.py <<'END'
import html.parser, re
class Page(html.parser.HTMLParser):
    """Elements as a list of (name, attributes); complains of tags that do not match."""
    void = {"meta", "link", "br", "wbr", "input"}
    def __init__(self, source):
        super().__init__()
        self.open, self.elements, self.wrong, self.words = [], [], [], []
        self.feed(source)
        self.close()
        self.wrong += [f"<{name}> is not closed" for name in self.open]
    def handle_starttag(self, name, attributes):
        self.elements.append((name, dict(attributes)))
        if name not in self.void:
            self.open.append(name)
    def handle_startendtag(self, name, attributes):
        self.elements.append((name, dict(attributes)))
    def handle_endtag(self, name):
        if not self.open or self.open.pop() != name:
            self.wrong.append(f"</{name}> at {self.getpos()}")
    def handle_data(self, data):
        self.words.append(data)
source = open("page/index.html", encoding="utf-8").read()
page = Page(source)
END
python() { # as in common.sh, with the page parsed
  cat tables.py parse.py - >program.py
  /usr/bin/python3 program.py "$@" >said 2>&1 || note "python: $(tail -n 1 said)"
  [ ! -s said ] || note "$(head -n 3 said)"
}
python <<'END'
if page.wrong:
    bad(*page.wrong[:3])
names = [given["id"] for _, given in page.elements if "id" in given]
twice = {name for name in names if names.count(name) > 1}
if twice:
    bad("ids that are not unique:", *sorted(twice))
links = [given["href"] for name, given in page.elements if given.get("href", "").startswith("#")]
links += ["#" + target for target in re.findall(r"url\(#([^)]*)\)", source)]
for link in links:
    if link[1:] not in names:
        bad("no target of", link)
END
finish 'report: tags match, ids are unique, links within the page have targets'

python <<'END'
for name, given in page.elements:
    for key, value in given.items():
        if key in ("src", "srcset", "data", "poster", "xlink:href", "style") or key.startswith("on"):
            bad(f"<{name} {key}>")
        cited = name == "a" and value.startswith("https://arxiv.org/")
        if key == "href" and not (cited or value.startswith(("#", "data:"))):
            bad(f"<{name} href={value[:60]}>")
policy = [given["content"] for _, given in page.elements if given.get("http-equiv") == "Content-Security-Policy"]
if len(policy) != 1 or "default-src 'none'" not in policy[0] or "unsafe" in policy[0] or "http" in policy[0]:
    bad("policy:", *policy)
if re.search(r"@import|@font-face", source):
    bad("a style that loads")
END
finish 'report: nothing is loaded, and the policy forbids it'

"$tool" claims --summary 2>summary >/dev/null
python "$root/data" "$figures" <<'END'
import os, urllib.parse
figures = ["journey", *sys.argv[2].split()]
there = [given.get("id") for name, given in page.elements if name == "figure"]
if sorted(there) != sorted(figures):
    bad("figures:", *there)
pictures = [given for name, given in page.elements if name == "svg" and given.get("role") == "img"]
if len(pictures) != 23 or not all(given.get("aria-label") for given in pictures):
    bad(len(pictures), "pictures, some without a label")
files = {given["download"]: given["href"] for _, given in page.elements if "download" in given}
wanted = sorted(os.listdir(sys.argv[1]))
wanted = [name for name in wanted if name.endswith(".tsv")]
if sorted(files) != wanted:
    bad("tables:", *sorted(files))
for name in wanted:
    given = urllib.parse.unquote(files[name].split(",", 1)[1])
    if given != open(os.path.join(sys.argv[1], name), encoding="utf-8").read():
        bad(name, "is not what is downloaded")
ledger = read(os.path.join(sys.argv[1], "claims.tsv"))
whole = source[source.index('id="ledger-table"'):]
rows = re.findall(r'<tr data-verdict="(\w+)" data-scope="(\w+)">', whole)
scope = lambda row: "corrected" if row["source"] == "corrected" else "outside" if row["inside"] != "yes" else "paper" if row["derived_order"] != "-" else "words"
if sorted(rows) != sorted((row["verdict"], scope(row)) for row in ledger):
    bad("the ledger has other verdicts than the table, or other rows")
inside = [row["verdict"] for row in ledger if scope(row) == "paper"]
for verdict in ("holds", "sharper", "refuted", "undecided"):
    if not re.search(rf'<li class="{verdict}"><a [^>]*><b>{inside.count(verdict)}</b>', source):
        bad(verdict, "is not counted as", inside.count(verdict))
# Counted as `scallop claims --summary` counts: checks of formulas, and one verdict for each statement in words
said = " ".join("".join(page.words).split())
checks, words = ([int(n) for n in re.findall(r"\d+", line)] for line in open("summary", encoding="utf-8") if re.search(" checks of | statements in ", line))
wanted = "Of %d statements in words %d fail under some condition, and %d hold in all that was looked at: " % (words[0], words[1], words[3])
wanted += "%d are proven, %d certified for one crawler, %d sampled and %d measured in doubles." % tuple(words[4:])
if len(inside) != checks[0] or f"its formulas make {checks[0]} checks" not in said or wanted not in said:
    bad("not", checks[0], "checks, or not:", wanted)
if whole.count('<span class="note">(proven for all parameters)</span>') != sum(row["evidence"] == "proven for all parameters" for row in ledger):
    bad("rows do not say how they are known")
END
finish 'report: every figure, every table, and the counts of the ledger'

python <<'END'
for text in ("a &lt; b &amp; c", "&lt;b&gt; &amp; &#34;quotes&#34;", "d(&lt;U&gt; T/L)"):
    if text not in source:
        bad("not escaped, or not there:", text)
if re.search(r"rgb\(|Gnuplot|gnuplot_|DejaVu Sans,", source):
    bad("left of gnuplot:", re.search(r"rgb\(|Gnuplot|gnuplot_|DejaVu Sans,", source)[0])
if 'd="M100,80L200,80L200,40L100,40zM190,80L300,80L300,40L190,40z"' not in source:
    bad("boxes of one colour are not joined")
END
finish 'report: cells, scenes and labels are escaped, colours have names'

# Whatever a file says stays text: a ledger, a scene, a book and a plot that try.
mkdir odd odd/scenes
cp "$root"/data/*.tsv odd/
cp scenes/*.cfg odd/scenes/
evil='<img src=x onerror=alert(3)>"</script><b>'
sed "s|text_steady_xC|$evil|; s|extension from rest|$evil|; s|^# parameters: .*|# parameters: m1=$evil gait=$evil|" "$root/data/claims.tsv" >odd/claims.tsv
sed "s|-m2/M\*(l_end - l_start)|<script>alert(4)</script>|; s|l_end|$(printf '%s' "$evil" | tr -d '"')|" "$root/asymptotics/published/paper.cfg" >odd/paper.cfg
for scene in odd/scenes/*.cfg; do printf '%s\n' "$evil" >>"$scene"; done
report 0 --tables odd --plots plots --scenes odd/scenes --book odd/paper.cfg --output page/index.html
python <<'END'
names = [name for name, _ in page.elements]
if names.count("script") != 1 or "img" in names or page.wrong:
    bad("markup from a file:", names.count("script"), "scripts", *page.wrong[:1])
for name, given in page.elements:
    if any(key.startswith("on") for key in given) or "example.org" in given.get("href", ""):
        bad("from a plot:", name, given)
if "onerror=alert(3)&gt;" not in source or "alert(4)" not in source or "alert(2)" in source:
    bad("a text is missing, or too much")
END
finish 'report: what comes from files cannot be markup'

# The formulas of the book, typeset, mean what their texts do: read back from MathML, they have the same values.
python "$root" <<'END'
import pathlib, random, xml.etree.ElementTree as tree
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1] + "/scripts/report")
import book
shown = {"α": "alpha", "ΔT": "dT", "l(0)": "l_start", "l(T)": "l_end", "x(T−ΔT)": "x_switch", "ẋ0": "v0", "m*": "mstar"}
def read_back(node):
    words = "".join(node.itertext())
    if words in shown and node.tag != "math":
        return shown[words]
    parts = [read_back(child) for child in node]
    if node.tag in ("mfrac", "msup"):
        return "((%s)%s(%s))" % (parts[0], {"mfrac": "/", "msup": "**"}[node.tag], parts[1])
    return words if node.tag == "msub" else "".join(parts) or {"\u2062": "*", "−": "-"}.get(words, words)
formulas = book.read(pathlib.Path(sys.argv[1], "asymptotics/published/paper.cfg"))
random.seed(28)
for name, formula in formulas.items():
    text = formula["text"].replace("^", "**").replace("L_kin", "Lkin")
    values = {word: random.uniform(0.5, 2) for word in re.findall(r"[A-Za-z_]\w*", text)}
    back = read_back(tree.fromstring("<math>%s</math>" % str(book.typeset(formula["text"])).replace("&#x2062;", "\u2062")))
    if not near(eval(text, dict(values)), eval(back, dict(values)), 1e-12):
        bad(name, formula["text"], "became", back)
if len(formulas) < 60:
    bad(len(formulas), "formulas")
END
finish 'report: formulas are typeset as they are'

# Links into the explorer, where it is, with the parameters of each figure
mkdir explorer
touch explorer/index.html
report 0 --tables "$root/data" --plots plots --scenes scenes --output page/index.html
links='href="../explorer/index.html#m1=1&amp;m2=1&amp;F1=4&amp;F2=1&amp;L=10&amp;T=2&amp;gait=quadratic&amp;alpha=0.75&amp;start=rest"'
grep -q -F "$links" page/index.html || note "no link to the explorer at figure 2"
sed -n '/<nav/,/<.nav>/p' page/index.html | grep -q -F '<a href="../explorer/index.html">Explorer</a>' || note "no link to the explorer among the contents"
report 0 --tables "$root/data" --plots plots --scenes scenes --output new/index.html
cmp -s page/index.html new/index.html || note "another page in a folder that was not there"
rm -r explorer new
report 0 --tables "$root/data" --plots plots --scenes scenes --output page/index.html
! grep -q explorer/index page/index.html || note "a link to an explorer that is not there"
grep -q 'Explorer: <code>make explorer</code>' page/index.html || note "nothing says how to get the explorer"
finish 'report: links into the explorer'

cp page/index.html first.html
mkdir elsewhere
cp -r plots scenes elsewhere/
(cd elsewhere && report 0 --tables "$root/data" --plots plots --scenes scenes --output index.html)
cmp -s first.html elsewhere/index.html || note "another page from another folder"
! grep -q -e "$root" -e "$scratch" first.html || note "the page has a path of the machine"
[ "$(wc -c <first.html)" -lt 5000000 ] || note "$(wc -c <first.html) bytes"
finish 'report: the same bytes, without a path, below 5 MB'

cp plots/figure3.svg kept.svg
sed -i 's/a &lt; b &amp; c/]]\&gt; \&lt;b> "q"/' plots/figure3.svg
cp scenes/figure3.cfg kept.cfg
printf '# ]]> <i>\001\033[31m \302\205\n' >>scenes/figure3.cfg
cp -r "$root/data" marked
/usr/bin/python3 - "$root/data/claims.tsv" >said 2>&1 <<'END' || note "$(tail -n 1 said)"
import sys
lines = open(sys.argv[1], encoding="utf-8").read().split("\n")
names = next(line for line in lines if not line.startswith("#")).split("\t")
last = lines[-2].split("\t")
last[names.index("reason")] = "<u>]]> \f\x1e\x85 x"
open("marked/claims.tsv", "w", encoding="utf-8").write("\n".join(lines[:-2] + ["\t".join(last), ""]))
END
report 0 --tables marked --plots plots --scenes scenes --output marked/index.html
/usr/bin/python3 - >said 2>&1 <<'END' || note "$(tail -n 1 said)"
import re, sys
page = open("marked/index.html", encoding="utf-8", newline="").read()
found = re.search("[\0-\x08\x0b-\x1f\x7f-\x9f]", page)
missing = [text for text in ("]]&gt; &lt;i&gt;??[31m ?", "&lt;u&gt;]]&gt; ??? x", "]]&gt; &lt;b&gt;") if text not in page]
sys.exit(f"control characters: {found}" if found else f"not in the page: {missing}" if missing else 0)
END
mv kept.svg plots/figure3.svg
mv kept.cfg scenes/figure3.cfg
finish 'report: markup and control characters in tables, scenes and plots are text'

cp page/index.html before.html
mv plots/figure3.svg moved.svg
report 4 --tables "$root/data" --plots plots --scenes scenes --output page/index.html
say 'plots/figure3.svg: No such file'
echo '<svg' >plots/figure3.svg
report 4 --tables "$root/data" --plots plots --scenes scenes --output page/index.html
say 'plots/figure3.svg'
mv moved.svg plots/figure3.svg
mkdir tables
cp "$root"/data/*.tsv tables/
printf 'a\tb\n1\n' >tables/figure2.tsv
report 4 --tables tables --plots plots --scenes scenes --output page/index.html
say 'figure2.tsv: row 1 has 1 cells where the header has 2'
rm tables/figure2.tsv
report 4 --tables tables --plots plots --scenes scenes --output page/index.html
say 'figure2.tsv: No such file'
cp "$root/data/figure2.tsv" tables/
report 4 --tables tables --plots plots --scenes nowhere --output page/index.html
say 'nowhere/.*.cfg: No such file'
report 2 --tables "$root/data"
cmp -s before.html page/index.html || note "the earlier page is not what it was"
[ "$(ls page)" = index.html ] || note "left behind: $(ls page)"
finish 'report: bad input is refused, and an earlier page stays'

for browser in chromium chromium-browser google-chrome ''; do
  [ -z "$browser" ] || ! command -v "$browser" >/dev/null 2>&1 || break
done
if [ -n "$browser" ]; then
  /usr/bin/python3 "$root/scripts/report/check_report.py" --quick first.html >out 2>err || note "$(head -n 3 out err)"
  sed 's/<\/style>/svg{visibility:hidden}p{color:#555}main{min-width:2000px}.ledger td:first-child{display:none !important}<\/style>/
    s/style-src [^;]*;/style-src '"'unsafe-inline'"';/' first.html >bad.html
  /usr/bin/python3 "$root/scripts/report/check_report.py" --quick bad.html >out 2>err
  code=$?
  [ $code = 1 ] || note "exit code $code for a page that is bad"
  for complaint in 'blank, 1 colours' 'contrast' 'the page is 20.. px wide in a window of' 'out of sight'; do
    grep -q "$complaint" out || note "no complaint: $complaint"
  done
  finish 'report: looked at in Chromium'
fi
exit $failed
