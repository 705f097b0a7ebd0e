/* What the library does, from a program outside of it: cc installed.c $(pkg-config --cflags --libs scallop-core) */
#include <scallop.h>

#include <stdio.h>

/* One crawler: its steady state, exactly, and what the paper's equation (28) says of the displacement. */
static int one_crawler(void)
{
  struct scallop_crawler crawler = scallop_crawler_default();
  struct scallop_complaint wrong;
  crawler.F1 = 3; /* the friction of body 1; any consistent units */
  crawler.T = 0.5;
  if (scallop_crawler_check(&crawler, &wrong) != SCALLOP_OK) {
    fprintf(stderr, "%s = %g: wanted: %s\n", wrong.name, wrong.given, wrong.allowed);
    return 1;
  }
  struct scallop_steady_result steady;
  struct scallop_steady_error error; /* an estimate of how wrong each number is */
  enum scallop_status status = scallop_steady(&crawler, &steady);
  if (status >= 0)
    status = scallop_steady_error(&crawler, &steady, &error);
  if (status < 0) {
    fprintf(stderr, "no steady state: %s\n", scallop_status_text(status));
    return 1;
  }
  char modes[SCALLOP_MODES_TEXT];
  scallop_modes_text(&steady.period.modes[SCALLOP_EXTENSION], modes);
  printf("exact\t%.17g\n", steady.period.displacement);
  printf("error\t%.2g\n", error.displacement);
  const struct scallop_formula *equation_28 = scallop_formula_named("eq28_displacement");
  printf("series\t%.17g\n", scallop_published_value(equation_28, &crawler, SCALLOP_EXTENSION, 0, 0, 0, 0));
  printf("extension\t%s, %s\n", scallop_regime_text(steady.period.regime), modes);
  return 0;
}

enum { COUNT = 4 };

/* Many at once, column by column: what is not wanted stays NULL. */
static int many_crawlers(void)
{
  const double m[COUNT] = { 1, 1, 1, 1 }, F1[COUNT] = { 2, 3, 10, -1 }, F2[COUNT] = { 1, 1, 1, 1 },
               L[COUNT] = { 10, 10, 10, 10 };
  const double T[COUNT] = { 0.5, 0.5, 0.5, 0.5 }, alpha[COUNT] = { 0.75, 0.75, 0.75, 0.75 };
  const struct scallop_gait *const gait[COUNT] = { &scallop_gait_quadratic, &scallop_gait_quadratic,
                                                   &scallop_gait_sinusoidal, &scallop_gait_quadratic };
  double displacement[COUNT];
  enum scallop_status status[COUNT];
  const struct scallop_crawlers crawlers = {
    .count = COUNT, .m1 = m, .m2 = m, .F1 = F1, .F2 = F2, .L = L, .T = T, .alpha = alpha, .gait = gait
  };
  const struct scallop_steady_states wanted = { .displacement = displacement, .status = status };
  long failed = scallop_steady_batch(&crawlers, &wanted, 1);
  for (int i = 0; i < COUNT; i++)
    printf("%s, F1 = %g\t%.17g\t%s\n", gait[i]->name, F1[i], displacement[i], scallop_status_text(status[i]));
  printf("failed\t%ld\n", failed);
  return 0;
}

int main(void) { return one_crawler() || many_crawlers(); }
