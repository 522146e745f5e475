#!/bin/sh
# Builds tests with the thread sanitizer and runs them: tsan.sh [MODULE...], as in `tsan.sh drivers server`. Without a module those of
# all, with the program, and everything that has threads.
# A race anywhere is a failure, also in a program that a test kills: every process leaves its reports in a folder.
set -eu
cd "$(dirname "$0")/.."

echo "== building the tests (thread sanitizer)"
tools/configure.sh tsan
if [ $# -gt 0 ]; then
  targets=$(printf 'playhouse_%s_test ' "$@")
  chosen="-R ^($(printf '%s|' "$@" | sed 's/|$//'))\\."
else
  # Left out: what checks text, or runs programs of other builds (the page's tests use the release, fuzzers their own).
  targets=all
  chosen='-E ^(tree|codegen|web|fuzz)\.'
fi
# shellcheck disable=SC2086
cmake --build --preset tsan --target $targets

reports=$PWD/build/tsan/reports
rm -rf "$reports"
mkdir "$reports"
export TSAN_OPTIONS="halt_on_error=0 exitcode=66 log_path=$reports/race ${TSAN_OPTIONS:-}"
# Mesa's software renderer is not compiled for the sanitizer, which takes its threads' own locks for races: it has none.
export LP_NUM_THREADS=0

echo "== running the tests"
failed=0
# shellcheck disable=SC2086
ctest --test-dir build/tsan --output-on-failure -j "$(nproc)" $chosen || failed=$?

count=$(cat "$reports"/* 2>/dev/null | grep -c '^WARNING: ThreadSanitizer' || true)
if [ "$count" -ne 0 ]; then
  cat "$reports"/*
  echo "== $count reports of the thread sanitizer, in build/tsan/reports"
  exit 1
fi
[ "$failed" -ne 0 ] || echo "== no races"
exit "$failed"
