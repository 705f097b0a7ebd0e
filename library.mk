# The two libraries, and what `make install` puts where. Included by the Makefile.
#
# libscallop-core: the model, the published formulas and the exact solver; needs libm only, and has no threads.
# libscallop:      everything in model/, asymptotics/ and numerics/ that the build has.
# Visible are the functions and tables that the installed headers declare, and nothing else, in the static libraries too: each is
# one object, in which the rest was made local.
# The number after .so is SCALLOP_ABI of model/version.h.
version := $(shell sed -n 's/^.define SCALLOP_VERSION "\(.*\)"/\1/p' model/version.h)
abi     := $(shell sed -n 's/^.define SCALLOP_ABI //p' model/version.h)

core_headers := scallop.h $(addprefix model/,version.h model.h gaits.h) asymptotics/asymptotics.h $(addprefix numerics/,numerics.h wide.h)
full_headers := $(core_headers) $(addprefix numerics/,rival.h odeiv.h smoothed.h moreau.h cvode.h) \
                $(if $(filter 0,$(WITH_FLINT)),,model/flint.h model/ball.h numerics/certified.h)

library_parts = $(filter model/% asymptotics/% numerics/%,$(filter-out $(sundials_parts) $(if $(filter 0,$(WITH_FLINT)),$(flint_parts)),$(parts)))
rivals       := $(addprefix numerics/,moreau odeiv rival rival_motion rival_phases smoothed)
core_objects := $(patsubst %,$(B)/pic/%.o,$(filter-out $(flint_parts) $(rivals),$(library_parts)))
full_objects := $(patsubst %,$(B)/pic/%.o,$(filter-out $(threaded),$(library_parts)) $(cvode)) $(patsubst %,$(B)/pic-threads/%.o,$(threaded))
core_needs    = -lm
full_needs    = $(if $(filter 0,$(WITH_FLINT)),,$(FLINT)) $(SUNDIALS) -lgsl -lgslcblas $(filter -fopenmp,$(openmp)) -lm
core_is       = Exact motion of the crawling scallop and the published series
full_is       = Exact motion of the crawling scallop, certified numbers, and general-purpose methods to compare with

names     := core full
core_name := scallop-core
full_name := scallop
libraries := $(foreach l,$(names),$(B)/lib$($(l)_name).so $(B)/lib$($(l)_name).a)

pic = -fPIC -fno-semantic-interposition -MMD -MP -c
$(B)/pic/%.o: %.c Makefile config.mk library.mk
	@mkdir -p $(@D)
	@echo "  CC $< (library)"
	@$(CC) $(CPPFLAGS) $(without_threads) $(pic) -o $@ $<

$(B)/pic-threads/%.o: %.c Makefile config.mk library.mk
	@mkdir -p $(@D)
	@echo "  CC $< (library, threads)"
	@$(CC) $(CPPFLAGS) $(ALL_CFLAGS) $(pic) -o $@ $<

define library_rules # WHICH
$(1)_file := $(B)/lib$($(1)_name)
# what the objects define and the headers declare
$$($(1)_file).names: $$($(1)_objects) $$($(1)_headers)
	@$(NM) -g --defined-only $$($(1)_objects) | awk 'NF == 3 { print $$$$3 }' | LC_ALL=C sort -u >$$@.defined
	@cat $$($(1)_headers) | tr -c 'A-Za-z0-9_' '\n' | LC_ALL=C sort -u | LC_ALL=C comm -12 - $$@.defined >$$@
	@rm $$@.defined
$$($(1)_file).map: $$($(1)_file).names
	@{ echo 'SCALLOP_$(abi) { global:'; sed 's/$$$$/;/' $$<; echo 'local: *; };'; } >$$@
$$($(1)_file).so.$(version): $$($(1)_objects) $$($(1)_file).map
	@echo "  LD $$@"
	@$$(CC) $$(ALL_CFLAGS) $$(LDFLAGS) -shared -Wl,-soname,lib$($(1)_name).so.$(abi) -Wl,--version-script=$$($(1)_file).map \
	  -Wl,-Bsymbolic-functions -o $$@ $$($(1)_objects) $$($(1)_needs)
$$($(1)_file).so: $$($(1)_file).so.$(version)
	@ln -sf $$(<F) $$@.$(abi) && ln -sf lib$($(1)_name).so.$(abi) $$@
$$($(1)_file).a: $$($(1)_objects) $$($(1)_file).names
	@echo "  AR $$@"
	@$$(CC) -r -nostdlib -o $$(@:.a=.o) $$($(1)_objects)
	@$$(OBJCOPY) --keep-global-symbols=$$($(1)_file).names $$(@:.a=.o)
	@rm -f $$@ && $$(AR) rcs $$@ $$(@:.a=.o)
$(B)/$($(1)_name).pc: scripts/dev/scallop.pc.in FORCE
	@sed -e 's|@PREFIX@|$$(PREFIX)|' -e 's|@libdir@|$$(libdir)|' -e 's|@includedir@|$$(includedir)|' -e 's|@NAME@|$($(1)_name)|' \
	  -e 's|@DESCRIPTION@|$$($(1)_is)|' -e 's|@VERSION@|$(version)|' -e 's|@PRIVATE@|$$(strip $$($(1)_needs))|' $$< >$$@
endef
$(foreach l,$(names),$(eval $(call library_rules,$(l))))
$(B)/libscallop-core.so.$(version): private openmp = -fopenmp-simd
$(B)/libscallop.so.$(version): $(chosen)
FORCE:

# From what --help prints. A page for each command, and one for all
$(B)/man: $(B)/scallop scripts/dev/man.awk
	@rm -rf $@ && mkdir -p $@.part
	@for command in '' $$($< --help | sed -n '/^Commands:/,/^$$/s/^  \([a-z]*\) .*/\1/p'); do page=scallop$${command:+-$$command}; \
	  $< --help $$command | awk -v page=$$page -v version='scallop $(version)' -f scripts/dev/man.awk >$@.part/$$page.1 || exit 1; done
	@mv $@.part $@

# The Python module finds the library from its own place
$(B)/scallop_library.py: scripts/python/scallop_library.py FORCE
	@sed "s|^BESIDE = .*|BESIDE = \"$$(realpath -ms --relative-to='$(datadir)/scallop/python' '$(libdir)')\"|" $< >$@

.PHONY: libraries install uninstall FORCE
## libraries:  libscallop-core, which needs libm only, and libscallop, static and shared, in build/
libraries: $(libraries)

put      = $(INSTALL) -m 644
to       = $(DESTDIR)$(1)
folders  = $(bindir) $(libdir) $(pkgconfigdir) $(mandir)/man1 $(completionsdir) $(datadir)/scallop
scenes   = $(wildcard data/scenes/*.cfg)
## install:    programs, libraries, headers, man pages, completion, scenes, plot scripts, the Python module, to PREFIX (/usr/local), with DESTDIR in front
install: $(programs) $(libraries) $(foreach l,$(names),$(B)/$($(l)_name).pc) $(B)/man $(B)/scallop_library.py
	@$(INSTALL) -d $(foreach f,$(folders),"$(call to,$(f))")
	@$(INSTALL) $(programs) "$(call to,$(bindir))"
	@$(put) $(foreach l,$(names),$(B)/lib$($(l)_name).a $(B)/lib$($(l)_name).so.$(version)) "$(call to,$(libdir))"
	@cd "$(call to,$(libdir))" && $(foreach l,$(names),ln -sf lib$($(l)_name).so.$(version) lib$($(l)_name).so.$(abi) \
	  && ln -sf lib$($(l)_name).so.$(abi) lib$($(l)_name).so &&) :
	@for header in $(full_headers); do $(put) -D $$header "$(call to,$(includedir))/scallop/$$header" || exit 1; done
	@$(put) $(foreach l,$(names),$(B)/$($(l)_name).pc) "$(call to,$(pkgconfigdir))"
	@$(put) $(B)/man/*.1 "$(call to,$(mandir))/man1"
	@$(put) scripts/dev/completion.bash "$(call to,$(completionsdir))/scallop"
	@for module in scripts/python/scallop.py $(B)/scallop_library.py; do $(put) -D $$module "$(call to,$(datadir))/scallop/python/$${module##*/}" || exit 1; done
	@for page in docs/*.md; do $(put) -D $$page "$(call to,$(datadir))/doc/scallop/$${page##*/}" || exit 1; done
	@for scene in $(scenes); do $(put) -D $$scene "$(call to,$(datadir))/scallop/scenes/$${scene##*/}" || exit 1; done
	@$(put) scripts/plots/cheapest.awk "$(call to,$(datadir))/scallop/cheapest.awk"
	@for script in $(plot_scripts); do $(put) -D $$script "$(call to,$(datadir))/scallop/plots/$${script##*/}" || exit 1; done

## uninstall:  takes away what install put there
uninstall:
	@rm -f $(patsubst %,"$(call to,$(bindir))/%",scallop scallop-flint) "$(call to,$(completionsdir))/scallop" \
	  "$(call to,$(mandir))"/man1/scallop.1 "$(call to,$(mandir))"/man1/scallop-*.1 $(foreach l,$(names),\
	  "$(call to,$(pkgconfigdir))/$($(l)_name).pc" "$(call to,$(libdir))/lib$($(l)_name)".a "$(call to,$(libdir))/lib$($(l)_name)".so*)
	@rm -rf "$(call to,$(includedir))/scallop" "$(call to,$(datadir))/scallop" "$(call to,$(datadir))/doc/scallop"
