"""Boundaries that documents draw: modules that stay apart, libraries of which one module alone knows, and files that
documents name."""

import pathlib
import re

import module_graph

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"

# ARCHITECTURE.md: modules -> what they link neither directly nor through others.
APART = {
    ("arena", "bodies", "behaviour", "controllers", "rays", "senses", "stage", "world"): ("device", "net", "server", "wire"),
    ("net",): ("wire",),
    ("config", "device", "device_server", "drivers", "libraries", "net", "server", "wire"): ("images", "mesh", "run", "scene", "world"),
    ("render",): ("scene", "world"),
    ("wire",): ("net",),
}
# What is included or written -> the modules that do.
ALONE = {
    r"#include <assimp/": ("mesh",),
    r"#include <(?:bt|BulletCollision/|BulletDynamics/|LinearMath/)": ("arena",),
    r"#include <(?:boost/(?:asio|beast)|asio[./])": ("net",),
    r"#include <openssl/": ("net",),
    r"#include <avahi-": ("discovery",),
    r"#include <(?:sys/socket|netinet/\w+)\.h>": ("app", "bridge", "drivers", "mesh", "net"),
    r"\bgeom::degrees\(": ("bridge", "drivers", "record", "scene"),  # docs/conventions.md
    r"#include <cassert>|\bassert\(": (),  # PLAYHOUSE_ASSERT is on in every build
}
# A file in a document: `module/file.h`, or its path; NAME stands for many.
NAMED = re.compile(r"`((?:[\w.-]+/)+[a-z0-9_.-]+\.(?:cc|cmake|h|inc|java|lisp|md|mjs|py|sh|tcl|toml|ts))`")
BESIDE = ("", "playhouse", "playhouse/world", "web", "clients/c/include", "clients/cpp/include")  # where documents mean it to be
EXAMPLES = {"kinds/altimeter.toml", "kinds/NAME.toml"}  # to be written by who reads


def findings(documents):
    yield from near()
    yield from strangers()
    for name in sorted(documents):
        yield from missing_files(name)


def near():
    for modules, others in APART.items():
        for module in modules:
            for other in sorted(module_graph.reachable(module) & set(others)):
                yield f"playhouse/{module}/CMakeLists.txt:1: {module} links {other}, and is to stay apart from it ({module_graph.MAP.name})"


def strangers():
    rules = [(re.compile(pattern), modules) for pattern, modules in ALONE.items()]
    for path in sorted(SOURCE.rglob("*")):
        if path.suffix not in (".h", ".cc", ".inc") or module_graph.is_test(path) or "generated" in path.parts:
            continue
        module = path.relative_to(SOURCE).parts[0]
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for pattern, modules in rules:
                if module not in modules and (found := pattern.search(line.split("//")[0])):
                    yield f"{path.relative_to(ROOT)}:{number}: {found[0]} is for {', '.join(modules) or 'no module'} (tools/boundaries.py)"


def missing_files(name):
    document = ROOT / name
    for number, line in enumerate(document.read_text().splitlines(), 1):
        for file in NAMED.findall(line):
            if not any((folder / file).exists() for folder in (document.parent, *(ROOT / each for each in BESIDE))) and file not in EXAMPLES:
                yield f"{name}:{number}: there is no {file}"
