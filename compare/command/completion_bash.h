/* The parts of the script for bash that are the same whatever the commands are, in the order in which they are written. Its
 * words for values: FILE, FILE.cfg (only files with that ending, if there are any), DIR, measured:FILE (a file after that
 * text); what ends in a colon goes on; the rest stands for itself. */
#ifndef SCALLOP_COMPLETION_BASH_H
#define SCALLOP_COMPLETION_BASH_H

extern const char completion_usage[];
extern const char completion_of_command[]; /* up to the cases of its commands                                         */
extern const char completion_of_option[];  /* the end of those, and up to the cases of options                        */
extern const char completion_of_words[];   /* the end of those, and the rest                                          */

#endif
