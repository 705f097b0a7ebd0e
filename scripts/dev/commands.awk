# Writes pages of help in Markdown: awk -f scripts/dev/commands.awk PAGE...
# scripts/dev/man.awk describes the lines of a page. What an earlier page has, too, is named, with a link to that page.

function wrapped(text, first, others,   words, count, line, i) {
  count = split(text, words, " ")
  line = first words[1]
  for (i = 2; i <= count; i++)
    if (length(line) + 1 + length(words[i]) > 120) {
      print line
      line = others words[i]
    } else
      line = line " " words[i]
  print line
}
function link(to,   anchor) {
  anchor = to
  gsub(/ /, "-", anchor)
  sub(/^scallop (help )?/, "", to)
  return "[" to "](#" anchor ")"
}
function marked(text,   done) { # what Markdown would take for its own, and links to topics
  gsub(/[*<]/, "\\\\&", text)
  while (match(text, /scallop help [a-z]+/)) {
    done = done substr(text, 1, RSTART - 1) link(substr(text, RSTART, RLENGTH))
    text = substr(text, RSTART + RLENGTH)
  }
  return done text
}
function entry(names, text) {
  name[++entries] = names
  about[entries] = text
}
function shown(i) { return name[i] (name[i] != "" && about[i] != "" ? ": " : "") marked(about[i]) }

# Names the entries that earlier pages have.
function name_repeated(   i, key, pages, page, names) {
  for (i = 1; i <= entries; i++) {
    key = name[i] "\n" about[i]
    if (name[i] == "" || about[i] == "")
      continue
    if (!(key in first))
      first[key] = title
    if (first[key] == title)
      continue
    if (!(first[key] in names))
      page[++pages] = first[key]
    names[first[key]] = names[first[key]] " " name[i]
    name[i] = about[i] = ""
  }
  for (i = 1; i <= pages; i++)
    entry(substr(names[page[i]], 2) (index(heading, page[i]) ? "" : " as in " link(page[i])), "")
}
# Short paragraphs are items of a list, with another mark than the entries of a group before them.
function paragraph(text, is_short) {
  if (!(is_short && was_short))
    print ""
  wrapped(text, is_short ? "- " : "", is_short ? "  " : "")
  was_short = is_short
}
function list(   i, listed) {
  print heading == "" ? "" : "\n**" marked(heading) "**:"
  for (i = 1; i <= entries; i++) {
    if (name[i] == "" && listed)
      print ""
    listed = name[i] != ""
    wrapped(shown(i), listed ? "* " : "", listed ? "  " : "")
  }
  was_short = 0
}
# Prints a group: a heading with entries, or a paragraph.
function flush(   i, all, line, kept, texts) {
  for (i = 1; i <= entries; i++)
    all = all "\n" name[i] "\n" about[i]
  if (heading == "" && entries == 1)
    paragraph(shown(1), 0)
  else if (heading == "" && entries)
    list()
  else if (all in first && first[all] != title) {
    if (!(first[all] in as_in))
      source[++sources] = first[all]
    as_in[first[all]] = as_in[first[all]] ", " group
  } else if (heading != "") {
    first[all] = title
    name_repeated()
    for (i = 1; i <= entries; i++)
      if (name[i] about[i] != "") {
        line = line (!kept++ ? "" : name[i] == "" || line ~ /\.$/ ? " " : "; ") shown(i)
        texts += about[i] != ""
        name[kept] = name[i]
        about[kept] = about[i]
      }
    entries = kept
    line = "**" marked(heading) "**: " line (line ~ /\.$/ ? "" : ".")
    if (!texts || length(line) < 360)
      paragraph(line, 1)
    else
      list()
  }
  heading = group = ""
  entries = 0
}
function finish(   i, line) {
  flush()
  for (i = 1; i <= sources; i++)
    line = line (i == 1 ? "As" : "; as") " in " link(source[i]) ": " substr(as_in[source[i]], 3)
  if (line != "")
    paragraph(line ".", 1)
  split("", as_in)
  sources = was_short = 0
}
function begin(usage, summary) { # "scallop steady [options]", "scallop help options"
  finish()
  title = usage
  sub(/ [^a-z].*/, "", title)
  print "\n## " title
  head = (usage == title ? toupper(substr(summary, 1, 1)) substr(summary, 2) : "`" usage "`: " summary) "."
}

FNR == 1 { begin(substr($0, 1, index($0, ": ") - 1), substr($0, index($0, ": ") + 2)); next }
/^Example: / { paragraph(head " Example: `" substr($0, 10) "`.", 0); next }
!NF { flush(); next }
/^Exit codes: / { heading = group = "Exit codes"; sub(/^Exit codes: /, "") }
!entries && heading == "" && /^[^ ].*:$/ {
  heading = group = substr($0, 1, length - 1)
  sub(/ \(.*/, "", group)
  next
}
{
  line = $0
  sub(/^ +/, "", line)
  gap = index(line, "  ")
}
/^  [^ ]/ && gap && title == "scallop" && heading ~ /^(Commands|Topics)$/ {
  entry(link((heading == "Topics" ? "scallop help " : "scallop ") substr(line, 1, gap - 1)), "")
  next
}
/^  [^ ]/ && gap {
  names = substr(line, 1, gap - 1)
  line = substr(line, gap)
  sub(/^ +/, "", line)
  entry("`" names "`", line)
  next
}
/^  --/ { # options that a topic explains
  gsub(/[^ ]+/, "`&`", line)
  if (entries && name[entries] ~ /^`--/ && about[entries] == "")
    name[entries] = name[entries] " " line
  else
    entry(line, "")
  next
}
entries && (/^   / || name[entries] == "") { about[entries] = about[entries] " " line; next }
{ entry("", line) }
END { finish() }
