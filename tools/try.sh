#!/bin/sh
# Builds the tests of one module without optimiser and sanitizers, and runs them: try.sh MODULE [OPTIONS of the test program]
set -eu
cd "$(dirname "$0")/.."
module=${1:?usage: try.sh MODULE [--gtest_filter=...]}
shift
[ -f "playhouse/$module/CMakeLists.txt" ] || { echo "try.sh: invalid module $module: a folder of playhouse/ is valid" >&2; exit 2; }
[ -f build/quick/build.ninja ] || tools/configure.sh quick
cmake --build build/quick --target "playhouse_${module}_test"
exec "build/quick/playhouse/$module/playhouse_${module}_test" --gtest_brief=1 "$@"
