# Two commands for a fresh clone: `make demo` draws a real model, `make test` runs every test. Both install what is
# missing first (Debian packages of packages.txt) and build.
JOBS ?= $(shell nproc)
BUILD := build/release

.PHONY: all demo test setup build docs bench clean

all: build

setup:
	@tools/setup.sh

build: setup
	@test -f $(BUILD)/build.ninja || cmake --preset release
	@cmake --build --preset release -j $(JOBS)

demo: build
	@tools/demo.py --croquis $(BUILD)/croquis --output build/demo

test: build
	@ctest --preset release -j $(JOBS)

# Pictures and generated pages of docs/.
docs: build
	@tools/make_docs.py --croquis $(BUILD)/croquis

bench: build
	@$(BUILD)/croquis bench --techniques all
	@for program in croquis_bench_strokes croquis_bench_finders croquis_bench_lines croquis_bench_viewer; do \
	    $(BUILD)/bench/$$program --benchmark_enable_random_interleaving=true || exit 1; \
	done

clean:
	rm -rf build
