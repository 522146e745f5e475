#!/bin/sh
# Builds the tests with warnings as errors and the sanitizers on, and runs everything through ctest. Before that the tests of
# what is computed, compiled as the program is: the optimiser makes vectors only there. After it the tests of engine, server and
# drivers with the thread sanitizer.
# Called by `make test` after the release program, the page and the fuzzers are built.
set -eu
cd "$(dirname "$0")/.."

echo "== building and running the tests of what is computed, as the program is compiled"
tools/configure.sh release-test
cmake --build --preset release-test
ctest --test-dir build/release-test --output-on-failure -j "$(nproc)" -R '^(base|geom|stage|wire|replicate|drivers)\.'

echo "== building the tests (address and undefined sanitizers)"
tools/configure.sh ci
cmake --build --preset ci

echo "== running every test"
ctest --test-dir build/ci --output-on-failure -j "$(nproc)" "$@"

tools/tsan.sh behaviour stage server drivers
