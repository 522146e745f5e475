#!/bin/sh
# Every test, in three builds; each finds what the others don't. The program as people run it, with the tests of what is
# computed: the optimiser makes vectors only there. All tests and fuzzers, with warnings as errors and the address and
# undefined-behaviour sanitizers. The tests of engine, server, drivers and bridge with the thread sanitizer. The device server alone, for machines of
# other kinds as well.
# Called by `make test`, which installs what is missing. Arguments are ctest's, for the second build.
set -eu
cd "$(dirname "$0")/.."
. tools/steps.sh
rm -f build/*/Testing/Temporary/LastTest.log  # of earlier runs
trap 'report_steps; python3 tools/test_summary.py --failures build/release build/ci build/tsan' EXIT

step "building the page" make --no-print-directory web
step "configuring the program" tools/configure.sh release-test
step "building the program and the tests of what is computed" cmake --build --preset release-test
step "running the tests of what is computed, as the program is compiled" \
  ctest --test-dir build/release --output-on-failure -j "$(nproc)" -L computed
step "configuring the tests (address and undefined sanitizers)" tools/configure.sh ci
step "building the tests and fuzzers (address and undefined sanitizers)" cmake --build --preset ci
step "running every test" ctest --test-dir build/ci --output-on-failure -j "$(nproc)" "$@"
step "building the device server alone, for four kinds of machines, and running its tests" tools/cores.sh
step "building and running tests with the thread sanitizer" tools/tsan.sh bodies rays senses stage run server drivers bridge
step "checking that all they read comes with the packages of tools/setup.sh" \
  tools/packages.py check --build build/release --build build/ci --build build/tsan
python3 tools/test_summary.py build/release build/ci build/tsan
