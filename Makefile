# Front door for people and machines; CMake does the work. `make help` lists the commands.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.ONESHELL:
.DEFAULT_GOAL := help
.PHONY: help demo designer python docs deb test-deb dist paper test test-long test-sanitized test-sanitized-python test-threads fuzz mutations coverage compilers lint bench bench-peers tolerances free-end verify-fe verify-siconos format clean

JOBS := $(shell nproc)
define BUILD
cmake --log-level=WARNING --preset $(1) $(2) > /dev/null
cmake --build --preset $(1) --parallel $(JOBS) $(if $(3),--target $(3))
endef

help: ## list the commands
	@grep -E '^[a-z-]+:.*##' Makefile | sed -E 's/^([a-z-]+):.*## /\1|/' | awk -F'|' '{printf "make %-22s %s\n", $$1, $$2}'

# The designer's solver is all of the library compiled again: the demo leaves it to `make designer`, but keeps one that a
# folder of build has.
demo: ## install what is missing, build, run the reference bearing in four directions, make its report
	@scripts/require_packages.sh build
	$(call BUILD,release,$(if $(wildcard build/release/CMakeCache.txt),,-DBUMPFOIL_BUILD_DESIGNER=OFF),bumpfoil)
	echo
	build/release/bumpfoil cycle examples/gen1.toml -o results/demo --force
	build/release/bumpfoil report results/demo --force --quiet
	echo
	echo "Results: $(CURDIR)/results/demo"
	echo "Report:  $(CURDIR)/results/demo/report.html (open it in a browser)"
	echo "Time: $$SECONDS s in all"

designer: ## the program as one HTML page: change the bearing, see it answer
	@scripts/require_packages.sh build designer
	$(call BUILD,release,-DBUMPFOIL_BUILD_DESIGNER=ON)
	echo
	mkdir -p results
	build/release/bumpfoil designer -o results/designer.html --force --quiet
	echo "Designer: $(CURDIR)/results/designer.html (open it in a browser)"

python: ## the Python package, from Debian's packages alone
	@scripts/require_packages.sh build python
	$(call BUILD,release,-DBUMPFOIL_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3)
	echo
	PYTHONPATH=build/release/python /usr/bin/python3 -B -c 'import bumpfoil; print("Built: bumpfoil", bumpfoil.__version__)'
	echo "To import it:  export PYTHONPATH=$(CURDIR)/build/release/python"

docs: ## the documentation as a site that opens without a network
	@scripts/require_packages.sh build python docs
	$(call BUILD,release,-DBUMPFOIL_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3)
	echo
	/usr/bin/python3 -B docs/site/build.py build/release/python build/docs
	echo "Documentation: $(CURDIR)/build/docs/html/docs/index.html (open it in a browser)"

deb: ## a Debian package: program, library, headers, Python package, documentation, examples
	@scripts/require_packages.sh build designer python package
	$(call BUILD,release,-DBUMPFOIL_BUILD_DESIGNER=ON -DBUMPFOIL_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3)
	echo
	cpack --config build/release/CPackConfig.cmake -B build/release > /dev/null
	rm -rf build/release/_CPack_Packages
	echo "Package: $$(ls -t build/release/bumpfoil_*.deb | head -1) (install it: apt-get install ./FILE)"

test-deb: deb ## as root: install that package, use it, remove it; lintian judges it
	@scripts/require_packages.sh package plot test
	scripts/check_deb.sh "$$(ls -t build/release/bumpfoil_*.deb | head -1)"

dist: ## the sources of the last commit as a tarball, which builds and is tested without git
	@version="$$(sed -nE 's/^project\(bumpfoil VERSION ([0-9.]+) .*/\1/p' CMakeLists.txt)"
	mkdir -p build
	git archive --prefix="bumpfoil-$$version/" --output="build/bumpfoil-$$version.tar.gz" HEAD
	if [[ -n "$$(git status --porcelain)" ]]; then echo "warning: changes that are not committed are not in it" >&2; fi
	echo "Sources: $(CURDIR)/build/bumpfoil-$$version.tar.gz"

paper: ## reproduce the studies of the source paper, and further ones, with pictures
	@scripts/require_packages.sh build plot
	$(call BUILD,release)
	echo
	build/release/bumpfoil reproduce -o results/paper --all --force
	echo
	echo "Results: $(CURDIR)/results/paper"

tolerances: ## scatter of heights, thicknesses, clearance, friction: data and page; TOLERANCES="--heights N --others N"
	@scripts/require_packages.sh build test
	$(call BUILD,release)
	/usr/bin/python3 -B studies/tolerances/ensembles.py build/release/bumpfoil results/tolerances $(TOLERANCES)

free-end: ## the free end of the top foil: data, tables of its page, pictures
	@scripts/require_packages.sh build plot
	$(call BUILD,release)
	/usr/bin/python3 -B studies/free_end/free_end.py build/release/bumpfoil results/free_end

test: ## install what is missing, build with assertions armed, run all tests but the long ones
	@scripts/require_packages.sh build plot designer python docs test
	$(call BUILD,release-audit)
	ctest --preset release-audit --parallel $(JOBS)

test-long: ## the longest tests, which are left out of `make test`
	@scripts/require_packages.sh build plot designer python docs test
	$(call BUILD,release-audit)
	ctest --preset long --parallel $(JOBS)

test-sanitized: ## the tests of the code again, under the address and undefined-behaviour sanitizers
	@scripts/require_packages.sh build plot test fuzz
	$(call BUILD,dev)
	ctest --preset dev --parallel $(JOBS)

test-sanitized-python: ## the tests of the Python package under the address and undefined-behaviour sanitizers
	@scripts/require_packages.sh build plot python test
	$(call BUILD,dev-python)
	ctest --preset dev-python --parallel $(JOBS)

# Where tasks of oneTBB begin and end the sanitizer sees only of one that was built with it.
test-threads: ## the tests of what runs on several threads, under the thread sanitizer
	@scripts/require_packages.sh build plot test
	scripts/sanitized_tbb.sh build/threads-tbb
	$(call BUILD,threads)
	ctest --preset threads

FUZZ_MINUTES := 1
fuzz: ## feed every fuzzer of tests/fuzz/ by clang and its sanitizers for FUZZ_MINUTES=1 each; what they find is in results/fuzz
	@scripts/require_packages.sh build plot test fuzz
	$(call BUILD,dev,,fuzz_bytes)
	scripts/fuzz.sh build/dev/fuzz_bytes results/fuzz "$(FUZZ_MINUTES)"

mutations: ## change one token of the sources at a time and see whether tests notice; MUTATIONS="--module contact --count 20"
	@scripts/require_packages.sh build plot test
	$(call BUILD,release-audit)
	/usr/bin/python3 -B scripts/mutations.py build/release-audit results/mutations.jsonl $(MUTATIONS)

# Exceptions make branches of every call, which say nothing. Aims: 95 % of lines and 85 % of branches where numbers are
# made, 90 % of lines in all.
coverage: ## lines and branches that the short tests of the code run, in results/coverage; fails below the aims
	@scripts/require_packages.sh build plot test coverage
	$(call BUILD,coverage)
	find build/coverage -name '*.gcda' -delete
	ctest --preset coverage --parallel $(JOBS)
	mkdir -p results/coverage
	gcovr -j $(JOBS) --filter '(src|include|apps)/' --exclude-throw-branches \
	  --exclude-unreachable-branches --json results/coverage/coverage.json build/coverage
	gcovr --add-tracefile results/coverage/coverage.json --fail-under-line 90 \
	  --html-details results/coverage/index.html --print-summary
	gcovr --add-tracefile results/coverage/coverage.json --print-summary --fail-under-line 95 --fail-under-branch 85 \
	  --filter '(src|include/bumpfoil)/(contact|structure|film|bearing|motion|rotor|experiments|optimise)/'
	echo "Coverage: $(CURDIR)/results/coverage/index.html (open it in a browser)"

# The baseline leaves out the wider vector instructions, which are chosen at run time elsewhere.
compilers: ## build the program by g++ and clang++, -O2 and -O3, with and without wide vectors; results agree to 1e-9
	@scripts/require_packages.sh build test fuzz
	build_by() {
	  cmake --log-level=WARNING --preset release -B "build/compilers/$$1" -DCMAKE_CXX_COMPILER="$$2" \
	    -DCMAKE_CXX_FLAGS_RELEASE="$$3 -DNDEBUG" -DBUMPFOIL_BUILD_DESIGNER=OFF -DBUMPFOIL_BUILD_REPORT=OFF > /dev/null
	  cmake --build "build/compilers/$$1" --parallel $(JOBS) --target bumpfoil
	}
	build_by gcc g++ -O2
	build_by gcc-baseline g++ "-O3 -DBUMPFOIL_BASELINE_ONLY"
	build_by clang clang++ -O3
	build_by clang-baseline clang++ "-O2 -DBUMPFOIL_BASELINE_ONLY"
	for other in gcc-baseline clang clang-baseline; do
	  /usr/bin/python3 -B scripts/compare_programs.py build/compilers/{gcc,"$$other"}/bumpfoil --drawn 0 --zero 1e-9
	done

lint: ## install what is missing, let clang-tidy read the sources
	@scripts/require_packages.sh build python test bench lint
	scripts/lint.sh

bench: ## build and run the benchmarks; JSON in results/bench
	@scripts/require_packages.sh build bench
	$(call BUILD,bench)
	mkdir -p results/bench
	build/bench/bumpfoil_bench --benchmark_repetitions=5 --benchmark_report_aggregates_only=true \
	  --benchmark_out=results/bench/bumpfoil_bench.json --benchmark_out_format=json
	@echo "Results: $(CURDIR)/results/bench"

bench-peers: ## time other solvers on the same problems; ratios in results/bench/peers.json
	@scripts/require_packages.sh build bench verify
	$(call BUILD,bench)
	mkdir -p results/bench
	/usr/bin/python3 -B bench/peers/compare.py build/bench/bumpfoil_peers results/bench

verify-fe: ## compare with finite elements of CalculiX; writes docs/verification/fe_*.md and their data
	@scripts/require_packages.sh build plot test verify
	cmake --log-level=WARNING --preset release-audit > /dev/null
	cmake --build --preset release-audit --parallel $(JOBS) --target bumpfoil shells_study
	programs=(build/release-audit/bumpfoil build/release-audit/shells_study)
	/usr/bin/python3 -B tests/verification/fe/verify_fe.py "$${programs[@]}" results/verify-fe

verify-siconos: ## compare with the contact solvers of Siconos on random problems; writes tests/data/siconos.json
	@scripts/require_packages.sh build plot test verify
	cmake --log-level=WARNING --preset release-audit > /dev/null
	cmake --build --preset release-audit --parallel $(JOBS) --target siconos_study verification_by_others
	cd tests
	# Threads of the linear algebra only get in each other's way in systems this small.
	OPENBLAS_NUM_THREADS=1 ../build/release-audit/siconos_study > data/siconos.json
	../build/release-audit/verification_by_others --gtest_filter='Siconos*'

format: ## format the C++ sources in place
	@find include src apps python tests bench examples -name '*.[ch]pp' -exec clang-format -i {} +

clean: ## remove what was built and the results of the demo
	@rm -rf build results/demo results/paper
