# The crawling-scallop toolkit. `make help` lists the targets. All output goes to build/, tables to data/; config.mk has the choices.
include config.mk
B         ?= build
MAKEFLAGS += --no-print-directory
ifeq ($(filter -j% --jobserver%,$(MAKEFLAGS)),)
  MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN) # unless make was told how many
endif
# Recipes read and write numbers with a point, and texts in UTF-8, whatever the language of the user is.
export LC_ALL := C.UTF-8
# What a goal needs is looked for first, and installed where that is possible; by make -n it is not.
quoted     = '$(subst ','\'',$(1))'
setup      = CC=$(call quoted,$(CC)) CPPFLAGS=$(call quoted,$(CPPFLAGS)) $(foreach name,FLINT GSL LIBCONFIG,WITH_$(name)=$(WITH_$(name))) scripts/dev/setup.sh
ifeq ($(findstring n,$(filter-out -%,$(firstword $(MAKEFLAGS)))),)
  $(if $(shell $(setup) $(or $(MAKECMDGOALS),all) >&2 || echo no),$(error something is missing))
endif
works      = $(shell { $(1); } >/dev/null 2>&1 && echo yes)
# A choice that is 0, 1 or auto, the last: whether it works
chosen     = $(filter-out 0,$(if $(filter auto,$(1)),$(2),$(1)))

# No contraction to fused multiply-add: the tables in data/ must not depend on the processor. No care for traps, which are off: vector
# instructions compute what is then not used. Objects serve programs and libraries alike.
WARN       = -Wall -Wextra -Werror -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla
ALL_CFLAGS = -std=c11 -D_XOPEN_SOURCE=700 -I. $(if $(filter 0,$(WITH_LIBCONFIG)),-Icompare/config/absent )-fPIC -fno-semantic-interposition -ffp-contract=off -fno-trapping-math -fopenmp-simd $(WARN) $(CFLAGS)
threads   := $(if $(call chosen,$(WITH_OPENMP),$(call works,echo 'int main(void){return 0;}' | $(CC) -fopenmp -x c - -o /dev/null)),-fopenmp)
# Of GSL and libconfig a program takes what it uses out of the archives, so that nothing is looked for when it starts.
archive    = $(filter /%,$(if $(filter 0,$(STATIC)),,$(shell $(CC) -print-file-name=lib$(1).a)))
LDLIBS    ?= $(foreach l,$(if $(filter 0,$(WITH_GSL)),,gsl gslcblas) $(if $(filter 0,$(WITH_LIBCONFIG)),,config),$(or $(call archive,$(l)),-l$(l))) -lm
# Arb is a library of its own beside FLINT 2, and a part of FLINT 3.
FLINT     ?= $(if $(call works,echo '#include <arb.h>' | $(CC) $(CPPFLAGS) -E -),-lflint-arb) -lflint -lgmp
sundials  := $(filter 4 5 6 7 8 9,$(shell printf '\043include <cvode/cvode.h>\nSUNDIALS_VERSION_MAJOR' | $(CC) $(CPPFLAGS) -E -P - 2>/dev/null | tail -n 1))
with_sundials := $(if $(call chosen,$(WITH_SUNDIALS),$(sundials)),1,0)
SUNDIALS  ?= $(if $(filter 1,$(with_sundials)),-lsundials_cvode -lsundials_nvecserial $(if $(filter 4 5 6,$(sundials)),,-lsundials_core))

# What needs FLINT follows from the folder, or from a name that ends in _flint; what is made for it has threads, where there are any.
in_flint   = model/exact/% asymptotics/derived/% asymptotics/symbolic/% numerics/certified/% $(patsubst %,compare/%/%,claims breakdown maps stress workprec summary)
flint     := $(in_flint) $(addprefix tests/,$(in_flint) fuzz/flint/%) %_flint
built      = $(if $(filter 0,$(WITH_FLINT)),$(filter-out $(flint),$(1)),$(1))
found      = $(call built,$(basename $(sort $(shell find $(1) -name '$(2).c'))))
# What a build without GSL has not
in_gsl     = numerics/integrators/% compare/text/gsl compare/points/sobol
cvode     := $(if $(filter 0,$(WITH_GSL)),,numerics/integrators/cvode)
left_out  := compare/command/main $(cvode) $(if $(filter 0,$(WITH_GSL)),$(in_gsl))
parts     := $(filter-out $(left_out),$(call found,model asymptotics numerics compare,*)) asymptotics/published/paper
threaded  := numerics/batch
object     = $(patsubst %,$(B)/%.o,$(1))
shipped   := $(call object,$(addprefix shipped_,scenes scripts completion help))
core      := $(call object,$(filter-out $(flint),$(parts))) $(shipped)
full      := $(call object,$(filter-out $(threaded),$(parts)) $(cvode) $(addprefix threads/,$(threaded))) $(shipped)
with_flint := $(call object,$(filter $(flint),$(parts)) $(cvode))

# A test or a fuzz target needs what its folder needs; tests/ mirrors the folders. libFuzzer drives a target (make fuzz), or tests/corpus does.
of_tests  := $(call found,tests,test_*)
of_fuzz   := $(call found,tests,fuzz_*)
tests     := $(addprefix $(B)/,$(notdir $(of_tests)))
fuzz      := $(addprefix $(B)/,$(notdir $(of_fuzz)))
program   := $(addprefix $(B)/,scallop $(if $(filter 0,$(WITH_FLINT) $(WITH_GSL)),,scallop-flint.so))

.PHONY: all help docs pictures single-order check check-report check-cluster reproduce bench-sweeps bench instructions explorer check-explorer bare flint3 release api layers size lint asan fuzz fuzz-programs valgrind matrix coverage gates growth faults clean libraries install uninstall
.DELETE_ON_ERROR:
.PRECIOUS: $(B)/%.o

## all:        build the command, build/scallop, and the libraries; config.mk has the choices
all: $(program) libraries
	@[ "$(filter %.so,$(program))" ] || rm -f $(B)/scallop-flint.so

## help:       this list
help: ; @sed -n 's/^## //p' Makefile explorer/rules.mk

compile    = @mkdir -p $(@D); echo "  CC $<"; $(CC) $(CPPFLAGS) $(ALL_CFLAGS) -MMD -MP -c -o $@ $<
$(B)/%.o: %.c Makefile config.mk
	$(compile)
$(B)/threads/%.o: %.c Makefile config.mk
	$(compile)
$(B)/%.o: $(B)/%.c
	$(compile)
$(call object,$(filter $(flint),$(parts)) $(addprefix threads/,$(threaded))): ALL_CFLAGS += $(threads)
# Who judges rounds the same way whatever CFLAGS allow the judged.
$(B)/tests/%.o: ALL_CFLAGS += -ffp-contract=off
$(call object,$(cvode)): ALL_CFLAGS += -DWITH_SUNDIALS=$(with_sundials)
$(call object,$(cvode)): $(B)/with-sundials-$(with_sundials)
$(call object,$(filter compare/%,$(parts)) compare/command/main): $(B)/with-libconfig-$(if $(filter 0,$(WITH_LIBCONFIG)),0,1)
$(B)/with-%:
	@mkdir -p $(@D) && rm -f $(B)/with-$(firstword $(subst -, ,$*))-* && touch $@

# Scenes, their plot scripts, the completion and the texts of --help, in the program
$(B)/shipped_scenes.c: $(sort $(wildcard data/scenes/*.cfg))
$(B)/shipped_scripts.c: $(addprefix scripts/plots/,plot.sh common.gp) $(sort $(wildcard scripts/plots/plot/*.awk scripts/plots/figure*.gp))
$(B)/shipped_completion.c: scripts/dev/completion.bash
$(B)/shipped_help.c: $(sort $(wildcard docs/help/*.txt docs/help/parts/*.txt))
$(B)/asymptotics/published/paper.c: scripts/dev/formulas.awk asymptotics/published/paper.cfg
	@mkdir -p $(@D) && awk -f $^ >$@
$(B)/shipped_%.c: scripts/dev/embed.sh
	@mkdir -p $(@D) && sh $< $(basename $(@F)) $(filter-out $< docs/help/parts/%,$^) >$@

# A program is linked with the libraries that its objects need.
needed     = $(if $(filter %/exact/ball.o,$^),$(FLINT)) $(if $(filter %/integrators/cvode.o,$^),$(SUNDIALS)) $(if $(filter %/support/check.o,$^),-lcmocka) \
             $(if $(filter $(B)/threads/%,$^),$(threads)) $(if $(filter %/command/main.o %/part_flint.o,$^),-rdynamic)
# What needs FLINT is a part of its own, which scallop loads when a command asks for it (compare/answers/flint.h): loading FLINT takes
# longer than most commands do. It takes from the program what it has not.
$(B)/scallop: $(B)/compare/command/main.o $(core) | $(filter-out $(B)/scallop,$(program))
$(B)/scallop-flint.so: $(with_flint)
	@echo "  LD $@"; echo '{ global: flint_part; local: *; };' >$(B)/flint_part.map
	@$(CC) $(ALL_CFLAGS) $(threads) $(LDFLAGS) -shared -Wl,--version-script=$(B)/flint_part.map -o $@ $(filter %.o,$^) $(needed) $(LDLIBS)
$(foreach t,$(of_tests) $(of_fuzz),$(eval $(B)/$(notdir $(t)): $(B)/$(t).o $(if $(filter $(flint),$(t)),$(full),$(core))))
$(tests): $(call object,tests/support/check)
$(addprefix $(B)/,test_integrators test_all_integrators): $(call object,$(cvode))
$(fuzz): $(call object,tests/fuzz/target $(if $(FUZZER),,tests/fuzz/replay))
$(B)/scallop-bench: $(call object,$(filter-out bench/nothing,$(basename $(wildcard bench/*.c)))) $(core)
$(B)/scallop $(tests) $(fuzz) $(B)/scallop-bench:
	@echo "  LD $@"; $(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(FUZZER) $(needed) $(LDLIBS)
$(B)/nothing: $(B)/bench/nothing.o
	@$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $<
-include $(shell find $(B) -name root -prune -o -name '*.d' -print 2>/dev/null)
# They come with the objects. Without this rule make takes build/shipped_scenes.d for a program, of a file shipped_scenes.d.c.
$(B)/%.d: ;

# A target that is the script of its name is given the build, and the programs to run; some make once more, in a folder of their own.
script     = sh scripts/dev/$@.sh $(B) $(filter $(tests) $(fuzz),$^)
## check:      build with warnings as errors and run every test, the commands included
## asan:       the tests under the address, leak and undefined-behaviour sanitizers
## matrix:     is the bound of the error kept by gcc and clang, -O0 and -O3 -march=native, without and with fused multiply-add?
## coverage:   lines and branches of model/, asymptotics/ and numerics/ that the tests reach; all lines and 95 % are wanted (needs gcovr)
## bare:       does each goal ask for what it needs, on a machine that has make only? needs root and Debian
## release:    README's commands, and make check, on bare systems of Debian stable and before it; needs root, Debian and its mirror
## flint3:     do all sources compile with FLINT 3? needs apt and a mirror of Debian
## faults:     does a test fail for each fault of tests/faults, or for those that FAULTS="WORDS" name?
## fuzz:       search for inputs that break a reader or the solver, FUZZ_SECONDS (60) for each of FUZZ_TARGETS (all); needs clang
check asan matrix coverage fuzz flint3 faults:
	+@WITH_FLINT=$(WITH_FLINT) STATIC=$(if $(filter -lgsl,$(LDLIBS)),0,1) MAKE="$(MAKE)" $(script)
## valgrind:   memory errors and leaks in tests, fuzz replays and commands; slow
## lint:       layers, wordings (scripts/dev/prose.txt), clang-format, cppcheck and clang-tidy
## reproduce:  the main job: the tables of data/, their plots in build/plots/, and a summary
## growth:     how the cost grows with rows, digits, orders and recordings: exponents by scallop order (needs valgrind)
## instructions: instructions by function that the answers of the benchmark take (needs valgrind)
valgrind lint reproduce instructions growth bare release:
	@$(script)
check valgrind faults: $(program) libraries $(tests) $(fuzz)
lint: layers
reproduce growth: $(program)
instructions: $(B)/scallop-bench $(program)
fuzz-programs: $(fuzz)

## layers:     which folder uses which, by includes and by symbols, beside the list in scripts/dev/layers.txt; circles, and what is too long
layers: $(program)
## size:       files, lines and functions of each folder; the median and the longest function, in lines
layers size: ; @/usr/bin/python3 scripts/dev/layers.py $(B) $(filter --size,--$@)
## gates:      all that guards something, or GATES="NAME...", a row each: scripts/dev/gates.txt has the list, docs/development/contributing.md what each guards
gates: ; @sh scripts/dev/gates.sh scripts/dev/gates.txt $(B)/gates $(GATES)
## docs:       docs/reference/commands.md anew, from --help, and the tables of other pages that follow from data
docs: $(program)
	@sh scripts/dev/commands.sh $(B)/scallop >$(B)/commands.md && mv $(B)/commands.md docs/reference/commands.md
	@/usr/bin/python3 scripts/dev/pages.py
## pictures:   the pictures of the pages that show no table of data/ (needs gnuplot and Chromium)
pictures: explorer $(program)
	@sh scripts/plots/pages.sh $(B)/scallop
	@/usr/bin/python3 scripts/report/explorer_picture.py $(B)/explorer/index.html docs/guide/explorer.png
## api:        the reference of the C and the Python interface as pages, BUILD/api; needs Doxygen
api: ; @sh scripts/dev/api.sh $(B) $(version) $(headers)
include explorer/rules.mk
## bench-sweeps: what a row of a sweep costs, beside the batch call
bench-sweeps: $(B)/scallop $(B)/libscallop-core.a ; @/usr/bin/python3 scripts/dev/bench-sweeps.py $(B)
## check-cluster: the Slurm script and the line of GNU parallel of docs/guide/sweeps.md, on a private Slurm of which a node dies; needs root, Debian
check-cluster: $(program)
	@$(script)
## bench:      nanoseconds per steady state and period, beside the arithmetic floor and GSL's ODE solvers; what starting takes
bench: $(B)/scallop-bench $(B)/nothing $(B)/scallop ; @$(B)/scallop-bench
## single-order: the estimator of orders as one file of C99 and C++17, to copy: build/scallop_order.h (docs/guide/order.md)
single-order: $(B)/scallop_order.h
$(B)/scallop_order.h: scripts/dev/single_order.sh $(wildcard asymptotics/observed/*.[ch]) model/version.h LICENSE
	@mkdir -p $(@D) && sh $< >$@
## clean:      remove build/
clean: ; rm -rf $(B)

# libscallop-core: the model, the published formulas and the exact solver; needs libm only, and has no threads.
# libscallop:      everything in model/, asymptotics/ and numerics/ that the build has.
version   := $(shell sed -n 's/^.define SCALLOP_VERSION "\(.*\)"/\1/p' model/version.h)
abi       := $(shell sed -n 's/^.define SCALLOP_ABI //p' model/version.h)
libraries := $(addprefix $(B)/lib,scallop-core.a scallop.a)
in_library = $(filter $(patsubst %,$(B)/%/%,model asymptotics numerics threads),$(1))
core_headers := scallop.h $(shell sed -n 's/^.include "\(.*\)"/\1/p' scallop.h)
headers   := $(core_headers) $(if $(filter 0,$(WITH_GSL)),,numerics/integrators/integrator.h) \
             $(call built,model/exact/flint.h model/exact/ball.h asymptotics/derived/expansion.h numerics/certified/certified.h)
passed     = NM OBJCOPY AR LDFLAGS INSTALL DESTDIR PREFIX bindir libdir includedir datadir mandir pkgconfigdir completionsdir
to_script  = CC="$(CC) $(ALL_CFLAGS)" $(foreach name,$(passed),$(name)="$($(name))") sh scripts/dev
$(B)/libscallop-core.a: $(filter-out $(B)/numerics/integrators/%,$(call in_library,$(core))) $(core_headers)
$(B)/libscallop.a: $(call in_library,$(full)) $(headers)
$(B)/libscallop.a: needed += $(if $(filter 0,$(WITH_GSL)),,-lgsl -lgslcblas)
$(libraries):
	@$(to_script)/library.sh $(@:$(B)/lib%.a=%) $(B) $(version) $(abi) "$(strip $(needed) -lm)" "$(filter %.h,$^)" $(filter %.o,$^)
$(B)/man: $(B)/scallop scripts/dev/man.awk scripts/dev/man.sh
	@sh scripts/dev/man.sh $< $(version) $@

## libraries:  libscallop-core, which needs libm only, and libscallop, static and shared, in build/
libraries: $(libraries)
## install:    programs, libraries, headers, man pages, completion, scenes, plot scripts, the Python package, to PREFIX (/usr/local), with DESTDIR in front
## uninstall:  takes away what install put there
install: $(program) $(libraries) $(B)/man
install uninstall:
	@$(to_script)/install.sh $@ $(B) $(version) $(abi) "$(headers)" "$(program)"
