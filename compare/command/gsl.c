/* GSL's own handler of errors ends the program. A build without GSL leaves this file out. */
#include <gsl/gsl_errno.h>

static void __attribute__((constructor)) begin(void) { gsl_set_error_handler_off(); }
