/* Texts that are part of the program, each named like its file without folder and ending. scripts/dev/embed.sh
 * generates them. */
#ifndef SCALLOP_COMPARE_TEXT_SHIPPED_H
#define SCALLOP_COMPARE_TEXT_SHIPPED_H

struct shipped {
  const char *name, *text;
};
/* The last of each list has name NULL. */
extern const struct shipped shipped_scenes[];     /* data/scenes/ */
extern const struct shipped shipped_scripts[];    /* gnuplot scripts of scripts/plots/ */
extern const struct shipped shipped_completion[]; /* scripts/dev/completion.bash */
extern const struct shipped shipped_help[];       /* docs/help/ */

/* Returns the text called name ("figure4"), or NULL; in message.c. */
const char *shipped_text(const struct shipped *list, const char *name);

#endif
