#!/bin/sh
# configure.sh PRESET: configures build/PRESET, quietly unless it fails. One that was configured for another place, as in a
# checkout that was moved or copied, is begun anew: its cache is full of paths that are no more.
set -eu
cd -P "$(dirname "$0")/.."
preset=${1:?usage: configure.sh PRESET}
cache=build/$preset/CMakeCache.txt
fresh=
mkdir -p build
if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" "$cache"; then
  echo "== build/$preset was made in another place: it is configured anew"
  fresh=--fresh
fi
# CMake forgets a preset's other settings when the compiler is another one than the cache's.
[ ! -f "$cache" ] || [ "$cache" -nt CMakePresets.json ] || fresh=--fresh
log=build/configure-$preset.log
# shellcheck disable=SC2086
cmake $fresh --preset "$preset" -Wno-dev > "$log" 2>&1 || { cat "$log"; exit 1; }
