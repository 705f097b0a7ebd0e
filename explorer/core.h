/* explorer/: the library in WebAssembly, for a page with an interactive solver: model/, the exact periods of numerics/
 * and the published formulas, without imports. It reads numbers from flat arrays and writes results to them. Choose a
 * gait, then a crawler, then request results. Statuses are enum scallop_status; text() explains a negative one. core.js
 * is the caller. */
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

/* The crawler chosen last, with the gait chosen last */
extern struct scallop_crawler explorer_crawler;
extern double explorer_numbers[EXPLORER_NUMBERS], explorer_rows[EXPLORER_ROWS][EXPLORER_MOST];
extern char explorer_text[EXPLORER_TEXT];
/* Returns the crawler with m1, m2, F1, F2, L, T, alpha in element k of row(0) to row(6), and this gait. */
struct scallop_crawler explorer_row_crawler(int k);

#define EXPORTED(name) __attribute__((export_name(#name), used)) name

/* Return the addresses of numbers, of rows of most() numbers, and of a text of text_size() bytes including its NUL. */
double *EXPORTED(numbers)(void);
double *EXPORTED(row)(int i);
char *EXPORTED(text)(void);
int EXPORTED(most)(void);
int EXPORTED(text_size)(void);
const char *EXPORTED(version)(void);
/* Writes to text() of family i, on a line each: name, names of its numbers, defaults, domain, description. Returns 0
 * after the last family. */
int EXPORTED(describe_family)(int i);
/* Chooses the gait of family i with the first count of numbers(). On failure the gait is unchanged. */
int EXPORTED(choose_gait)(int i, int count);
/* Chooses the measured gait of the table in text(); its first line is a name for messages. Writes L, T and alpha to
 * numbers(). */
int EXPORTED(choose_table)(void);
/* Writes a measured gait: t and l of its samples to row(0) and row(1); t, l and l' of the curve at `places` times of a
 * period to row(2) to row(4); its description to text(). Returns the count of samples; 0: the gait is not measured. */
int EXPORTED(recording)(int places);
/* Chooses the crawler m1, m2, F1, F2, L, T, alpha of numbers(). */
int EXPORTED(choose_crawler)(void);
/* Writes the steady state to numbers(): froude, v_start, v_mid, displacement, mean_velocity, multiplier, v_low, v_high,
 * regime, friction_work; its modes to text(). */
int EXPORTED(steady)(void);
/* Writes the period from v0 to numbers(): v_mid, v_end, displacement, multiplier, regime; its modes to text(). */
int EXPORTED(period)(double v0);
/* Writes the intervals of constant mode of `periods` periods from v0, each to row(0)...: t_begin, t_end, directions of
 * both bodies. Returns their count (at most what fits), or a status. */
int EXPORTED(walk)(double v0, int periods);
/* Writes samples to row(0)...: t, x1, x2, xC, v1, v2, l. Returns their count, or a status. */
int EXPORTED(trajectory)(double v0, int periods, int samples);
/* Return or forget the names of classes: a regime with its modes, numbered in the order of steady_states. */
const char *EXPORTED(class_name)(int i);
void EXPORTED(forget_classes)(void);
/* Writes the steady states of the first count crawlers of the rows to row(7)...: froude, v_start, v_mid, displacement,
 * mean_velocity, multiplier, class (-1: no steady state), friction_work (if with_work). digits: enum digits
 * (numerics/digits.h) */
void EXPORTED(steady_states)(int count, int with_work, int digits);
/* Writes to text() of formula i, on a line each: name, equation, text, name of its quantity, setting, remainder, turns,
 * and names and texts of its parts in turn. Returns 0 after the last formula. */
int EXPORTED(describe_formula)(int i);
/* Returns 1 if formula i is claimed for the crawler, else 0. */
int EXPORTED(formula_is_claimed)(int i);
/* Writes the formulas of one quantity with indices in numbers(), at most EXPLORER_FORMULAS, at the periods in row(0),
 * for the phase of this kind from v0 or for the steady state. row(1): exact value; row(2): a number that differs if the
 * modes differ; row(3)...: each formula. */
void EXPORTED(formulas_along)(int formulas, int kind, double v0, int count);
/* Computes the series of the quantity of formula i, for the phase of this kind from v0 or for the steady state: with T
 * as unit the coefficients of T^(step k - shift), k = 0, ..., count - 1; step is 1 or 2, shift 0 or 1, count at most
 * EXPLORER_NUMBERS. They are the coefficients of the polynomial through the exact numbers at the periods in row(0), in
 * binary128; the caller estimates their error from other periods. Each call solves period k; calls for k = 0, ...,
 * count - 1 follow each other, and the last writes the coefficients to row(1). Returns 0 if a number does not exist, or
 * the modes differ from the preceding period's, else 1. */
int EXPORTED(series_of)(int i, int kind, double v0, double unit, int step, int shift, int k, int count);
/* Writes formula i, of the steady state, for the first count crawlers of the rows to row(15). */
void EXPORTED(formula_over)(int i, int count);

#endif
