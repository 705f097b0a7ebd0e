# The choices of a build. Each can be given on make's command line or in the environment as well: make WITH_FLINT=0 PREFIX=/usr

# FLINT: derived series, certified numbers and the table of claims, in scallop-flint.so, which the program loads when a command needs it. 0: without.
WITH_FLINT    ?= 1
# GSL: the general-purpose methods to compare with, and what needs FLINT in the program. 0: without both; tests need it.
WITH_GSL      ?= 1
# libconfig: scenes and formula files. 0: the program refuses these.
WITH_LIBCONFIG ?= 1
# OpenMP: many steady states, and maps, on all cores. auto: where the compiler has it; 0: on one.
WITH_OPENMP   ?= auto
# SUNDIALS: one more integrator for `workprec`. auto: where its headers are found (where they need MPI's, give them CPPFLAGS and LDLIBS).
WITH_SUNDIALS ?= auto
# 1: GSL and libconfig are linked into the programs where there are archives of them, so that a program starts in a millisecond. 0: they
# are shared libraries, as distributions want it.
STATIC        ?= 1

# Where `make install` puts things. DESTDIR, empty here, goes in front of each.
PREFIX        ?= /usr/local
bindir        ?= $(PREFIX)/bin
libdir        ?= $(PREFIX)/lib
includedir    ?= $(PREFIX)/include
datadir       ?= $(PREFIX)/share
mandir        ?= $(datadir)/man
pkgconfigdir  ?= $(libdir)/pkgconfig
completionsdir ?= $(datadir)/bash-completion/completions

CC            ?= cc
CFLAGS        ?= -O2 -g
AR            ?= ar
OBJCOPY       ?= objcopy
NM            ?= nm
INSTALL       ?= install
