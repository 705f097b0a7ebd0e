# Makes a page of the manual from the page of help of a command, or of the program, and the topics that this page names:
#   awk -v page=scallop-steady -v version="scallop 1.0" -f scripts/dev/man.awk STEADY OPTIONS GAITS...
# A heading is a line that ends with ":" below an empty one. An item of a list is "  NAMES  TEXT"; "  --a --b", without a text, names options
# that a topic explains. Of a topic the items about options that the command does not take are left out, and what its own page has.

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

# Prints the headings that precede a line, and the text below them.
function head(line) {
  if (section != "")
    print ".SH " section
  section = ""
  if (heading != "" && page != "scallop" && is_command && line ~ /^  --/ && !options++)
    print ".SH OPTIONS"
  if (heading != "")
    print page == "scallop" ? ".SH " toupper(roff(heading)) : ".SS \"" roff(heading) "\""
  else if (broken)
    print ".PP"
  if (about != "")
    print about
  heading = about = ""
  broken = 0
}

{ sub(/ +$/, ""); is_command = FILENAME == ARGV[1] }
FNR == 1 && is_command { # scallop NAME [options]: summary
  colon = index($0, ": ")
  print ".TH " roff(toupper(page)) " 1 \"\" \"" version "\" \"The crawling\\-scallop toolkit\""
  print ".SH NAME\n" roff(page) " \\- " roff(substr($0, colon + 2))
  print ".SH SYNOPSIS\n\\fB" roff(substr($0, 1, colon - 1)) "\\fR"
  section = "DESCRIPTION"
  next
}
FNR == 1 { # scallop help TOPIC: summary
  section = toupper(roff(substr($0, 1, index($0, ": ") - 1)))
  heading = about = ""
  broken = left_out = 0
  next
}
/^Example: / { if (is_command) example = substr($0, length("Example: ") + 1); next }
!NF { broken = 1; left_out = 0; next }
broken && /^[^ ].*:$/ { group = heading = substr($0, 1, length - 1); broken = 0; about = ""; next }
/^Exit codes: / { section = "EXIT STATUS"; sub(/^Exit codes: /, "") }
{
  gap = index(substr($0, 3), "  ")
  names = /^  [^ ]/ ? substr($0, 3, gap ? gap - 1 : length) : ""
  text = $0
  sub(/^ +/, "", text)
  if (names ~ /^--/) {
    count = split(names, word, /,? /)
    left_out = !is_command
    for (i = 1; i <= count; i++)
      if (word[i] !~ /^--/)
        continue
      else if (is_command)
        taken[word[i]] = 1
      else if (word[i] in taken && !($0 in printed))
        left_out = 0
  } else if (names != "" || /^[^ ]/)
    left_out = 0
  if (!is_command && heading != "" && /^  / && !gap) { # a text above options: printed if the command takes one of them
    about = about (about == "" ? "" : "\n") roff(text)
    next
  }
  if (left_out)
    next
  if (is_command)
    printed[$0] = 1
  head($0)
  if (gap && names != "") {
    print ".TP\n" (names ~ /^--/ ? roff(names) : "\\fB" roff(names) "\\fR")
    text = substr($0, gap + 3)
    sub(/^ +/, "", text)
    if (group == "Commands")
      pages = pages (pages ? ",\n" : "") "\\fBscallop\\-" names "\\fR(1)"
  } else if (listed && !/^   /)
    print ".PP"
  else if (names ~ /^--/ && !named)
    print ".br"
  named = names ~ /^--/
  listed = (gap && names != "") || (listed && /^   /)
  print roff(text)
}

END {
  print ".SH EXAMPLE\n.EX\n" roff(example) "\n.EE\n.SH \"SEE ALSO\"\n.nh"
  print pages ? pages : "\\fBscallop\\fR(1), which lists the commands and the exit codes"
}
