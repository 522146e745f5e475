#!/usr/bin/env python3
"""Checks that what building and testing read below /usr comes with the packages of `tools/setup.sh --list`: with those, what
they depend on (not what they recommend), and what a Debian has that was made with git and make alone. On a machine that has
more, nothing else would show that a package is missing from the list.

  packages.py check [--build FOLDER]... [--trace FILE]... [--without PACKAGE]...
      --build    a build folder of CMake and Ninja: what configuring, compiling and linking in it read. Needed by `make build`
                 is what the program of the folder `release` is made of
      --trace    what programs opened: the output of `strace -f -y --seccomp-bpf -z -e trace=open,openat,execve -o FILE`. What a
                 file whose name begins with "build." tells is needed by `make build`, any other by `make test`
      --without  as if setup.sh did not list it
  packages.py list build|test
      the packages that a bare machine has after setup.sh

Prints a line for each package that is read and not brought; exit 1. Standard library only."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections import defaultdict

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What debootstrap --variant=minbase installs beside packages that are essential or required, and what README.md asks for.
BARE = ["apt", "git", "make"]
# Required by what they say themselves, but not by Debian's archive, which is what debootstrap goes by.
NOT_BARE = ["liblocale-gettext-perl", "sensible-utils"]

# Commands that may come from elsewhere than Debian (setup.sh takes those that are there), Debian's package of each, and the files
# that they have in their prefix: as the archive from nodejs.org, a newer npm that npm has installed, a Python made from source.
FROM_ELSEWHERE = {
    "node": ("nodejs", "bin/node|include/node/.*|lib/node_modules/.*"),
    "npm": ("npm", "bin/(npm|npx|corepack)|lib/node_modules/.*"),
    "python3": (r"python3\.\d+-minimal", r"bin/python3[^/]*|include/python3.*|lib/(lib)?python3.*"),
}

# What is read because it happens to be there, and would not be missed.
READ_IF_THERE = re.compile("|".join((
    "/usr/(local/)?share/(fonts|icons|mime|applications)/.*",  # by Chromium: all of a desktop's
    "/usr/share/fontconfig/conf.avail/.*",  # rules for fonts, which packages of fonts bring
    "/usr/share/(glvnd|vulkan|drirc.d)/.*",  # the drivers of all graphics cards
    "/usr/(lib|share)/locale/.*",  # the user's language
    r"/usr/(local/)?lib/python3[^/]*/dist-packages/([^/]*\.pth|_distutils_hack/.*)",  # run when any Python starts
    r"/usr/(local/)?lib/python3[^/]*/dist-packages/[^/]*\.(egg|dist)-info/.*",  # which modules are there, and their plug-ins
    r"/usr/lib/python3[^/]*/distutils/.*",  # by CMake, which does without
    r"/usr/(lib|share)/tcltk/.*/pkgIndex\.tcl",  # by every `package require`
    "/usr/etc/npmrc",  # npm's settings
    r"/usr/lib/[^/]+/libnuma\.so\..*",  # loaded by ps
)))
# Tools that are used where they are, and whose absence is handled, by the names of what CMake found.
OPTIONAL_TOOLS = re.compile("|".join((
    "CCACHE",  # cmake/Playhouse.cmake
    # For clang CMake takes those of LLVM, and those of g++ if they are not there.
    "CMAKE_(C_COMPILER_|CXX_COMPILER_)?(ADDR2LINE|AR|NM|OBJCOPY|OBJDUMP|RANLIB|READELF|STRIP)",
    "CMAKE_C(XX)?_COMPILER_CLANG_SCAN_DEPS|CMAKE_DLLTOOL|CMAKE_MT|CMAKE_TAPI",  # for modules of C++, and other systems
)))
# Files that installing a package makes: no package lists them.
MADE_BY_INSTALLATION = [
    (re.compile(r"/usr/lib/[\w-]+/gconv/gconv-modules\.cache"), "libc6"),
    (re.compile(r"/usr/lib/[\w-]+/gio/modules/giomodule\.cache|/usr/share/glib-2\.0/schemas/gschemas\.compiled"), "libglib2.0-0"),
    (re.compile(r"/usr/lib/jvm/java-(\d+)-openjdk-\w+/lib/server/classes(_nocoops)?\.jsa"), r"openjdk-\1-jre-headless"),
]
BYTE_CODE = re.compile(r"/__pycache__/([^/]+)\.cpython-[^/]+\.pyc$")


class Package:
    """One installed package, as dpkg's status tells it."""

    def __init__(self, fields):
        self.name = fields["Package"]
        self.architecture = fields.get("Architecture", "all")
        self.is_base = fields.get("Essential") == "yes" or (fields.get("Priority") == "required" and self.name not in NOT_BARE)
        self.needs = [needed for field in ("Pre-Depends", "Depends") for needed in parse_relations(fields.get(field, ""))]
        self.provides = [alternatives[0] for alternatives in parse_relations(fields.get("Provides", ""))]


def parse_relations(text):
    """'a (>= 1) | b:any, c' is [['a', 'b'], ['c']]. Versions are fulfilled: dpkg has installed all of it."""
    return [[re.split(r"[\s:(\[]", name.strip(), maxsplit=1)[0] for name in clause.split("|")]
            for clause in text.split(",") if clause.strip()]


class Machine:
    """The packages of a machine and the files of each; root is where its file system begins."""

    def __init__(self, root="/"):
        self.root = str(root).rstrip("/")
        status = self.root + "/var/lib/dpkg/status"
        if not os.path.exists(status):
            raise SystemExit("packages.py: there is no dpkg here: the check, as `make test`, needs Debian 12")
        found = [Package(fields) for fields in read_paragraphs(status) if fields.get("Status", "").endswith(" ok installed")]
        self.native = next((package.architecture for package in found if package.name == "dpkg"), "amd64")
        self.packages = {package.name: package for package in found if package.architecture in (self.native, "all")}
        self.providers = defaultdict(list)
        for package in self.packages.values():
            for name in package.provides:
                self.providers[name].append(package.name)
        self.links = {}

    def closure(self, wanted):
        """Names of the packages that apt installs for those wanted on a bare machine, without what is only recommended."""
        names = [package.name for package in self.packages.values() if package.is_base] + BARE + list(wanted)
        found, waiting, choices = set(), [self.candidates(name)[:1] for name in names], []
        while waiting or choices:
            # A choice is made last, when all that is needed anyway is known.
            alternatives = waiting.pop() if waiting else choices.pop(0)
            if not alternatives or found.intersection(alternatives):
                continue
            if len(alternatives) > 1 and waiting:
                choices.append(alternatives)
                continue
            found.add(alternatives[0])
            for needed in self.packages[alternatives[0]].needs:
                candidates = [name for alternative in needed for name in self.candidates(alternative)]
                (waiting if len(candidates) == 1 else choices).append(candidates)
        return found

    def candidates(self, name):
        """Installed packages that are, or provide, what a relation names; the first is the one that apt takes."""
        return [name] if name in self.packages else sorted(self.providers.get(name, []))

    def steps(self, path):
        """The links on the way to a file, and the file itself; all by the names that packages list since /lib is in /usr."""
        current, waiting = "", path.split("/")[::-1]
        while waiting:
            part = waiting.pop()
            if part in ("", "."):
                continue
            if part == "..":
                current = os.path.dirname(current)
                continue
            place = f"{current}/{part}"
            target = self.link(place)
            if target is None:
                current = place
                continue
            # /usr/bin/java is a link that update-alternatives makes to one in /etc: it is whose file it leads to.
            if not target.startswith("/etc/alternatives/"):
                yield place
            if target.startswith("/"):
                current = ""
            waiting += target.split("/")[::-1]
        yield current

    def link(self, path):
        if path not in self.links:
            try:
                self.links[path] = os.readlink(self.root + path)
            except OSError:
                self.links[path] = None
        return self.links[path]

    def exists(self, path):
        return os.path.lexists(self.root + path)

    def is_folder(self, path):
        return os.path.isdir(self.root + path)

    def owners(self, paths):
        """The packages that have each of these files or folders; foreign ones with their architecture."""
        wanted, owners = set(paths), defaultdict(set)
        moved = {name: target for name in ("bin", "sbin", "lib", "lib32", "lib64", "libx32") if (target := self.link("/" + name))}
        diverted = self.diversions()
        for entry in os.scandir(self.root + "/var/lib/dpkg/info"):
            if not entry.name.endswith(".list"):
                continue
            package = entry.name[:-len(".list")].removesuffix(":" + self.native)
            with open(entry.path, encoding="utf-8", errors="surrogateescape") as lines:
                for line in lines:
                    path = line.rstrip("\n")
                    if path in diverted and diverted[path][1] != package:
                        path = diverted[path][0]
                    first, slash, rest = path[1:].partition("/")
                    if first in moved:
                        path = f"/{moved[first].strip('/')}{slash}{rest}"
                    if path in wanted:
                        owners[path].add(package)
        return owners

    def diversions(self):
        """{path: (where other packages' file of that name went, the package that has the name)}."""
        try:
            lines = pathlib.Path(self.root + "/var/lib/dpkg/diversions").read_text().splitlines()
        except FileNotFoundError:
            return {}
        return {path: (place, package) for path, place, package in zip(lines[::3], lines[1::3], lines[2::3])}


def read_paragraphs(path):
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        for paragraph in file.read().split("\n\n"):
            fields = dict(re.findall(r"^([\w-]+):[ \t]*(.*(?:\n[ \t].*)*)", paragraph, re.MULTILINE))
            if "Package" in fields:
                yield fields


class Reads:
    """Files that were read, each with one of its readers: for {goal: {path: reader}}."""

    def __init__(self):
        self.of = {"build": {}, "test": {}}

    def add(self, goal, path, reader):
        if path.startswith(("/usr/", "/lib", "/bin/", "/sbin/")):
            self.of[goal].setdefault(path, reader)


def read_build(folder, reads):
    """What a build folder's configuring, compiling and linking read."""
    folder = pathlib.Path(folder)
    if not (folder / "build.ninja").exists():
        raise SystemExit(f"packages.py: {folder} is not a build folder of Ninja")
    of_program = program_objects(folder) if folder.name == "release" else set()
    read_configured(folder, reads)
    read_cache(folder, reads)
    read_compiled(folder, of_program, reads)
    read_linked(folder, of_program, reads)


def ninja(folder, *arguments):
    done = subprocess.run(["ninja", "-C", folder, *arguments], capture_output=True, text=True, errors="surrogateescape")
    return done.stdout if done.returncode == 0 else ""


def program_objects(folder):
    """The program, and all that is made for it, as Ninja names them."""
    return set(ninja(folder, "-t", "inputs", "playhouse").splitlines())


def read_configured(folder, reads):
    with open(folder / "build.ninja") as lines:
        listed = next((line for line in lines if line.startswith("build build.ninja")), "")
    files = re.split(r"(?<!\$) ", listed.strip())
    goal = configured_for(folder)
    for path in files:
        reads.add(goal, path, f"configuring {folder.name}")
    for path, reader in checked_by_imports(files):
        reads.add(goal, path, reader)


def configured_for(folder):
    """What the folder's settings are for; tests/e2e/test_packages.py traces the configuring of `make build`."""
    without_tests = "PLAYHOUSE_TESTS:BOOL=OFF" in (folder / "CMakeCache.txt").read_text()
    return "build" if folder.name == "release" and without_tests else "test"


def checked_by_imports(files):
    """Files of which CMake demands that they are there, used or not: those of all targets that a package's *Targets.cmake
    imports. With the reader's name."""
    for path in files:
        if not path.endswith(".cmake") or not path.startswith("/") or not os.path.exists(path):
            continue
        text = pathlib.Path(path).read_text(errors="surrogateescape")
        for listed in re.findall(r"list\(APPEND _(?:cmake_import_check_files|IMPORT_CHECK_FILES)_(?:for|FOR)_\S+ ([^)]*)\)", text):
            for file in re.findall(r'"([^"]+)"', listed):
                yield file.replace("${_IMPORT_PREFIX}", import_prefix(path)), f"{os.path.basename(path)}, whose targets name it"


def import_prefix(path):
    """${_IMPORT_PREFIX} as the file that includes this one computes it: its folder, some folders up, or a fixed one."""
    stem = re.sub(r"-\w+\.cmake$", "", path)
    for candidate in (path, stem + ".cmake"):
        text = pathlib.Path(candidate).read_text(errors="surrogateescape") if os.path.exists(candidate) else ""
        fixed = re.search(r'^set\(_IMPORT_PREFIX "(/[^"]*)"\)', text, re.MULTILINE)
        if fixed:
            return fixed[1]
        if ups := len(re.findall(r"^get_filename_component\(_IMPORT_PREFIX .* PATH\)", text, re.MULTILINE)):
            prefix = str(pathlib.PurePath(candidate).parents[ups - 1])
            return "" if prefix == "/" else prefix
    return ""


def read_cache(folder, reads):
    """What find_library, find_path, find_program and find_package found."""
    for name, path in re.findall(r"^([^:#\n]+):(?:FILEPATH|PATH)=(/.*)$", (folder / "CMakeCache.txt").read_text(), re.MULTILINE):
        if not OPTIONAL_TOOLS.fullmatch(name) and not name.startswith("CMAKE_INSTALL_"):
            reads.add(configured_for(folder), path, f"configuring {folder.name}, as {name}")


def read_compiled(folder, of_program, reads):
    seen = {"build": set(), "test": set()}
    for line in ninja(folder, "-t", "deps").splitlines():
        if line.startswith("    "):
            path = line[4:]
            if path not in seen[goal]:
                seen[goal].add(path)
                reads.add(goal, path, reader)
        elif line:
            target = line.partition(": #deps")[0]
            goal = "build" if target in of_program else "test"
            reader = re.sub(r"CMakeFiles/[^/]+\.dir/", "", target)


def read_linked(folder, of_program, reads):
    """The dependency files that the linker leaves (cmake/Playhouse.cmake)."""
    for file in sorted(folder.rglob("link.d")):
        rule = re.split(r"(?<!\\)\s+", file.read_text(errors="surrogateescape").partition("\n\n")[0].replace("\\\n", " ").strip())
        target = rule[0].removesuffix(":")
        for path in rule[1:]:
            reads.add("build" if target in of_program else "test", path, f"{target}, linked")


CALL = re.compile(r'^(?:(\d+) +)?(execve|open|openat)\((?:AT_FDCWD(?:<[^>]*>)?, |\d+(?:<([^>]*)>)?, )?"([^"]*)", (.*)\) = \d+(?:<([^>]*)>)?')


def read_trace(file, reads):
    """The files, not folders, that traced programs opened and executed."""
    goal = "build" if os.path.basename(file).startswith("build.") else "test"
    programs, opened = {}, set()
    with open(file, errors="surrogateescape") as lines:
        for line in lines:
            call = CALL.match(line)
            if not call:
                continue
            process, name, folder, path, rest, real = call.groups()
            if not path.startswith("/"):
                path = os.path.join(folder or "", path)
            if name == "execve":
                programs[process] = os.path.basename(path)
                if interpreter := interpreter_of(path):
                    reads.add(goal, interpreter, f"{path}, whose first line names it,")
            if "O_DIRECTORY" in rest:
                continue
            for place in (path, real):
                if place and place.startswith("/") and place not in opened:
                    opened.add(place)
                    reads.add(goal, place, f"{programs.get(process, 'a process')} of {os.path.basename(file)}")
    for path, reader in checked_by_imports(sorted(opened)):
        reads.add(goal, path, reader)


def interpreter_of(path):
    """The program that the kernel starts for a script; no trace tells of it."""
    try:
        with open(path, "rb") as file:
            first = file.readline(200)
    except OSError:
        return None
    return os.fsdecode(first[2:].split()[0]) if first.startswith(b"#!") and first[2:].split() else None


def from_elsewhere(machine):
    """{where a command is that is not Debian's: pattern of its files}; they are not checked."""
    found = {}
    for command, (package, files) in FROM_ELSEWHERE.items():
        place = os.path.realpath(shutil.which(command) or "/")
        if place != "/" and not any(re.fullmatch(package, owner) for owner in machine.owners([place])[place]):
            prefix = re.match("(.*?)/(bin|lib)/", place)
            found[place] = re.compile(rf"{re.escape(prefix[1])}/({files})" if prefix else re.escape(place))
    return found


class Check:
    """Holds what was read against what the list brings."""

    def __init__(self, machine, listed):
        self.machine = machine
        self.listed = listed
        self.brought = {goal: machine.closure(names) for goal, names in listed.items()}
        self.elsewhere = from_elsewhere(machine)
        self.remarks = [f"{place} is not Debian's: its own files are not checked" for place in self.elsewhere]

    def findings(self, reads):
        found = [f"tools/setup.sh lists {name}, which is not installed here: run tools/setup.sh test"
                 for name in self.listed["test"] if not self.machine.candidates(name) and not self.is_elsewhere(name)]
        told = set()
        for goal in ("build", "test"):
            for package, finding in self.findings_for(goal, reads.of[goal]):
                if package not in told:
                    told.add(package)
                    found.append(finding)
        return found

    @staticmethod
    def is_elsewhere(name):
        return any(package == name and shutil.which(command) for command, (package, _) in FROM_ELSEWHERE.items())

    def findings_for(self, goal, read):
        """Pairs of a package, or of a file that belongs to none, and the line that tells of it."""
        readers = {}
        for path, reader in read.items():
            if not self.machine.exists(path):
                continue  # of an older build
            for step in self.machine.steps(path):
                if step.startswith("/usr/") and not self.is_allowed(step):
                    readers.setdefault(step, reader)
        owners = self.machine.owners(readers)
        self.own_what_installation_makes(readers, owners)
        outside = defaultdict(list)
        for path in sorted(readers):
            if not owners.get(path):
                # A folder that an installation made is whose files are in it.
                if not self.machine.is_folder(path):
                    outside[""].append(path)
            elif not owners[path] & self.brought[goal]:
                outside[min(owners[path])].append(path)
        for package, paths in sorted(outside.items()):
            if any(self.brings(other, package) and not self.brings(package, other) for other in outside):
                continue  # adding the other is enough
            path, more = paths[0], f" and {len(paths) - 1} more" if len(paths) > 1 else ""
            if not package:
                yield from ((path, f"{path} belongs to no package (read by {readers[path]})") for path in paths)
            elif package in self.brought["test"]:
                yield package, (f"package {package} is read by `make build`, and only test_packages of tools/setup.sh bring it: "
                                f"{path} (read by {readers[path]}){more}; add it to build_packages")
            else:
                where = "build_packages" if goal == "build" else "test_packages, or to build_packages if `make build` needs it, too"
                yield package, (f"package {package} is read but tools/setup.sh does not bring it: "
                                f"{path} (read by {readers[path]}){more}; add it to {where}")

    def brings(self, package, other):
        return bool(package) and other in self.machine.closure([package])

    def is_allowed(self, path):
        return bool(READ_IF_THERE.fullmatch(path)) or any(files.fullmatch(path) for files in self.elsewhere.values())

    def own_what_installation_makes(self, paths, owners):
        sources = {}
        for path in paths:
            if owners.get(path):
                continue
            if code := BYTE_CODE.search(path):
                sources[path] = f"{path[:code.start()]}/{code[1]}.py"
            for pattern, package in MADE_BY_INSTALLATION:
                if made := pattern.fullmatch(path):
                    owners[path].add(made.expand(package))
        if sources:
            of_sources = self.machine.owners(sources.values())
            for path, source in sources.items():
                owners[path] |= of_sources.get(source, set())


def listed_packages(goal, without=()):
    names = subprocess.run([ROOT / "tools/setup.sh", "--list", goal], capture_output=True, text=True, check=True).stdout.split()
    unknown = set(without) - set(names) if goal == "test" else ()
    if unknown:
        raise SystemExit(f"packages.py: tools/setup.sh does not list {' '.join(sorted(unknown))}")
    return [name for name in names if name not in without]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    check = commands.add_parser("check")
    for option in ("--build", "--trace", "--without"):
        check.add_argument(option, action="append", default=[])
    commands.add_parser("list").add_argument("goal", choices=("build", "test"))
    arguments = parser.parse_args()

    machine = Machine()
    if arguments.command == "list":
        print("\n".join(sorted(machine.closure(listed_packages(arguments.goal)))))
        return 0
    reads = Reads()
    for folder in arguments.build:
        read_build(folder, reads)
    for file in arguments.trace:
        read_trace(file, reads)
    checked = Check(machine, {goal: listed_packages(goal, arguments.without) for goal in ("build", "test")})
    findings = list(checked.findings(reads))
    print("\n".join(f"packages: {line}" for line in checked.remarks + findings))
    if not findings:
        print(f"packages: {len(reads.of['build'].keys() | reads.of['test'].keys())} files below /usr were read, all of them brought by tools/setup.sh")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
