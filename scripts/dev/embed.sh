#!/bin/sh
# Writes a C file with the texts of files, so that the program needs no folder for them: scripts/dev/embed.sh LIST FILE... >FILE.c.
# LIST is one of the lists of compare/text/shipped.h. A text has the name of its file, without folder and ending. A line @NAME in it stands
# for the lines of NAME.txt in its folder.
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
  awk -v folder="${file%/*}/" '
    function put(file, line) {
      while ((getline line < file) > 0)
        if (line ~ /^@[a-z/-]+$/) put(folder substr(line, 2) ".txt"); else print line
      close(file)
    }
    BEGIN { put(ARGV[1]) }' "$file" | sed -e 's/[\\"?]/\\&/g' -e 's/^/    "/' -e 's/$/\\n"/'
  echo '  },'
done
echo '  { 0, 0 }'
echo '};'
