/* Linked into every program with FLINT: at its end the memory that FLINT keeps for reuse is given back. A leak checker then sees
 * what was forgotten, the limbs of big integers too, which FLINT holds behind pointers that no checker can read. */
#include <flint/flint.h>

static void end_of_program(void) __attribute__((destructor));

static void end_of_program(void) { flint_cleanup(); }
