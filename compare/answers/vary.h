/* Variables of a sweep, from the texts of options and scenes, added to the last group of the last product of the
 * request's sweep. Each function returns NULL or the error of a text, valid until the next call. */
#ifndef SCALLOP_COMPARE_ANSWERS_VARY_H
#define SCALLOP_COMPARE_ANSWERS_VARY_H

#include "compare/answers/request.h"

/* Begin a product behind the existing ones; a group of the last product, from now on its fastest. */
const char *vary_product(struct request *request);
const char *vary_group(struct request *request);

/* Joins all ranges without a count to one sampled group in each product; called after all variables are read. */
const char *vary_sample(struct request *request);

/* Adds a list of values. All variables of a group have the same number of values, or one value. */
const char *vary_list(struct request *request, struct sweep_variable variable, const char *const *texts, long count);
/* Adds a range, both ends included; each end is a number, or a formula of sticking_onset and of the parameters of
 * slower groups. */
const char *vary_range(struct request *request, struct sweep_variable variable, const char *from, const char *to,
                       long count, bool is_log);
/* Returns the variable of a label, a column of texts, in *label. */
const char *vary_label(struct request *request, const char *name, struct sweep_variable *label);
/* Reads an end of a range: a number or a formula. */
const char *vary_end(const struct request *request, const char *text, struct sweep_end *end);

/* Reads the value of an option for a parameter or "label". A single value is set in the point. A list "0.6,0.7", a
 * range "1:10:10" or "1e-3:1:50:log", a range for samples, "1:10" or "1e-3:1:log", and any value of a ratio become a
 * group of the last product. Either replaces the values that the parameter has in that product. A list of gaits is
 * "constant:0.1,quadratic": numbers follow the name; "label" takes NAME=TEXT,TEXT. */
const char *vary_text(struct request *request, const char *name, const char *text);

#endif
