/* The claims in words, table by table. */
#include "compare/claims/words.h"

static const struct words_claim *const tables[] = { words_at_random,        words_of_peaks,  words_of_figures,
                                                    words_of_steady_states, words_of_phases, words_of_regimes,
                                                    words_of_appendices };
enum { TABLES = sizeof tables / sizeof *tables };

static void decide(const struct words *w, enum words_scope first, enum words_scope last)
{
  for (int t = 0; t < TABLES; t++)
    for (const struct words_claim *claim = tables[t]; claim->claim; claim++)
      if (claim->scope >= first && claim->scope <= last)
        claim->decide(w, claim);
}

static void decide_for_crawlers(struct words w, const struct scallop_crawler *of_the_ledger)
{
  const struct scallop_gait *gait = w.crawler.gait;
  w.of_the_paper = true;
  decide(&w, WORDS_EACH_CRAWLER, WORDS_OF_THE_PAPER);
  w.of_the_paper = false;
  w.crawler = *of_the_ledger;
  w.crawler.gait = gait;
  w.crawler.T = 0.5 * words_natural_time(of_the_ledger);
  decide(&w, WORDS_EACH_CRAWLER, WORDS_EACH_CRAWLER);
}

void claims_in_words(const struct scallop_crawler *crawler, const struct scallop_gait *gait, claim_sink *sink, void *context)
{
  struct words w = { .crawler = scallop_crawler_default(), .sink = sink, .context = context };
  if (!gait)
    decide(&w, WORDS_ONCE, WORDS_ONCE);
  for (int g = 0; gait ? g == 0 : scallop_gait_name(g) != NULL; g++) {
    w.crawler.gait = gait ? gait : scallop_gait_named(scallop_gait_name(g));
    decide(&w, WORDS_EACH_GAIT, WORDS_EACH_GAIT);
    decide_for_crawlers(w, crawler);
  }
}
