# The crawling-scallop toolkit. `make help` lists the targets. All output goes to build/, tables to data/.
CC      ?= cc
CFLAGS  ?= -O2 -g
LDLIBS  ?= -lgsl -lgslcblas -lm
WARN     = -Wall -Wextra -Werror -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
# No contraction to fused multiply-add: the tables in data/ must not depend on the processor.
ALL_CFLAGS = -std=c11 -D_XOPEN_SOURCE=700 -I. -ffp-contract=off $(WARN) $(CFLAGS)
B       ?= build

# FLINT: derived series, certified numbers and the ledger. make WITH_FLINT=0 leaves it out: see compare/with_flint.h.
WITH_FLINT ?= 1
flint_parts := $(addprefix model/,ball) $(addprefix asymptotics/,series expression lift branch limit evaluate derived bound) \
               $(addprefix numerics/,certified march enclose) \
               $(addprefix compare/,decimal ledger claims_order claims_words cmd_claims certified_rows series_derived)
flint_tests := certified claims series series_terms expression derived formulas bounds
# Arb is a library of its own beside FLINT 2, and a part of FLINT 3
has_arb      = $(shell printf '\043include <arb.h>' | $(CC) -E - >/dev/null 2>&1 && echo yes)
FLINT       ?= $(if $(has_arb),-lflint-arb) -lflint -lgmp

rooms    = $(wildcard $(1)/*.c)
parts    = $(patsubst %.c,%,$(foreach r,model asymptotics numerics compare,$(call rooms,$(r))))
core    := $(filter-out compare/main compare/without_flint $(flint_parts),$(parts))
objects  = $(patsubst %,$(B)/%.o,$(1))
tests   := $(patsubst tests/test_%.c,%,$(wildcard tests/test_*.c))
ifeq ($(WITH_FLINT),0)
  library := $(call objects,$(core) compare/without_flint)
  tests   := $(filter-out $(flint_tests),$(tests))
  LINK     = $(LDLIBS)
else
  library := $(call objects,$(core) $(flint_parts))
  LINK     = $(FLINT) $(LDLIBS)
endif
tests   := $(patsubst %,$(B)/test_%,$(tests))
link     = $(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^)

.PHONY: all help check reproduce bench lint format asan clean setup-build setup-check setup-plots
.DELETE_ON_ERROR:
.PRECIOUS: $(B)/%.o

## all:        build the command, build/scallop; WITH_FLINT=0 leaves FLINT out, and what needs it
all: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop

## help:       this list
help:
	@sed -n 's/^## //p' Makefile

setup-build:
	@WITH_FLINT=$(WITH_FLINT) scripts/setup.sh build
setup-check:
	@WITH_FLINT=$(WITH_FLINT) scripts/setup.sh build tests
setup-plots:
	@WITH_FLINT=$(WITH_FLINT) scripts/setup.sh build plots

# Changes when WITH_FLINT does: then what is linked is linked anew.
chosen := $(B)/with-flint-$(WITH_FLINT)
$(chosen):
	@mkdir -p $(B)
	@rm -f $(B)/with-flint-*
	@touch $@

$(B)/scallop: $(B)/compare/main.o $(library) $(chosen)
	@echo "  LD $@"
	@$(link) $(LINK)

# For the tests: that a build without FLINT works and says what it lacks
$(B)/scallop-without-flint: $(B)/compare/main.o $(call objects,$(core) compare/without_flint)
	@echo "  LD $@"
	@$(link) $(LDLIBS)

$(B)/%.o: %.c Makefile
	@mkdir -p $(@D)
	@echo "  CC $<"
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

$(B)/test_%: $(B)/tests/test_%.o $(B)/tests/check.o $(library) $(chosen)
	@echo "  LD $@"
	@$(link) -lcmocka $(LINK)

-include $(shell find $(B) -name '*.d' 2>/dev/null)

## check:      build with warnings as errors and run every test, the commands included
check: setup-check
	@$(MAKE) --no-print-directory $(B)/scallop $(B)/scallop-without-flint $(tests)
	@WITH_FLINT=$(WITH_FLINT) scripts/check.sh $(B) $(tests)

## reproduce:  the main job: the tables of data/, their plots in build/plots/, and a summary
reproduce: setup-plots
	@$(MAKE) --no-print-directory $(B)/scallop
	@sh scripts/reproduce.sh $(B)

## bench:      nanoseconds per period and steady state beside GSL's ODE solvers, as ratios of one run
bench: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop-bench
	@$(B)/scallop-bench

$(B)/scallop-bench: $(B)/bench/bench.o $(library) $(chosen)
	@echo "  LD $@"
	@$(link) $(LINK)

## asan:       the tests under the address and undefined-behaviour sanitizers
asan:
	@$(MAKE) --no-print-directory check B=$(B)/asan \
	  CFLAGS="-O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all"

sources  = $(foreach r,model asymptotics numerics compare tests bench,$(wildcard $(r)/*.c))
## lint:       clang-tidy, cppcheck and clang-format
lint:
	@scripts/setup.sh build tests lint
	clang-format --dry-run -Werror $(sources) $(foreach r,model asymptotics numerics compare tests,$(wildcard $(r)/*.h))
	cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 -I. $(sources)
	clang-tidy --quiet $(sources) -- -std=c11 -D_XOPEN_SOURCE=700 -I.

## clean:      remove build/
clean:
	rm -rf $(B)
