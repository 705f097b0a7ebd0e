# Makes a page of the manual from what --help prints:
#   scallop steady --help | awk -v page=scallop-steady -v version="scallop 1.0" -f scripts/dev/man.awk
# A heading is a line such as "Commands:" or "Options (...):". A line "  name  text" is an item of a list, and so is "name: text"
# after the end of a sentence.

function roff(s) { # quotes in `...` and options are bold
  gsub(/\\/, "\\(rs", s)
  gsub(/-/, "\\-", s)
  gsub(/'/, "\\(aq", s)
  gsub(/\^/, "\\(ha", s)
  gsub(/~/, "\\(ti", s)
  while (match(s, /`[^`]+`/))
    s = substr(s, 1, RSTART - 1) "\\fB" substr(s, RSTART + 1, RLENGTH - 2) "\\fR" substr(s, RSTART + RLENGTH)
  gsub(/\\-\\-[A-Za-z][A-Za-z0-9_]*(\\-[a-z]+)*/, "\\fB&\\fR", s)
  return s ~ /^\./ ? "\\&" s : s
}

{ sub(/ +$/, "") }
NR == 1 { example = substr($0, length("Example: ") + 1) }
NR <= 2 { next }

# scallop NAME [options]: summary.
!opened && NF { usage = usage " " $0; next }
!opened {
  colon = index(usage, ": ")
  print ".TH " roff(toupper(page)) " 1 \"\" \"" version "\" \"The crawling\\-scallop toolkit\""
  print ".SH NAME\n" roff(page) " \\- " roff(substr(usage, colon + 2, length(usage) - colon - 2))
  print ".SH SYNOPSIS\n\\fB" roff(substr(usage, 2, colon - 2)) "\\fR"
  opened = ended = 1
  next
}

/^(Commands|Quantities .*|Gaits .*|Options .*|Exit codes):$/ {
  print ".SH " toupper(substr($0, 1, length - 1))
  titled = 1
  commands = /^Commands/
  broken = indented = 0
  next
}
!NF { broken = ended = 1; commands = 0; next }
{
  if (!titled++) {
    print ".SH DESCRIPTION"
    broken = 0
  }
  name = ""
  text = $0
  gap = index(substr($0, 3), "  ")
  if (/^  [^ ]/ && gap) {
    name = substr($0, 3, gap - 1)
    text = substr($0, gap + 2)
  } else if (ended && /^(--)?[a-z0-9][^.:;]*:( |$)/) {
    name = substr($0, 1, index($0, ":") - 1)
    text = substr($0, index($0, ":") + 1)
  }
  if (name != "")
    print ".TP\n" (name ~ /^--/ ? roff(name) : "\\fB" roff(name) "\\fR")
  else if (broken || (indented && !/^ /) || (listed && ended && /^[A-Z]/))
    print ".PP"
  if (name != "" && commands)
    pages = pages (pages ? ",\n" : "") "\\fBscallop\\-" name "\\fR(1)"
  sub(/^ +/, "", text)
  if (text != "")
    print roff(text)
  listed = name != "" || (listed && !broken && !(ended && /^[A-Z]/))
  ended = /[.:]$/
  indented = /^ /
  broken = 0
}

END {
  print ".SH EXAMPLE\n.EX\n" roff(example) "\n.EE\n.SH \"SEE ALSO\"\n.nh"
  print pages ? pages : "\\fBscallop\\fR(1), which lists the commands and the exit codes"
}
