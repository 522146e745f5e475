#!/bin/sh
# fuzz.sh SECONDS [TARGET]: runs each libFuzzer program (or one) for SECONDS from its corpus in tests/fuzz. New inputs go
# under build/, so the corpus stays as it is; a crash leaves its input there and fails.
set -eu
cd "$(dirname "$0")/.."
# Freed memory is kept back for 8 MB, not 256, and stacks of allocations are short: 1.5 times the runs.
export ASAN_OPTIONS="${ASAN_OPTIONS:-quarantine_size_mb=8:malloc_context_size=6}"
seconds=${1:?usage: fuzz.sh SECONDS [TARGET]}
targets=${2:-$(find build/ci/playhouse build/ci/clients -name '*_fuzz' -type f -perm -u+x -exec basename {} \; | sort)}
[ -n "$targets" ] || { echo "fuzz.sh: no fuzzers under build/ci (make fuzzers)" >&2; exit 2; }

for target in $targets; do
  program=$(find build/ci/playhouse build/ci/clients -name "$target" -type f -perm -u+x | head -1)
  [ -n "$program" ] || { echo "fuzz.sh: no fuzzer $target under build/ci (make fuzzers)" >&2; exit 2; }
  name=${target%_fuzz}
  found=build/ci/found/$name
  mkdir -p "$found"
  words=tests/fuzz/$name.dict
  inputs=$name
  case "$name" in *_engine) words=tests/fuzz/scene_world.dict inputs=stage_engine ;; esac  # both engines run the same worlds
  corpus=tests/fuzz/$inputs
  if [ ! -d "$corpus" ]; then  # those that a test makes or reads are files, the others packed
    corpus=build/ci/corpus/$name
    tools/corpus.py unpack "$inputs" "$corpus"
  fi
  dictionary=
  [ -f "$words" ] && dictionary="-dict=$words"
  echo "== $target: $seconds s from $(find "$corpus/" -type f | wc -l) inputs"
  # One input may take longer than the process of its own that reads a mesh, which ends after 10 s of a processor.
  # shellcheck disable=SC2086
  "$program" -max_total_time="$seconds" -timeout=25 -rss_limit_mb=2048 -max_len=65536 -print_final_stats=1 \
    $dictionary -artifact_prefix="$found/crash-" "$found" "$corpus" > "$found.log" 2>&1 \
    || { tail -40 "$found.log"; echo "fuzz.sh: $target failed, see $found.log" >&2; exit 1; }
  grep -E "stat::number_of_executed_units|stat::new_units_added" "$found.log"
done
