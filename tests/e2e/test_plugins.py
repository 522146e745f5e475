"""Drivers from outside the tree: examples/drivers and the tutorial of docs/plugins.md are built with the installed package,
and their devices are used over a socket."""

import contextlib
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tty
import unittest
from unittest import mock

from house import ACK, CMD, NACK, PLAYER, POSITION2D, ROOT, Client, House, finish, ranges_of, wait_for_any, wait_until
from installed import InstalledTest, tool

AIO, BLINKENLIGHT, OPAQUE, LASER = 21, 33, 51, 6

# A driver of opaque:0 that does, once it is told to, what no driver should, and says of its process what it is asked.
BAD = """
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/opaque.h"

namespace op = playhouse::wire::opaque;

class Bad : public playhouse::drivers::Plugin {
  void configure(const playhouse::drivers::PluginSection& section) override {
    closed_ = section.filename("filename", "");
    needed_ = section.filename("needs", "");
    on_command<op::Data>(0, op::kCmdData, [this](const op::Data& told) { be_bad(text_of(told)); });
    on_request<op::Data>(0, op::kReqData, [this](const op::Data& asked, playhouse::drivers::PluginReply reply) {
      const std::string what = text_of(asked);
      if (what.rfind("other ", 0) == 0) return ask_other(what.substr(6), std::move(reply));
      const std::string answer = about(what);
      reply.ack(op::Data{{answer.begin(), answer.end()}});
    });
  }
  void open() override {
    if (!needed_.empty() && !std::filesystem::exists(needed_)) throw std::runtime_error("there is no " + needed_);
  }
  void close() override {
    if (!closed_.empty()) std::ofstream(closed_) << "closed";
    if (stays_) be_bad("block");
  }

  void be_bad(const std::string& how) {
    std::fprintf(stderr, "will %s\\n", how.c_str());
    if (how == "throw") throw std::runtime_error("smoke");
    if (how == "abort") std::abort();
    if (how == "exit") std::exit(3);
    if (how == "orphan") leave_orphan();
    if (how == "stay") stays_ = true;
    if (how == "block")
      for (;;) pause();
    if (how == "crash") {
      std::signal(SIGSEGV, SIG_DFL);
      std::raise(SIGSEGV);
    }
  }

  void ask_other(const std::string& what, playhouse::drivers::PluginReply reply) {
    const auto shared = std::make_shared<playhouse::drivers::PluginReply>(std::move(reply));
    const op::Data body{{what.begin(), what.end()}};
    const std::size_t used = what == "nobody" ? 99 : 0;
    ask<op::Data>(used, op::kReqData, body, [shared](const std::optional<op::Data>& answer) {
      if (answer) shared->ack(*answer);
    });
  }

  // It asks the program for the time, again and again, by the socket of its parent.
  static void leave_orphan() {
    if (fork() != 0) _exit(3);
    setsid();
    unsigned char asks[32] = {0, 0, 0, 0, 11};
    while (write(3, asks, sizeof asks) > 0) continue;
    _exit(0);
  }

  static std::string text_of(const op::Data& data) { return {data.data.begin(), data.data.end()}; }
  static std::string about(const std::string& what) {
    std::ostringstream answer;
    if (what == "process") answer << getpid();
    if (what == "status") answer << std::ifstream("/proc/self/status").rdbuf();
    if (what == "descriptors")
      for (int each = 0; each < 4096; ++each)
        if (fcntl(each, F_GETFD) >= 0) answer << each << " ";
    return answer.str();
  }

  std::string closed_, needed_;
  bool stays_ = false;
};

PLAYHOUSE_DRIVER(Bad)
"""
PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(bad LANGUAGES CXX)
find_package(playhouse 0.2 REQUIRED)
playhouse_add_library(bad bad.cc)
"""
WORLD = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] )
position( name "r0" size [0.4 0.4 0.2] scanner( pose [0 0 0 0] ) )
"""
GUARD = """
driver ( name "stage" provides ["simulation:0"] worldfile "room.world" )
driver ( name "stage" provides ["position2d:0" "laser:0"] model "r0" )
driver ( name "guard" plugin "guard" provides ["position2d:1"] requires ["position2d:0" "laser:0"] distance 1
  isolated {isolated} )
"""


def payload(data: bytes) -> bytes:
    """Of interface opaque."""
    return struct.pack(">II", len(data), len(data)) + data + b"\0" * (-len(data) % 4)


class Plugins(InstalledTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.libraries = cls.place / "build"
        shutil.copytree(ROOT / "examples" / "drivers", cls.place / "drivers")
        cls.build(cls.place / "drivers", cls.libraries)
        bad = cls.place / "bad"
        bad.mkdir()
        (bad / "bad.cc").write_text(BAD)
        (bad / "CMakeLists.txt").write_text(PROJECT)
        cls.build(bad, cls.place / "bad_build")

    def setUp(self):
        super().setUp()
        folders = f"{self.libraries}:{self.place / 'bad_build'}"
        self.enterContext(mock.patch.dict(os.environ, PLAYHOUSE_PATH=folders))

    def serve(self, cfg: str) -> House:
        return House("serve", self.write("plugin.cfg", cfg), "--port", 0, "--headless")

    def test_a_sensor_reads_what_the_machine_says(self):
        self.write("load", "0.25 1.5 3.75 1/100 4242\n")
        with self.serve('driver ( name "load" plugin "load" provides ["aio:3"] filename "load" interval 0.05 )') as house:
            with Client(house.port()) as client:
                self.assertEqual(client.devices(), [(AIO, 3)])
                self.assertEqual(client.open(AIO, 3).type, ACK)
                self.assertEqual(struct.unpack(">IIfff", client.next_data(AIO, 3).body), (3, 3, 0.25, 1.5, 3.75))
                self.write("load", "nothing\n")
                house.wait_for_line(f'driver "load" has failed, and its devices retire: no load in {self.folder}/load$')
                self.assertEqual(client.receive().interf, PLAYER, "it is told that the device has retired")
            self.assertEqual(house.end(), 128 + 15)

    def test_an_actuator_does_what_it_is_told_and_is_off_afterwards(self):
        lamp = self.write("lamp", "")
        with self.serve('driver ( name "lamp" plugin "lamp.so" provides ["blinkenlight:0"] filename "lamp" )') as house:
            with Client(house.port()) as client:
                client.open(BLINKENLIGHT, 0)
                client.send(BLINKENLIGHT, 0, CMD, 2, struct.pack(">II", 0, 1))
                self.assertEqual(struct.unpack(">I", client.next_data(BLINKENLIGHT, 0).body[:4]), (1,))
                self.assertEqual(lamp.read_text(), "1")
            with Client(house.port()) as client:  # hooks come one at a time
                client.open(BLINKENLIGHT, 0)
                client.send(BLINKENLIGHT, 0, CMD, 2, struct.pack(">II", 0, 0))
                client.next_data(BLINKENLIGHT, 0)
            self.assertEqual(house.end(), 128 + 15)
        self.assertEqual(lamp.read_text(), "0")

    def test_an_algorithm_stops_the_wheels_before_the_wall(self):
        self.write("room.world", WORLD)
        for isolated in (0, 1):
            with self.subTest(isolated=isolated):
                self.drive_at_the_wall(self.write("room.cfg", GUARD.replace("{isolated}", str(isolated))))

    def drive_at_the_wall(self, cfg):
        with House("serve", cfg, "--port", 0, "--web", "off", "--speed", 10) as house, Client(house.port()) as client:
            for interf, index in ((POSITION2D, 1), (LASER, 0)):
                self.assertEqual(client.open(interf, index).type, ACK)
            geom = client.request(POSITION2D, 1, 1)
            self.assertEqual(struct.unpack(">ddd", geom.body[-24:])[:2], (0.4, 0.4), "the geometry of its wheels")
            client.drive(1, 0.5)
            while min(ranges_of(client.next_data(LASER, 0))) > 1:
                pass
            standing = 0
            while standing < 10:
                state = struct.unpack(">ddddddI", client.next_data(POSITION2D, 1).body)
                standing = standing + 1 if state[3] == 0 else 0
            self.assertGreater(state[0], 1.5)
            self.assertLess(state[0], 2.1, "it stopped about a metre from the wall at 2.9 m")
            self.assertEqual(client.request(POSITION2D, 1, 5, struct.pack(">ddd", 100, 0, 0)).type, ACK)
            while struct.unpack(">d", client.next_data(POSITION2D, 1).body[:8])[0] < 50:
                pass
            self.assertEqual(client.request(POSITION2D, 1, 2, struct.pack(">I", 0)).type, ACK, "the power of its wheels")

    def ask(self, client, what: str) -> str:
        return client.request(OPAQUE, 0, 1, payload(what.encode())).body[8:].rstrip(b"\0").decode()

    def is_lost_alone(self, told: str, isolated: str, how):
        """What `how` does to driver "bad" takes its devices down, and nothing else."""
        cfg = f'driver ( name "bad" plugin "bad" provides ["opaque:0"] {isolated} )\n'
        with self.serve(cfg + 'driver ( name "relay" provides ["opaque:1"] )') as house, Client(house.port()) as client:
            for index in (0, 1):
                client.open(OPAQUE, index)
            process = int(self.ask(client, "process"))
            self.assertEqual(process == house.process.pid, not isolated)
            how(client, process)
            house.wait_for_line('plugin.cfg:1: driver "bad" has failed, and its devices retire: ' + told)
            client.send(OPAQUE, 1, CMD, 1, payload(b"still here"))
            self.assertEqual(client.next_data(OPAQUE, 1).body, payload(b"still here"))
            asked = 0
            while (OPAQUE, 0) in client.devices() and asked < 1000:  # the line comes before its devices retire
                asked += 1
            self.assertEqual(client.devices(), [(OPAQUE, 1)])
            self.assertEqual(house.end(), 128 + 15)
            return house.log()

    @staticmethod
    def tell(what: bytes):
        def command(client, _):
            client.send(OPAQUE, 0, CMD, 1, payload(what))
            assert client.request(OPAQUE, 0, 1, payload(b"process")).type == NACK, "never lost"
        return command

    def test_one_that_throws_or_blocks_loses_its_devices_and_nobody_elses(self):
        for isolated in ("", "isolated 1"):
            for fault, told in ((b"throw", "smoke$"), (b"block", r"it has not come back for \d+ s$")):
                with self.subTest(told, isolated=isolated):
                    self.is_lost_alone(told, isolated, self.tell(fault))

    def test_one_that_crashes_in_a_process_of_its_own_does_so_as_well(self):
        for fault, told in ((b"abort", "its process was ended by SIGABRT$"), (b"crash", "its process was ended by SIGSEGV$"),
                            (b"exit", "its process ended with exit code 3$"),
                            (b"orphan", "its process (ended with exit code 3|broke the rules: it asks again and has .*)$")):
            with self.subTest(told):
                log = self.is_lost_alone(told, "isolated 1", self.tell(fault))
                self.assertRegex(log, f'driver "bad": will {fault.decode()}', "what it printed")
        with self.subTest("killed"):
            self.is_lost_alone("its process was ended by SIGKILL$", "isolated yes",
                               lambda _, process: os.kill(process, signal.SIGKILL))

    def test_a_process_of_its_own_has_no_descriptors_and_signals_of_ours(self):
        with self.serve('driver ( name "bad" plugin "bad" provides ["opaque:0"] isolated 1 )') as house:
            with Client(house.port()) as client:
                client.open(OPAQUE, 0)
                self.assertEqual(self.ask(client, "descriptors").split(), ["0", "1", "2", "3"])
                status = self.ask(client, "status")
        self.assertRegex(status, "Name:\tisolated-plugin\n", "for who lists processes")
        self.assertRegex(status, r"SigBlk:\s+0{16}\n")
        ignored = int(re.search(r"SigIgn:\s+(\w+)", status).group(1), 16) & 0x7FFFFFFF  # but for those of the C library
        self.assertEqual(ignored, 1 << signal.SIGPIPE - 1 | 1 << signal.SIGXFSZ - 1, "as in the program")

    def test_a_process_of_its_own_ends_with_the_program_however_that_ends(self):
        for told, by in ((None, signal.SIGTERM), (None, signal.SIGKILL), (b"block", signal.SIGKILL), (b"stay", signal.SIGTERM),
                         (b"stay", signal.SIGKILL)):
            with self.subTest(told=told, by=by):
                closed = self.folder / "closed"
                closed.unlink(missing_ok=True)
                cfg = 'driver ( name "bad" plugin "bad" provides ["opaque:0"] isolated 1 filename "closed" )'
                with self.serve(cfg) as house, Client(house.port()) as client:
                    client.open(OPAQUE, 0)
                    process = os.pidfd_open(int(self.ask(client, "process")))
                    self.addCleanup(os.close, process)
                    signal.pidfd_send_signal(process, signal.SIGTERM)  # as to all processes of a service
                    if told:
                        client.send(OPAQUE, 0, CMD, 1, payload(told))
                        house.wait_for_line(f'driver "bad": will {told.decode()}')
                    house.end(by)
                    wait_for_any([process], "the end of its process")
                if told != b"block":
                    self.assertEqual(closed.read_text(), "closed", "what moves stops")

    @staticmethod
    def access(opened) -> int:
        """Of the answer to an opening."""
        return struct.unpack(">I", opened.body[16:20])[0]

    def test_one_that_fails_to_open_is_tried_again_by_the_next_client(self):
        for isolated in (0, 1):
            with self.subTest(isolated=isolated):
                needed = self.folder / f"needed{isolated}"
                cfg = f'driver ( name "bad" plugin "bad" provides ["opaque:0"] needs "{needed}" isolated {isolated} )'
                with self.serve(cfg) as house, Client(house.port()) as client:
                    for _ in range(2):
                        opened = client.open(OPAQUE, 0)
                        self.assertEqual((opened.type, self.access(opened)), (ACK, 3))
                    needed.touch()
                    self.assertEqual(self.access(client.open(OPAQUE, 0)), 1)
                    self.assertTrue(self.ask(client, "process"))
                    house.wait_for_line(f"opaque:0: the device cannot start: there is no {needed}")
                    house.end()
                    self.assertEqual(house.log().count(f"there is no {needed}"), 1, "one line for a client")

    def test_one_asks_what_it_requires_with_a_body(self):
        other = 'driver ( name "other" plugin "bad" provides ["opaque:1"] isolated 1 )\n'
        for isolated in (0, 1):
            cfg = f'driver ( name "bad" plugin "bad" provides ["opaque:0"] requires ["opaque:1"] isolated {isolated} )'
            with self.subTest(isolated=isolated), self.serve(other + cfg) as house, Client(house.port()) as client:
                for index in (0, 1):
                    client.open(OPAQUE, index)
                its = client.request(OPAQUE, 1, 1, payload(b"process"))
                self.assertEqual(client.request(OPAQUE, 0, 1, payload(b"other process")).body, its.body)
                for _ in range(2):
                    self.assertEqual(client.request(OPAQUE, 0, 1, payload(b"other nobody")).type, NACK)
                house.wait_for_line("a request gets NACK: there is no device 99 in a list of 1$")
                house.end()
                self.assertEqual(house.log().count("a request gets NACK"), 1)

    def test_one_with_alwayson_that_fails_to_open_is_tried_until_it_does(self):
        needed = self.folder / "needed"
        cfg = f'driver ( name "bad" plugin "bad" provides ["opaque:0"] needs "{needed}" alwayson 1 )'
        with self.serve(cfg) as house:
            house.wait_for_line(f'driver "bad" waits: there is no {needed}$')
            needed.touch()
            house.wait_for_line('driver "bad" has started$')

    def test_a_library_is_found_by_a_path_from_the_folder_of_the_file(self):
        beside, elsewhere = self.folder / "robot" / "build", self.folder / "other"
        for folder in (beside, elsewhere):
            folder.mkdir(parents=True)
            shutil.copy(self.libraries / "load.so", folder / "mine.so")
        def cfg(named):
            return self.write("robot/x.cfg", f'driver ( name "mine" plugin "{named}" provides ["aio:0"] )')
        def serves(named, *options):
            with House("serve", cfg(named), "--port", 0, "--headless", *options) as house:
                house.port()
        for named in ("build/mine", "./build/mine.so", "../robot/build/mine.so"):
            with self.subTest(named):
                serves(named)
        for named in ("../other/mine.so", "../other/mine"):
            with self.subTest(named):
                done = finish("serve", cfg(named), "--port", 0)
                self.assertEqual(done.returncode, 2)
                self.assertIn("x.cfg:1: ", done.stderr)
                self.assertIn(f"if you trust it, run with --allow-library {elsewhere.resolve()}/mine.so", done.stderr)
                serves(named, "--allow-library", elsewhere / "mine.so")
                with mock.patch.dict(os.environ, PLAYERPATH=str(elsewhere)):
                    serves(named)

    def test_libraries_may_be_named_outside_all_sections(self):
        for cfg in ('plugin "load"\ndriver ( name "load" provides ["aio:0"] )',
                    'plugin "load.so"\nplugin "lamp"\ndriver ( name "load" provides ["aio:0"] interval 2 )',
                    'plugin "load"\ndriver ( name "of_the_machine" provides ["aio:0"] )'):
            with self.subTest(cfg), self.serve(cfg) as house, Client(house.port()) as client:
                self.assertEqual(client.devices(), [(AIO, 0)])
        done = finish("serve", self.write("two.cfg", 'plugin "load"\nplugin "lamp"\ndriver ( name "x" provides ["aio:0"] )'))
        self.assertEqual(done.returncode, 2)
        self.assertIn('and no plug-in of this file has its name: "load", "lamp"', done.stderr)

    def test_a_check_does_not_know_what_a_plug_in_reads(self):
        for field in ("", "alwayson 1"):
            cfg = self.write("x.cfg", f'driver ( name "load" plugin "load" provides ["aio:0"] interval 2 {field} )')
            done = finish("check", cfg)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertNotIn("is not used", done.stdout)
            self.assertNotIn("waits", done.stdout + done.stderr)
        done = finish("check", self.write("x.cfg", 'driver ( name "relay" provides ["opaque:0"] interval 2 )'))
        self.assertIn('"interval" is not used by driver "relay"', done.stdout)

    def test_a_library_is_found_beside_the_file_that_names_it(self):
        shutil.copy(self.libraries / "load.so", self.folder / "beside.so")
        cfg = self.write("plugin.cfg", 'driver ( name "beside" plugin "beside" provides ["aio:0"] )')
        with contextlib.chdir(self.folder):
            for named in (cfg, cfg.name, f"./{cfg.name}"):
                with self.subTest(named=named), House("serve", named, "--port", 0, "--headless") as house:
                    house.port()

    def test_what_is_wrong_is_told_with_its_line(self):
        for cfg, told in (
                ('driver ( name "lamp" plugin "lamp" provides ["blinkenlight:0"] )', 'driver "lamp": needs a filename'),
                ('driver ( name "load" plugin "lode" provides ["aio:0"] )', 'no driver "lode" (did you mean "load"?)'),
                ('driver ( name "load" plugin "load" provides ["aio:0"] interval "x" )', '"interval"'),
                ('driver ( name "load" plugin "load" provides ["aio:0"] intervall 2 )', None)):
            done = finish("check", self.write("bad.cfg", "\n" + cfg))
            if told in ('"interval"', 'driver "lamp": needs a filename'):  # code alone knows: check loads none
                self.assertEqual(done.returncode, 0, done.stderr)
                for isolated in (cfg, cfg.replace(" )", " isolated 1 )")):
                    done = finish("serve", self.write("bad.cfg", "\n" + isolated), "--port", 0)
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertRegex(done.stderr, "bad.cfg:2: .*" + told)
            elif told:
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(told, done.stdout)
            else:
                self.assertIn("load.so, which is there and not checked", done.stdout)

    def test_the_walk_of_the_documentation_leads_to_what_it_says(self):
        walk = self.build_walk("plugins.md", {"knob.cc", "CMakeLists.txt", "knob.cfg", "turn.py", "tank.cc"})
        clients = re.search(r"^PYTHONPATH=\$HOME/playhouse/(\S+) python3 turn.py$", walk, re.MULTILINE).group(1)
        environment = os.environ | {"PYTHONPATH": str(self.place / "prefix" / clients)}
        with mock.patch.dict(os.environ, PLAYHOUSE_PATH=str(self.folder / "build")):
            with House("serve", self.folder / "knob.cfg", "--port", 0, "--headless") as house:
                said = tool(sys.executable, self.folder / "turn.py", f"127.0.0.1:{house.port()}", env=environment)
        self.assertIn(f"It prints `{said.strip()}`.", walk)

    def test_the_driver_that_the_documentation_carries_over_works(self):
        code = re.search(r"`tank\.cc`:\n\n```cpp\n(.*?)```", (ROOT / "docs" / "plugins.md").read_text(), re.DOTALL).group(1)
        self.write("tank.cc", code)
        self.write("CMakeLists.txt", PROJECT.replace("bad", "tank"))
        self.build(self.folder, self.folder / "build")
        terminal, line = os.openpty()
        tty.setraw(line)
        for each in (terminal, line):
            self.addCleanup(os.close, each)
        cfg = f'driver ( name "tank" plugin "build/tank" provides ["aio:0"] port "{os.ttyname(line)}" )'
        with self.serve(cfg) as house, Client(house.port()) as client:
            self.assertEqual(self.access(client.open(AIO, 0)), 1)
            client.send(AIO, 0, CMD, 1, struct.pack(">If", 0, 7))
            self.assertEqual(os.read(terminal, 1), bytes([7]))
            os.write(terminal, bytes([42]))
            self.assertEqual(struct.unpack(">IIf", client.next_data(AIO, 0).body), (1, 1, 42))

    def test_a_robot_of_ones_own_and_its_twin_are_driven_by_one_program(self):
        files = {"firmware.py", "tinybot.cc", "CMakeLists.txt", "tinybot.cfg", "square.py", "twin.world"}
        walk = self.build_walk("tutorial-robot.md", files)
        clients = re.search(r"^PYTHONPATH=\$HOME/playhouse/(\S+) python3 square.py$", walk, re.MULTILINE).group(1)
        environment = os.environ | {"PYTHONPATH": str(self.place / "prefix" / clients)}

        def drive(house) -> str:
            return tool(sys.executable, self.folder / "square.py", f"127.0.0.1:{house.port()}", env=environment).strip()

        port = self.folder / "tinybot"
        cfg = self.write("tinybot.cfg", (self.folder / "tinybot.cfg").read_text().replace("/tmp/tinybot", str(port)))
        firmware = subprocess.Popen([sys.executable, self.folder / "firmware.py", port])
        self.addCleanup(firmware.wait)
        self.addCleanup(firmware.kill)
        wait_until(port.is_symlink, "its port")
        with House("serve", cfg, "--port", 0, "--headless") as house:
            said = drive(house)
            self.assertIn(f"It prints `{said}`.", walk)
            with Client(house.port()) as client:
                client.open(POSITION2D, 0)
                firmware.kill()
                house.wait_for_line("the line is lost")
        with House("run", self.folder / "twin.world", "--port", 0, "--headless") as house:
            self.assertEqual(drive(house), said)


if __name__ == "__main__":
    unittest.main()
