#!/usr/bin/env python3
"""Checks rules that a compiler does not: module dependencies, boundaries that documents draw, missing includes, names
that say nothing or mean two things, calls that break reproducibility, messages that do not say what is invalid, test
scripts that do not run all of their tests, tests that sleep, version numbers and limits that differ, links to nothing,
generated files in git. Prints file:line: what; exit 1.
Without arguments only files that differ from main are checked, and their headers are compiled alone."""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import boundaries
import captions
import includes
import limits
import links
import messages
import module_graph
import names
import threads
import versions
import waits

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"

REPRODUCIBLE = set(re.search(r"multiply-add in `([a-z ]+)`", (ROOT / "docs/conventions.md").read_text())[1].split())
UNREPRODUCIBLE = re.compile(
    r"std::(sin|cos|tan|atan2?|asin|acos|exp|log|pow|hypot|rand)\(|\brand\(|random_device|unordered_|"
    r"(?:system|steady|high_resolution)_clock|\btime\(nullptr|clock_gettime|<random>|\bmt19937|\bfma\(")
EMPTY_NAME = re.compile(r"\b(?:class|struct|enum class)\s+(\w*(?:Manager|Handler|Helper|Util|Utils|Data|Info))\b")
# What the build defines for tests and the program.
BUILD = [f'-D{name}=""' for name in ("PLAYHOUSE_SOURCE_DIR", "EXAMPLE_CONTROLLERS")]
# Of libraries whose headers are in a folder of their own.
BUILD += subprocess.run(["pkg-config", "--cflags", "bullet"], capture_output=True, text=True, check=True).stdout.split()
# What Debian 12's node, 18, lacks, though the machine may have a newer one.
NEWER_NODE = re.compile(r"import\.meta\.(?:dirname|filename|resolve)|\bwithResolvers\b|\.(?:toSorted|toReversed|toSpliced)\(|\bgroupBy\(|\bstyleText\b|"
                        r"node:sqlite")
CLIENT = [ROOT / "clients/cpp/include", ROOT / "clients/cpp/generated"]  # which the command line is made of


def sources():
    return sorted(p for p in SOURCE.rglob("*") if p.suffix in (".h", ".cc", ".inc") and "generated" not in p.parts)


def check_file(path):
    module = path.relative_to(SOURCE).parts[0]
    is_test = path.stem.endswith(("_test", "_bench", "_fuzz"))
    for number, includer, included in module_graph.wrong_includes(path):
        yield f"{path.relative_to(ROOT)}:{number}: {includer} may not include {included}: it does not link it (DEPS)"
    yield from messages.odd_phrases(path)
    if path.suffix == ".inc":
        return
    for number, line in enumerate(path.read_text().splitlines(), 1):
        where = f"{path.relative_to(ROOT)}:{number}"
        code = line.split("//")[0]
        empty = EMPTY_NAME.search(code)
        if empty:
            yield f"{where}: {empty[1]} is a name that says nothing"
        if module in REPRODUCIBLE and not is_test and UNREPRODUCIBLE.search(code):
            yield f"{where}: {UNREPRODUCIBLE.search(code)[0]} makes a run depend on more than its seed"
    for number, name, header in includes.missing(path, (ROOT, *CLIENT)):
        yield f"{path.relative_to(ROOT)}:{number}: {name} needs #include <{header}>"


def check_header(path):
    with tempfile.NamedTemporaryFile("w", suffix=".cc") as alone:
        alone.write(f'#include "{path.relative_to(ROOT)}"\n')
        alone.flush()
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", *BUILD, f"-I{ROOT}", *(f"-I{folder}" for folder in CLIENT), alone.name], capture_output=True, text=True)
    if done.returncode:
        first = next((line for line in done.stderr.splitlines() if "error" in line), done.stderr[:200])
        yield f"{path.relative_to(ROOT)}:1: does not compile alone: {first}"


def check_node_script(path):
    """Run by node: tests, and tools of the build."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = NEWER_NODE.search(line)
        if found:
            yield f"{path.relative_to(ROOT)}:{number}: node 18 of Debian 12 has no {found[0]}"


def check_test_script(path):
    """Definitions behind unittest.main() never run."""
    lines = path.read_text().splitlines()
    calls = [number for number, line in enumerate(lines, 1) if line.strip() == "unittest.main()"]
    if not calls or any(line and not line.startswith("#") for line in lines[calls[0]:]):
        yield f"{path.relative_to(ROOT)}:{calls[0] if calls else 1}: a test script ends with unittest.main()"


def git(*words, **more):
    """The lines that a command of git prints."""
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, **more)
    if done.returncode > 1:
        sys.exit(done.stderr)
    return done.stdout.splitlines()


def generated():
    """What codegen makes, which it does first: a fresh clone has none of it, and headers and documents name it."""
    subprocess.run([sys.executable, "-m", "codegen"], cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
    return subprocess.run([sys.executable, "-m", "codegen", "--list"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()


def kept_by_git(names):
    """Generated files that git has, or would take (docs/adr/0026)."""
    yield from (f"{name}:1: git has it though .gitignore names it: git rm --cached" for name in git("ls-files", "-ci", "--exclude-standard"))
    ignored = git("check-ignore", "--no-index", "--stdin", input="\n".join(names))
    yield from (f"{name}:1: codegen makes it, and .gitignore does not name it" for name in sorted({*names} - {*ignored}))


def changed():
    """Files that differ from main, committed on a branch or not committed yet."""
    lists = [["diff", "--name-only", "main..."], ["diff", "--name-only", "HEAD"], ["ls-files", "--others", "--exclude-standard"]]
    names = {name for command in lists for name in git(*command)}
    return [path for path in sources() if str(path.relative_to(ROOT)) in names]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--all", action="store_true", help="check every source file, as make test does")
    parser.add_argument("--write-table", action="store_true", help="write the modules' links into ARCHITECTURE.md")
    options = parser.parse_args()
    if options.write_table:
        print("\n".join(module_graph.table_findings(write=True)) or "tidy: the table is in order")
        return 0
    made = generated()
    check_all = options.all
    checked = sources() if check_all else changed()
    findings = [finding for path in checked for finding in check_file(path)]
    ours = ["ls-files", "--cached", "--others", "--exclude-standard"]
    scripts = git(*ours, "*.mjs", "web/*.test.ts", "web/*.config.ts", "clients/typescript/*.ts")
    findings += [finding for name in scripts if (ROOT / name).is_file() for finding in check_node_script(ROOT / name)]
    documents = {*git(*ours, "*.md"), *(name for name in made if name.endswith(".md"))}
    findings += [finding for name in sorted(documents) if (ROOT / name).is_file() for finding in links.dead(ROOT / name)]
    findings += kept_by_git(made)
    findings += module_graph.table_findings()
    findings += module_graph.large_folders()
    findings += threads.findings()
    findings += versions.findings()
    written = [name for name in documents if (ROOT / name).is_file()]
    findings += limits.findings(written)
    findings += boundaries.findings(written)
    findings += waits.findings(git(*ours))
    findings += captions.missing()
    findings += names.defined_twice()
    findings += names.unknown_types()
    instead = names.refused()
    findings += [finding for path in checked for finding in names.refused_words(path, instead)]
    findings += [finding for folder in (ROOT / "tests", ROOT / "clients/python") for path in sorted(folder.glob("*/test_*.py")) for finding in check_test_script(path)]
    headers = [path for path in checked if path.suffix == ".h" and not check_all]
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(lambda path: list(check_header(path)), headers):
            findings += found
    print("\n".join(findings) or f"tidy: {len(checked)} files in order")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
