# The explorer: the core in WebAssembly, without imports, in a page of one file. The event solver is compiled for speed, the rest for size;
# long double is binary128. wasm-opt reads the features of WebAssembly that clang has used from the object: the linker must keep them.
wasm_parts := $(filter-out numerics/integrators/% asymptotics/observed/% compare/%,$(filter-out $(flint),$(parts))) \
              compare/points/gait_file $(addprefix compare/tables/,tsv json) $(addprefix compare/text/,values digits message) $(basename $(wildcard explorer/*.c))
wasm       = clang --target=wasm32-wasi
$(B)/wasm/%.o: %.c Makefile explorer/rules.mk
	@mkdir -p $(@D); $(wasm) $(WASM_LEVEL) -std=c11 -D_XOPEN_SOURCE=700 -I. -ffp-contract=off -fno-trapping-math $(WARN) -MMD -MP -c -o $@ $<
$(B)/wasm/%.o: WASM_LEVEL = -Oz
$(patsubst %,$(B)/wasm/%.o,model/gait numerics/event/motion): WASM_LEVEL = -O3
$(B)/wasm/asymptotics/published/paper.o: $(B)/asymptotics/published/paper.c
	@mkdir -p $(@D); $(wasm) -Oz -I. -c -o $@ $<
$(B)/core.wasm: $(patsubst %,$(B)/wasm/%.o,$(wasm_parts))
	@echo "  LD $@"; $(wasm) -nostartfiles -Wl,--no-entry,--strip-debug,--compress-relocations,-z,stack-size=262144 -o $@ $^ && wasm-opt -Oz --flatten --rereloop -Oz $(addprefix --strip-,debug producers target-features) $@ -o $@
$(B)/explorer/index.html: $(B)/core.wasm $(wildcard explorer/*.js explorer/*.css explorer/*.html explorer/*.json) scripts/dev/explorer.sh
	@sh scripts/dev/explorer.sh $(B)

## check-report: the page of `make reproduce` in headless Chromium, at the width of a phone and of a desktop, light and dark
check-report:
	@/usr/bin/python3 scripts/report/check_report.py $(B)/report/index.html --screenshots $(B)/report/screenshots

## explorer:   build/explorer/index.html, an interactive page with the solver: one file, needs no server
explorer: $(B)/explorer/index.html
	@echo "open $<"
## check-explorer: this page in headless Chromium: its numbers, drags, presets, links, and refused input
check-explorer: explorer $(B)/scallop
	@/usr/bin/python3 scripts/report/check_explorer.py $(B)/explorer/index.html $(B)/scallop --screenshots $(B)/explorer/screenshots
