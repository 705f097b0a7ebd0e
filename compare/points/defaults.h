/* Defaults of the options of tables that need FLINT. --help prints them, also in a build without FLINT. */
#ifndef SCALLOP_COMPARE_POINTS_DEFAULTS_H
#define SCALLOP_COMPARE_POINTS_DEFAULTS_H

/* Digits of certified rows */
#define CERTIFIED_DIGITS 30

/* workprec: periods, and the seconds of --limit; the second of each with --quick */
#define WORKPREC_T 1, 0.1, 0.01, 1e-3, 1e-4
#define WORKPREC_QUICK_T 0.5, 0.01
#define WORKPREC_LIMIT 1
#define WORKPREC_QUICK_LIMIT 0.05

/* stress: cases of each family */
#define STRESS_CASES 1000
#define STRESS_CHECK_STEADY 4
#define STRESS_CHECK_PHASES 30
#define STRESS_FULL_CASES 5000

/* breakdown: errors for which it finds the reach of series, in tables and in maps */
#define BREAKDOWN_TOLERANCES 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12
#define BREAKDOWN_MAP_TOLERANCES 1e-2, 1e-6

#endif
