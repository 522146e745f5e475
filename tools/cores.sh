#!/bin/sh
# cores.sh [PRESET...]: builds the device server alone, for this machine and for machines of other kinds, and has a client
# compare it with the whole program, which must be built; by qemu where this machine cannot run it (docs/small.md). Its other
# tests run for the machines of other kinds.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- core core-arm64 core-armhf core-powerpc
for preset in "$@"; do
  tools/configure.sh "$preset"
  if [ "$preset" = core ]; then  # those of `make test` are the same
    cmake --build --preset "$preset" --target player
    ctest --test-dir "build/$preset" --no-tests=error --output-on-failure -R core.e2e
  else
    cmake --build --preset "$preset"
    ctest --test-dir "build/$preset" -j2 --no-tests=error --output-on-failure
  fi
done
