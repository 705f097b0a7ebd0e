/* explorer/: a page in which the solver follows the reader's hand. The core is the library in WebAssembly: model/, the
 * exact periods of numerics/ and the published formulas, without a single import. It takes numbers from flat arrays and
 * leaves its answers there. A gait is chosen, then a crawler, and then asked about. Statuses are those of enum
 * scallop_status; where one is negative text() says why. core.js is the other side. */
#ifndef SCALLOP_EXPLORER_CORE_H
#define SCALLOP_EXPLORER_CORE_H

#include "scallop.h"

enum {
  EXPLORER_MOST = 16384,
  EXPLORER_ROWS = 20,
  EXPLORER_NUMBERS = 64,
  EXPLORER_TEXT = 1 << 20,
  EXPLORER_FORMULAS = 6
};

/* The crawler that was chosen last, with the gait that was. */
extern struct scallop_crawler explorer_crawler;
extern double explorer_numbers[EXPLORER_NUMBERS], explorer_rows[EXPLORER_ROWS][EXPLORER_MOST];
extern char explorer_text[EXPLORER_TEXT];
/* m1, m2, F1, F2, L, T, alpha from place k of row(0) to row(6), with that gait */
struct scallop_crawler explorer_row_crawler(int k);

#define EXPORTED(name) __attribute__((export_name(#name), used)) name

/* Places for numbers, for rows of most() numbers, and for a text of text_size() bytes with its NUL */
double *EXPORTED(numbers)(void);
double *EXPORTED(row)(int i);
char *EXPORTED(text)(void);
int EXPORTED(most)(void);
int EXPORTED(text_size)(void);
const char *EXPORTED(version)(void);
/* text(): of family i, a line each, its name, what its numbers are called, the usual ones, their domain, and the
 * sentence about it. 0: there is none */
int EXPORTED(describe_family)(int i);
/* The gait of family i with the first count of numbers(). Where there is none the gait of the crawler stays. */
int EXPORTED(choose_gait)(int i, int count);
/* The measured gait of the table in text(); name: what to call it in messages, the first line of that text. numbers():
 * its L, T and alpha. */
int EXPORTED(choose_table)(void);
/* Of a measured gait: t and l of its samples in row(0) and row(1), t, l and l' of the curve at so many places of a
 * period in row(2) to row(4); text(): what was understood. Returns how many samples; 0: the gait is not measured. */
int EXPORTED(recording)(int places);
/* The crawler m1, m2, F1, F2, L, T, alpha of numbers(). */
int EXPORTED(choose_crawler)(void);
/* numbers(): froude, v_start, v_mid, displacement, mean_velocity, multiplier, v_low, v_high, regime, friction_work.
 * text(): the modes */
int EXPORTED(steady)(void);
/* The period from v0. numbers(): v_mid, v_end, displacement, multiplier, regime. text(): the modes */
int EXPORTED(period)(double v0);
/* The intervals of constant mode of so many periods from v0, each in row(0)...: t_begin, t_end, directions of both
 * bodies. Returns how many (as many as there is room for), or a status. */
int EXPORTED(walk)(double v0, int periods);
/* row(0)...: t, x1, x2, xC, v1, v2, l. Returns how many samples, or a status. */
int EXPORTED(trajectory)(double v0, int periods, int samples);
/* Classes: a regime with its modes, numbered as steady_states meets them. */
const char *EXPORTED(class_name)(int i);
void EXPORTED(forget_classes)(void);
/* The steady states of the first count crawlers of the rows. row(7)...: froude, v_start, v_mid, displacement,
 * mean_velocity, multiplier, class (-1: it has no steady state), friction_work (if that is wanted). digits: of enum
 * digits (numerics/digits.h) */
void EXPORTED(steady_states)(int count, int with_work, int digits);
/* text(): of formula i, a line each, its name, equation, text, the word of its quantity, setting, remainder, turns, and
 * names and texts of its parts in turn. 0: there is none */
int EXPORTED(describe_formula)(int i);
/* 1 if formula i is claimed for the crawler, else 0 */
int EXPORTED(formula_is_claimed)(int i);
/* The formulas of one quantity whose indices are in numbers(), at most EXPLORER_FORMULAS, along the periods in row(0),
 * for the phase of this kind from v0 or for the steady state. row(1): exact, row(2): a number that differs where the
 * modes do, row(3)...: by each formula. */
void EXPORTED(formulas_along)(int formulas, int kind, double v0, int count);
/* The series of what formula i is about, for the phase of this kind from v0 or for the steady state: with T as unit the
 * coefficients of T^(step k - shift), k = 0, ..., count - 1; step is 1 or 2, shift 0 or 1, count at most
 * EXPLORER_NUMBERS. They are those of the polynomial through the exact numbers at the periods in row(0), in binary128:
 * their error is the polynomial's, and to be judged by other periods. A call solves period k; the calls for k = 0, ...,
 * count - 1 follow each other, and the last leaves the coefficients in row(1). Returns 0 where there is no such number,
 * or the modes are not the same as at the period before, else 1. */
int EXPORTED(series_of)(int i, int kind, double v0, double unit, int step, int shift, int k, int count);
/* Formula i, of the steady state, for the first count crawlers of the rows: row(15). */
void EXPORTED(formula_over)(int i, int count);

#endif
