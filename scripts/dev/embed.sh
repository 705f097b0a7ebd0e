#!/bin/sh
# Writes a C file with the texts of files, so that the program needs no folder for them: scripts/dev/embed.sh LIST FILE... >FILE.c.
# LIST is one of the lists of compare/text/shipped.h. A text has the name of its file, without folder and ending.
set -eu
list=$1
shift
echo '/* Made by scripts/dev/embed.sh */'
echo '#include "compare/text/shipped.h"'
echo
echo "const struct shipped $list[] = {"
for file in "$@"; do
  name=${file##*/}
  printf '  { "%s",\n' "${name%.*}"
  sed -e 's/[\\"?]/\\&/g' -e 's/^/    "/' -e 's/$/\\n"/' "$file"
  echo '  },'
done
echo '  { 0, 0 }'
echo '};'
