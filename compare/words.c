#include "compare/words.h"

#include <ctype.h>
#include <stddef.h>
#include <string.h>

/* Levenshtein's, upper and lower case being the same */
static int distance(const char *a, const char *b)
{
  enum { LONGEST = 40 };
  int row[LONGEST + 1];
  size_t m = strlen(b);
  if (m > LONGEST || strlen(a) > LONGEST)
    return LONGEST;
  for (size_t j = 0; j <= m; j++)
    row[j] = (int)j;
  for (size_t i = 1; a[i - 1] != '\0'; i++) {
    int diagonal = row[0];
    row[0] = (int)i;
    for (size_t j = 1; j <= m; j++) {
      int substitute = diagonal + (tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]));
      int insert = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
      diagonal = row[j];
      row[j] = substitute < insert ? substitute : insert;
    }
  }
  return row[m];
}

bool likely(const char *word, const char *name) { return distance(word, name) == 0; }

const char *nearest(const char *word, const char *const *names)
{
  const char *best = NULL;
  size_t length = strlen(word);
  int least = length > 0 ? (int)length / 3 + 1 : 0;
  for (; *names; names++) {
    int d = length > 2 && strncmp(word, *names, length) == 0 ? 0 : distance(word, *names);
    if (d <= least && (!best || d < least)) {
      best = *names;
      least = d;
    }
  }
  return best;
}
