"""Servers are found on the network by DNS-SD: by Avahi's own programs and by this one, on a network of the tests' own, with a
system bus and an Avahi daemon that they start. They run in name spaces of their own, of a user or of root, and are
skipped, with a line, where none can be made."""

import fcntl
import json
import os
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

from house import ACK, LASER, PROGRAM, Client, House, HouseTest

INSIDE = "PLAYHOUSE_TEST_NETWORK"
NO_SPACES = "none"  # value of INSIDE
TYPE = "_player2._tcp"
WIDE = ("--bind", "0.0.0.0", "--insecure", "--headless")

BUS = """<!DOCTYPE busconfig PUBLIC "-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN"
 "http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd">
<busconfig>
  <type>system</type>
  <listen>unix:path={folder}/bus</listen>
  <auth>EXTERNAL</auth>
  <policy context="default">
    <allow user="*"/> <allow own="*"/> <allow send_destination="*"/> <allow receive_sender="*"/>
  </policy>
</busconfig>
"""

DAEMON = """[server]
host-name=lab
allow-interfaces=lo
use-ipv6=no
[publish]
publish-workstation=no
"""


class Told:
    """A program that tells when it is ready, in a line; its other lines are read and dropped."""

    def __init__(self, *command, ready: str):
        self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True)
        said = []
        for line in self.process.stdout:
            said.append(line)
            if ready in line:
                break
        else:
            raise AssertionError(f"{command[0]} ended: {''.join(said)}")
        threading.Thread(target=self.process.stdout.read, daemon=True).start()

    def end(self):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()


class Network:
    """The bus and the daemon of all tests."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        bus, self.conf = Path(self.folder.name) / "bus.conf", Path(self.folder.name) / "avahi.conf"
        bus.write_text(BUS.format(folder=self.folder.name))
        self.conf.write_text(DAEMON)
        self.address = f"unix:path={self.folder.name}/bus"
        self.bus = Told("dbus-daemon", f"--config-file={bus}", "--nofork", "--nopidfile", "--print-address", ready="unix:")
        os.environ["DBUS_SYSTEM_BUS_ADDRESS"] = self.address

    def begin(self):
        self.daemon = Told("/usr/sbin/avahi-daemon", "-f", str(self.conf), "--no-drop-root", "--no-chroot", "--no-rlimits",
                           "--no-proc-title", ready="Server startup complete")

    def end(self):
        self.bus.end()
        self.folder.cleanup()


def setUpModule():
    global network
    network = Network() if os.environ[INSIDE] != NO_SPACES else None


def tearDownModule():
    if network is not None:
        network.end()


def unescaped(name: str) -> str:
    """Of a name as avahi-browse prints it: \\032 for a space."""
    parts = name.split("\\")
    return parts[0] + "".join(chr(int(part[:3])) + part[3:] for part in parts[1:])


def browse() -> dict[str, tuple[str, int, set[str]]]:
    """Address, port and texts of each service, as Avahi's own browser reads them."""
    out = subprocess.run(["avahi-browse", "--resolve", "--parsable", "--terminate", TYPE], capture_output=True, text=True,
                         check=True).stdout
    found = {}
    for line in out.splitlines():
        fields = line.split(";", 9)
        if fields[0] == "=":
            found[unescaped(fields[3])] = fields[7], int(fields[8]), set(fields[9].strip('"').split('" "'))
    return found


def playhouse(*arguments, env=None) -> subprocess.CompletedProcess:
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, env=env)


def why_nobody_answers(*arguments, env=None) -> str:
    asked = playhouse(*arguments, env=env)
    assert asked.returncode == 1, asked
    assert asked.stderr.count("\n") == 1, asked.stderr
    return asked.stderr


class NoDaemon(HouseTest):
    def test_without_a_system_bus_a_line_says_so_and_the_server_serves(self):
        env = {**os.environ, "DBUS_SYSTEM_BUS_ADDRESS": "unix:path=/nowhere"}
        with House("run", self.world(), "--port", 0, *WIDE, env=env) as house:
            house.wait_for_line("not announced on the network: there is no Avahi daemon")
            with Client(int(house.wait_for_line(r"^Player clients: [\d.]+:(\d+)$").group(1))) as client:
                self.assertEqual(client.open(LASER, 0).type, ACK)

    def test_who_names_a_robot_is_told_that_there_is_no_daemon(self):
        if os.environ[INSIDE] == NO_SPACES:
            self.skipTest("this machine makes no name spaces, and whoever has the default port on it would answer")
        env = {**os.environ, "DBUS_SYSTEM_BUS_ADDRESS": "unix:path=/nowhere"}
        for words in (["drive", "pioneer"], ["watch", "pioneer"], ["devices"]):
            self.assertRegex(why_nobody_answers(*words, env=env), "127.0.0.1:6665: cannot connect: Connection refused; no server .*; "
                             "cannot look for servers on the network, as there is no Avahi daemon")


class Discovery(HouseTest):
    def setUp(self):
        super().setUp()
        if os.environ[INSIDE] == NO_SPACES:
            self.skipTest("this machine makes no name spaces, and its own network is not for tests: unshare --net --mount")
        network.begin()
        self.addCleanup(lambda: network.daemon.end())  # with all that it remembers

    def announced(self, house: House, seen=0) -> str:
        return house.wait_for_line('announced on the network as "(.*)"', seen).group(1)

    def test_a_server_tells_its_port_its_robots_and_what_a_client_needs(self):
        guests = self.write("guests.txt", "admin abcdefgh-1 Ada\n")
        with House("run", self.world(), "--port", 0, *WIDE) as house, \
                House("run", self.world(), "--port", 0, "--bind", "0.0.0.0", "--guests", guests, "--headless") as guarded:
            name, other = self.announced(house), self.announced(guarded)
            self.assertEqual(name, f"lab {house.port()}")
            found = browse()
            address, port, texts = found[name]
            self.assertEqual((address, port), ("127.0.0.1", house.port()))
            self.assertLessEqual({"txtvers=1", "robots=2", "robot0=r0", "robot1=r1"}, texts)
            self.assertFalse({"guests=1", "tls=1"} & texts)
            self.assertIn("guests=1", found[other][2])

    def test_devices_lists_servers_as_lines_and_as_json(self):
        with House("run", self.world(), "--port", 0, *WIDE) as house:
            name = self.announced(house)
            listed = playhouse("devices", "--network")
            self.assertEqual(listed.returncode, 0, listed.stderr)
            self.assertRegex(listed.stdout, rf"127\.0\.0\.1:{house.port()} +{name} +r0, r1\n")
            line = json.loads(playhouse("devices", "--network", "--json").stdout)
            self.assertEqual(line, {"server": name, "host": "127.0.0.1", "port": house.port(), "tls": False, "guests": False,
                                    "robots": ["r0", "r1"]})

    def test_without_a_server_on_this_machine_devices_lists_those_of_the_network(self):
        with House("run", self.world(), "--port", 0, *WIDE) as house:
            name = self.announced(house)
            listed = playhouse("devices")
            self.assertEqual(listed.returncode, 0, listed.stderr)
            self.assertIn(name, listed.stdout)
            with House("run", self.world(), "--headless") as here:  # on the default port
                here.port()
                self.assertIn("position2d:0", playhouse("devices").stdout)

    def test_a_robot_is_reached_by_its_name_and_a_server_by_its_own(self):
        with House("run", self.world(), "--port", 0, *WIDE) as house:
            name = self.announced(house)
            for words in (["r0"], [name, "r0"], ["r0", "laser:0"]):
                watched = playhouse("watch", *words, "--count", 1)
                self.assertEqual(watched.returncode, 0, watched.stderr)
                self.assertIn('"time":', watched.stdout)
            self.assertIn("laser:0", playhouse("devices", name).stdout)

    def test_a_robot_that_nobody_announces_is_told_so(self):
        self.assertIn('Connection refused; no server announces a robot "pioneer"', why_nobody_answers("drive", "pioneer"))
        self.assertIn('no server announces a robot "pioneer"', why_nobody_answers("watch", "pioneer"))
        self.assertIn('no server or robot "the pioneer" is announced', why_nobody_answers("watch", "the pioneer", "laser:0"))
        self.assertIn("no server is announced on the network", why_nobody_answers("devices"))

    def test_a_robot_that_two_servers_announce_is_asked_about(self):
        with House("run", self.world(), "--port", 0, *WIDE) as one, House("run", self.world(), "--port", 0, *WIDE) as other:
            self.announced(one), self.announced(other)
            asked = playhouse("watch", "r0", "--count", 1)
            self.assertNotEqual(asked.returncode, 0)
            for house in (one, other):
                self.assertIn(f"127.0.0.1:{house.port()}", asked.stderr)

    def test_a_server_for_this_machine_alone_is_not_announced(self):
        with House("run", self.world(), "--port", 0, "--headless") as alone, House("run", self.world(), "--port", 0, *WIDE) as house:
            alone.port()
            self.announced(house)
            self.assertEqual(list(browse()), [f"lab {house.port()}"])

    def test_a_name_that_somebody_has_gets_a_number(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        with Told("avahi-publish", "-s", f"lab {port}", TYPE, "1", ready="Established"), \
                House("run", self.world(), "--port", port, *WIDE) as house:
            self.assertEqual(self.announced(house), f"lab {port} #2")

    def test_it_is_announced_again_when_the_daemon_comes_back(self):
        with House("run", self.world(), "--port", 0, *WIDE) as house:
            name, seen = self.announced(house), len(house.lines)
            network.daemon.end()
            try:
                house.wait_for_line("not announced on the network: there is no Avahi daemon", seen)
                with Client(house.port()) as client:
                    self.assertEqual(client.open(LASER, 0).type, ACK)
                self.assertIn("cannot look for servers", playhouse("devices", "--network").stderr)
            finally:
                network.begin()
            self.assertEqual(self.announced(house, seen), name)
            self.assertIn(name, browse())

    def test_what_others_announce_is_shown_without_its_control_characters(self):
        with Told("avahi-publish", "-s", "evil\x1b[2J", TYPE, "1", "robot0=\x1b]0;x\x07\nr9", ready="Established"):
            listed = playhouse("devices", "--network").stdout
            self.assertIn(r"evil\x1b[2J", listed)
            self.assertIn(r"\x1b]0;x\x07\x0ar9", listed)
            self.assertNotIn("\x1b", listed)
            self.assertEqual(len(listed.splitlines()), 1)


def up(interface: bytes):
    """Brings an interface up, as `ip link set` does where there is one."""
    siocsifflags, iff_up_running = 0x8914, 0x41
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, siocsifflags, struct.pack("16sH14x", interface, iff_up_running))


def enter():
    """Starts this program again in name spaces of its own, if they can be made."""
    root = os.geteuid() == 0
    spaces = ["unshare", "--net", "--mount"] if root else ["unshare", "--user", "--map-root-user", "--net", "--mount"]
    can = subprocess.run([*spaces, "true"], capture_output=True, text=True)
    if can.returncode == 0:
        os.execvpe("unshare", [*spaces, sys.executable, *sys.argv], {**os.environ, INSIDE: "own"})
    os.environ[INSIDE] = NO_SPACES


if __name__ == "__main__":
    if INSIDE not in os.environ:
        enter()
    if os.environ[INSIDE] == "own":
        up(b"lo")
        subprocess.run(["mount", "-t", "tmpfs", "tmpfs", "/run"], check=True)  # of the daemon
    unittest.main()
