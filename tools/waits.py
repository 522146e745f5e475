"""Tests wait for what they need, never for a time: in their files nothing sleeps and nothing reads a clock, but for one
helper in each language that needs it."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

HELPERS = {
    "clients/tcl/tests/waiting.tcl",
    "playhouse/base/testing/wait.h",
    "tests/waiting.py",
    "web/e2e/delaying_proxy.mjs",  # a slow link
}
IS_TEST = re.compile(r"(?:^|/)(?:tests|e2e)/|(?:^|/)test_[^/]*$|_test\.\w+$|\.test\.\w+$|(?:^|/)testing_?[^/]*(?:$|/)")

_C = r"\b(?:sleep_for|sleep_until|u?sleep|nanosleep|gettimeofday|clock_gettime)\s*\(|\w*[cC]lock::now\b|\bmonotonic_seconds\b|\btime\((?:nullptr|NULL|0)\)|\bpoll\((?:nullptr|NULL),"
_JAVASCRIPT = r"\b(?:waitForTimeout|setTimeout|setInterval)\b|timers/promises|\b(?:Date|performance)\.now\(|new Date\(\)"
_TCL = r"(?:^\s*|[\[{;]\s*)after [1-9$]|\bclock (?:seconds|\w+seconds|clicks)\b|playhouse::now\b"
PATTERNS = {
    ".c": _C, ".cc": _C, ".h": _C,
    ".java": r"\bThread\.sleep\b|\bSystem\.(?:nanoTime|currentTimeMillis)\b|\bInstant\.now\b|TimeUnit\.\w+\.sleep\b",
    ".lisp": r"\((?:sleep|get-universal-time|get-internal-real-time|sb-ext:get-time-of-day)\b",
    ".mjs": _JAVASCRIPT, ".ts": _JAVASCRIPT,
    ".py": r"\btime\.(?:sleep|time|monotonic|perf_counter)(?:_ns)?\(|\bfrom time import\b|\basyncio\.sleep\b|\bdatetime\.(?:now|utcnow|today)\(",
    ".tcl": _TCL, ".test": _TCL,
}


def findings(names):
    """"file:line: what" of each place of the tests among these files."""
    for name in sorted(names):
        path = pathlib.Path(name)
        if name in HELPERS or path.suffix not in PATTERNS or not IS_TEST.search(name):
            continue
        if (ROOT / name).is_file():
            yield from _in_file(name, re.compile(PATTERNS[path.suffix]))


def _in_file(name, pattern):
    for number, line in enumerate((ROOT / name).read_text().splitlines(), 1):
        if found := pattern.search(line):
            yield f"{name}:{number}: {found[0].strip()} in a test, which waits for what it needs, by a helper of tools/waits.py, and not for a time"
