#!/usr/bin/env python3
"""Counts the tests that ctest ran in some build folders, and names those that were skipped, with their reasons, from
ctest's logs: test_summary.py BUILD..."""

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


def log_of(build: Path) -> str:
    log = build / "Testing" / "Temporary" / "LastTest.log"
    return COLOR.sub("", log.read_text(encoding="utf-8", errors="replace")) if log.exists() else ""


def main() -> None:
    for build in map(Path, sys.argv[1:]):
        text = log_of(build)
        count = sum(int(number) for pattern in RAN for number in pattern.findall(text))
        skipped = Counter(reason for pattern in SKIPPED for reason in pattern.findall(text))
        print(f"== {build}: {count} tests, {sum(skipped.values())} skipped")
        for reason, times in skipped.most_common():
            print(f"   skipped {times}: {reason}")


if __name__ == "__main__":
    main()
