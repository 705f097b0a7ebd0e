/* Functions that C's library would link and no call here needs: files, because messages and tables are in memory, and
 * trigonometry of large arguments and in binary128. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>

static int refuse(void)
{
  errno = ENOTSUP;
  return -1;
}

FILE *fopen(const char *name, const char *mode)
{
  (void)name, (void)mode;
  refuse();
  return NULL;
}
int close(int file) { return (void)file, refuse(); }
off_t __lseek(int file, off_t offset, int whence); /* the library's internal call */
off_t __lseek(int file, off_t offset, int whence) { return (void)file, (void)offset, (void)whence, refuse(); }
ssize_t read(int file, void *to, size_t size) { return (void)file, (void)to, (void)size, refuse(); }
ssize_t readv(int file, const struct iovec *to, int count) { return (void)file, (void)to, (void)count, refuse(); }
ssize_t writev(int file, const struct iovec *from, int count) { return (void)file, (void)from, (void)count, refuse(); }

char *strerror(int error)
{
  static char memory[] = "out of memory", other[] = "there are no files here";
  return error == ENOMEM ? memory : other;
}

/* Called at an end of a piece, with result 1 (model/law.c). */
long double cosl(long double x) { return (long double)cos((double)x); }

/* Reduces arguments of sines and cosines beyond 2^20: no call has one beyond a quarter turn. */
int __rem_pio2_large(double *x, double *y, int exponent, int count, int precision);
int __rem_pio2_large(double *x, double *y, int exponent, int count, int precision)
{
  (void)x, (void)exponent, (void)count, (void)precision;
  y[0] = y[1] = NAN;
  return 0;
}
