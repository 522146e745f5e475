"""Numbers that package formats and other languages force to be written again: the version, which is that of the top
CMakeLists.txt, and the numbers of formats, which are those of playhouse/base/formats.h."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

# (file, what stands before the version)
VERSIONS = [
    (".github/ISSUE_TEMPLATE/bug.yml", r"placeholder: playhouse "),
    ("clients/c/CMakeLists.txt", r"project\(playhouse_c VERSION "),
    ("clients/cpp/CMakeLists.txt", r"project\(playhouse_client VERSION "),
    ("clients/lisp/playhouse-client.asd", r':version "'),
    ("clients/python/playhouse_client/__init__.py", r'__version__ = "'),
    ("clients/tcl/pkgIndex.tcl", r"package ifneeded playhouse "),
    ("clients/tcl/playhouse.tcl", r"variable version "),
    ("clients/typescript/package.json", r'^  "version": "'),
    ("clients/typescript/package-lock.json", r'^  "version": "'),
    ("clients/typescript/package-lock.json", r'^    "": \{\n      "name": "playhouse-client",\n      "version": "'),
]
# The same without its last part, by which CMake compares.
MINORS = [
    ("docs/libraries.md", r"find_package\(playhouse "),
    ("examples/custom/CMakeLists.txt", r"find_package\(playhouse "),
    ("tests/e2e/test_libraries.py", r"find_package\(\{package\} "),
    ("tests/e2e/test_outside_project.py", r"find_package\(playhouse_client "),
]
# (constant, file, what stands before its number)
FORMATS = [
    ("kSavedRun", "docs/versions.md", r"^\| saved runs \| "),
    ("kRecording", "docs/versions.md", r"^\| recordings \| "),
    ("kWireExtensions", "docs/versions.md", r"^\| additions to Player's protocol \| "),
    ("kRobots", "docs/versions.md", r"^\| robots of other machines \| "),
    ("kPage", "docs/versions.md", r"^\| page \| "),
    ("kObserver", "docs/versions.md", r"^\| observers \| "),
    ("kCluster", "docs/versions.md", r"^\| clusters \| "),
    ("kGym", "docs/versions.md", r"^\| learning programs \| "),
    ("kSavedRun", "docs/saved-runs.md", r'^"playhouse saved run '),
    ("kRecording", "docs/recording.md", r"`playhouse recording "),
    ("kPage", "docs/viewer-protocol.md", r"^\| `protocol` \| "),
    ("kCluster", "docs/cluster.md", r"text `playhouse cluster "),
    ("kGym", "docs/gym.md", r"the number of the format \("),
    ("kPage", "web/src/protocol/scene.ts", r"^  protocol: "),
    ("kPage", "web/src/protocol/scene.ts", r"message\.protocol === "),
    ("kGym", "clients/python/playhouse_gym/arena.py", r'_FORMAT = b"plhsgym\\0", '),
]


def version():
    return re.search(r"^project\(playhouse VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]


def formats():
    header = (ROOT / "playhouse/base/formats.h").read_text()
    return dict(re.findall(r"^inline constexpr [\w:]+ (k\w+) = (\d+);", header, re.M))


def _wanted():
    """(file, what stands before the number, the number)"""
    numbers = formats()
    yield from ((name, before, version()) for name, before in VERSIONS)
    yield from ((name, before, version().rpartition(".")[0]) for name, before in MINORS)
    yield from ((name, before, numbers[constant]) for constant, name, before in FORMATS)
    yield "CHANGELOG.md", r"^## \[(?!Unreleased)", version()


def findings():
    for name, before, number in _wanted():
        text = (ROOT / name).read_text()
        found = re.search(rf"(?:{before})([\d.]*)", text, re.M)
        line = text.count("\n", 0, found.start(1)) + 1 if found else 1
        if not found or found[1] != number:
            yield f"{name}:{line}: {number} should be here, as in CMakeLists.txt or formats.h (tools/versions.py)"
