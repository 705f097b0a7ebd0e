/* What varies, from the texts of options and of scenes: variables go into the last group of the last product of the
 * request's sweep. Each function returns NULL, or what is wrong with a text: that lives until the next call. */
#ifndef SCALLOP_COMPARE_ANSWERS_VARY_H
#define SCALLOP_COMPARE_ANSWERS_VARY_H

#include "compare/answers/request.h"

/* Begins a product, behind those that there are; a group of the last one, which then varies fastest. */
const char *vary_product(struct request *request);
const char *vary_group(struct request *request);

/* Of the samples that are asked for, all ranges without a count become one group in each product: once all is read. */
const char *vary_sample(struct request *request);

/* Values as they are written. All variables of a group have as many, or one. */
const char *vary_list(struct request *request, struct sweep_variable variable, const char *const *texts, long count);
/* Both ends belong to a range; each is a number, or a formula of the parameters that are set further out and of
 * sticking_onset. */
const char *vary_range(struct request *request, struct sweep_variable variable, const char *from, const char *to,
                       long count, bool is_log);
/* The variable that is the label of that name: a column of texts */
const char *vary_label(struct request *request, const char *name, struct sweep_variable *label);
/* A number, or such a formula */
const char *vary_end(const struct request *request, const char *text, struct sweep_end *end);

/* A parameter, or "label", as an option gives it. One value is set; several, a list "0.6,0.7" a range "1:10:10" or
 * "1e-3:1:50:log", or, for samples, "1:10" or "1e-3:1:log", and any of what the point has no number for, become a
 * group of the last product. Either takes the place of values that the parameter has in that product. A value of a
 * list stays as it is written, with the numbers of a gait behind its name, "constant:0.1,quadratic"; "label" takes
 * NAME=TEXT,TEXT. */
const char *vary_text(struct request *request, const char *name, const char *text);

#endif
