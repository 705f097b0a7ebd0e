/* How many threads a loop runs on. Header-only; not public. */
#ifndef SCALLOP_NUMERICS_THREADS_H
#define SCALLOP_NUMERICS_THREADS_H

#ifdef _OPENMP
#include <omp.h>
#endif

/* As many as are wanted, but no more than there are items or processors: more gain nothing, and OpenMP ends the process
 * where it cannot start them, or has no room on the stack for a list of them. wanted = 0: as many as OMP_NUM_THREADS
 * says. */
static inline int threads_for(int wanted, long items)
{
#ifdef _OPENMP
  int threads = wanted > 0 ? wanted : omp_get_max_threads(), processors = omp_get_num_procs();
  if (threads > processors)
    threads = processors;
  if (threads > items)
    threads = (int)items;
  return threads > 1 ? threads : 1;
#else
  (void)wanted, (void)items;
  return 1;
#endif
}

#endif
