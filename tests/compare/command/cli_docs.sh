#!/bin/sh
# The documents as pages: their length, their links, and what they repeat of the tool. Usage: sh tests/compare/command/cli_docs.sh build/scallop
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
cd "$root" || exit 1

# Lines of a document of more than 120 characters; tables, blocks of console and code, and pictures may be longer.
cat >"$scratch/long.py" <<'END'
import sys

for path in sys.argv[1:]:
    fenced = False
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        line = line.rstrip("\n")
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and len(line) > 120 and not line.lstrip().startswith(("|", "![")) and not line.startswith("    "):
            print(f"{path}:{number} has {len(line)} characters")
END
# Links to files that do not exist, or to headings that the document does not have
cat >"$scratch/links.py" <<'END'
import os
import re
import sys


def prose(path):
    return re.sub(r"^```.*?^```", "", open(path, encoding="utf-8").read(), flags=re.S | re.M)


def anchors(path):
    headings = re.findall(r"^#+ (.*)", prose(path), flags=re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


for path in sys.argv[1:]:
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(path)):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
        if not os.path.exists(file):
            print(f"{path}: no {target}")
        elif anchor and anchor not in anchors(file):
            print(f"{path}: {file} has no heading for #{anchor}")
END

[ "$(wc -l <README.md)" -le 150 ] || note "$(wc -l <README.md) lines"
finish "README.md has at most 150 lines"
long=$(/usr/bin/python3 "$scratch/long.py" README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md docs/*.md docs/*/*.md)
[ -z "$long" ] || note "$long"
finish "lines of documents have at most 120 characters"
broken=$(/usr/bin/python3 "$scratch/links.py" README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md docs/*.md docs/*/*.md)
[ -z "$broken" ] || note "$broken"
finish "links between documents resolve"
for page in docs/*.md docs/*/*.md; do
  [ "$page" = docs/README.md ] || grep -q -F "](${page#docs/})" docs/README.md || note "docs/README.md has no link to $page"
done
finish "the index has every document"
terms=$(grep '^| ' docs/glossary.md | grep -c -v -e '^| term ' -e '^|---')
[ "$terms" -le 40 ] || note "$terms terms"
[ "$terms" -ge 30 ] || note "only $terms terms found"
finish "the glossary has at most 40 terms"
versions=$(awk '/^## / { if (n > 60) print name ": " n " lines"; name = $0; n = 0 } { n++ } END { if (n > 60) print name ": " n " lines"; if (!name) print "none" }' CHANGELOG.md)
[ -z "$versions" ] || note "$versions"
finish "CHANGELOG.md has at most 60 lines a version"
grep -q "^version: $("$tool" --version | sed 's/^scallop \([^ ]*\).*/\1/')\$" CITATION.cff || note "$(grep '^version' CITATION.cff)"
finish "CITATION.cff has the version"
# Pages that the sources and texts name, beside links
git ls-files 2>/dev/null | grep -v -e '^CHANGELOG' -e '^tests/corpus/' | xargs grep -ohE '\bdocs/[a-z/-]+\.md\b' | sort -u >"$scratch/named"
[ "$(wc -l <"$scratch/named")" -ge 8 ] || [ ! -e .git ] || note "only $(wc -l <"$scratch/named") pages are named"
while read -r page; do
  [ -f "$page" ] || note "no $page, which $(git grep -l -F "$page" | head -n 1) names"
done <"$scratch/named"
finish "pages that the sources name are there"
sh scripts/dev/commands.sh "$tool" >"$scratch/commands.md"
cmp -s "$scratch/commands.md" docs/reference/commands.md || note "$(diff docs/reference/commands.md "$scratch/commands.md" | head -n 5); make docs"
finish "docs/reference/commands.md is what --help prints"
[ "$(wc -l <docs/reference/commands.md)" -le 620 ] || note "$(wc -l <docs/reference/commands.md) lines"
finish "docs/reference/commands.md has at most 620 lines"
differs=$(/usr/bin/python3 scripts/dev/pages.py --check) || note "$differs; make docs"
finish "pages have what follows from data, the paper's formulas and --help"
"$tool" claims --summary 2>"$scratch/counts" >/dev/null
grep -o -e '[0-9]* checks' -e '[0-9]* hold,' -e '[0-9]* errors fall faster than claimed' -e '[0-9]* are refuted' -e '[0-9]* statements in words' \
  -e '[0-9]* fail under some condition' "$scratch/counts" >"$scratch/phrases"
[ "$(wc -l <"$scratch/phrases")" -ge 6 ] || note "$(cat "$scratch/counts")"
while read -r phrase; do
  tr '\n' ' ' <README.md | tr -d '*' | tr -s ' ' | grep -q -F "$phrase" || note "README.md does not have: $phrase"
done <"$scratch/phrases"
finish "README.md counts the claims"
exit $failed
