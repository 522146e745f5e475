"""What setup.sh installs is all that builds and tests need: the checker of that (tools/packages.py) against made-up machines,
against this one with packages taken out of the list, and on what programs of this build open while they run."""

import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from house import PATIENCE, RELEASE, ROOT

sys.path.insert(0, str(ROOT / "tools"))
import packages  # noqa: E402

BUILD = os.environ.get("PLAYHOUSE_BUILD", "")


class MadeUp(unittest.TestCase):
    """A machine in a folder: packages as dpkg notes them, and their files."""

    def setUp(self):
        self.root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.status = []
        self.file("/var/lib/dpkg/info/format", "1")
        self.package("dpkg", essential=True)

    def file(self, path, text=""):
        place = self.root / path.lstrip("/")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text)

    def link(self, path, target):
        place = self.root / path.lstrip("/")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.symlink_to(target)

    def package(self, name, *files, depends="", provides="", essential=False, priority="optional", status="install ok installed",
                architecture="amd64", made=True):
        lines = [f"Package: {name}", f"Status: {status}", f"Priority: {priority}", f"Architecture: {architecture}", "Version: 1"]
        lines += [f"Depends: {depends}"] if depends else []
        lines += [f"Provides: {provides}"] if provides else []
        lines += ["Essential: yes"] if essential else []
        self.status.append("\n".join(lines) + "\nDescription: made up\n of several lines\n")
        self.file("/var/lib/dpkg/status", "\n".join(self.status))
        suffix = "" if architecture in ("amd64", "all") else ":" + architecture
        self.file(f"/var/lib/dpkg/info/{name}{suffix}.list", "".join(f"{file}\n" for file in ("/.", "/usr", *files)))
        for file in files:
            if made and not (self.root / file.lstrip("/")).is_symlink():
                self.file(file)

    def closure(self, *wanted):
        return packages.Machine(self.root).closure(wanted) - {"dpkg"}

    def findings(self, listed, *read, test_listed=()):
        reads = packages.Reads()
        for path in read:
            reads.add("build", path, "a.o")
        check = packages.Check(packages.Machine(self.root), {"build": list(listed), "test": [*listed, *test_listed]})
        return check.findings(reads)


class Closure(MadeUp):
    def test_it_is_what_packages_depend_on_and_what_every_debian_has(self):
        self.package("base", depends="libbase", priority="required")
        self.package("libbase")
        self.package("git")
        self.package("a", depends="b (>= 1), c:any")
        self.package("b")
        self.package("c", depends="a")
        self.package("unrelated")
        self.assertEqual(self.closure("a"), {"base", "libbase", "git", "a", "b", "c"})

    def test_recommended_and_removed_packages_are_none_of_it(self):
        self.package("a", depends="b | gone")
        self.status[-1] = self.status[-1].replace("Depends: b | gone", "Recommends: b\nDepends: gone | c\nSuggests: b")
        self.package("b")
        self.package("gone", status="deinstall ok config-files")
        self.package("c")
        self.assertEqual(self.closure("a"), {"a", "c"})

    def test_the_first_alternative_is_taken_unless_another_comes_anyway(self):
        for name in ("x", "y"):
            self.package(name)
        self.package("a", depends="x | y")
        self.assertEqual(self.closure("a"), {"a", "x"})
        self.package("z", depends="y")
        self.assertEqual(self.closure("a", "z"), {"a", "y", "z"})
        self.package("first", depends="a, z")
        self.assertEqual(self.closure("first"), {"first", "a", "y", "z"})

    def test_a_name_that_others_provide(self):
        self.package("mawk", provides="awk")
        self.package("zawk", provides="awk (= 1), something")
        self.package("a", depends="awk")
        self.assertEqual(self.closure("a"), {"a", "mawk"})
        self.assertEqual(self.closure("a", "zawk"), {"a", "zawk"})
        self.assertEqual(self.closure("something"), {"zawk"})

    def test_packages_of_another_architecture_do_not_count(self):
        self.package("a", "/usr/lib/i386/liba.so", architecture="i386")
        self.assertEqual(self.closure("a"), set())
        self.assertIn("a:i386", self.findings([], "/usr/lib/i386/liba.so")[0])


class Findings(MadeUp):
    def setUp(self):
        super().setUp()
        self.package("listed", "/usr/include/listed.h")
        self.package("other", "/usr/include/other.h", "/usr/include/other_too.h")

    def test_a_file_of_another_package_is_told_with_its_reader_and_what_to_do(self):
        self.assertEqual(self.findings(["listed"], "/usr/include/listed.h"), [])
        self.assertEqual(self.findings(["listed"], "/usr/include/other.h", "/usr/include/other_too.h"), [
            "package other is read but tools/setup.sh does not bring it: /usr/include/other.h (read by a.o) and 1 more; "
            "add it to build_packages"])

    def test_what_only_the_tests_list_is_too_little_for_the_build(self):
        self.assertIn("only test_packages", self.findings(["listed"], "/usr/include/other.h", test_listed=["other"])[0])

    def test_what_comes_with_another_that_is_missing_is_not_told(self):
        self.package("other-dev", "/usr/include/dev.h", depends="other")
        found = self.findings(["listed"], "/usr/include/other.h", "/usr/include/dev.h")
        self.assertEqual(len(found), 1)
        self.assertIn("other-dev", found[0])

    def test_files_of_no_package_are_told_one_by_one(self):
        self.file("/usr/local/include/own.h")
        self.file("/usr/include/made.h")
        found = self.findings(["listed"], "/usr/local/include/own.h", "/usr/include/made.h")
        self.assertEqual(found, ["/usr/include/made.h belongs to no package (read by a.o)",
                                 "/usr/local/include/own.h belongs to no package (read by a.o)"])

    def test_a_listed_package_that_is_not_here_is_told(self):
        self.assertEqual(self.findings(["listed", "absent"]), ["tools/setup.sh lists absent, which is not installed here: run tools/setup.sh test"])

    def test_folders_that_became_one_have_files_by_both_names(self):
        self.link("/lib", "usr/lib")
        self.package("old", "/lib/x/libold.so.1", made=False)
        self.package("new", "/usr/lib/x/libnew.so.1")
        self.file("/usr/lib/x/libold.so.1")
        for path in ("/lib/x/libold.so.1", "/usr/lib/x/libold.so.1", "/usr/lib/gcc/../x/libold.so.1"):
            self.file("/usr/lib/gcc/here")
            self.assertEqual(self.findings(["old"], path), [], path)
            self.assertIn("package old ", self.findings(["new"], path)[0])

    def test_a_link_needs_its_own_package_and_that_of_its_file(self):
        self.package("lib", "/usr/lib/liba.so.1")
        self.link("/usr/lib/liba.so", "liba.so.1")
        self.package("dev", "/usr/lib/liba.so")
        self.assertIn("package dev ", self.findings(["lib"], "/usr/lib/liba.so")[0])
        self.assertIn("package lib ", self.findings(["dev"], "/usr/lib/liba.so")[0])
        self.assertEqual(self.findings(["dev", "lib"], "/usr/lib/liba.so"), [])

    def test_an_alternative_is_whose_file_it_leads_to(self):
        self.package("tool-2", "/usr/bin/tool-2")
        self.link("/etc/alternatives/tool", "/usr/bin/tool-2")
        self.link("/usr/bin/tool", "/etc/alternatives/tool")
        self.assertEqual(self.findings(["tool-2"], "/usr/bin/tool"), [])
        self.assertIn("package tool-2 ", self.findings(["listed"], "/usr/bin/tool")[0])

    def test_a_diverted_file_is_the_diverting_packages(self):
        self.package("original", "/usr/bin/thing")
        self.package("wrapper", "/usr/bin/thing")
        self.file("/usr/bin/thing.real")
        self.file("/var/lib/dpkg/diversions", "/usr/bin/thing\n/usr/bin/thing.real\nwrapper\n")
        self.assertEqual(self.findings(["wrapper"], "/usr/bin/thing"), [])
        self.assertIn("package wrapper ", self.findings(["original"], "/usr/bin/thing")[0])
        self.assertEqual(self.findings(["original"], "/usr/bin/thing.real"), [])

    def test_byte_code_is_whose_source_it_was(self):
        self.package("python", "/usr/lib/python3/x.py")
        self.file("/usr/lib/python3/__pycache__/x.cpython-311.pyc")
        self.assertEqual(self.findings(["python"], "/usr/lib/python3/__pycache__/x.cpython-311.pyc"), [])

    def test_what_is_no_more_and_what_is_elsewhere_does_not_count(self):
        self.file("/home/me/x.h")
        self.assertEqual(self.findings(["listed"], "/usr/include/no_more.h", "/home/me/x.h"), [])


class Reading(MadeUp):
    def test_files_that_targets_of_cmake_name_are_read_whether_used_or_not(self):
        folder = self.root / "usr/lib/cmake/thing"
        self.file("/usr/lib/cmake/thing/thingTargets.cmake", '''
get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
''')
        self.file("/usr/lib/cmake/thing/thingTargets-none.cmake", '''
list(APPEND _cmake_import_check_files_for_thing::a "${_IMPORT_PREFIX}/lib/liba.a" "/usr/lib/libb.so" )
list(APPEND _IMPORT_CHECK_FILES_FOR_thing::c "/usr/lib/libc.so" )
''')
        files = [path for path, _ in packages.checked_by_imports([str(folder / "thingTargets-none.cmake")])]
        self.assertEqual(files, [f"{self.root}/usr/lib/liba.a", "/usr/lib/libb.so", "/usr/lib/libc.so"])

    def test_a_trace_tells_files_that_were_opened_and_executed(self):
        self.file("/script", "#!/usr/bin/tclsh -x\n")
        self.file("/build.trace", '''\
7 execve("/usr/bin/java", ["java"], 0x7ffe /* 12 vars */) = 0
9 execve("SCRIPT", ["script"], 0x7ffe /* 12 vars */) = 0
7 openat(AT_FDCWD, "/lib/x/libc.so.6", O_RDONLY|O_CLOEXEC) = 3
7 openat(AT_FDCWD</tmp>, "/usr/lib/a.so", O_RDONLY|O_CLOEXEC) = 3</usr/lib/a.so.1>
7 openat(4</usr/share>, "data", O_RDONLY) = 5</usr/share/data>
8 openat(AT_FDCWD, "/usr/share/folder", O_RDONLY|O_DIRECTORY) = 3
8 openat(AT_FDCWD, "/usr/share/absent", O_RDONLY) = -1 ENOENT (No such file or directory)
8 open("/home/me/file", O_RDONLY) = 3
8 +++ exited with 0 +++
'''.replace("SCRIPT", f"{self.root}/script"))
        reads = packages.Reads()
        packages.read_trace(self.root / "build.trace", reads)
        self.assertEqual(sorted(reads.of["build"]), ["/lib/x/libc.so.6", "/usr/bin/java", "/usr/bin/tclsh", "/usr/lib/a.so", "/usr/lib/a.so.1", "/usr/share/data"])
        self.assertEqual(reads.of["build"]["/usr/lib/a.so"], "java of build.trace")
        self.assertEqual(reads.of["test"], {})


@unittest.skipUnless(BUILD, "run by ctest, which names the build")
class ThisMachine(unittest.TestCase):
    """The build folder of this test, with a package less in the list."""

    @classmethod
    def setUpClass(cls):
        cls.machine = packages.Machine()
        cls.reads = packages.Reads()
        packages.read_build(BUILD, cls.reads)

    def findings(self, *without):
        listed = {goal: packages.listed_packages(goal, without) for goal in ("build", "test")}
        return packages.Check(self.machine, listed).findings(self.reads)

    def test_a_package_less_is_told_by_name(self):
        for package, file in (("libjpeg62-turbo-dev", "libjpeg.a"), ("libpng-dev", "png.h"), ("libgmock-dev", "gmock")):
            with self.subTest(package=package):
                found = [line for line in self.findings(package) if line.startswith(f"package {package} ")]
                self.assertEqual(len(found), 1)
                self.assertIn(file, found[0])
        self.assertEqual(self.findings(), [])

    def test_a_package_that_is_not_listed_cannot_be_taken_out(self):
        with self.assertRaises(SystemExit):
            self.findings("libnothing-dev")


@unittest.skipUnless(RELEASE and Path(RELEASE).exists(), "there is no release program (make build)")
class Runs(unittest.TestCase):
    """What programs open, traced. Names of traces that begin with "build." are of what `make build` and the program do."""

    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "traces").mkdir()

    def start(self, name, *command, **options):
        trace = ["strace", "-f", "-y", "--seccomp-bpf", "-z", "-e", "trace=open,openat,execve", "-o", self.folder / "traces" / name]
        # Debian's Python, if another comes first; and its own distutils, which setuptools stands in for where it is installed.
        environment = os.environ | {"PATH": f"/usr/bin:{os.environ['PATH']}", "SETUPTOOLS_USE_DISTUTILS": "stdlib"}
        return subprocess.Popen([*trace, *map(str, command)], cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, **options)

    def trace(self, name, *command, **options):
        with self.start(name, *command, **options) as process:
            out, err = process.communicate(timeout=5 * PATIENCE)
        self.assertEqual(process.returncode, 0, f"{command}\n{out}{err}")

    def check(self):
        reads = packages.Reads()
        for trace in sorted((self.folder / "traces").iterdir()):
            packages.read_trace(trace, reads)
        self.assertGreater(len(reads.of["build"]) + len(reads.of["test"]), 5, "nothing was traced")
        listed = {goal: packages.listed_packages(goal) for goal in ("build", "test")}
        found = packages.Check(packages.Machine(), listed).findings(reads)
        self.assertFalse(found, "\n".join(found))

    def test_configuring(self):
        for preset, name in (("release", "build.configure"), ("ci", "configure")):
            self.trace(name, "cmake", "--preset", preset, "-B", self.folder / name, "-Wno-dev")
        self.check()

    def test_the_program(self):
        run = (RELEASE, "run", "--headless", "--fast", "--port", "0", "--duration", "1")
        seen = self.folder / "seen.mcap"
        for name, *command in (
                ("build.stage", *run, "worlds/cave.world"),
                ("build.arena", *run, "worlds/weather.world", "--engine", "arena", "--record", seen),
                ("build.meshes", *run, "worlds/mesh.world", "--engine", "arena"),
                ("build.picture", RELEASE, "picture", "worlds/camera.world", "--renderer", "playhouse", "-o", self.folder / "a.png"),
                ("build.film", RELEASE, "film", "worlds/cave.world", "--renderer", "playhouse", "--duration", "1", "-o", self.folder / "b.png"),
                ("chromium", RELEASE, "picture", "worlds/cave.world", "-o", self.folder / "c.png")):
            self.trace(name, *command)
        self.check()

    def test_tools_that_tests_start(self):
        (self.folder / "a.cc").write_text("#include <string>\nint main() {}\n")
        (self.folder / "A.java").write_text("class A { public static void main(String[] words) {} }\n")
        for name, *command in (
                ("g++", "g++", "-shared", "-fPIC", self.folder / "a.cc", "-o", self.folder / "a.so"),
                ("clang", "clang++", "-fuse-ld=lld", "-fsanitize=address,undefined", self.folder / "a.cc", "-o", self.folder / "a"),
                ("assimp", "assimp", "export", "worlds/meshes/ramp.dae", self.folder / "ramp.obj", "-fobj"),
                ("ps", "ps", "-e"),
                ("avahi-daemon", "/usr/sbin/avahi-daemon", "--version"),
                ("avahi-browse", "avahi-browse", "--version"),
                ("avahi-publish", "avahi-publish", "--version"),
                ("dbus-daemon", "dbus-daemon", "--version"),
                ("javac", "javac", "-d", self.folder, self.folder / "A.java"),
                ("java", "java", "-cp", self.folder, "A"),
                ("sbcl", "sbcl", "--noinform", "--no-userinit", "--non-interactive", "--eval", "(require :asdf)",
                 "--eval", f'(asdf:initialize-output-translations \'(:output-translations (t ("{self.folder}" :implementation :**/ :*.*.*)) :ignore-inherited-configuration))',
                 "--eval", "(asdf:load-system :chipz)")):
            self.trace(name, *command)
        self.check()

    @unittest.skipUnless(BUILD, "run by ctest, which names the build")
    def test_the_page_and_a_client_of_each_language(self):
        with self.start("build.server", RELEASE, "run", "worlds/cave.world", "--port", "0", "--web", "0") as tracer:
            try:
                page, port = self.places_of(tracer)
                self.use(page, port)
            finally:
                self.end_traced(tracer)
        self.check()

    def places_of(self, tracer):
        """The page's address and the port of Player clients, as the program says them."""
        said = {}
        for line in tracer.stderr:
            for what in ("web page", "Player clients"):
                if line.startswith(what + ": "):
                    said[what] = line.split(": ")[1].split()[0]
            if len(said) == 2:
                return said["web page"], said["Player clients"]
        self.fail("the program ended without serving")

    def use(self, page, server):
        self.trace("build.page", "python3", "-c", f"import urllib.request; urllib.request.urlopen('{page}').read()")
        self.trace("build.devices", RELEASE, "devices", server)
        self.trace("build.python", "python3", "clients/python/examples/square.py", server, "12", "1")
        for language in ("java", "lisp", "tcl", "typescript"):
            self.trace(language, f"{BUILD}/clients/{language}/programs/square", server, "12", "1")

    def end_traced(self, tracer):
        """Ends the program: strace itself ends with it."""
        children = Path(f"/proc/{tracer.pid}/task/{tracer.pid}/children")
        for child in children.read_text().split():
            os.kill(int(child), signal.SIGTERM)
        tracer.communicate(timeout=PATIENCE)


if __name__ == "__main__":
    unittest.main()
