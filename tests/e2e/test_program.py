"""The command line as people and scripts meet it: exit codes, single clear lines, signals, ports."""

import fcntl
import json
import os
import pty
import re
import shutil
import signal
import socket
import struct
import subprocess
import threading
import tomllib
import unittest
from pathlib import Path
from xml.etree import ElementTree

from house import (PATIENCE, POSITION2D, PROGRAM, ROOT, WORLD, Client, House, HouseTest, finish, wait_for_any, wait_until)


class Faults(HouseTest):
    def check_fault(self, code: int, expected: str, *arguments):
        """Ends with the code and one line that says what is wrong, and where."""
        done = finish(*arguments)
        lines = done.stderr.strip().splitlines()
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertIn(expected, lines[0])
        self.assertEqual(done.stdout, "")

    def test_a_mistyped_command_gets_the_nearest_one(self):
        self.check_fault(2, 'did you mean "serve"?', "sreve", "x.cfg")

    def test_a_mistyped_flag_gets_the_nearest_one(self):
        self.check_fault(2, 'did you mean "--duration"?', "run", self.world(), "--durration", "3")

    def test_a_wrong_value_is_named(self):
        self.check_fault(2, "--workers", "run", self.world(), "--workers", "many")

    def test_a_missing_world_is_named(self):
        self.check_fault(2, "nosuch.world", "run", self.folder / "nosuch.world", "--headless", "--port", "0")

    def test_a_malformed_world_is_refused_with_its_line(self):
        world = self.world('position( name "r0"\n  pose [0 0 0\n')
        self.check_fault(2, "test.world:", "run", world, "--headless", "--port", "0")

    def test_a_malformed_configuration_is_refused_with_its_line(self):
        cfg = self.write("test.cfg", 'driver( name "stage" provides ["simulation:0"\n')
        self.check_fault(2, "test.cfg:", "serve", cfg, "--headless", "--port", "0")

    def test_an_unknown_driver_gets_the_nearest_one(self):
        cfg = self.write("test.cfg", 'driver( name "stag" provides ["simulation:0"] )\n')
        self.check_fault(2, 'did you mean "stage"?', "serve", cfg, "--headless", "--port", "0")

    def test_an_unknown_model_gets_the_nearest_one(self):
        self.world()
        cfg = self.write("test.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "test.world" )\n'
                                     'driver( name "stage" provides ["position2d:0"] model "r00" )\n')
        self.check_fault(2, "test.cfg:2", "serve", cfg, "--headless", "--port", "0")

    def test_a_port_in_use_is_one_clear_line(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = str(taken.getsockname()[1])
            self.check_fault(1, f"{port}: cannot listen: Address already in use; --port takes another port", "run",
                             self.world(), "--headless", "--port", port)
            self.check_fault(1, "--web takes another port", "run", self.world(), "--port", "0", "--web", port)
            self.world()
            cfg = self.write("taken.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "test.world" )\n'
                                          f'driver( name "stage" provides ["{port}:position2d:0"] model "r0" )\n')
            self.check_fault(1, "the configuration file names this port", "serve", cfg, "--headless", "--port", "0")

    def test_a_server_that_is_not_there_is_one_clear_line(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
        self.check_fault(1, str(port), "devices", f"127.0.0.1:{port}")

    def test_an_unknown_interface_gets_the_nearest_one(self):
        self.check_fault(2, 'did you mean "laser"?', "watch", "localhost", "lazer:0")

    def test_a_server_that_is_no_address_is_a_wrong_command_line(self):
        for command in (["devices"], ["watch", "laser:0"], ["drive", "position2d:0"]):
            self.check_fault(2, "HOST:PORT", command[0], "localhost:port", *command[1:])

    def test_an_interface_without_data_cannot_be_watched(self):
        self.check_fault(2, "no data", "watch", "localhost", "simulation:0")

    def test_a_world_and_a_configuration_are_told_apart(self):
        cfg = self.write("test.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "test.world" )\n')
        self.check_fault(2, "playhouse serve", "run", cfg, "--headless", "--port", "0")
        self.check_fault(2, "playhouse run", "serve", self.world(), "--headless", "--port", "0")

    def test_a_world_for_serve_is_told_what_runs_it(self):
        world = self.world('define wall model( )\nwall( )\nposition( name "r0" )\n')
        done = finish("serve", world, "--headless", "--port", "0")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, f"{world}: error: is a world file, not a configuration: playhouse run {world} "
                                      "serves its robots\n")

    def test_errors_of_files_begin_with_their_place_and_all_others_with_one_word(self):
        world = self.world('model( pose [0 0] )\nmodle( )\n')
        for command in (["run", world, "--headless", "--port", "0"], ["check", world]):
            done = finish(*command)
            self.assertEqual(done.returncode, 2)
            lines = (done.stdout + done.stderr).splitlines()
            self.assertEqual(len(lines), 2, lines)
            self.assertTrue(lines[0].startswith(f"{world}:1: error: "), lines)
            self.assertTrue(lines[1].startswith(f"{world}:2: error: "), lines)
        for command in (["rnu"], ["run"], ["devices", "localhost:port"], ["watch", "localhost", "lazer:0"], ["bench", "x"],
                        ["drive", "localhost", "laser:0"]):
            done = finish(*command)
            self.assertTrue(done.stderr.startswith("error: "), done.stderr)

    def test_every_unknown_controller_is_told_once_at_its_line(self):
        world = self.world('define r position( ctrl "wandr" )\nr( )\nr( )\nposition( ctrl "fsr" )\n')
        for command in (["run", world, "--headless", "--port", "0"], ["check", world], ["verify", world, "--ticks", "1"],
                        ["picture", world, "--renderer", "playhouse", "-o", self.folder / "a.png"]):
            done = finish(*command)
            self.assertEqual(done.returncode, 2, done.stderr)
            lines = [line for line in (done.stdout + done.stderr).splitlines() if "error" in line]
            self.assertEqual(len(lines), 2, lines)
            self.assertRegex(lines[0], '^' + re.escape(f"{world}:2: error: ") + '.*"wandr"')
            self.assertRegex(lines[1], '^' + re.escape(f"{world}:4: error: ") + '.*"fsr"')

    def test_check_says_all_on_standard_output(self):
        self.write("plan.pbm", "P1 2 2 1001")
        world = self.world('position( )\nmodel( bitmap "plan.pbm" size [2 2 1] obstacle_return 0 )\n'
                           'ranger( sensor( error "lidar" ) )\n')
        done = finish("check", world)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn(f"{world}:2: warning: model ", done.stdout)
        self.assertIn(f"{world}:3: warning: error has its full effect with --engine arena only", done.stdout)
        run = finish("run", world, "--headless", "--port", "0", "--fast", "--duration", "0")
        self.assertIn(f"{world}:2: warning: model ", run.stderr)

    def test_check_counts_warnings_as_errors_if_asked(self):
        misspelt = self.write("misspelt.world", 'position( name "a" sise [1 1 1] )\n')
        fine = self.write("fine.world", "position( )\n")
        cfg = self.write("one.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "misspelt.world" )\n')
        for arguments, code in (((misspelt,), 0), ((misspelt, "--strict"), 2), ((fine, "--strict"), 0),
                                ((fine, misspelt, fine, "--strict"), 2), ((cfg,), 0), ((cfg, "--strict"), 2)):
            done = finish("check", *arguments)
            self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)

    def test_a_library_that_is_allowed_and_not_there_is_a_wrong_command_line(self):
        gone = self.folder / "gone.so"
        self.check_fault(2, f"{gone}: error: --allow-library: there is no such file", "run", self.world(), "--headless",
                         "--port", "0", "--allow-library", gone)

    def test_no_name_of_a_file_reaches_the_terminal_with_its_escape_codes(self):
        evil = "\x1b]0;title\x07\x1b[31m"
        cfg = self.write("evil.cfg", f'driver( name "stage" provides ["simulation:0"] worldfile "{evil}.world" )\n')
        named = self.folder / f"{evil}.world"
        named.write_text(f'position( name "{evil}" ctrl "{evil}" )\nmodel( bitmap "{evil}" )\n')
        other = self.write("other.cfg", f'driver( name "{evil}" provides ["{evil}:0"] {"x"} "{evil}" )\n')
        for file in (cfg, named, other, self.folder / f"{evil}gone.world"):
            for command in (["check", file], ["run", file, "--headless", "--port", "0"],
                            ["serve", file, "--headless", "--port", "0"]):
                done = finish(*command)
                self.assertEqual(done.returncode, 2, command)
                self.assertNotIn("\x1b", done.stdout + done.stderr)
                self.assertNotIn("\x07", done.stdout + done.stderr)

    def test_a_world_that_a_configuration_misses_is_named_with_the_line(self):
        cfg = self.write("test.cfg", '\ndriver( name "stage" provides ["simulation:0"] worldfile "gone.world" )\n')
        self.check_fault(2, "test.cfg:2: error: world file", "serve", cfg, "--headless", "--port", "0")


class StandardStreams(HouseTest):
    """A result that nobody got is a failed run; what nobody wanted to hear is not."""

    def shell(self, redirections: str) -> subprocess.CompletedProcess:
        command = f'"{PROGRAM}" run "{self.world()}" --port 0 --headless --fast --duration 1 --json {redirections}'
        return subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=PATIENCE)

    def test_a_full_disk_is_a_failure(self):
        done = self.shell("> /dev/full")
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output cannot be written", done.stderr)

    def test_a_reader_that_left_is_none(self):
        done = self.shell("| true; exit ${PIPESTATUS[0]}")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_closed_standard_output_is_a_failure(self):
        done = self.shell(">&-")
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output cannot be written", done.stderr)

    def test_watch_ends_where_it_cannot_write(self):
        with self.run_house() as house:
            done = subprocess.run(["bash", "-c", f'"{PROGRAM}" watch 127.0.0.1:{house.port()} laser:0 >&-'],
                                  capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)

    def test_closed_streams_that_carry_no_result_are_none(self):
        done = self.shell("<&- 2>&-")
        self.assertEqual((done.returncode, json.loads(done.stdout)["ticks"]), (0, 10))

    def test_a_log_that_cannot_be_written_is_none(self):
        done = self.shell("2> /dev/full")
        self.assertEqual((done.returncode, json.loads(done.stdout)["ticks"]), (0, 10))


class Texts(unittest.TestCase):
    def test_help_and_version_go_to_standard_output(self):
        done = finish("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("playhouse run", done.stdout)
        done = finish("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout,
                         r"^playhouse \d+\.\d+\.\d+ \(commit ([0-9a-f]{7,}(-dirty)?|unknown), Player protocol 3\.1\)\n$")
        self.assertEqual(finish("-V").stdout, done.stdout)


class Examples(HouseTest):
    """Every example of a command's --help is run, with free ports, in a folder with the files they name."""

    def setUp(self):
        super().setUp()
        (self.folder / "worlds").symlink_to(ROOT / "worlds")
        self.write("my.world", WORLD.replace('"r0"', '"guest"'))
        self.write("my.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "my.world" )\n'
                             'driver( name "stage" provides ["position2d:0" "laser:0"] model "guest" )\n')

    def examples(self, command: str) -> list[str]:
        lines = [line.strip() for line in finish(command, "--help").stdout.splitlines()]
        found = [line for line in lines[lines.index("Examples:"):] if line.startswith("playhouse ")]
        self.assertGreaterEqual(len(found), 2, command)
        return found

    def shell(self, line: str) -> subprocess.CompletedProcess:
        return subprocess.run(["bash", "-c", line.replace("playhouse", f'"{PROGRAM}"', 1)], cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=PATIENCE)

    def test_those_of_servers_listen(self):
        for command in ("run", "serve"):
            for line in self.examples(command):
                with self.subTest(line):
                    words = line.replace("0.0.0.0", "127.0.0.1").replace("--port 7000", "").split()[1:]
                    page = [] if "--web" in words or "--headless" in words else ["--web", 0]
                    words = [str(self.folder / word) if word.startswith(("worlds/", "my.")) else word for word in words]
                    with House(*words, "--port", 0, *page) as house:
                        house.port()
                        if "--duration" in words:
                            self.assertEqual(house.wait(), 0, house.log())
                            self.assertEqual(json.loads(house.output())["sim_time"], 60)
                        else:
                            self.assertEqual(house.end(), 143, house.log())

    def test_those_of_clients_find_their_server(self):
        with self.run_house(world=self.folder / "my.world") as house:
            for command in ("devices", "watch", "drive"):
                for line in self.examples(command):
                    if "--network" in line:  # needs one: test_discovery.py
                        continue
                    with self.subTest(line):
                        words = line.split()
                        here = f"127.0.0.1:{house.port()}"
                        words = [here if word.startswith("127.0.0.1") else word for word in words]
                        if command == "watch" and "--count" not in words:
                            words += ["--count", "1"]  # it would go on
                        done = self.shell(" ".join(words if here in words else [*words[:2], here, *words[2:]]))
                        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
                        self.assertNotEqual(done.stdout, "")

    def test_those_of_observe_find_their_server(self):
        with self.run_house("--observers", 0, world=self.folder / "my.world") as house:
            here = house.wait_for_line(r"^observers: (\S+)$").group(1)
            for line in self.examples("observe"):
                with self.subTest(line):
                    done = self.shell(line.replace("127.0.0.1", here))
                    self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
                    self.assertNotEqual(done.stdout, "")

    def test_those_of_check_and_convert_and_kinds_and_bench_end_well(self):
        recorded = self.shell("playhouse run my.world --fast --headless --port 0 --duration 2 --record my.mcap")
        self.assertEqual(recorded.returncode, 0, recorded.stderr)
        for command in ("check", "convert", "picture", "film", "kinds", "drivers", "bench"):
            for line in self.examples(command):
                with self.subTest(line):
                    done = self.shell(line)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_those_of_replay_and_export_work_on_a_recording(self):
        recorded = self.shell("playhouse run my.world --fast --headless --port 0 --duration 2 --record my.mcap")
        self.assertEqual(recorded.returncode, 0, recorded.stderr)
        for line in self.examples("export"):
            with self.subTest(line):
                self.assertEqual(self.shell(line).returncode, 0)
        self.assertTrue((self.folder / "my" / "tf.csv").exists() and (self.folder / "tables" / "tf.csv").exists())
        for line in self.examples("replay"):
            with self.subTest(line):
                words = line.replace("my.mcap", str(self.folder / "my.mcap")).replace("--web 8081", "").split()[1:]
                with House(*words, "--web", 0) as house:
                    house.wait_for_line(r"^web page: http://127\.0\.0\.1:\d+/$")
                    self.assertEqual(house.end(), 143, house.log())

    def test_bench_world_is_the_run_of_that_file(self):
        world = self.write("parts.world", 'position( size [0.4 0.4 0.2] ctrl "dynamic" velocity [0.1 0 0 10] )')
        done = finish("bench", "world", world, "--duration", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        run = finish("run", world, "--headless", "--fast", "--port", "0", "--duration", "1", "--json")
        self.assertEqual(json.loads(done.stdout)["hash"], json.loads(run.stdout)["hash"])

    def test_series_have_a_line_for_each_scenario_and_the_plot_a_curve_for_each(self):
        lines = []
        for series, scenarios in (("vaughan2008", ["cave", "hospital"]), ("diffusion", ["diffusion"])):
            for robots in (3, 30):
                done = finish("bench", series, "--robots", robots, "--duration", "0.5")
                self.assertEqual(done.returncode, 0, done.stderr)
                made = [json.loads(line) for line in done.stdout.splitlines()]
                self.assertEqual([(line["scenario"], line["robots"]) for line in made], [(name, robots) for name in scenarios])
                lines += done.stdout.splitlines()
        picture = Path(self.write("cost.svg", ""))
        drawn = subprocess.run(["python3", ROOT / "tools" / "plot_bench.py", self.write("lines.jsonl", "\n".join(lines)), picture],
                               capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertEqual(len(drawn.stdout.splitlines()), 2 + 6)
        curves = ElementTree.parse(picture).findall("{http://www.w3.org/2000/svg}polyline")
        self.assertEqual([len(curve.get("points").split()) for curve in curves], [2, 2, 2])

    def test_the_plot_tells_in_one_line_what_it_cannot_read_or_write(self):
        picture = self.folder / "cost.svg"
        for lines, fault in ((self.folder / "nope", "No such file or directory"), (self.folder, "Is a directory"),
                             (self.write("none.jsonl", ""), "has no line of playhouse bench"),
                             (self.write("other.jsonl", '{"a": 1}\n'), "has lines that playhouse bench did not write")):
            done = subprocess.run(["python3", ROOT / "tools" / "plot_bench.py", lines, picture], capture_output=True, text=True,
                                  timeout=PATIENCE)
            self.assertEqual((done.returncode, done.stderr), (1, f"{lines}: {fault}\n"))

    def test_the_page_of_robots_is_as_their_files_say_and_its_examples_run_anywhere(self):
        done = subprocess.run(["python3", ROOT / "tools" / "robots_page.py", "--check"], capture_output=True, text=True, timeout=PATIENCE,
                              env={**os.environ, "PLAYHOUSE_PROGRAM": PROGRAM})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        examples = re.findall(r"```\n(.*?)```", (ROOT / "docs" / "robots.md").read_text(), re.DOTALL)
        self.assertGreaterEqual(len(examples), 5)
        for example in examples:
            self.assertEqual(len(example.splitlines()), 10)
            done = finish("run", self.write("example.world", example), "--port", 0, "--headless", "--fast", "--duration", 5, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("warning", done.stderr)
            self.assertEqual(json.loads(done.stdout)["robots"], 3)

    def test_the_tool_that_makes_the_swarm_has_help(self):
        tool = ROOT / "tools" / "make_swarm_world.py"
        done = subprocess.run(["python3", tool, "--help"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertIn("example: tools/make_swarm_world.py > worlds/swarm.world", done.stdout)
        made = subprocess.run(["python3", tool], capture_output=True, text=True, timeout=PATIENCE).stdout
        self.assertEqual(made, (ROOT / "worlds" / "swarm.world").read_text())


class Ending(HouseTest):
    def test_signals_end_a_run_cleanly_with_their_codes(self):
        for by, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.run_house("--json") as house:
                port = house.port()
                with Client(port) as client:
                    client.open(POSITION2D, 0)
                    client.next_data(POSITION2D, 0)
                    self.assertEqual(house.end(by), code, house.log())
                self.assertEqual(json.loads(house.output().splitlines()[-1])["robots"], 2)

    def test_what_nohup_ignores_ends_nothing(self):
        before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
        self.addCleanup(signal.signal, signal.SIGHUP, before)
        with self.run_house() as house:
            with Client(house.port()) as client:
                house.process.send_signal(signal.SIGHUP)
                client.open(POSITION2D, 0)
            self.assertEqual(house.end(), 143)

    def test_a_signal_while_a_world_loads_ends_with_its_code(self):
        world = self.world('unknown_key 1\n' + 'model( size [0.1 0.1 0.1] )\n' * 5000)
        for by, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.run_house(world=world) as house:
                house.wait_for_line("unknown_key")     # it has read the file, and makes the models
                self.assertEqual(house.end(by), code, house.log())

    def test_bench_watched_tells_what_a_page_and_clients_cost(self):
        done = finish("bench", "watched", "--robots", "10", "--duration", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(done.stdout)
        self.assertEqual((figures["robots"], figures["clients"], figures["lost"]), (10, 200, 0))
        for name in ("tick_ms", "tick_ms_with_page", "tick_ms_with_lasers", "packets_per_s", "messages_per_s"):
            self.assertGreater(figures[name], 0, name)

    def test_a_bench_of_the_server_ends_with_the_code_and_without_figures(self):
        with House("bench", "server", "--robots", "1") as bench:
            threads = Path(f"/proc/{bench.process.pid}/task")
            wait_until(lambda: bench.process.poll() is not None or len(list(threads.iterdir())) >= 4, "serving its clients")
            self.assertEqual(bench.end(), 143, bench.log())
            self.assertEqual((bench.output(), bench.log().strip()), ("", ""))

    def test_a_signal_ends_a_paused_run_too(self):
        with self.run_house("--paused") as house:
            house.port()
            self.assertEqual(house.end(signal.SIGINT), 130)

    def test_the_duration_ends_a_run_with_its_result_on_the_last_line(self):
        done = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", "2.5", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(done.stdout.splitlines()[-1])
        self.assertEqual(set(result), {"sim_time", "wall_time", "real_time_factor", "ticks", "robots", "rays", "hash",
                                       "sensed_hash"})
        self.assertEqual((result["ticks"], result["robots"]), (25, 2))
        self.assertAlmostEqual(result["sim_time"], 2.5)
        for name in ("hash", "sensed_hash"):
            self.assertRegex(result[name], r"^[0-9a-f]{16}$")

    def test_the_files_quit_time_ends_a_run(self):
        world = self.world("quit_time 1\nposition( name \"r0\" )\n")
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--json")
        self.assertEqual((done.returncode, json.loads(done.stdout)["ticks"]), (0, 10))

    def test_standard_output_is_silent_without_json(self):
        done = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", "1")
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_real_time_is_kept(self):
        world = self.world("speedup 0\nposition( name \"r0\" )\n")
        done = finish("run", world, "--port", 0, "--headless", "--duration", "1", "--json")
        self.assertGreater(json.loads(done.stdout)["wall_time"], 0.85)


class Terminal(HouseTest):
    """The progress line, and log lines in between."""

    def test_colors_are_for_terminals_whose_user_wants_them(self):
        for environment, colored in (({}, True), ({"NO_COLOR": ""}, True), ({"NO_COLOR": "1"}, False)):
            ours, its = pty.openpty()
            subprocess.run([PROGRAM, "run", str(self.folder / "gone.world")], stdin=its, stdout=its, stderr=its,
                           timeout=PATIENCE, env={**os.environ, "TERM": "xterm", **environment})
            os.close(its)
            shown = os.read(ours, 4096)
            os.close(ours)
            self.assertIn(b"error", shown)
            self.assertEqual(b"\x1b[1;31m" in shown, colored, shown)
        self.assertNotIn("\x1b", finish("run", self.folder / "gone.world").stderr)

    def start_on_terminal(self) -> tuple[subprocess.Popen, int]:
        """The program, and our end of its terminal."""
        ours, its = pty.openpty()
        self.addCleanup(os.close, ours)
        process = subprocess.Popen([PROGRAM, "run", str(self.world()), "--port", "0", "--headless"], stdin=its, stdout=its,
                                   stderr=its)
        os.close(its)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process, ours

    def test_a_log_line_takes_the_place_of_the_progress_line(self):
        process, ours = self.start_on_terminal()
        shown = self.read_until(ours, b"", rb"Player clients: 127\.0\.0\.1:(\d+)\r\n")
        port = int(re.search(rb"clients: [\d.]+:(\d+)", shown).group(1))
        shown = self.read_until(ours, shown, b"s simulated.*clients ")
        with Client(port) as client:
            client.request(99, 0, 1)
            shown = self.read_until(ours, shown, b"no such device.*s simulated")
        self.assertRegex(shown, b"\r\x1b\\[K[^\r]*warning")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE), 130)

    def test_the_progress_line_has_a_speed_once_it_is_measured(self):
        process, ours = self.start_on_terminal()
        shown = self.read_until(ours, b"", b"s simulated, [\d.]+x real time, 0 clients ")
        self.assertNotIn(b" 0.00x", shown)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE), 130)

    def read_until(self, terminal: int, shown: bytes, pattern: bytes) -> bytes:
        while not re.search(pattern, shown, re.DOTALL):
            shown += os.read(terminal, 4096)
        return shown


class UnreadLog(HouseTest):
    """Nobody reads standard error: the house goes on, for its clients and for whoever ends it."""

    def start(self, stderr) -> subprocess.Popen:
        process = subprocess.Popen([PROGRAM, "run", str(self.world()), "--port", "0", "--headless"], stderr=stderr)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def port_from(self, reading: int) -> int:
        shown = b""
        while not (found := re.search(rb"Player clients: [\d.]+:(\d+)\r?\n", shown)):
            shown += os.read(reading, 4096)
        return int(found.group(1))

    def check_serves_and_ends(self, process: subprocess.Popen, port: int):
        for _ in range(200):    # 13 kB of warnings
            with Client(port) as client:
                client.request(99, 0, 1)
        with Client(port) as client:
            client.open(POSITION2D, 0)
            first = client.next_data(POSITION2D, 0).time
            while client.next_data(POSITION2D, 0).time < first + 1:
                pass
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(PATIENCE), 143)

    def test_a_pipe_that_nobody_reads_stops_nobody(self):
        ours, its = os.pipe()
        self.addCleanup(os.close, ours)
        fcntl.fcntl(its, fcntl.F_SETPIPE_SZ, 4096)
        process = self.start(its)
        os.close(its)
        self.check_serves_and_ends(process, self.port_from(ours))

    def test_a_terminal_that_stands_still_stops_nobody(self):
        ours, its = pty.openpty()
        self.addCleanup(os.close, ours)
        process = self.start(its)
        os.close(its)
        port = self.port_from(ours)
        os.write(ours, b"\x13")     # Ctrl-S
        self.check_serves_and_ends(process, port)


class Tools(HouseTest):
    def setUp(self):
        super().setUp()
        self.house = self.enterContext(self.run_house())
        self.server = f"127.0.0.1:{self.house.port()}"

    def test_devices_lists_names_and_drivers(self):
        done = finish("devices", self.server)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line.split() for line in done.stdout.splitlines()]
        self.assertIn(["position2d:0", "r0", "stage"], lines)
        self.assertIn(["laser:0", "r0.ranger:0", "stage"], lines)
        self.assertIn(["simulation:0", "-", "stage"], lines)

    def test_devices_are_json_objects_with_their_model_and_robot(self):
        done = finish("devices", self.server, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        devices = {device["device"]: device for device in map(json.loads, done.stdout.splitlines())}
        self.assertEqual(devices["laser:0"], {"device": "laser:0", "interface": "laser", "index": 0, "port": self.house.port(),
                                              "driver": "stage", "model": "r0.ranger:0", "robot": "r0"})
        self.assertIsNone(devices["simulation:0"]["model"])

    def test_robots_are_watched_and_driven_by_their_names(self):
        done = finish("watch", self.server, "r1", "--count", 1)
        self.assertEqual((done.returncode, json.loads(done.stdout)["index"]), (0, 1), done.stderr)
        done = finish("watch", self.server, "r1.ranger:0", "--count", 1)
        self.assertEqual((done.returncode, json.loads(done.stdout)["index"]), (0, 2), done.stderr)
        self.assertEqual(finish("drive", self.server, "r1").returncode, 0)      # the end of its keys ends it
        for command, name, expected in (("drive", "r3", "r3"), ("drive", "wall", "wall"), ("watch", "r", "\"r\"")):
            done = finish(command, self.server, name)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(expected, done.stderr)

    def test_a_number_alone_is_a_port_of_this_machine(self):
        done = finish("devices", self.house.port())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(finish("devices", "70000").returncode, 2)

    def test_watch_prints_json_lines(self):
        done = finish("watch", self.server, "laser:0", "--count", 2)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(lines), 2)
        self.assertEqual(lines[0]["message"], "laser.data.scan")
        self.assertEqual(len(lines[0]["data"]["ranges"]), 181)
        self.assertGreater(lines[1]["time"], lines[0]["time"])

    def test_watch_ends_cleanly_on_a_signal(self):
        with House("watch", self.server, "position2d:0") as watch:
            watch.process.stdout.readline()
            self.assertEqual(watch.end(signal.SIGINT), 130)

    def test_a_signal_ends_watch_and_drive_at_once_while_they_connect(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            server = f"127.0.0.1:{silent.getsockname()[1]}"
            for command in (("watch", server, "laser:0"), ("drive", server, "position2d:0"), ("devices", server)):
                for by, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
                    with House(*command) as tool:
                        with silent.accept()[0]:
                            self.assertEqual(tool.end(by), code, tool.log())

    def test_a_device_that_is_not_there_fails(self):
        done = finish("watch", self.server, "gripper:0")
        self.assertEqual(done.returncode, 1)
        self.assertIn("gripper:0", done.stderr)

    def test_keys_drive_a_robot_and_quitting_stops_it_and_restores_the_terminal(self):
        ours, its = pty.openpty()
        self.addCleanup(os.close, ours)
        import termios
        before = termios.tcgetattr(its)
        with House("drive", self.server, "position2d:0", stdin=its) as drive, Client(self.house.port()) as watcher:
            watcher.open(POSITION2D, 0)
            drive.process.stdout.readline()     # the keys are explained, the robot is open
            os.write(ours, b"\x1b[A")
            self.wait_for_speed(watcher, 0.1)
            os.write(ours, b"ww")
            self.wait_for_speed(watcher, 0.3)
            os.write(ours, b"q")
            self.assertEqual(drive.wait(), 0, drive.log())
            self.wait_for_speed(watcher, 0)
        self.assertEqual(termios.tcgetattr(its)[3], before[3])
        os.close(its)

    def test_however_drive_ends_the_robot_stops_although_another_client_has_it_open(self):
        import termios
        ends = {"q": (b"q", 0), "Ctrl-D": (b"\x04", 0), "Ctrl-Z": (b"\x1a", 0), "Ctrl-\\": (b"\x1c", 0),
                "Ctrl-C": (b"\x03", 130), "Ctrl-S": (b"\x13q", 0),
                "SIGTERM": (signal.SIGTERM, 143), "SIGHUP": (signal.SIGHUP, 129), "a closed terminal": (None, None)}
        for name, (by, code) in ends.items():
            with self.subTest(name), Client(self.house.port()) as watcher:
                watcher.open(POSITION2D, 0)
                pid, terminal = pty.fork()
                if pid == 0:
                    os.execv(PROGRAM, [PROGRAM, "drive", self.server, "position2d:0"])
                shown = b""
                while b"q ends" not in shown:
                    shown += os.read(terminal, 4096)
                os.write(terminal, b"w")
                self.wait_for_speed(watcher, 0.1)
                if isinstance(by, bytes):
                    os.write(terminal, by)
                elif by is not None:
                    os.kill(pid, by)
                else:
                    os.close(terminal)
                self.wait_for_speed(watcher, 0)
                ended = self.exit_code(pid, terminal if by is not None else None)
                if code is not None:
                    self.assertEqual(ended, code)
                    self.assertEqual(termios.tcgetattr(terminal)[3] & (termios.ECHO | termios.ICANON),
                                     termios.ECHO | termios.ICANON)
                    os.close(terminal)

    def exit_code(self, pid: int, terminal) -> int:
        """Of a child that may have to say something before it ends."""
        end = os.pidfd_open(pid)
        self.addCleanup(os.close, end)
        heard = [end] if terminal is None else [end, terminal]
        while end not in wait_for_any(heard, "ended"):
            try:
                os.read(terminal, 4096)
            except OSError:
                heard = [end]    # the terminal is gone
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])

    def wait_for_speed(self, client, speed):
        for _ in range(600):
            seen = struct.unpack(">d", client.next_data(POSITION2D, 0).body[24:32])[0]
            if abs(seen - speed) < 1e-9:
                return
        self.fail(f"never drove at {speed}, last at {seen}")


class Check(HouseTest):
    def test_a_good_file_is_zero_and_its_warnings_are_printed(self):
        done = finish("check", self.world("gui_speed 3\nposition( name \"r0\" colour \"red\" )\n"))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("test.world:2", done.stdout)

    def test_several_files_are_checked_and_one_bad_one_is_two(self):
        good, bad = self.world(), self.write("bad.world", "modle( )\n")
        self.assertEqual(finish("check", good, good).returncode, 0)
        done = finish("check", bad, good)
        self.assertEqual((done.returncode, done.stderr), (2, ""))
        self.assertIn("bad.world:1: error: ", done.stdout)
        self.assertIn("test.world: ", done.stdout)

    def test_no_code_is_loaded(self):
        mark = self.folder / "loaded"
        source = self.write("evil.cc", f"""#include <cstdio>
            static const int at_once = (std::fopen("{mark}", "w"), 0);""")
        library = self.folder / "evil.so"
        subprocess.run(["g++", "-shared", "-fPIC", "-o", library, source], check=True)
        away = self.folder / "away"
        away.mkdir()
        world = self.write("away/test.world", f'position( ctrl "{self.folder}/evil" )\n')
        done = finish("check", world)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn(f"warning: controller \"{self.folder}/evil\" is {library}, which is there and not checked", done.stdout)
        run = ["run", world, "--headless", "--port", 0]
        done = finish(*run)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertIn(f"run with --allow-library {library}", done.stderr)
        self.assertFalse(mark.exists())
        done = finish(*run, "--allow-library", library)
        self.assertIn(f"loads {library}", done.stderr)
        self.assertIn("is not a controller", done.stderr)
        self.assertTrue(mark.exists())

    def test_a_pipe_is_read_once(self):
        pipe = os.path.join(self.folder, "pipe.world")
        os.mkfifo(pipe)
        writer = threading.Thread(target=lambda: Path(pipe).write_text(WORLD, encoding="utf-8"), daemon=True)
        writer.start()
        done = finish("check", pipe)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("not a regular file", done.stdout)

    def test_a_bad_file_is_two(self):
        self.assertEqual(finish("check", self.world("position(")).returncode, 2)
        self.assertEqual(finish("check", self.folder / "nothing.cfg").returncode, 2)

    def test_a_controller_that_does_not_exist_is_an_error(self):
        done = finish("check", self.world("position( ctrl \"wandr\" )\n"))
        self.assertEqual(done.returncode, 2, done.stdout)


class Kinds(HouseTest):
    """What kinds/*.toml define, as the program tells it."""

    def test_each_definition_is_a_line_and_a_json_object(self):
        defined = {}
        for path in (ROOT / "kinds").glob("*.toml"):
            defined[path.stem] = tomllib.loads(path.read_text(encoding="utf-8"))
        told = {kind["name"]: kind for kind in map(json.loads, finish("kinds", "--json").stdout.splitlines())}
        self.assertEqual(set(told), set(defined))
        for name, kind in told.items():
            wanted = defined[name]
            self.assertEqual((kind["entity"], kind["doc"]), (wanted["entity"], wanted["doc"]))
            self.assertEqual(kind["simulated"], wanted["entity"] != "model" or "number" in wanted, name)
            words = [w["name"] for w in wanted.get("word", [])] + wanted.get("silent", []) + list(wanted.get("old", {}))
            self.assertEqual([w["name"] for w in kind["words"]], words)
            self.assertEqual([i["name"] for i in kind["interfaces"]], [i["name"] for i in wanted.get("interface", [])])
        self.assertEqual([line.split()[0] for line in finish("kinds").stdout.splitlines()], list(told))

    def test_a_kind_is_told_with_its_words(self):
        done = finish("kinds", "position")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn('  wheelbase           length (m)\n', done.stdout)
        self.assertIn('Limits: above 0. Default: 1.\n', done.stdout)
        self.assertIn("playhouse kinds model\n", done.stdout)
        drive = json.loads(finish("kinds", "position", "--json").stdout)["words"][0]
        self.assertEqual((drive["name"], drive["form"], drive["default"], drive["unit"]),
                         ("drive", '"diff" | "omni" | "walk" | "car"', '"diff"', None))

    def test_an_unknown_name_is_one_line_with_what_to_write(self):
        for name, expected in (("positoin", 'unknown kind "positoin" (did you mean "position"?); playhouse kinds lists all'),
                               ("laser", "Stage 4 has none: write ranger( sensor("), ("wrold", 'did you mean "world"?')):
            done = finish("kinds", name)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (2, "", 1), done.stderr)
            self.assertIn(expected, done.stderr)


class Drivers(HouseTest):
    """What drivers of configuration files define, as the program tells it; playhouse/drivers/definition_test.cc compares it with what they read."""

    def test_each_driver_is_a_line_and_a_json_object(self):
        told = [json.loads(line) for line in finish("drivers", "--json").stdout.splitlines()]
        names = [name for driver in told for name in (driver["name"], driver["other_name"]) if name is not None]
        self.assertIn("statgrabdriver", names)
        self.assertEqual([line.split()[0] for line in finish("drivers").stdout.splitlines()], names)

    def test_a_driver_is_told_with_its_devices_and_options(self):
        done = finish("drivers", "nd")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("  requires output:::position2d: gets velocities and requests\n", done.stdout)
        self.assertIn("  goal_tol              [length angle] (m, deg)\n", done.stdout)
        self.assertIn("Limits: 0.001 at least. Default: 0.5.\n", done.stdout)
        self.assertIn("  refusal (string): ", done.stdout)
        self.assertIn("may have isolated (docs/plugins.md)", done.stdout)
        told = json.loads(finish("drivers", "nd", "--json").stdout)
        self.assertEqual({device["interface"]: device["many"] for device in told["requires"]},
                         {"position2d": "one", "laser": "some of these", "ranger": "some of these", "sonar": "some of these"})
        option = told["options"][0]
        self.assertEqual((option["name"], option["default"], option["default_told"]), ("goal_tol", "[0.5 10]", None))

    def test_an_unknown_name_is_one_line_with_what_to_write(self):
        for name, expected in (("vhf", 'unknown driver "vhf" (did you mean "vfh"?); playhouse drivers lists all'),
                               ("writelog", "the option --record records a run")):
            done = finish("drivers", name)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (2, "", 1), done.stderr)
            self.assertIn(expected, done.stderr)

    def test_their_pages_are_what_the_program_prints(self):
        done = subprocess.run(["python3", ROOT / "tools" / "driver_pages.py", "--check"], capture_output=True, text=True, timeout=PATIENCE,
                              env={**os.environ, "PLAYHOUSE_PROGRAM": PROGRAM})
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class PlayerLink(HouseTest):
    def setUp(self):
        super().setUp()
        self.player = self.folder / "player"
        self.player.symlink_to(PROGRAM)
        self.world()
        self.cfg = self.write("test.cfg", """
            driver( name "stage" provides ["simulation:0"] plugin "stageplugin" worldfile "test.world" )
            driver( name "stage" provides ["position2d:0"] model "r0" )
            """)

    def test_says_that_it_listens_as_scripts_wait_for(self):
        with House("-p", 0, "-d", 1, "-q", self.cfg, program=str(self.player)) as house:
            line = house.process.stdout.readline()
            self.assertRegex(line, r"^Listening on ports: \d+ $")
            with Client(int(line.split()[3])) as client:
                self.assertIn((POSITION2D, 0), client.devices())
            self.assertEqual(house.end(), 0)
            self.assertIn("Quitting.", house.output())

    def test_the_log_file_gets_the_lines_too(self):
        log = self.folder / "player.log"
        log.write_text("before\n")
        with House("-p", 0, "-l", log, self.cfg, program=str(self.player)) as house:
            house.process.stdout.readline()
            self.assertEqual(house.end(), 0)
            self.assertRegex(log.read_text(), r"\Abefore\n\[.*-k KEY asks for a key\n(\[.*announced on the network.*\n)?\[[-0-9: .]+\] info: simulated .*\n\Z")

    def test_a_log_file_whose_folder_is_not_there_is_refused(self):
        folder = self.folder / "none"
        done = finish("-l", folder / "log", self.cfg, program=str(self.player))
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertFalse(folder.exists())

    def test_help_and_faults_end_with_players_code(self):
        bad = self.write("bad.cfg", "driver(")
        for arguments in (["-h"], [], ["-x", self.cfg], ["-p"], ["-p", "0", bad]):
            self.assertEqual(finish(*arguments, program=str(self.player)).returncode, 255, arguments)
        done = finish(self.folder / "nosuch.cfg", program=str(self.player))
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)

    def test_odd_arguments_are_taken_as_players_server_takes_them(self):
        for arguments in (["-qp0", self.cfg], [self.cfg, "-d", "10", "-p", "0"], ["-d", "x", "-p0", self.cfg, "second.cfg"]):
            with House(*arguments, program=str(self.player)) as house:
                self.assertRegex(house.process.stdout.readline(), r"^Listening on ports: \d+ $")
                self.assertEqual(house.end(signal.SIGINT), 0, house.log())

    def test_what_it_cannot_do_it_says(self):
        for arguments, code, expected in ((["-s", self.cfg], 255, "-s is not supported"),
                                          (["-l", "/proc/none/log", self.cfg], 1, "/proc/none/log")):
            done = finish(*arguments, program=str(self.player))
            self.assertEqual(done.returncode, code, arguments)
            self.assertIn(expected, done.stderr)

    def test_the_program_has_a_player_link_beside_it(self):
        link = Path(PROGRAM).parent / "player"
        self.assertTrue(link.is_symlink())
        self.assertEqual(link.resolve(), Path(PROGRAM).resolve())


if __name__ == "__main__":
    unittest.main()
