#!/bin/sh
# Prints one JSON line per benchmark, on one thread: the simulation scenarios, then the server. docs/benchmarks.md says what they measure.
set -eu
cd "$(dirname "$0")/.."
program=${PLAYHOUSE_PROGRAM:-build/playhouse}
"$program" bench laser --robots 1000
"$program" bench sonar --robots 1000
"$program" bench cave --robots 100
"$program" bench swarm --robots 10000
"$program" bench mixed --robots 10000
"$program" bench load --robots 100000
"$program" bench server
