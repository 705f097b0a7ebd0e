/* Runs a fuzz target over files, without a fuzzer: fuzz_NAME FILE... */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/target.h"

static uint8_t *read_all(const char *name, size_t *size)
{
  enum { MOST = 1 << 20 };
  uint8_t *data = malloc(MOST), *exact = NULL;
  FILE *file = fopen(name, "rb");
  *size = data && file ? fread(data, 1, MOST, file) : 0;
  if (data && file && feof(file) && !ferror(file))
    exact = realloc(data, *size > 0 ? *size : 1); /* so that a sanitizer sees a read beyond it */
  if (file)
    fclose(file);
  if (!exact) {
    fprintf(stderr, "%s: cannot be read, or is larger than %d bytes\n", name, MOST);
    exit(EXIT_FAILURE);
  }
  return exact;
}

int main(int count, char **arguments)
{
  for (int i = 1; i < count; i++) {
    const char *slash = strrchr(arguments[i], '/');
    size_t size;
    uint8_t *data = read_all(arguments[i], &size);
    fprintf(stderr, "%s\n", arguments[i]); /* the last one before it ends abruptly */
    LLVMFuzzerTestOneInput(data, size);
    free(data);
    printf("ok %s\n", slash ? slash + 1 : arguments[i]);
    fflush(stdout);
  }
  return EXIT_SUCCESS;
}
