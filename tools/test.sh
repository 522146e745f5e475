#!/bin/sh
# Builds the tests with warnings as errors and the sanitizers on, and runs everything through ctest.
# Called by `make test` after the release program, the page and the fuzzers are built.
set -eu
cd "$(dirname "$0")/.."

echo "== building the tests (address and undefined sanitizers)"
cmake --preset ci -Wno-dev > build/configure-ci.log 2>&1 || { cat build/configure-ci.log; exit 1; }
cmake --build --preset ci

echo "== running every test"
ctest --test-dir build/ci --output-on-failure -j "$(nproc)" "$@"
