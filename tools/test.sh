#!/bin/sh
# Every test, in three builds. The program as people run it, with the tests of what is computed: the optimiser makes vectors only
# there. Then all tests and fuzzers, with warnings as errors and the address and undefined-behaviour sanitizers. Then the tests of
# engine, server and drivers with the thread sanitizer. Last, whose files all of this read.
# Called by `make test` after the page is built.
set -eu
cd "$(dirname "$0")/.."

echo "== building the program and the tests of what is computed"
tools/configure.sh release-test
cmake --build --preset release-test
echo "== running the tests of what is computed, as the program is compiled"
ctest --test-dir build/release --output-on-failure -j "$(nproc)" -R '^(base|geom|stage|wire|replicate|drivers)\.'

echo "== building the tests and fuzzers (address and undefined sanitizers)"
tools/configure.sh ci
cmake --build --preset ci

echo "== running every test"
ctest --test-dir build/ci --output-on-failure -j "$(nproc)" "$@"

tools/tsan.sh behaviour stage server drivers

echo "== checking that all they read comes with the packages of tools/setup.sh"
tools/packages.py check --build build/release --build build/ci --build build/tsan
