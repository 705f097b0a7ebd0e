# The crawling-scallop toolkit. `make help` lists the targets. All output goes to build/, tables to data/.
# The choices of a build are in config.mk, libraries and installation in library.mk.
include config.mk
WARN     = -Wall -Wextra -Werror -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
# OpenMP: scallop_steady_batch on all cores, and maps
has_openmp = $(shell printf 'int main(void){return 0;}' | $(CC) -fopenmp -x c - -o /dev/null 2>/dev/null && echo 1 || echo 0)
override WITH_OPENMP := $(if $(filter auto,$(WITH_OPENMP)),$(has_openmp),$(WITH_OPENMP))
openmp   = $(if $(filter 0,$(WITH_OPENMP)),-fopenmp-simd,-fopenmp)
# No contraction to fused multiply-add: the tables in data/ must not depend on the processor. No care for traps, which are off:
# vector instructions compute what is then not used.
ALL_CFLAGS = -std=c11 -D_XOPEN_SOURCE=700 -I. -ffp-contract=off -fno-trapping-math $(WARN) $(CFLAGS) $(openmp)
B       ?= build
# What threads are used in. The command asks for one at a time, and does without their library.
threaded := numerics/batch
without_threads = $(patsubst -fopenmp,-fopenmp-simd,$(ALL_CFLAGS))

# Of GSL and libconfig the programs take what they use out of the archives, so that nothing is looked for when they start.
archive   = $(shell $(CC) -print-file-name=lib$(1).a)
linked    = $(if $(filter 0,$(STATIC)),-l$(1),$(if $(findstring /,$(archive)),$(archive),-l$(1)))
LDLIBS   ?= $(foreach l,gsl gslcblas config,$(call linked,$(l))) -lm

# FLINT: derived series, certified numbers and the ledger, in a program of their own that the command hands over to
# (compare/command/with_flint.h).
flint_parts := $(addprefix model/,ball fractions exact_gaits) $(basename $(wildcard asymptotics/derived/*.c)) \
               $(addprefix numerics/,certified certified_steady march march_mode enclose) \
               $(filter-out compare/workprec/stopwatch,$(basename $(wildcard compare/*/*flint.c $(patsubst %,compare/%/*.c,claims breakdown maps stress workprec))))
flint_tests := certified friction written_gaits rises certified_edges certified_laws claims claims_check claims_figures claims_words series series_terms formula_series derived derived_laws derived_edges formulas first_wrong bounds workprec stiff odd_gaits gaits_certified dwell many_pieces derived_gaits branch out_of_memory range wide stress breakdown map map_curves singularity
# Arb is a library of its own beside FLINT 2, and a part of FLINT 3
has_arb      = $(shell printf '\043include <arb.h>' | $(CC) -E - >/dev/null 2>&1 && echo yes)
FLINT       ?= $(if $(has_arb),-lflint-arb) -lflint -lgmp

# SUNDIALS: one more rival for `workprec`
sundials      := $(filter 4 5 6 7 8 9,$(shell printf '\043include <cvode/cvode.h>\nSUNDIALS_VERSION_MAJOR' | $(CC) $(CPPFLAGS) -E -P - 2>/dev/null | tail -n 1))
override WITH_SUNDIALS := $(if $(filter auto,$(WITH_SUNDIALS)),$(if $(sundials),1,0),$(WITH_SUNDIALS))
sundials_parts = numerics/cvode numerics/cvode_absent
cvode          = numerics/cvode$(if $(filter 0,$(WITH_SUNDIALS)),_absent)
SUNDIALS      ?= $(if $(filter 0,$(WITH_SUNDIALS)),,-lsundials_cvode -lsundials_nvecserial $(if $(filter 4 5 6,$(sundials)),,-lsundials_core))
chosen         = $(B)/with-sundials-$(WITH_SUNDIALS)

rooms   := $(patsubst %/,%,$(sort $(dir $(shell find model asymptotics numerics compare -name '*.c'))))
code     = $(rooms) tests tests/fuzz bench
units    = $(wildcard $(1)/*.c)
parts    = $(patsubst %.c,%,$(foreach r,$(rooms),$(call units,$(r))))
objects  = $(patsubst %,$(B)/%.o,$(1))
core    := $(call objects,$(filter-out compare/command/main $(flint_parts) $(sundials_parts),$(parts)) shipped_scenes shipped_scripts shipped_completion)
one_thread = $(patsubst $(B)/%,$(B)/single/%,$(call objects,$(threaded)))
full    := $(core) $(call objects,$(flint_parts) $(cvode) shipped_ledger) $(chosen)
tests   := $(patsubst tests/test_%.c,%,$(wildcard tests/test_*.c))
# Fuzz targets: each is linked with libFuzzer (make fuzz) or with a driver that replays tests/corpus/ (make check)
fuzz_flint := certified decimal formula_series
fuzz    := $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZER  ?=
ifeq ($(WITH_FLINT),0)
  programs := $(B)/scallop
  tests    := $(filter-out $(flint_tests),$(tests))
  fuzz     := $(filter-out $(fuzz_flint),$(fuzz))
else
  programs := $(B)/scallop $(B)/scallop-flint
endif
tests   := $(patsubst %,$(B)/test_%,$(tests))
fuzz    := $(patsubst %,$(B)/fuzz_%,$(fuzz))
fuzz_by := $(call objects,tests/fuzz/target $(if $(FUZZER),,tests/fuzz/replay))
link     = $(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^)

.PHONY: all help check check-report reproduce bench instructions rooms size lint format asan fuzz fuzz-programs valgrind matrix coverage gates clean setup-build setup-check setup-plots
.DELETE_ON_ERROR:
.PRECIOUS: $(B)/%.o

## all:        build the command, build/scallop, and the libraries; config.mk has the choices
all: setup-build
	@[ $(WITH_FLINT) != 0 ] || rm -f $(B)/scallop-flint
	@$(MAKE) --no-print-directory $(programs) $(libraries)

## help:       this list
help:
	@sed -n 's/^## //p' Makefile library.mk

setup-build:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build
setup-check:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build tests
setup-plots:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build plots

$(B)/scallop: private openmp = -fopenmp-simd
$(B)/scallop: $(B)/compare/command/main.o $(filter-out $(call objects,$(threaded)),$(core)) $(one_thread)
	@echo "  LD $@"
	@$(link) $(LDLIBS)

$(B)/scallop-flint: $(B)/compare/command/main.o $(full)
	@echo "  LD $@"
	@$(link) $(FLINT) $(SUNDIALS) $(LDLIBS)

# so that another choice links anew
$(chosen):
	@mkdir -p $(@D) && rm -f $(B)/with-sundials-* && touch $@

$(B)/%.o: %.c Makefile config.mk
	@mkdir -p $(@D)
	@echo "  CC $<"
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

$(B)/single/%.o: %.c Makefile config.mk
	@mkdir -p $(@D)
	@echo "  CC $< (one thread)"
	@$(CC) $(CPPFLAGS) $(without_threads) -MMD -MP -c -o $@ $<

# Scenes, their plot scripts, the completion and the ledger, in the program
plot_scripts := $(addprefix scripts/plots/,common.gp curves.gp) $(wildcard scripts/plots/figure*.gp)
$(B)/shipped_scenes.c: $(wildcard data/scenes/*.cfg)
$(B)/shipped_scripts.c: $(plot_scripts)
$(B)/shipped_completion.c: scripts/dev/completion.bash
$(B)/shipped_ledger.c: data/claims.tsv
$(B)/shipped_%.c: scripts/dev/embed.sh
	@mkdir -p $(@D)
	@sh $< $(basename $(@F)) $(filter-out $<,$^) >$@
$(B)/shipped_%.o: $(B)/shipped_%.c compare/text/shipped.h
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -c -o $@ $<

# Who judges rounds the same way whatever CFLAGS allow the judged
$(B)/tests/%.o: ALL_CFLAGS += -ffp-contract=off

$(patsubst %,$(B)/test_%,$(flint_tests)): $(B)/test_%: $(B)/tests/test_%.o $(B)/tests/check.o $(full)
	@echo "  LD $@"
	@$(link) -lcmocka $(FLINT) $(SUNDIALS) $(LDLIBS)

$(B)/test_cvode: $(B)/tests/test_cvode.o $(B)/tests/check.o $(core) $(call objects,$(cvode)) $(chosen)
	@echo "  LD $@"
	@$(link) -lcmocka $(SUNDIALS) $(LDLIBS)

$(B)/test_%: $(B)/tests/test_%.o $(B)/tests/check.o $(core)
	@echo "  LD $@"
	@$(link) -lcmocka $(LDLIBS)

$(patsubst %,$(B)/fuzz_%,$(fuzz_flint)): $(B)/fuzz_%: $(B)/tests/fuzz/fuzz_%.o $(fuzz_by) $(full)
	@echo "  LD $@"
	@$(link) $(FUZZER) $(FLINT) $(SUNDIALS) $(LDLIBS)

$(B)/fuzz_%: $(B)/tests/fuzz/fuzz_%.o $(fuzz_by) $(core)
	@echo "  LD $@"
	@$(link) $(FUZZER) $(LDLIBS)

include library.mk
-include $(shell find $(B) -name '*.d' 2>/dev/null)

# The gates build on all cores, unless make was told how many
at_once = $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),,-j$(shell getconf _NPROCESSORS_ONLN))

## check:      build with warnings as errors and run every test, the commands included
check: setup-check
	@$(MAKE) --no-print-directory $(at_once) $(programs) $(libraries) $(tests) $(fuzz)
	@WITH_FLINT=$(WITH_FLINT) STATIC=$(if $(filter -lgsl,$(LDLIBS)),0,1) MAKE="$(MAKE)" scripts/dev/check.sh $(B) $(tests) $(fuzz)

## reproduce:  the main job: the tables of data/, their plots in build/plots/, and a summary
reproduce: setup-plots
	@$(MAKE) --no-print-directory $(programs)
	@sh scripts/dev/reproduce.sh $(B)

## check-report: the page of `make reproduce` in headless Chromium, at the width of a phone and of a desktop, light and dark
check-report: setup-plots
	@scripts/dev/setup.sh report
	@/usr/bin/python3 scripts/report/check_report.py $(B)/report/index.html --screenshots $(B)/report/screenshots

## bench:      nanoseconds per steady state and period, beside the arithmetic floor and GSL's ODE solvers; what starting takes
bench: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop-bench $(B)/nothing $(B)/scallop
	@$(B)/scallop-bench

## instructions: instructions by function that the answers of the benchmark take (needs valgrind)
instructions: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop-bench
	@sh scripts/dev/instructions.sh $(B)

$(B)/scallop-bench: $(call objects,$(filter-out bench/nothing,$(basename $(call units,bench)))) $(core)
	@echo "  LD $@"
	@$(link) $(LDLIBS)

$(B)/nothing: $(B)/bench/nothing.o
	@$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $<

# With the sanitizers gcc 12 warns of regions and texts that cannot be too small
no_false_alarms = -Wno-stringop-overflow -Wno-stringop-overread -Wno-format-truncation
## asan:       the tests under the address, leak and undefined-behaviour sanitizers
asan:
	@ASAN_OPTIONS=detect_leaks=1 LSAN_OPTIONS=suppressions=$(CURDIR)/tests/lsan.supp:print_suppressions=0 $(MAKE) --no-print-directory check B=$(B)/asan \
	  CFLAGS="-O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all $(no_false_alarms)"

FUZZ_SECONDS ?= 60
FUZZ_TARGETS ?= $(patsubst $(B)/fuzz_%,%,$(fuzz))
fuzz_flags = -fno-omit-frame-pointer -Wno-pass-failed -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
## fuzz:       search for inputs that break a reader or the solver, FUZZ_SECONDS (60) for each of FUZZ_TARGETS (all); needs clang
fuzz:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build tests fuzz
	@$(MAKE) --no-print-directory $(at_once) fuzz-programs CC=clang B=$(B)/fuzz WITH_OPENMP=0 CFLAGS="-O1 -g $(fuzz_flags)" FUZZER=-fsanitize=fuzzer
	@sh scripts/dev/fuzz.sh $(B)/fuzz $(FUZZ_SECONDS) $(FUZZ_TARGETS)
fuzz-programs: $(fuzz)

## valgrind:   memory errors and leaks in tests, fuzz replays and commands; slow
valgrind:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build tests valgrind
	@$(MAKE) --no-print-directory $(at_once) $(programs) $(tests) $(fuzz)
	@sh scripts/dev/valgrind.sh $(B) $(tests) $(fuzz)

## matrix:     is the promise of accuracy kept by gcc and clang, -O0 and -O3 -march=native, without and with fused multiply-add?
matrix:
	@scripts/dev/setup.sh build tests matrix
	@MAKE="$(MAKE)" sh scripts/dev/matrix.sh $(B)/matrix

## coverage:   lines and branches of model/, asymptotics/ and numerics/ that the tests reach; all lines and 95 % are wanted (needs gcovr)
coverage:
	@WITH_FLINT=$(WITH_FLINT) scripts/dev/setup.sh build tests coverage
	+@MAKE="$(MAKE)" sh scripts/dev/coverage.sh $(B)/coverage

## rooms:      which folder uses which, by includes and by symbols, beside the list in scripts/dev/rooms.txt; circles, and what is too long
rooms: setup-build
	@$(MAKE) --no-print-directory $(at_once) $(programs)
	@/usr/bin/python3 scripts/dev/rooms.py $(B)

## size:       files, lines and functions of each folder; the median and the longest function, in lines
size:
	@/usr/bin/python3 scripts/dev/rooms.py $(B) --size

sources  = $(filter-out $(if $(filter 0,$(WITH_SUNDIALS)),numerics/cvode.c),$(foreach r,$(code),$(wildcard $(r)/*.c)))
## lint:       rooms, clang-format, cppcheck and clang-tidy
lint:
	@scripts/dev/setup.sh build tests lint
	@$(MAKE) --no-print-directory rooms
	clang-format --dry-run -Werror $(sources) scallop.h $(foreach r,$(code),$(wildcard $(r)/*.h))
	cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 -I. $(sources)
	printf '%s\n' $(sources) | xargs -n 8 -P "$$(getconf _NPROCESSORS_ONLN)" sh -c 'clang-tidy --quiet "$$@" -- -std=c11 -D_XOPEN_SOURCE=700 -I.' clang-tidy

## gates:      all of the above that guard something, one row each: scripts/dev/gates.txt has the list, docs/contributing.md what each guards
gates:
	@sh scripts/dev/gates.sh scripts/dev/gates.txt $(B)/gates

## clean:      remove build/
clean:
	rm -rf $(B)
