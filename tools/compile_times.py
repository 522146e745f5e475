#!/usr/bin/env python3
"""What each unit of a build takes the compiler: compile_times.py PRESET [TARGET...] builds a preset anew, one unit at a time,
in build/times-PRESET, and prints processor seconds and peak memory of each, the dearest first, and their sum by module.

CMake starts this file before each compiler as well (CMAKE_CXX_COMPILER_LAUNCHER): it then runs the command and notes it."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NOTES = "PLAYHOUSE_COMPILE_TIMES"
LEAST_SECONDS = 1.0  # of a unit that is listed


def compile_and_note(command: list[str], notes: str) -> int:
    status = subprocess.call(command)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    output = command[command.index("-o") + 1] if "-o" in command else "-"
    with open(notes, "a", encoding="utf-8") as file:
        file.write(f"{used.ru_utime + used.ru_stime:.2f}\t{used.ru_maxrss // 1024}\t{output}\n")
    return status


def build(preset: str, targets: list[str], folder: Path, notes: Path) -> None:
    subprocess.run(["rm", "-rf", folder], check=True)
    folder.mkdir(parents=True)
    subprocess.run(["cmake", "--preset", preset, "-B", folder, "-Wno-dev", f"-DCMAKE_CXX_COMPILER_LAUNCHER={__file__}",
                    f"-DPLAYHOUSE_PROGRAM_DIR={folder}/bin"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "-j1", *(["--target", *targets] if targets else [])], cwd=ROOT, check=True,
                   env={**os.environ, NOTES: str(notes)}, stdout=subprocess.DEVNULL)


def report(notes: Path) -> None:
    units = []
    modules: Counter[str] = Counter()
    for line in notes.read_text(encoding="utf-8").splitlines():
        seconds, megabytes, output = line.split("\t")
        folder, _, unit = output.partition("CMakeFiles/")
        units.append((float(seconds), int(megabytes), folder + unit))
        modules[folder.rstrip("/")] += float(seconds)
    for seconds, megabytes, unit in sorted(units, reverse=True):
        if seconds >= LEAST_SECONDS:
            print(f"{seconds:6.1f} s {megabytes:5} MB  {unit}")
    print("  ".join(f"{module} {seconds:.0f} s" for module, seconds in modules.most_common()))
    print(f"{len(units)} units, {sum(unit[0] for unit in units):.0f} s, the dearest {max(unit[0] for unit in units):.1f} s, "
          f"the largest {max(unit[1] for unit in units)} MB")


def main() -> int:
    if notes := os.environ.get(NOTES):
        return compile_and_note(sys.argv[1:], notes)
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print("usage: compile_times.py PRESET [TARGET...]", file=sys.stderr)
        return 2
    preset, *targets = sys.argv[1:]
    folder = ROOT / "build" / f"times-{preset}"
    notes = folder / "compile_times.tsv"
    build(preset, targets, folder, notes)
    report(notes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
