"""Drivers of hardware on real lines: a simulated robot that `playhouse emulate` shows as hardware, on a pseudo-terminal and by TCP,
drives for whoever speaks the protocol: for the driver of a second server, and for a host whose bytes are written here by hand."""

import math
import os
import select
import socket
import struct
import subprocess
import sys
import tty
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "clients/python"))
from house import House, HouseTest, PROGRAM, free_ports, wait_until  # noqa: E402
from playhouse_client import connect  # noqa: E402

WORLD = """
interval_sim 100
define pioneer position( size [0.5 0.4 0.2]
  ranger( sensor( range [0 5] fov 15 pose [0.1 0.1 0 90] ) sensor( range [0 5] fov 15 pose [0.2 0 0 0] ) ) )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] color "gray" )
pioneer( name "r0" pose [0 0 0 0] localization "odom" odom_error [0 0 0 0] joules 1000 )
"""


class Emulated:
    """`playhouse emulate`, once it has said where the hardware is."""

    def __init__(self, *words):
        self.program = subprocess.Popen([PROGRAM, "emulate", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.line = self.program.stdout.readline().rstrip("\n")

    def end(self) -> int:
        self.program.terminate()
        self.program.communicate()
        return self.program.returncode


class Host:
    """A Pioneer's host: the frames that it writes and reads, by the maker's rules."""

    def __init__(self, descriptor: int):
        self.descriptor, self.bytes = descriptor, b""

    @staticmethod
    def checksum(data: bytes) -> int:
        total = sum(data[at] << 8 | data[at + 1] for at in range(0, len(data) - 1, 2))
        return (total & 0xFFFF) ^ (data[-1] if len(data) % 2 else 0)

    def say(self, *data: int):
        body = bytes(data)
        os.write(self.descriptor, b"\xfa\xfb" + bytes([len(body) + 2]) + body + struct.pack(">H", self.checksum(body)))

    def hear(self) -> bytes:
        """The data of the next frame."""
        while True:
            begin = self.bytes.find(b"\xfa\xfb")
            if begin >= 0 and len(self.bytes) > begin + 2 and len(self.bytes) >= begin + 3 + self.bytes[begin + 2]:
                end = begin + 3 + self.bytes[begin + 2]
                data, check = self.bytes[begin + 3:end - 2], self.bytes[end - 2:end]
                self.bytes = self.bytes[end:]
                assert struct.pack(">H", self.checksum(data)) == check
                return data
            if not select.select([self.descriptor], [], [], 20)[0]:
                raise AssertionError("the robot says nothing")
            self.bytes += os.read(self.descriptor, 4096)

    def open(self) -> list[bytes]:
        self.say(0)
        assert self.hear() == b"\x00"
        self.say(1)
        assert self.hear() == b"\x01"
        self.say(2)
        names = self.hear()
        self.say(1)
        return names[1:].split(b"\x00")[:3]

    def drive(self, right: int, left: int):
        self.say(32, 0x3B, right & 0xFF, left & 0xFF)

    def packet(self) -> tuple[int, int, int]:
        """x, y and heading of the next one, in the robot's units."""
        while True:
            data = self.hear()
            if data[0] in (0x32, 0x33):
                return struct.unpack_from("<HHh", data, 1)


LASER_WORLD = """
interval_sim 100
define scanner position( size [0.5 0.4 0.2] ranger( sensor( range [0 7] fov 180 samples 181 ) ) )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] color "gray" )
scanner( name "r0" pose [0 0 0 0] joules 1000 )
"""


class Scanners(HouseTest):
    def emulate(self, name: str, *words) -> House:
        house = self.enterContext(self.run_house(world=self.world(LASER_WORLD)))
        self.addCleanup(Emulated(name, "--server", f":{house.port()}", "--robot", "r0", *words).end)
        return house

    def expect_wall(self, name: str, port):
        """Straight ahead, 2.9 m away."""
        metal = self.enterContext(House("serve", self.write(
            "metal.cfg", f'driver( name "{name}" port "{port}" provides ["laser:0"] )'), "--port", 0, "--headless"))
        with connect(f":{metal.port()}", timeout=20) as client:
            laser = client.laser()
            laser.next_data()
            wait_until(lambda: client.read() and abs(laser.ranges[len(laser.ranges) // 2] - 2.9) < 0.02, "the wall is seen")

    def test_a_second_server_sees_by_a_serial_line_what_a_simulated_laser_sees(self):
        for name in ("sicklms200", "urglaser", "rplidar"):
            with self.subTest(name):
                line = self.folder / name
                self.emulate(name, "--port", line)
                self.expect_wall(name, line)

    def test_by_tcp_as_well(self):
        (port,) = free_ports()
        self.emulate("urglaser", "--tcp-port", port, "--option", "model=UST-10LX")
        with socket.create_connection(("127.0.0.1", port), timeout=20) as line:
            line.sendall(b"PP\n")
            self.assertIn(b"MODL:UST-10LX(Hokuyo Automatic Co.,Ltd.)", line.recv(4096))
        self.expect_wall("urglaser", f"tcp:127.0.0.1:{port}")


class Hardware(HouseTest):
    def robot(self) -> House:
        return self.enterContext(self.run_house(world=self.world(WORLD)))

    def emulate(self, house: House, *words) -> Emulated:
        emulated = Emulated("p2os", "--server", f":{house.port()}", "--robot", "r0", *words)
        self.addCleanup(emulated.end)
        return emulated

    def test_a_second_server_drives_a_simulated_robot_by_its_serial_line(self):
        house = self.robot()
        line = self.folder / "pioneer"
        emulated = self.emulate(house, "--port", line)
        self.assertEqual(emulated.line, f'p2os at {line}: position2d:0, sonar:0, power:0 of "r0" at 127.0.0.1:{house.port()}')
        metal = self.enterContext(House("serve", self.write(
            "metal.cfg", f'driver( name "p2os" port "{line}" provides ["position2d:0" "sonar:0" "power:0"] )'), "--port", 0, "--headless"))
        with connect(f":{metal.port()}", timeout=20) as client, connect(f":{house.port()}") as world:
            wheels, sonar, truth = client.position2d(), client.sonar(), world.simulation()
            wheels.next_data()
            wheels.drive(0.4, 0.2)
            wait_until(lambda: client.read() and truth.pose("r0").x > 0.5, "the robot drives")
            wheels.drive(0)
            wait_until(lambda: client.read() and wheels.velocity.x == 0 and wheels.velocity.a == 0, "it stops")
            client.read()
            there = truth.pose("r0")
            self.assertAlmostEqual(wheels.pose.x, there.x, delta=0.005)
            self.assertAlmostEqual(wheels.pose.y, there.y, delta=0.005)
            self.assertAlmostEqual(wheels.pose.a, there.a, delta=0.01)
            ahead = (2.9 - there.x - 0.2 * math.cos(there.a)) / math.cos(there.a)
            wait_until(lambda: client.read() and abs(sonar.ranges[1] - ahead) < 0.02, "the sonar measures")
            self.assertGreater(client.power().next_data() or 1, 0)
        self.assertEqual(emulated.end(), 143)
        self.assertFalse(line.is_symlink())

    def test_a_host_of_others_drives_it_and_it_stops_when_the_host_is_silent(self):
        house = self.robot()
        line = self.folder / "pioneer"
        self.emulate(house, "--port", line, "--option", "watchdog=1")
        descriptor = os.open(line, os.O_RDWR | os.O_NOCTTY)
        self.addCleanup(os.close, descriptor)
        tty.setraw(descriptor)
        host = Host(descriptor)
        self.assertEqual(host.open(), [b"Playhouse", b"Pioneer", b"p3dx-sh"])
        self.assertEqual(host.packet(), (0, 0, 0))
        host.say(4, 0x3B, 1, 0)  # motors on
        host.drive(10, 10)  # 200 mm/s
        with connect(f":{house.port()}") as world:
            truth = world.simulation()
            wait_until(lambda: host.say(0) or truth.pose("r0").x > 0.1, "the robot drives")
            x, y, heading = host.packet()
            self.assertEqual((y, heading), (0, 0))
            self.assertAlmostEqual(x / 1000, truth.pose("r0").x, delta=0.15)
            before = None

            def stands() -> bool:
                nonlocal before
                host.packet()
                now = truth.pose("r0").x
                was, before = before, now
                return was == now

            wait_until(stands, "it stops")

    def test_by_tcp_as_well(self):
        house = self.robot()
        (port,) = free_ports()
        self.emulate(house, "--tcp-port", port, "--option", "robot=p3at-sh")
        with socket.create_connection(("127.0.0.1", port)) as line:
            self.assertEqual(Host(line.fileno()).open()[2], b"p3at-sh")
        metal = self.enterContext(House("serve", self.write(
            "metal.cfg", f'driver( name "p2os" port "tcp:127.0.0.1:{port}" provides ["position2d:0"] )'), "--port", 0, "--headless"))
        with connect(f":{metal.port()}", timeout=20) as client:
            client.position2d().next_data()
        metal.wait_for_line("a Pioneer of type p3at-sh, answers at 127.0.0.1")

    def test_what_is_wrong_is_one_line(self):
        def line_of(*words) -> str:
            done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertNotEqual(done.returncode, 0)
            return done.stderr

        house = self.robot()
        at = ("--server", f":{house.port()}", "--port", self.folder / "line")
        self.assertIn('"p3os": is nothing that can be emulated: ', line_of("emulate", "p3os", *at))
        self.assertIn('there is no robot "r1"', line_of("emulate", "p2os", *at, "--robot", "r1"))
        self.assertIn("--port or --tcp-port", line_of("emulate", "p2os"))
        self.assertIn("robot is a subclass such as p3dx-sh", line_of("emulate", "p2os", *at, "--option", "robot=p9"))
        self.write("file", "")
        self.assertIn("cannot be made: File exists", line_of("emulate", "p2os", *at[:2], "--port", self.folder / "file"))
        serve = self.write("none.cfg", 'driver( name "p2os" port "/dev/none" provides ["position2d:0"] alwayson 1 )')
        self.assertIn("/dev/none: cannot be opened: No such file or directory", line_of("serve", serve, "--port", 0, "--headless"))


if __name__ == "__main__":
    unittest.main()
