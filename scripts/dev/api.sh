#!/bin/sh
# The reference of the C API from the installed headers, by Doxygen, and of the Python package from its docstrings, by
# Sphinx: api.sh BUILD VERSION HEADER... BUILD/api/c/index.html, BUILD/api/python/index.html. A warning is an error.
set -eu
api=$1/api version=$2
shift 2
rm -rf "$api"
mkdir -p "$api/conf"
# A comment in front of a declaration, or behind a member, becomes one of Doxygen. Indented lines are shown as they are;
# in the others markup is text.
cat >"$api/filter" <<'END'
#!/bin/sh
exec awk '
/^[ ]*\/\*/ || /[;,{}][ ]+\/\*/ { comment = 1 }
{ indented = comment && /^ \*    / }
indented && !was_indented { print " *" }
comment && !indented { gsub(/[\\@#<>%&]/, "\\\\&") }
FNR == 1 { sub(/^\/\*/, FILENAME ~ /\/scallop\.h$/ ? "/** @mainpage The C library\n *" : "/** @file\n *") }
FNR > 1 && !sub(/^[ ]*\/\*/, "/**") { sub(/[;,][ ]+\/\*/, "&*< ") }
index($0, "*/") { comment = 0 }
{ was_indented = indented; print }' "$1"
END
chmod +x "$api/filter"
doxygen - <<END
PROJECT_NAME = "crawling-scallop"
PROJECT_NUMBER = $version
INPUT = $*
INPUT_FILTER = $api/filter
OUTPUT_DIRECTORY = $api
HTML_OUTPUT = c
GENERATE_LATEX = NO
OPTIMIZE_OUTPUT_FOR_C = YES
JAVADOC_AUTOBRIEF = YES
EXTRACT_ALL = YES
SHOW_INCLUDE_FILES = NO
HAVE_DOT = NO
INLINE_SIMPLE_STRUCTS = YES
SORT_MEMBER_DOCS = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
QUIET = YES
END
cat >"$api/conf/index.rst" <<'END'
crawling_scallop
================

.. automodule:: crawling_scallop
   :members:
   :imported-members:
   :member-order: groupwise

.. automodule:: crawling_scallop.plot
   :members:
END
PYTHONPATH=scripts/python sphinx-build -q -W --keep-going -b html -C -D project=crawling_scallop -D "release=$version" -D html_theme=classic \
  -D extensions=sphinx.ext.autodoc,sphinx.ext.napoleon -D napoleon_use_ivar=1 -D autodoc_mock_imports=matplotlib -D autodoc_typehints=none -D html_copy_source=0 \
  -D html_show_copyright=0 "$api/conf" "$api/python"
echo "$api/c/index.html, $api/python/index.html"
