# The short way in. Everything here can also be done with the CMake presets (cmake --list-presets).
.DEFAULT_GOAL := help
.PHONY: help setup build python modal-tools demo web web-serve wheel npm static deb try test test-fast test-friends test-long coverage systems bench bench-compare \
	calibrate validate results docs paper paper-quick format lint release install uninstall clean

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
PYTHON ?= /usr/bin/python3
PORT ?= 8000
THRESHOLD ?= 1.3
SOURCES = $(shell git ls-files '*.cpp' '*.hpp' '*.c' '*.h')

help: ## show this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):.*## (.*)/  make \1\t\2/' | expand -t 22

setup: ## install the Debian packages that are missing
	@scripts/install-dependencies.sh

build: ## build the library and the command, after installing what that needs
	@scripts/install-dependencies.sh build
	@mkdir -p build && cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset release -j $(JOBS) --target stoss stoss_command

python: build ## build the Python package and install it into build/venv (PYTHON=... for another interpreter)
	@scripts/install-dependencies.sh python
	@scripts/python.sh

modal-tools: python ## what build/venv/bin/python -m stoss.modal needs: DOLFINx, SLEPc and Gmsh
	@scripts/install-dependencies.sh modal

demo: build python ## restitution against speed for two Poisson's ratios, and a collision: here and in out/
	@scripts/demo.sh build/release/cli/stoss build/venv/bin/python

web: ## build the page, with the core in WebAssembly, into build/web
	@scripts/install-dependencies.sh page
	@scripts/web.sh $(JOBS) && echo "built: build/web; any static server can serve it (make web-serve)"

web-serve: web ## serve it on this machine: http://127.0.0.1:8000 (PORT=... for another port)
	@$(PYTHON) -m http.server $(PORT) --bind 127.0.0.1 --directory build/web

wheel: ## the Python package for other machines, and its sources (sdist): build/dist
	@scripts/install-dependencies.sh python
	@scripts/wheel.sh

npm: ## the core in WebAssembly for JavaScript and TypeScript, as an npm package: build/dist
	@scripts/install-dependencies.sh page
	@scripts/npm.sh $(JOBS)

static: build ## the command without shared libraries, to be copied anywhere: build/static/stoss
	@cmake --build --preset release -j $(JOBS) --target stoss_static
	@install -D build/release/static/stoss build/static/stoss && ls -l build/static/stoss

try: ## build what has changed and run the tests of a source's room: make try FILE=src/contact/contact.cpp
	@scripts/try.sh "$(FILE)" $(JOBS)

test: ## what must hold: tests of every face, what handles memory under sanitizers, downstream projects, format
	@scripts/test.sh whole $(JOBS)

test-fast: ## only the fast ones of them, of the library and of the command
	@scripts/test.sh fast $(JOBS)

test-friends: ## programs of others, and the whole page in a browser, where what they take has changed (GROUP=..., ALL=1)
	@scripts/test.sh friends $(JOBS) $(if $(ALL),--all) $(GROUP)

test-long: ## before a release: all of it, everything under sanitizers, the documentation site, the validation, clang-tidy, coverage
	@scripts/test.sh long $(JOBS)

coverage: setup ## lines of src/ and cli/ that the fast tests run, by folder
	@scripts/coverage.sh $(JOBS)

systems: build ## build for other systems, and compare what the command computes there (SYSTEM=... for one of them)
	@for system in $${SYSTEM:-$$(scripts/systems.sh)}; do \
		scripts/systems.sh $$system $(JOBS) || [ $$? = 77 ] || exit 1; done

bench: setup python ## benchmarks, with the paper's protocol and finite elements as rivals; a line of bench/history.jsonl
	@cmake --preset release -DSTOSS_BUILD_BENCH=ON
	@cmake --build --preset release -j $(JOBS) --target stoss_bench
	@build/release/bench/stoss_bench --benchmark_out=build/bench.json --benchmark_out_format=json
	@$(PYTHON) bench/history.py build/bench.json

bench-compare: ## has anything become slower since the last release? (THRESHOLD=1.3, of bench/history.jsonl)
	@$(PYTHON) bench/compare.py --threshold $(THRESHOLD)

calibrate: setup ## what the references ask of each constant of the error bars (src/restitution/calibration.hpp)
	@cmake --preset release -DSTOSS_BUILD_VALIDATE=ON
	@cmake --build --preset release -j $(JOBS) --target stoss_validate
	@build/release/validate/stoss_validate --calibrate

validate: setup ## do the errors of restitution hold? writes docs/developer/validation.md, its points as CSV and picture
	@cmake --preset release -DSTOSS_BUILD_VALIDATE=ON
	@cmake --build --preset release -j $(JOBS) --target stoss_validate stoss_validate_rows
	@build/release/validate/stoss_validate --markdown=docs/developer/validation.md
	@$(PYTHON) validate/scatter.py docs/developer/validation.md docs/results/validation.csv docs/images/validation.png
	@build/release/validate/stoss_validate_rows 40 > docs/results/rows_validation.csv

results: setup python ## the tables of docs/results/ and the figures of docs/understand/
	@cmake --preset release -DSTOSS_BUILD_STUDIES=ON
	@cmake --build --preset release -j $(JOBS) --target stoss_curves stoss_gas stoss_half_space stoss_loss stoss_oblique \
		stoss_pairs stoss_plates stoss_rough_gas stoss_rows stoss_spheres stoss_vibration
	@build/release/studies/stoss_curves docs/results/restitution.csv
	@build/release/studies/stoss_pairs docs/results/pairs.csv
	@$(PYTHON) studies/pairs/figure.py docs/results/pairs.csv docs/images/pairs.png
	@build/release/studies/stoss_loss docs/results/loss.csv
	@$(PYTHON) studies/loss/figure.py docs/results/loss.csv docs/images/loss.png
	@$(PYTHON) studies/relaxing/make.py build/release/cli/stoss docs/results/relaxing
	@$(PYTHON) studies/relaxing/figure.py docs/results/relaxing docs/images
	@$(PYTHON) studies/rough/make.py build/release/cli/stoss docs/results/rough
	@$(PYTHON) studies/rough/figure.py docs/results/rough docs/images
	@$(PYTHON) studies/rows/make.py build/release/cli/stoss docs/results/rows
	@build/release/studies/stoss_rows docs/results/rows build/rows_wave.csv
	@$(PYTHON) studies/rows/figure.py docs/results/rows build/rows_wave.csv docs/images
	@build/release/examples/gas/stoss_gas docs/results/gas.csv build/gas_disks.csv
	@$(PYTHON) studies/gas/figure.py docs/results/gas.csv build/gas_disks.csv docs/images/gas.png
	@build/release/examples/gas/stoss_rough_gas docs/results/rough_gas.csv
	@$(PYTHON) studies/gas/rough_figure.py docs/results/rough_gas.csv docs/images/rough_gas.png
	@build/release/studies/stoss_spheres docs/results/spheres.csv
	@$(PYTHON) studies/spheres/figure.py docs/results/spheres.csv docs/results/restitution.csv docs/images/spheres.png
	@build/release/studies/stoss_half_space docs/results/half_space.csv
	@$(PYTHON) studies/half_space/figure.py docs/results/half_space.csv docs/images/half_space.png
	@build/venv/bin/python studies/half_space/wave.py docs/images/half_space_wave.png
	@build/venv/bin/python studies/half_space/ball_on_block.py docs/images/ball_on_block.png
	@build/venv/bin/python studies/half_space/film.py docs/images/film.gif
	@build/release/studies/stoss_plates docs/results/plates
	@$(PYTHON) studies/plates/figure.py docs/results/plates docs/images
	@build/venv/bin/python studies/plates/spreading.py docs/images/plates_wave.png
	@build/release/studies/stoss_oblique docs/results/oblique
	@$(PYTHON) studies/oblique/figure.py docs/results/oblique docs/images
	@$(PYTHON) studies/oblique/superball.py docs/results/oblique/superball.csv docs/images/superball.png
	@build/venv/bin/python studies/laws/make.py docs/results/laws.csv
	@$(PYTHON) studies/energy/figure.py build/release/cli/stoss docs/results/energy.csv docs/images/energy.png
	@build/venv/bin/python studies/energy/regimes.py docs/results/regimes.csv docs/images/regimes.png
	@$(PYTHON) studies/measured/figure.py build/release/cli/stoss docs/images/measured.png
	@build/release/studies/stoss_vibration docs/results/vibration
	@$(PYTHON) studies/vibration/figure.py docs/results/vibration docs/images

docs: setup python web ## the documentation site: build/docs/index.html
	@scripts/docs.sh $(JOBS)

paper: setup python ## reproduce the whole paper, in 40 s of processor time: out/paper/report.html
	@PYTHONPATH=studies build/venv/bin/python -m gerl_zippelius_1999 --output out/paper

paper-quick: setup python ## the same, coarser, in half of that: out/paper-quick/report.html
	@PYTHONPATH=studies build/venv/bin/python -m gerl_zippelius_1999 --quick --output out/paper-quick

format: setup ## format all sources
	@clang-format -i $(SOURCES)

lint: setup ## linters over all sources: ruff, Biome and clang-tidy
	@cd web && cmp -s package-lock.json node_modules/.installed || \
		{ npm ci --no-progress && cp package-lock.json node_modules/.installed; }
	@scripts/lint.sh
	@cmake --preset asan -B build/lint -DSTOSS_ARCHIVE= -DSTOSS_TEST_ROOMS= -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
	@scripts/tidy.sh "$(JOBS)"

install: build ## install to PREFIX (default /usr/local)
	@scripts/install.sh "$(PREFIX)"

uninstall: ## remove from PREFIX what `make install` put there
	@scripts/uninstall.sh "$(PREFIX)"

deb: $(if $(findstring nodoc,$(DEB_BUILD_PROFILES)),,docs) ## Debian packages, checked by lintian: build/deb (DEB_BUILD_PROFILES=nodoc: all but stoss-doc)
	@scripts/install-dependencies.sh deb
	@scripts/deb.sh $(JOBS)

release: ## test all, write and tag VERSION=2.0.0, make every package, and say what is left to a person
	@scripts/release.sh --check "$(VERSION)"
	@$(MAKE) --no-print-directory test-long
	@scripts/release.sh "$(VERSION)"
	@$(MAKE) --no-print-directory deb wheel npm static docs
	@scripts/release.sh --left "$(VERSION)"

clean: ## remove build and output folders
	@rm -rf build out
