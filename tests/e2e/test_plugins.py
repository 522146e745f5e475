"""Drivers from outside the tree: examples/drivers and the tutorial of docs/plugins.md are built with the installed package,
and their devices are used over a socket."""

import os
import shutil
import struct
import sys
import unittest
from unittest import mock

from house import ACK, CMD, NACK, PLAYER, POSITION2D, ROOT, Client, House, finish, ranges_of
from installed import InstalledTest, tool

AIO, BLINKENLIGHT, OPAQUE, LASER = 21, 33, 51, 6

# A driver of opaque:0 that does, once it is told to, what no driver should.
BAD = """
#include <unistd.h>

#include <stdexcept>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/opaque.h"

namespace op = playhouse::wire::opaque;

class Bad : public playhouse::drivers::Plugin {
  void configure(const playhouse::drivers::PluginSection& section) override {
    const bool blocks = section.flag("blocks", false);
    on_command<op::Data>(0, op::kCmdData, [blocks](const op::Data&) {
      if (!blocks) throw std::runtime_error("smoke");
      for (;;) pause();
    });
    on_request<op::Data>(0, op::kReqData, [](const op::Data& asked, playhouse::drivers::PluginReply reply) {
      reply.ack(asked);
    });
  }
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
driver ( name "guard" plugin "guard" provides ["position2d:1"] requires ["position2d:0" "laser:0"] distance 1 )
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
        cfg = self.write("room.cfg", GUARD)
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

    def test_one_that_throws_or_blocks_loses_its_devices_and_nobody_elses(self):
        for fault, told in (("", "smoke"), ("blocks 1", r"it has not come back for \d+ s")):
            with self.subTest(told):
                cfg = f'driver ( name "bad" plugin "bad" provides ["opaque:0"] {fault} )\n'
                with self.serve(cfg + 'driver ( name "relay" provides ["opaque:1"] )') as house:
                    with Client(house.port()) as client:
                        for index in (0, 1):
                            client.open(OPAQUE, index)
                        self.assertEqual(client.request(OPAQUE, 0, 1, payload(b"abc")).body, payload(b"abc"))
                        client.send(OPAQUE, 0, CMD, 1, payload(b"now"))
                        self.assertEqual(client.request(OPAQUE, 0, 1, payload(b"abc")).type, NACK, "never lost")
                        house.wait_for_line('driver "bad" has failed, and its devices retire: ' + told)
                        client.send(OPAQUE, 1, CMD, 1, payload(b"still here"))
                        self.assertEqual(client.next_data(OPAQUE, 1).body, payload(b"still here"))
                        self.assertEqual(client.devices(), [(OPAQUE, 1)])
                    self.assertEqual(house.end(), 128 + 15)

    def test_what_is_wrong_is_told_with_its_line(self):
        for cfg, told in (
                ('driver ( name "lamp" plugin "lamp" provides ["blinkenlight:0"] )', 'driver "lamp": needs a filename'),
                ('driver ( name "load" plugin "lode" provides ["aio:0"] )', 'no driver "lode" (did you mean "load"?)'),
                ('driver ( name "load" plugin "load" provides ["aio:0"] interval "x" )', '"interval"'),
                ('driver ( name "load" plugin "load" provides ["aio:0"] intervall 2 )', None)):
            done = finish("check", self.write("bad.cfg", "\n" + cfg))
            if told in ('"interval"', 'driver "lamp": needs a filename'):  # code alone knows: check loads none
                self.assertEqual(done.returncode, 0, done.stderr)
                done = finish("serve", self.folder / "bad.cfg", "--port", 0)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, "bad.cfg:2: .*" + told)
            elif told:
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(told, done.stdout)
            else:
                self.assertIn("load.so, which is there and not checked", done.stdout)

    def test_the_walk_of_the_documentation_leads_to_what_it_says(self):
        walk = self.build_walk("plugins.md", {"knob.cc", "CMakeLists.txt", "knob.cfg", "turn.py"})
        environment = os.environ | {"PYTHONPATH": str(ROOT / "clients" / "python")}
        with mock.patch.dict(os.environ, PLAYHOUSE_PATH=str(self.folder / "build")):
            with House("serve", self.folder / "knob.cfg", "--port", 0, "--headless") as house:
                said = tool(sys.executable, self.folder / "turn.py", f"127.0.0.1:{house.port()}", env=environment)
        self.assertIn(f"It prints `{said.strip()}`.", walk)


if __name__ == "__main__":
    unittest.main()
