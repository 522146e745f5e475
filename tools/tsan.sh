#!/bin/sh
# Builds the tests and the program with the thread sanitizer and runs everything that has threads: tsan.sh [CTEST OPTIONS]
# A race anywhere is a failure, also in a program that a test kills: every process leaves its reports in a folder.
set -eu
cd "$(dirname "$0")/.."

echo "== building the tests (thread sanitizer)"
tools/configure.sh tsan
cmake --build --preset tsan

reports=$PWD/build/tsan/reports
rm -rf "$reports"
mkdir "$reports"
export TSAN_OPTIONS="halt_on_error=0 exitcode=66 log_path=$reports/race ${TSAN_OPTIONS:-}"

echo "== running the tests"
# Left out: what checks text, or runs programs of other builds (the page's tests use the release, fuzzers their own).
failed=0
ctest --test-dir build/tsan --output-on-failure -j "$(nproc)" -E '^(tree|codegen|web|fuzz)\.' "$@" || failed=$?

count=$(cat "$reports"/* 2>/dev/null | grep -c '^WARNING: ThreadSanitizer' || true)
if [ "$count" -ne 0 ]; then
  cat "$reports"/*
  echo "== $count reports of the thread sanitizer, in build/tsan/reports"
  exit 1
fi
[ "$failed" -ne 0 ] || echo "== no races"
exit "$failed"
