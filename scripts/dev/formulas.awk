# Makes a C table of a formula file: awk -f scripts/dev/formulas.awk asymptotics/published/paper.cfg. The lists `formulas` and
# `corrected` become scallop_published and scallop_corrected (asymptotics/asymptotics.h). A formula file that is not well formed is refused;
# `scallop claims --formulas` says what is wrong with it.
BEGIN { RS = "\001" }
{ text = text $0 }

function take() { # the next token, in `token`; "" at the end
  sub(/^([ \t\n]+|\/\*([^*]|\*+[^*\/])*\*+\/)+/, "", text)
  if (!match(text, /^([A-Za-z_][A-Za-z_0-9]*|[0-9]+|"([^"\\]|\\.)*"|.)/))
    return token = ""
  token = substr(text, 1, RLENGTH)
  text = substr(text, RLENGTH + 1)
  return token
}
function fail(what) {
  print "formulas.awk: " what " is wanted before '" token substr(text, 1, 40) "'" > "/dev/stderr"
  failed = 1
  exit 1
}
function want(wanted) { if (take() != wanted) fail(wanted) }
function strings(all) { # adjacent strings, the first of which is the token
  for (all = token; match(text, /^[ \t\n]*"/); all = all " " token)
    take()
  return all
}
function parts(all, name) { # where = { name = "text"; }
  while (take() != "}") {
    name = token
    want("=")
    take()
    all = all "{ \"" name "\", " strings() " }, "
    want(";")
  }
  return "(const struct scallop_part[]){ " all "{ 0, 0 } }"
}
function conditions(all) { # when = ["...", "..."]
  while (take() != "]")
    all = all token (token == "," ? " " : "")
  return "(const char *const[]){ " all ", 0 }"
}
function word(string) { return substr(string, 2, length(string) - 2) }
function row(name, m) {
  split("", m)
  while (take() != "}") {
    name = token
    want("=")
    take()
    m[name] = token == "{" ? parts() : token == "[" ? conditions() : substr(token, 1, 1) == "\"" ? strings() : token
    want(";")
  }
  start = word(m["start"]) (m["start"] == "\"v0\"" ? m["phase"] == "\"contraction\"" ? "_contraction" : "_extension" : "")
  of = word(m["of"])
  if (of == "dx1" || of == "dx2")
    of = (of == "dx1") == (m["phase"] != "\"contraction\"") ? "rear_at_end" : "front_at_end"
  print "  { .name = " m["name"] ", .equation = " m["equation"] ", .setting = (enum scallop_setting)START_" start ", .quantity = (enum scallop_quantity)OF_" of ","
  print "    .remainder = " (m["claimed"] == "\"equality\"" ? "SCALLOP_EQUALITY" : m["claimed"] + 0) ", .text = " m["text"] ","
  print "    .parts = " (m["where"] ? m["where"] : 0) ", .when = " (m["when"] ? m["when"] : 0) ","
  print "    .corrected = " (m["corrected"] ? m["corrected"] : 0) ", .turns = " turns[m["turns"]] " },"
}
END {
  if (failed) exit 1
  turns[""] = "SCALLOP_TURNS_IN_BOTH"
  turns["\"not in the contraction\""] = "SCALLOP_NO_TURN_IN_CONTRACTION"
  turns["\"not in the extension\""] = "SCALLOP_NO_TURN_IN_EXTENSION"
  print "/* Made by scripts/dev/formulas.awk */\n#include \"asymptotics/asymptotics.h\"\n"
  print "enum { START_rest = SCALLOP_AT_REST_START, START_v0_extension = SCALLOP_MOVING_EXTENSION,"
  print "  START_v0_contraction = SCALLOP_MOVING_CONTRACTION, START_steady = SCALLOP_STEADY };"
  print "#define OF(word, name) OF_##word = SCALLOP_##name,\nenum { SCALLOP_QUANTITY_LIST(OF) OF_NONE };"
  while (take() != "") {
    print "\nconst struct scallop_formula scallop_" (token == "formulas" ? "published" : token) "[] = {"
    want("=")
    want("(")
    for (take(); token != ")"; take())
      if (token == "{") row(); else if (token != ",") fail("{")
    want(";")
    print "  { 0 }\n};"
  }
}
