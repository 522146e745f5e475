#!/bin/sh
# cores.sh [PRESET...]: builds the device server alone, for this machine and for machines of other kinds, and runs its tests,
# by qemu where this machine cannot (docs/small.md). Compares with the whole program, which must be built.
set -eu
cd "$(dirname "$0")/.."
for preset in "${@:-core core-arm64 core-armhf core-powerpc}"; do
  for each in $preset; do
    tools/configure.sh "$each"
    cmake --build --preset "$each"
    ctest --test-dir "build/$each" --output-on-failure
  done
done
