"""Headers and kernels of the modules that compute a tick say what goes in, what comes out and what it costs."""

import pathlib
import re

import module_graph

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"

MODULES = ("stage", "arena", "bodies", "rays")
LINES = ("In", "Out", "Cost")


def computing():
    """Headers of the modules, but those of tests; and kernels."""
    for module in MODULES:
        for path in sorted((SOURCE / module).rglob("*")):
            if "generated" not in path.parts and not module_graph.is_test(path) and not path.name.startswith("fuzz_") and (path.suffix == ".h" or path.name.endswith("_kernels.inc")):
                yield path


def missing():
    """Headers that only define values say "Values."."""
    for path in computing():
        comments = [line.partition("//")[2] for line in path.read_text().splitlines() if re.match(r"\s*//", line)]
        lacks = [name for name in LINES if not any(re.search(rf"\b{name}\b[\w, ]*:", line) for line in comments)]
        if lacks and not any(line.endswith("Values.") for line in comments):
            yield f"{path.relative_to(ROOT)}:1: says nothing of {', '.join(lacks)} (docs/conventions.md)"
