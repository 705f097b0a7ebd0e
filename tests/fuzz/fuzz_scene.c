/* A scene: read and checked. Each of its columns is a quantity or a formula; nothing is run. */
#include <stdlib.h>
#include <string.h>

#include "compare/scenes/scene.h"
#include "tests/fuzz/target.h"

static void judge(const struct scene *scene)
{
  if (scene->wants < 1 || scene->sweep.products < 1 || !(sweep_points(&scene->sweep) >= 1))
    fuzz_fail("a scene of %d wants, %d products and %ld points was taken", scene->wants, scene->sweep.products,
              sweep_points(&scene->sweep));
  for (int w = 0; w < scene->wants; w++)
    for (int i = 0; i < scene->want[w].sheet.count; i++) {
      const struct sheet_column *c = &scene->want[w].sheet.column[i];
      if (!c->name || (c->quantity >= 0) == (c->formula != NULL) || c->quantity >= scene->asked.quantities.count)
        fuzz_fail("column %d of want %d: quantity %d", i, w, c->quantity);
    }
}

static enum exit_code take_all(const struct scene *scene, const struct scene_want *want,
                               const struct scene_options *options, bool only_read)
{
  (void)scene, (void)want, (void)options, (void)only_read;
  return EXIT_DONE;
}

static enum exit_code read_scene(struct scene *scene, const char *text, const struct scene_options *options)
{
  const struct scene_source source = { .path = "x.cfg", .text = text };
  struct written written;
  written_begin(&written);
  enum exit_code code = scene_read(scene, &source, options, take_all);
  written_end(&written);
  if (written.out_size > 0 || (written.err_size > 0) != (code != EXIT_DONE))
    fuzz_fail("exit code %d, on standard output '%s', on standard error '%s'", (int)code, written.out, written.err);
  if (code != EXIT_DONE && code != EXIT_USAGE)
    fuzz_fail("exit code %d: %s", (int)code, written.err);
  written_free(&written);
  return code;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static char program[] = "scallop", command[] = "run", name[] = "x.cfg";
  char *arguments[] = { program, command, name, NULL }, *text = fuzz_text(data, size);
  struct arguments read;
  enum exit_code code;
  struct scene *scene = malloc(sizeof *scene);
  bool reads_files = !text || strstr(text, "measured:") || strstr(text, "book");
  if (!reads_files && scene && options_read(&read, &command_run, commands, 3, arguments, &code) == READ_RUN) {
    if (read_scene(scene, text, (const void *)&read.options) == EXIT_DONE) {
      judge(scene);
      scene_free(scene);
    }
    options_free(&read);
  }
  free(text);
  free(scene);
  return 0;
}
