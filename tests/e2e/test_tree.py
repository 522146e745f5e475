"""The tools that check the tree find what is wrong, in a tree made for the purpose."""

import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import boundaries  # noqa: E402
import captions  # noqa: E402
import corpus  # noqa: E402
import limits  # noqa: E402
import links  # noqa: E402
import messages  # noqa: E402
import module_graph  # noqa: E402
import names  # noqa: E402
import threads  # noqa: E402
import versions  # noqa: E402
import waits  # noqa: E402

MAP = """
| folder | contents | links |
|---|---|---|
| `playhouse/ground` | what all stand on | |
| `playhouse/house` | rooms | ground |
| `playhouse/roof` | tiles | ground |
"""


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("ground/CMakeLists.txt", "playhouse_module(ground)")
        self.write("house/CMakeLists.txt", "playhouse_module(house HOT DEPS playhouse_ground fmt::fmt\n  TOGETHER 4)")
        self.write("roof/CMakeLists.txt",
                   "playhouse_module(roof DEPS playhouse_house)  # DEPS playhouse_cellar\n"
                   "target_link_libraries(playhouse_roof_test PRIVATE playhouse_chimney)")
        self.write("chimney/CMakeLists.txt", "playhouse_module(chimney)")
        (self.root / "ARCHITECTURE.md").write_text(MAP)
        (self.root / "docs").mkdir()
        for module in (captions, links, module_graph, names, threads):
            self.replace(module, "ROOT", self.root)
        for module in (captions, module_graph, names, threads):
            self.replace(module, "SOURCE", self.root / "playhouse")
        for module in (module_graph, threads):
            self.replace(module, "MAP", self.root / "ARCHITECTURE.md")
        self.replace(threads, "PAGE", self.root / "docs/locks.md")
        self.replace(messages, "ROOT", self.root)
        self.replace(waits, "ROOT", self.root)
        for cached in (module_graph.links, module_graph.reachable):
            cached.cache_clear()
            self.addCleanup(cached.cache_clear)

    def replace(self, module, name, value):
        patch = mock.patch.object(module, name, value)
        patch.start()
        self.addCleanup(patch.stop)

    def write(self, name, text):
        path = self.root / "playhouse" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def wrong(self, name, *lines):
        return list(module_graph.wrong_includes(self.write(name, "\n".join(lines))))


class Includes(Tree):
    def test_of_what_a_module_links_by_itself_or_through_others_are_right(self):
        self.assertEqual(self.wrong("roof/tile.h", '#include "playhouse/roof/edge.h"', '#include "playhouse/house/a.h"',
                                    '#include "playhouse/ground/b.h"', "#include <vector>"), [])

    def test_of_anything_else_are_found_in_every_kind_of_file(self):
        for suffix in ("h", "cc", "inc"):
            with self.subTest(suffix):
                self.assertEqual(self.wrong(f"house/door.{suffix}", "", '  # include "playhouse/roof/tile.h"'),
                                 [(2, "house", "roof")])

    def test_tests_may_include_what_their_program_links(self):
        line = '#include "playhouse/chimney/smoke.h"'
        self.assertEqual(self.wrong("roof/tile_test.cc", line), [])
        self.assertEqual(self.wrong("roof/testing_tiles.h", line), [])
        self.assertEqual(self.wrong("roof/tile.cc", line), [(1, "roof", "chimney")])
        self.assertEqual(self.wrong("house/door_test.cc", line), [(1, "house", "chimney")])


class Messages(Tree):
    def odd(self, name, *lines):
        return list(messages.odd_phrases(self.write(name, "\n".join(lines))))

    def test_that_do_not_say_what_is_invalid_are_found_in_every_kind_of_file(self):
        for suffix in ("h", "cc", "inc"):
            with self.subTest(suffix):
                self.assertEqual(self.odd(f"house/door.{suffix}", "", 'return "the key is none";', 'log("\\"", "its hinges are none (told once)");'),
                                 [f'playhouse/house/door.{suffix}:2: "is none" in a message: say "invalid", and what is valid',
                                  f'playhouse/house/door.{suffix}:3: "are none" in a message: say "invalid", and what is valid',
                                  f'playhouse/house/door.{suffix}:3: "told once" in a message: say "logged once"'])

    def test_are_string_literals_of_the_program(self):
        self.assertEqual(self.odd("house/door.cc", "// the key is none", 'open("http://a", \'"\');  // "is none" and \'"\'',
                                  'return "there is none";', 'return "this none";', 'is none ("key")'), [])
        self.assertEqual(self.odd("house/door_test.cc", '"the key is none"'), [])
        self.assertEqual(self.odd("house/testing_doors.h", '"the key is none"'), [])


class Waits(Tree):
    """Words are put together here, for this file is a test as well."""

    WRONG = {
        "clients/c/tests/link_test.c": "u{}(100);",
        "clients/java/tests/LinkTest.java": "Thread.{}(100);",
        "clients/lisp/tests/link.lisp": "({} 10)",
        "playhouse/house/door_test.cc": "std::this_thread::{}_for(10ms);",
        "playhouse/house/testing/hinges.h": "std::this_thread::{}_for(10ms);",
        "tests/e2e/test_door.py": "time.{}(1)",
    }
    CLOCKS = {
        "clients/tcl/tests/link.test": ("after ", "20 {set late 1}"),
        "clients/typescript/tests/link.test.ts": ("set", "Timeout(done, 20)"),
        "playhouse/house/testing_doors.h": ("std::chrono::steady_clock", "::now()"),
        "web/e2e/door.test.mjs": ("await page.waitFor", "Timeout(20)"),
    }

    def found(self, name, line):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"\n{line}\n")
        return list(waits.findings([name]))

    def test_for_a_time_are_found_in_tests_of_every_language(self):
        lines = {**{name: line.format("sleep") for name, line in self.WRONG.items()}, **{name: "".join(parts) for name, parts in self.CLOCKS.items()}}
        for name, line in lines.items():
            with self.subTest(name):
                found = self.found(name, line)
                self.assertEqual(len(found), 1)
                self.assertTrue(found[0].startswith(f"{name}:2: "), found)

    def test_are_the_business_of_helpers_and_of_the_program(self):
        for name in ("tests/waiting.py", "playhouse/base/testing/wait.h", "tools/waiting.py", "playhouse/house/door.cc", "playhouse/house/door_bench.cc"):
            line = ("time.{}(1)" if name.endswith("py") else "std::this_thread::{}_for(10ms);").format("sleep")
            self.assertEqual(self.found(name, line), [], name)


class Limits(Tree):
    HEADER = """// Doors; heeded by hall.
inline constexpr std::size_t kDoors = 4u << 10;  // of a house
inline constexpr int kLeast = 2, kMost = 9;
// Tiles; heeded by ground, roof.
inline constexpr std::size_t kTiles = kDoors - 6;
"""

    def setUp(self):
        super().setUp()
        for name in ("ROOT", "SOURCE"):
            self.replace(limits, name, self.root / ("playhouse" if name == "SOURCE" else ""))
        self.write("base/limits.h", self.HEADER)
        self.write("base/mesh_limits.h", "")
        self.write("hall/door.cc", "kDoors kLeast kMost")
        self.write("roof/tile.cc", "limits::kTiles")
        self.write("ground/tile.h", "limits::kTiles")

    def test_are_numbers(self):
        self.assertEqual(limits.values(), {"kDoors": 4096, "kLeast": 2, "kMost": 9, "kTiles": 4090})

    def test_that_others_heed_or_nobody_are_found(self):
        self.assertEqual([*limits.unused(), *limits.wrong_owners()], [])
        self.write("roof/tile.cc", "kMost")
        self.assertEqual(list(limits.wrong_owners()), ["playhouse/base/limits.h:1: these limits are heeded by hall, roof",
                                                       "playhouse/base/limits.h:4: these limits are heeded by ground"])
        self.write("ground/tile.h", "// none")
        self.assertEqual(list(limits.unused()), ["playhouse/base/limits.h:5: nothing heeds kTiles"])

    def test_that_a_document_gives_otherwise_are_found(self):
        page = self.root / "page.md"
        page.write_text("`kDoors` 4 KiB, `kLeast` (2) to 9 of them (`kMost`)\n| `kTiles`, `kMost` | 4,090 tiles; 9 of one house |\n")
        self.assertEqual(list(limits.wrong_values("page.md")), [])
        page.write_text("`kDoors` 4 MiB, `kLeast` (3) to 10 of them (`kMost`)\n| `kTiles`, `kMost` | 9 tiles; 9 |\n`kWalls`\n")
        self.assertEqual(list(limits.wrong_values("page.md")), ["page.md:1: kDoors is 4096", "page.md:1: kLeast is 2", "page.md:1: kMost is 9",
                                                                "page.md:2: kTiles is 4090", "page.md:3: there is no kWalls"])


class Boundaries(Tree):
    def setUp(self):
        super().setUp()
        for name in ("ROOT", "SOURCE"):
            self.replace(boundaries, name, self.root / ("playhouse" if name == "SOURCE" else ""))

    def test_between_modules_hold_through_others_too(self):
        self.replace(boundaries, "APART", {("roof",): ("ground", "chimney")})
        self.assertEqual(list(boundaries.near()), ["playhouse/roof/CMakeLists.txt:1: roof links ground, and is to stay apart from it (ARCHITECTURE.md)"])

    def test_around_libraries_hold_but_for_tests(self):
        self.replace(boundaries, "ALONE", {"#include <smoke": ("chimney",), r"\bshout\(": ()})
        for name in ("chimney/smoke.cc", "roof/tile.cc", "roof/tile_test.cc"):
            self.write(name, "#include <smoke/ring.h>\nshout();  // shout()" if name != "chimney/smoke.cc" else "#include <smoke/ring.h>")
        self.assertEqual(list(boundaries.strangers()), ["playhouse/roof/tile.cc:1: #include <smoke is for chimney (tools/boundaries.py)",
                                                        "playhouse/roof/tile.cc:2: shout( is for no module (tools/boundaries.py)"])

    def test_files_that_a_document_names_are_there(self):
        self.write("roof/tile.h", "")
        (self.root / "docs/page.md").write_text("`roof/tile.h` `playhouse/roof/tile.h` `roof/NAME.h`\n`roof/slate.h`\n")
        self.assertEqual(list(boundaries.missing_files("docs/page.md")), ["docs/page.md:2: there is no roof/slate.h"])
class Names(Tree):
    def twice(self, **texts):
        for name, text in texts.items():
            self.write(f"{name}/{name}.h", text)
        return list(names.defined_twice())

    def test_of_types_that_two_headers_define_are_found(self):
        for kind in ("class Door final : public Wall {", "struct Door {};", "struct alignas(32) Door : Wall {", "enum class Door : std::uint8_t { kOpen };",
                     "enum Door {", "union Door {", "class [[nodiscard]] Door {", "class Door\n    : public Wall {", "using Door = std::vector<int>;",
                     "  struct Door {", "  using Door = roof::Window;", "class Roof::Door {", "template <typename T> struct Door {"):
            with self.subTest(kind):
                self.assertEqual(self.twice(house="namespace playhouse::house {\nclass Door {\n};", roof=f"// Door\n\n{kind}"),
                                 ["playhouse/roof/roof.h:3: Door is another thing in playhouse/house/house.h:2: a name that says which (docs/conventions.md)"])

    def test_of_types_within_others_are_found(self):
        self.assertEqual(self.twice(house="class House : public Wall {\n  struct Door {\n    int width;\n  };\n};\n\nclass Barn {\n  enum class Door { kOpen };\n};"),
                         ["playhouse/house/house.h:8: Door is another thing in playhouse/house/house.h:2: a name that says which (docs/conventions.md)"])

    def test_may_be_declared_or_defined_once_more_for_other_arguments(self):
        self.assertEqual(self.twice(house="class Door {\n};\ntemplate <>\nclass Door<int> {\n};\nclass Door;",
                                    roof="class Door;\nenum class Door : int;\nclass Tile {\n  struct Door;\n  friend class Door;\n};\nusing house::Door;\nstruct Door* open();",
                                    chimney="// class Door {\nDoor door() {\n}"), [])

    def test_may_be_aliases_of_the_same(self):
        self.assertEqual(self.twice(house="class Door {\n};\nusing Bell = std::function<double()>;",
                                    roof="class Tile {\n  using Door = house::Door;\n  using Bell =\n      std::function<double()>;\n};"), [])


class Glossary(Tree):
    def setUp(self):
        super().setUp()
        self.write("house/house.h", "struct Door {\n};")
        self.page("| *door* | what closes, `Door`, of a `wall` |")

    def page(self, *rows):
        (self.root / "docs/conventions.md").write_text("\n".join([
            "| `Roof` |", "## Words", "", "| a house | |", "|---|---|", *rows, "", "| not | but |", "|---|---|", "| lattice, window pane | pane |", "", "## Errors", "| `Roof` | |"]))

    def test_names_types_that_headers_define(self):
        self.assertEqual(list(names.unknown_types()), [])
        self.page("| *door* | what closes, `Door` |", "| *gate* | another: `Gate`, `Door` |")
        self.assertEqual(list(names.unknown_types()), ["docs/conventions.md:7: no header defines Gate"])

    def refused(self, *lines):
        return [each.partition(".cc:")[2] for each in names.refused_words(self.write("house/door.cc", "\n".join(lines)), names.refused())]

    def test_refuses_words_in_identifiers_and_comments(self):
        self.assertEqual(self.refused("int kLattice = 0;", "// A Lattice.", "class WindowPane;", "window_pane_", "  /// of the window pane"),
                         [f"{line}: {word}: say pane (docs/conventions.md)" for line, word in
                          enumerate(("lattice", "lattice", "window pane", "window pane", "window pane"), 1)])

    def test_does_not_refuse_texts_other_words_and_names_of_libraries(self):
        self.assertEqual(self.refused('say("a lattice", \'"\');', "lattices pane window.pane", "// a window; pane", "btLattice.getLattice(m_lattice)",
                                      "btWall::Lattice"), [])


class Captions(Tree):
    def missing(self, name, *lines):
        path = self.write(name, "\n".join(lines))
        found = list(captions.missing())
        path.unlink()
        return found

    def test_of_headers_and_kernels_that_compute_say_what_goes_in_what_comes_out_and_its_cost(self):
        self.assertEqual(self.missing("rays/cast.h", "/// In: rays. Out: hits.", "void cast();  // Cost: little"),
                         ["playhouse/rays/cast.h:1: says nothing of Cost (docs/conventions.md)"])
        self.assertEqual(self.missing("rays/cast_kernels.inc", "// Indeed: rays."),
                         ["playhouse/rays/cast_kernels.inc:1: says nothing of In, Out, Cost (docs/conventions.md)"])
        self.assertEqual(self.missing("rays/cast.h", "/// In: rays.", "/// Out: hits.", "/// Cost: little."), [])
        self.assertEqual(self.missing("rays/cast_kernels.inc", "// In, Out, Cost: as in cast.h."), [])

    def test_of_values_and_tests_and_of_other_modules_need_not(self):
        self.assertEqual(self.missing("rays/ray.h", "/// Rays. Values."), [])
        for name in ("rays/testing_rays.h", "rays/fuzz_rays.h", "rays/generated/rays.h", "rays/cast.cc", "rays/float8_plain.inc", "roof/tile.h"):
            with self.subTest(name):
                self.assertEqual(self.missing(name, "int tile;"), [])


class Folders(Tree):
    def test_with_too_many_files_are_found_but_not_those_of_generated_ones(self):
        for number in range(module_graph.FOLDER_FILES):
            self.write(f"house/generated/made{number}.h", "")
            self.write(f"house/rooms/room{number}.h", "")
        self.write("house/generated/one_more.h", "")
        self.assertEqual(list(module_graph.large_folders()), [])
        self.write("house/rooms/one_more.h", "")
        self.assertEqual(list(module_graph.large_folders()),
                         ["playhouse/house/rooms:1: 46 files in one folder: 45 at most (docs/adr/0024)"])


class Table(Tree):
    def test_says_what_is_linked_and_not_what_follows_from_it(self):
        self.assertEqual(module_graph.table_findings(),
                         ["ARCHITECTURE.md:6: roof links house: tools/tidy.py --write-table",
                          "ARCHITECTURE.md:1: no row for playhouse/chimney"])

    def test_has_no_rows_of_modules_that_are_gone(self):
        (self.root / "ARCHITECTURE.md").write_text(MAP + "| `playhouse/cellar` | wine | ground |\n")
        self.assertIn("ARCHITECTURE.md:7: there is no module cellar", module_graph.table_findings())

    def test_names_of_packages_are_no_keywords(self):
        self.write("roof/CMakeLists.txt", "playhouse_module(roof DEPS TBB::tbb ZLIB::ZLIB playhouse_house)")
        self.assertEqual(module_graph.links()["roof"], {"house"})

    def test_is_written(self):
        module_graph.table_findings(write=True)
        self.assertIn("| `playhouse/roof` | tiles | house |\n", (self.root / "ARCHITECTURE.md").read_text())
        self.assertEqual(module_graph.table_findings(), ["ARCHITECTURE.md:1: no row for playhouse/chimney"])


class Links(Tree):
    def test_to_files_that_are_not_there_are_found(self):
        page = self.root / "docs/page.md"
        page.write_text("[map](../ARCHITECTURE.md#tree) [here](#here) [far](https://example.org/a)\n"
                        "| [gone](gone.md), ![gone](images/gone.png#left) |\n")
        self.assertEqual(list(links.dead(page)), ["docs/page.md:2: there is no gone.md", "docs/page.md:2: there is no images/gone.png"])


class Corpora(Tree):
    INPUTS = {"every byte": bytes(range(256)), "lines": b"one\r\ntwo\n\n'\"\\", "nothing": b"", "zero": b"\0"}

    def test_come_back_as_they_were(self):
        self.replace(corpus, "FOLDER", self.root)
        (self.root / "made").mkdir()
        for name, content in self.INPUTS.items():
            (self.root / "made" / name).write_bytes(content)
            corpus.add("house", self.root / "made" / name)
        corpus.unpack("house", self.root / "docs")
        self.assertEqual({path.name: path.read_bytes() for path in (self.root / "docs").iterdir()}, self.INPUTS)

    def test_are_written_as_the_tool_writes_them(self):
        for path in corpus.FOLDER.glob("*.txt"):
            with self.subTest(path.name):
                text = path.read_text()
                self.assertEqual(corpus.to_text(corpus.from_text(text)), text)
                self.assertNotEqual(text, "")


class Locks(Tree):
    PAGE = "| mutex | protects |\n|---|---|\n| `roof::Tile::mutex_` | its colour |\n| `roof::paint::mutex` | the brush |\n"

    def found(self, page):
        (self.root / "docs/locks.md").write_text(page)
        self.write("roof/tile.h", "class Tile {\n public:\n  struct Edge {\n    int length;\n  };\n\n private:\n"
                                  "  mutable std::mutex mutex_;  // guards colour\n};\n")
        self.write("roof/tile.cc", "void paint(int colour) {\n  static std::mutex mutex;\n}\n")
        self.write("roof/tile_test.cc", "struct Log {\n  std::mutex mutex;\n};\n")
        return list(threads.lock_findings())

    def test_that_are_listed_are_right(self):
        self.assertEqual(self.found(self.PAGE), [])

    def test_that_are_missing_or_gone_are_found(self):
        self.assertEqual(self.found(self.PAGE.replace("Tile", "Chimney")),
                         ["playhouse/roof/tile.h:8: roof::Tile::mutex_ is not in docs/locks.md",
                          "docs/locks.md:1: there is no mutex roof::Chimney::mutex_"])

    def test_of_another_module_are_others(self):
        self.assertEqual(self.found(self.PAGE.replace("roof::Tile", "house::Tile"))[0],
                         "playhouse/roof/tile.h:8: roof::Tile::mutex_ is not in docs/locks.md")

    def test_are_written_one_a_line(self):
        for line in ("std::mutex a, b;", "std::mutex m = {};", "std::array<std::mutex, 4> m;", "std::unique_ptr<std::mutex> m;",
                     "alignas(64) std::mutex m;", "thread_local std::mutex m;", "void f() { static std::mutex m; }"):
            with self.subTest(line):
                self.write("house/door.h", line)
                self.assertEqual(self.found(self.PAGE), ["playhouse/house/door.h:1: write one mutex a line, so that "
                                                         "tools/threads.py finds it"])
        self.write("house/door.h", "std::lock_guard<std::mutex> lock(mutex);  // std::mutex m;\nvoid f(std::mutex& m);")
        self.assertEqual(self.found(self.PAGE), [])


class Threads(Tree):
    def test_are_found_where_the_table_lacks_the_file_that_starts_them(self):
        table = "| thread | does |\n|---|---|\n| sweep | `roof/sweep.h` |\n| guest | |\n\n`house/door.h`\n"
        (self.root / "ARCHITECTURE.md").write_text(f"There are two kinds of threads:\n\n{table}")
        self.write("roof/sweep.cc", "thread_ = std::thread([this] { run(); });")
        self.write("house/door.cc", "\nstd::thread bell([] {});")
        self.write("house/bench_door.cc", "std::thread bell([] {});")
        self.write("house/wall.cc", "std::thread::id id = std::this_thread::get_id();  std::thread thread_;")
        self.assertEqual(list(threads.thread_findings()),
                         ["playhouse/house/door.cc:2: house/door.h is not in the table of threads in ARCHITECTURE.md"])
        (self.root / "ARCHITECTURE.md").write_text(f"There are three kinds of threads:\n\n{table}")
        self.assertIn("ARCHITECTURE.md:1: the table has two kinds of threads", list(threads.thread_findings()))


class Versions(Tree):
    def found(self, package, page, changes="## [Unreleased]\n\n## [2.1.0] - 2030-01-01\n"):
        (self.root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(playhouse VERSION 2.1.0 LANGUAGES CXX)\n")
        self.write("base/formats.h", "inline constexpr std::uint32_t kLetter = 7;\n")
        (self.root / "package.json").write_text(package)
        (self.root / "page.ts").write_text(page)
        (self.root / "CHANGELOG.md").write_text(changes)
        self.replace(versions, "ROOT", self.root)
        self.replace(versions, "VERSIONS", [("package.json", '^  "version": "')])
        self.replace(versions, "MINORS", [("page.ts", "since ")])
        self.replace(versions, "FORMATS", [("kLetter", "page.ts", "letter: ")])
        return [each.partition(" should")[0] for each in versions.findings()]

    def test_that_are_those_of_the_definitions_are_right(self):
        self.assertEqual(self.found('{\n  "version": "2.1.0"', "since 2.1\nletter: 7;"), [])

    def test_that_differ_or_are_missing_are_found(self):
        self.assertEqual(self.found('{\n  "version": "2.1.01"', "since 2.0\nletter: 71;", "## [Unreleased]\n"),
                         ["package.json:2: 2.1.0", "page.ts:1: 2.1", "page.ts:2: 7", "CHANGELOG.md:1: 2.1.0"])
        self.assertEqual(self.found("{}", "since 2.1.0\n"), ["package.json:1: 2.1.0", "page.ts:1: 2.1", "page.ts:1: 7"])


if __name__ == "__main__":
    unittest.main()
