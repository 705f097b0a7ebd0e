/* A scene: read and checked. Each of its columns is a quantity or a formula; nothing is run. */
#include <stdlib.h>
#include <string.h>

#include "compare/command/scene_table.h"
#include "tests/fuzz/target.h"

static void judge(const struct planned_scene *all)
{
  const struct request *r = &all->scene.request;
  if (all->scene.tables < 1 || (r->sweep.products > 0 && !(sweep_points(&r->sweep) >= 1)))
    fuzz_fail("a scene of %d tables and %ld points was taken", all->scene.tables, sweep_points(&r->sweep));
  for (int t = 0; t < all->tables; t++)
    for (int i = 0; i < all->rows[t].sheet.columns.count; i++) {
      const struct column *c = &all->rows[t].sheet.columns.item[i];
      if (!c->name || (c->place >= 0) == (c->formula != NULL) || c->place >= r->required->quantities.count)
        fuzz_fail("column %d of table %d: quantity %d", i, t, c->place);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
  static char program[] = "scallop", command[] = "run", name[] = "x.cfg";
  char *arguments[] = { program, command, name, NULL }, *text = fuzz_text(data, size);
  struct arguments read;
  enum exit_code code;
  struct planned_scene *all = calloc(1, sizeof *all);
  bool reads_files = strstr(text, "measured:") || strstr(text, "formulas");
  if (!reads_files && all && options_read(&read, &command_run, commands, 3, arguments, &code) == READ_RUN) {
    const struct scene_source source = { .path = "x.cfg", .text = text };
    struct written written;
    written_begin(&written);
    code = planned_scene_read(all, &source, (const void *)&read.options);
    written_end_read(&written, code);
    if (code == EXIT_DONE)
      judge(all);
    planned_scene_free(all);
    options_free(&read);
  }
  free(text);
  free(all);
  return 0;
}
