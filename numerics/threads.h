/* The number of threads of a loop. Header-only; not public. */
#ifndef SCALLOP_NUMERICS_THREADS_H
#define SCALLOP_NUMERICS_THREADS_H

#ifdef _OPENMP
#include <omp.h>
#endif

/* Returns the requested number (0: OMP_NUM_THREADS), but at most the number of items and of processors: more threads
 * gain nothing, and OpenMP ends the process if it cannot start them or list them on the stack. */
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
