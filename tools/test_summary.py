#!/usr/bin/env python3
"""Counts the tests that ctest ran in some build folders, and names those that were skipped, with their reasons, from
ctest's logs: test_summary.py BUILD...

With --failures: what those that failed said, in the few lines that fit at the end of a log of which only the end is kept."""

from __future__ import annotations

import re
import sys
from collections import Counter
from pathlib import Path

# How the runners of all languages end: gtest, unittest, node's and vitest's, JUnit.
RAN = [re.compile(pattern, re.MULTILINE) for pattern in (
    r"^\[==========\] (\d+) tests? from .* ran\.", r"^Ran (\d+) tests? in ", r"^[#ℹ] tests (\d+)$",
    r"^ +Tests .*\((\d+)\)$", r"^OK \((\d+) tests?\)$")]
SKIPPED = [re.compile(pattern, re.MULTILINE) for pattern in (
    r"^\S+:\d+: Skipped\n(.+)$", r"skipped ['\"](.*)['\"]$", r"# SKIP (.+)$")]
COLOR = re.compile("\x1b\\[[0-9;]*m")

# A test in ctest's log, and the lines by which the runners and sanitizers say what is wrong.
TEST = re.compile(r"^\d+/\d+ Test: (\S+)\n.*?^Output:\n-+\n(.*?)<end of output>\n.*?^Test (Passed|Failed)", re.MULTILINE | re.DOTALL)
FAULT = re.compile(r": Failure$|\[  FAILED  \] \w+\.|^(FAIL|ERROR): |^\w*Error: |^not ok |✖ |runtime error: |SUMMARY: |: warning: |^FAULT|Assertion")
FAULT_LINES = 4  # of a fault: where, what was expected, what was there
FAILURE_LINES = 18  # in all


def log_of(build: Path) -> str:
    log = build / "Testing" / "Temporary" / "LastTest.log"
    return COLOR.sub("", log.read_text(encoding="utf-8", errors="replace")) if log.exists() else ""


def faults(output: str) -> list[str]:
    """The lines of a test's output that say what failed; its last ones if none does."""
    lines = [line for line in output.splitlines() if line.strip()]
    starts = [at for at, line in enumerate(lines) if FAULT.search(line)]
    kept = sorted({at for start in starts for at in range(start, min(start + FAULT_LINES, len(lines)))})
    return [lines[at] for at in kept] or lines[-FAULT_LINES:] or ["no output; its time was up, or it was killed"]


def print_failures(builds: list[Path]) -> None:
    failed = [(name, output) for build in builds for name, output, result in TEST.findall(log_of(build)) if result == "Failed"]
    for name, output in failed:
        print(f"== {name} failed")
        for line in faults(output)[:max(FAILURE_LINES // len(failed), FAULT_LINES)]:
            print("   " + line[:200])


def main() -> None:
    if sys.argv[1:2] == ["--failures"]:
        return print_failures([Path(build) for build in sys.argv[2:]])
    for build in map(Path, sys.argv[1:]):
        text = log_of(build)
        count = sum(int(number) for pattern in RAN for number in pattern.findall(text))
        skipped = Counter(reason for pattern in SKIPPED for reason in pattern.findall(text))
        print(f"== {build}: {count} tests, {sum(skipped.values())} skipped")
        for reason, times in skipped.most_common():
            print(f"   skipped {times}: {reason}")


if __name__ == "__main__":
    main()
