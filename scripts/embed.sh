#!/bin/sh
# Writes a C file with the texts of scenes, so that the program needs no folder for them: scripts/embed.sh SCENE.cfg... >FILE.c
set -eu
echo '/* Made by scripts/embed.sh from data/scenes/ */'
echo '#include "compare/shipped.h"'
echo
echo 'const struct shipped shipped_scenes[] = {'
for scene in "$@"; do
  printf '  { "%s",\n' "$(basename "$scene" .cfg)"
  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/^/    "/' -e 's/$/\\n"/' "$scene"
  echo '  },'
done
echo '  { 0, 0 }'
echo '};'
