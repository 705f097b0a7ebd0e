/* The version of the project and of its libraries. */
#ifndef SCALLOP_MODEL_VERSION_H
#define SCALLOP_MODEL_VERSION_H

/* Semantic version. The last number increases with repairs, the second with additions, the first with incompatible
 * changes. While the first is 0, the second counts additions and incompatible changes. */
#define SCALLOP_VERSION "0.3.0-dev"

/* Number after .so of the shared libraries. It increases if programs linked with an earlier library would fail: a
 * function is removed or its arguments change, or the layout of a struct changes. */
#define SCALLOP_ABI 1

#endif
