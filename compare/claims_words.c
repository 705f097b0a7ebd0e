/* The claims in words. */
#include "compare/claims.h"

void claims_in_words(const struct scallop_crawler *crawler, claim_sink *sink, void *context)
{
  (void)crawler, (void)sink, (void)context;
}
