#!/bin/sh
# cores.sh [PRESET...]: builds the device server alone, for this machine and for machines of other kinds, and has a client
# compare it with the whole program, which must be built; by qemu where this machine cannot run it (docs/small.md). On the
# machine that differs most, big-endian and of 32 bits, all its tests run.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- core core-arm64 core-armhf core-powerpc
for preset in "$@"; do
  tools/configure.sh "$preset"
  if [ "$preset" = core-powerpc ]; then
    cmake --build --preset "$preset"
    ctest --test-dir "build/$preset" --no-tests=error --output-on-failure
  else
    cmake --build --preset "$preset" --target player
    ctest --test-dir "build/$preset" --no-tests=error --output-on-failure -R core.e2e
  fi
done
