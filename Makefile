# The crawling-scallop toolkit. `make help` lists the targets. All output goes to build/, tables to data/.
CC      ?= cc
CFLAGS  ?= -O2 -g
LDLIBS  ?= -lgsl -lgslcblas -lm
WARN     = -Wall -Wextra -Werror -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
# No contraction to fused multiply-add: the tables in data/ must not depend on the processor.
ALL_CFLAGS = -std=c11 -D_XOPEN_SOURCE=700 -I. -ffp-contract=off $(WARN) $(CFLAGS)
B       ?= build

rooms    = $(wildcard $(1)/*.c)
library := $(patsubst %.c,$(B)/%.o,$(filter-out compare/main.c,$(foreach r,model asymptotics numerics compare,$(call rooms,$(r)))))
tests   := $(patsubst tests/%.c,$(B)/%,$(wildcard tests/test_*.c))

.PHONY: all help check reproduce bench lint format asan clean setup-build setup-check setup-plots
.DELETE_ON_ERROR:
.SECONDARY:

## all:        build the command, build/scallop
all: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop

## help:       this list
help:
	@sed -n 's/^## //p' Makefile

setup-build:
	@scripts/setup.sh build
setup-check:
	@scripts/setup.sh build tests
setup-plots:
	@scripts/setup.sh build plots

$(B)/scallop: $(B)/compare/main.o $(library)
	@echo "  LD $@"
	@$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(B)/%.o: %.c Makefile
	@mkdir -p $(@D)
	@echo "  CC $<"
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<

$(B)/test_%: $(B)/tests/test_%.o $(B)/tests/check.o $(library)
	@echo "  LD $@"
	@$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ -lcmocka $(LDLIBS)

-include $(shell find $(B) -name '*.d' 2>/dev/null)

## check:      build with warnings as errors and run every test, the commands included
check: setup-check
	@$(MAKE) --no-print-directory $(B)/scallop $(tests)
	@scripts/check.sh $(B) $(tests)

## reproduce:  the main job: the tables of data/, their plots in build/plots/, and a summary
reproduce: setup-plots
	@$(MAKE) --no-print-directory $(B)/scallop
	@sh scripts/reproduce.sh $(B)

## bench:      nanoseconds per period and steady state beside GSL's ODE solvers, as ratios of one run
bench: setup-build
	@$(MAKE) --no-print-directory $(B)/scallop-bench
	@$(B)/scallop-bench

$(B)/scallop-bench: $(B)/bench/bench.o $(library)
	@echo "  LD $@"
	@$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

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
