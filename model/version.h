/* The version, here and nowhere else. */
#ifndef SCALLOP_MODEL_VERSION_H
#define SCALLOP_MODEL_VERSION_H

/* Semantic: the last number rises when mistakes are repaired, the second when something is added, the first when
 * something that worked has to be written differently. While the first is 0 the second stands for both. */
#define SCALLOP_VERSION "0.3.0-dev"

/* Of the shared libraries: the number after .so. It rises when a program that was linked with an earlier one would not
 * run right: a function has gone or takes something else, or a struct has changed its layout. */
#define SCALLOP_ABI 1

#endif
