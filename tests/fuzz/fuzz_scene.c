/* A scene: read and checked. Each of its columns is a quantity or a formula; nothing is run. */
#include <stdlib.h>
#include <string.h>

#include "compare/command/want.h"
#include "tests/fuzz/target.h"

static void judge(const struct scene *scene, struct want *wants)
{
  const struct asked *asked = scene->request.asked;
  if (scene->wants < 1 || (scene->request.sweep.products > 0 && !(sweep_points(&scene->request.sweep) >= 1)))
    fuzz_fail("a scene of %d wants and %ld points was taken", scene->wants, sweep_points(&scene->request.sweep));
  for (int w = 0; w < scene->wants; w++)
    for (int i = 0; wants[w].has_rows && i < wants[w].rows.sheet.columns.count; i++) {
      const struct column *c = &wants[w].rows.sheet.columns.item[i];
      if (!c->name || (c->place >= 0) == (c->formula != NULL) || c->place >= asked->quantities.count)
        fuzz_fail("column %d of want %d: quantity %d", i, w, c->place);
    }
}

static enum exit_code read_all(struct scene *scene, struct want *wants, const struct scene_source *source,
                               const struct scene_options *options)
{
  enum exit_code code = scene_read(scene, source, &options->request);
  for (int i = 0; i < scene->wants && code == EXIT_DONE; i++)
    code = want_read(&wants[i], scene, scene->want[i], options) ? EXIT_DONE : EXIT_USAGE;
  return code;
}

static enum exit_code read_scene(struct scene *scene, struct want *wants, const char *text,
                                 const struct scene_options *options)
{
  const struct scene_source source = { .path = "x.cfg", .text = text };
  struct written written;
  written_begin(&written);
  enum exit_code code = read_all(scene, wants, &source, options);
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
  struct scene *scene = calloc(1, sizeof *scene);
  bool reads_files = !text || strstr(text, "measured:") || strstr(text, "book");
  if (!reads_files && scene && options_read(&read, &command_run, commands, 3, arguments, &code) == READ_RUN) {
    struct want *wants = calloc(SCENE_WANTS, sizeof *wants);
    if (wants && read_scene(scene, wants, text, (const void *)&read.options) == EXIT_DONE)
      judge(scene, wants);
    for (int i = 0; wants && i < scene->wants; i++)
      want_free(&wants[i]);
    free(wants);
    scene_free(scene);
    options_free(&read);
  }
  free(text);
  free(scene);
  return 0;
}
