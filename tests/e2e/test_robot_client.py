"""Robots that clients bring into a running world, and that they serve on their own ports."""

import json
import signal
import socket
import struct
import sys
import threading
import unittest

from house import (ACK, DATA, LASER, NACK, PLAYER, POSITION2D, REFERENCE, REQ, ROOT, SIMULATION, Client, House,
                   HouseTest, Message, finish, frame, ranges_of, text)

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import connect  # noqa: E402

LAB = """
interval_sim 100
robot_types [ "cart" "scanner" ]
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
define cart position( size [0.4 0.4 0.2] )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] color "gray" )
position( name "own" pose [0 -3 0 0] size [0.4 0.4 0.2] )
"""
BOB = 'type = "cart"\nname = "bob"\npose = [0, 0, 0]\nsensors = ["scanner"]\n'
TWO = """[[robot]]
type = "cart"
name = "ann"
pose = [0, 1, 0]
sensors = [{type = "scanner", pose = [0, 0, 180]}]

[[robot]]
type = "cart"
name = "eve"
pose = [0, 2, 90]
devices = {position2d = 4}
"""


class RobotClient(HouseTest):
    def lab(self, *arguments) -> House:
        house = House("run", self.world(LAB), "--port", 0, "--headless", *arguments)
        self.addCleanup(house.__exit__)
        return house

    def robot(self, lab: House, content: str = BOB) -> House:
        house = House("robot", self.write("robot.toml", content), "--server", f"127.0.0.1:{lab.port()}", "--port", 0)
        self.addCleanup(house.__exit__)
        return house

    def place(self, robot: House, name: str) -> tuple[int, str]:
        """Its port and devices, once it has joined."""
        found = robot.wait_for_line(rf"^Player clients: 127\.0\.0\.1:(\d+) \({name}: (.*)\)$")
        return int(found.group(1)), found.group(2)

    def client(self, port: int) -> Client:
        client = Client(port)
        self.addCleanup(client.close)
        return client

    def has(self, client: Client, name: str) -> bool:
        return client.request(SIMULATION, 0, 1, text(name) + struct.pack(">ddd", 0, 0, 0)).type == ACK

    def wait_until_gone(self, client: Client, name: str):
        while self.has(client, name):
            pass

    def test_a_robot_joins_is_driven_on_its_own_port_and_leaves_by_ctrl_c(self):
        for engine in ("stage", "arena"):
            with self.subTest(engine=engine):
                lab = self.lab("--engine", engine)
                robot = self.robot(lab)
                port, devices = self.place(robot, "bob")
                self.assertEqual(devices, "position2d:0 position3d:0 speech:0 speech_recognition:0 ranger:0 laser:0")
                client = self.client(port)
                self.assertEqual(sorted(client.devices()), [(4, 0), (6, 0), (12, 0), (30, 0), (50, 0), (62, 0)])
                self.assertEqual(client.open(POSITION2D, 0).type, ACK)
                self.assertEqual(client.open(LASER, 0).type, ACK)
                self.assertAlmostEqual(ranges_of(client.next_data(LASER, 0))[90], 2.9, delta=0.1)
                client.drive(0, 0.5)
                while struct.unpack(">d", client.next_data(POSITION2D, 0).body[:8])[0] < 0.5:
                    pass
                admin = self.client(lab.port())
                self.assertGreater(admin.pose("bob")[0], 0.4)
                self.assertEqual(robot.end(signal.SIGINT), 128 + signal.SIGINT, robot.log())
                self.wait_until_gone(admin, "bob")
                self.assertFalse(self.has(admin, "bob-scanner"))

    def test_the_examples_of_its_help_bring_a_robot(self):
        lines = [line.strip() for line in finish("robot", "--help").stdout.splitlines()]
        examples = [line for line in lines[lines.index("Examples:"):] if line.startswith("playhouse ")]
        self.assertEqual(len(examples), 2)
        lab = House("run", ROOT / "worlds/lab.world", "--port", 0, "--headless")
        self.addCleanup(lab.__exit__)
        for line in examples:
            words = line.replace("--port 7000", "").split()[1:]
            here = {"examples/robot.toml": ROOT / "examples/robot.toml", "0.0.0.0": "127.0.0.1"}
            words = [f"127.0.0.1:{lab.port()}" if word.startswith("127.0.0.1") else here.get(word, word) for word in words]
            robot = House(*words, "--port", 0)
            self.addCleanup(robot.__exit__)
            self.assertIn("laser:0", self.place(robot, "bob")[1])
            robot.end()
            self.wait_until_gone(self.client(lab.port()), "bob")

    def test_a_client_of_python_drives_it(self):
        lab = self.lab()
        port, _ = self.place(self.robot(lab), "bob")
        with connect(f"127.0.0.1:{port}") as client, client.position2d(0) as base, client.laser(0) as laser:
            base.drive(0.4)
            for state in base.updates():
                if state.pose.x > 0.3:
                    break
            base.stop()
            self.assertEqual(len(laser.scan().ranges), 181)

    def test_a_killed_client_takes_its_robots_along(self):
        lab = self.lab()
        robot = self.robot(lab, TWO)
        self.place(robot, "ann"), self.place(robot, "eve")
        admin = self.client(lab.port())
        self.assertTrue(self.has(admin, "ann") and self.has(admin, "eve"))
        robot.end(signal.SIGKILL)
        for name in ("ann", "eve", "ann-scanner"):
            self.wait_until_gone(admin, name)
        self.assertTrue(self.has(admin, "own"))

    def test_one_client_serves_several_robots_each_on_its_port(self):
        lab = self.lab()
        robot = self.robot(lab, TWO)
        (ann, ann_devices), (eve, eve_devices) = self.place(robot, "ann"), self.place(robot, "eve")
        self.assertNotEqual(ann, eve)
        self.assertEqual(ann_devices, "position2d:0 position3d:0 speech:0 speech_recognition:0 ranger:0 laser:0")
        self.assertEqual(eve_devices, "position2d:4 position3d:0 speech:0 speech_recognition:0")
        first, second, admin = self.client(ann), self.client(eve), self.client(lab.port())
        first.open(POSITION2D, 0), second.open(POSITION2D, 4)
        second.drive(4, 0.5)
        while admin.pose("eve")[1] < 2.5:
            second.next_data(POSITION2D, 4)
        self.assertAlmostEqual(admin.pose("ann")[0], 0)

        def remove(name):
            self.assertEqual(admin.request(SIMULATION, 0, 6, self.property(name, "remove")).type, ACK)
        remove("eve")
        robot.wait_for_line(r'"eve" was taken out of the world')
        first.next_data(POSITION2D, 0)
        remove("ann")
        self.assertEqual(robot.wait(), 1)
        self.assertIn('"ann" was taken out of the world', robot.log())
        self.wait_until_gone(admin, "ann-scanner")

    @staticmethod
    def property(name: str, what: str) -> bytes:
        return text(name) + text(what) + struct.pack(">I", 0) + struct.pack(">II", 0, 0)

    def test_a_robot_that_nobody_has_open_is_missed_too_and_its_sensors_go_with_it(self):
        lab = self.lab()
        robot = self.robot(lab)
        self.place(robot, "bob")
        admin = self.client(lab.port())
        self.assertTrue(self.has(admin, "bob-scanner"))
        self.assertEqual(admin.request(SIMULATION, 0, 6, self.property("bob", "remove")).type, ACK)
        self.wait_until_gone(admin, "bob-scanner")
        self.assertEqual(robot.wait(), 1)
        self.assertIn('"bob" was taken out of the world', robot.log())

    def test_the_end_of_the_world_ends_it(self):
        lab = self.lab()
        robot = self.robot(lab)
        self.place(robot, "bob")
        name = f"127.0.0.1:{lab.port()}"
        lab.end()
        self.assertEqual(robot.wait(), 1)
        self.assertEqual([line for line in robot.lines if "error" in line],
                         [f"{name}: error: closed the connection"])

    def test_what_cannot_be_is_one_line_and_leaves_nothing_behind(self):
        lab = self.lab()
        admin = self.client(lab.port())
        self.place(self.robot(lab), "bob")
        for content, line in (
                (BOB, ':1: error: there is a model "bob" already'),
                (BOB.replace("cart", "carrt"), 'no type of robot "carrt" (did you mean "cart"?)'),
                (BOB.replace("scanner", "scaner").replace("bob", "x"), 'no type of sensor "scaner" (did you mean "scanner"?)'),
                ('type = "cart"\npose = [0.1, 0.1, 0]\n', "the place at 0.10 0.10 is occupied"),
                ('type = "cart"\npose = [2.9, 3, 0]\n', "the place at 2.90 3.00 is occupied"),
                (TWO.replace("eve", "bob"), ':7: error: there is a model "bob" already'),
                ('type = "cart"\nposs = [0, 0, 0]\n', ':2: error: "poss" is unknown (did you mean "pose"?)')):
            robot = self.robot(lab, content.replace("[0, 0, 0]", "[0, 3, 0]") if "already" in line and "stands" not in line else content)
            self.assertEqual(robot.wait(), 2 if "unknown" in line else 1, content)
            errors = [each for each in robot.lines if "error" in each]
            self.assertEqual(len(errors), 1, robot.log())
            self.assertIn(line, errors[0])
        self.wait_until_gone(admin, "ann")
        with socket.create_server(("127.0.0.1", 0)) as server:
            host, port = server.getsockname()

            def greet() -> None:
                peer, _ = server.accept()
                with peer:
                    peer.sendall(b"Player v.3.1.0".ljust(32, b"\0"))
                    while peer.recv(4096):
                        pass

            threading.Thread(target=greet, daemon=True).start()
            mute = finish("robot", self.write("bob.toml", BOB), "--server", f"{host}:{port}", "--port", 0, "--wait", 0.3)
        self.assertEqual((mute.returncode, mute.stderr), (1, f"{host}:{port}: error: has not answered for 0.3 s\n"))
        nobody = finish("robot", self.write("bob.toml", BOB), "--server", "127.0.0.1:1", "--port", 0)
        self.assertEqual(nobody.returncode, 1)
        self.assertEqual(nobody.stderr, "127.0.0.1:1: error: cannot connect: Connection refused\n")

    def test_a_server_that_takes_robots_in_another_way_or_none_is_left_with_a_line(self):
        other = struct.pack("<I", 9)
        for answer, kind, line in ((text("") + text("robot_format") + struct.pack(">III", 0, 4, 4) + other, ACK,
                                    "robots join by format 9 there; this program brings them by format 1"),
                                   (b"", NACK, "takes no robots, or is older than Playhouse 0.2")):
            with self.subTest(line), socket.create_server(("127.0.0.1", 0)) as server:
                host, port = server.getsockname()

                def serve(answer=answer, kind=kind, server=server) -> None:
                    peer, _ = server.accept()
                    with peer, peer.makefile("rb") as asked:
                        peer.sendall(b"Player v.3.1.1 Playhouse 0.9.0".ljust(32, b"\0"))
                        while len(header := asked.read(40)) == 40:
                            message = Message(header, asked.read(struct.unpack(">I", header[36:])[0]))
                            if message.type == REQ and message.interf == SIMULATION:
                                peer.sendall(frame(*message.key()[:2], kind, message.subtype, answer, message.seq))
                            elif message.type == REQ:
                                peer.sendall(frame(*message.key()[:2], ACK, message.subtype, message.body, message.seq))

                threading.Thread(target=serve, daemon=True).start()
                ended = finish("robot", self.write("bob.toml", BOB), "--server", f"{host}:{port}", "--port", 0, "--wait", 10)
                self.assertEqual(ended.returncode, 1, ended.stderr)
                self.assertEqual(ended.stderr.splitlines()[-1], f"{host}:{port}: error: {line}")

    def test_the_recorded_run_runs_again_to_the_bit(self):
        for engine in ("stage", "arena"):
            with self.subTest(engine=engine):
                file = self.folder / f"{engine}.mcap"
                lab = self.lab("--engine", engine, "--record", file, "--json")
                robot = self.robot(lab)
                port, _ = self.place(robot, "bob")
                client = self.client(port)
                client.open(POSITION2D, 0), client.open(LASER, 0)
                client.drive(0, 0.5, 0.2)
                for _ in range(20):
                    client.next_data(LASER, 0)
                robot.end(signal.SIGKILL)
                admin = self.client(lab.port())
                self.wait_until_gone(admin, "bob")
                lab.end()
                again = finish("run", "--again", file, "--json")
                self.assertEqual(again.returncode, 0, again.stderr)
                first, second = json.loads(lab.output()), json.loads(again.stdout)
                for key in ("ticks", "hash", "sensed_hash"):
                    self.assertEqual(first[key], second[key])

    def test_a_recorded_client_of_player_is_answered_on_the_robots_port(self):
        sent = REFERENCE / "player/captures/02_raw_push_position2d.c2s"
        port, _ = self.place(self.robot(self.lab()), "bob")
        client = self.client(port)
        stream, said = sent.read_bytes(), []
        while stream:
            size = 40 + struct.unpack(">I", stream[36:40])[0]
            said.append(stream[:size])
            stream = stream[size:]

        def key(message: bytes) -> tuple:
            _, _, interf, index, kind, subtype = struct.unpack(">IIIIII", message[:24])
            return (interf, index, subtype) if kind == REQ else ()
        requests = [key(message) for message in said if key(message)]
        self.assertEqual((requests[0], key(said[-1])), ((PLAYER, 0, 3), (PLAYER, 0, 3)), "opened and closed")
        answers, data = [], 0
        client.socket.sendall(b"".join(said[:-1]))
        while len(answers) < len(requests):
            message = client.receive()
            if message.type in (ACK, NACK):
                answers.append((message.interf, message.index, message.subtype))
            data += message.type == DATA and message.interf == POSITION2D
            if len(answers) == len(requests) - 1 and data and said:
                client.socket.sendall(said[-1])
                said.clear()
        self.assertEqual(sorted(answers), sorted(requests))

    def test_a_configuration_file_relays_devices_of_another_server(self):
        lab = self.lab()
        cfg = self.write("relay.cfg", f"""driver( name "passthrough"
  provides ["position2d:3"] requires ["127.0.0.1:{lab.port()}:position2d:0"] )""")
        relay = House("serve", cfg, "--port", 0, "--headless")
        self.addCleanup(relay.__exit__)
        client = self.client(relay.port())
        self.assertEqual(client.devices(), [(POSITION2D, 3)])
        self.assertEqual(client.open(POSITION2D, 3).body[19], 1)
        client.drive(3, 0.5)
        while struct.unpack(">d", client.next_data(POSITION2D, 3).body[:8])[0] < 0.2:
            pass
        lab.end()
        relay.wait_for_line(r"trying again")
        self.assertEqual(client.devices(), [(POSITION2D, 3)])
        self.assertEqual(client.open(POSITION2D, 3).body[19], 3)
        self.assertEqual(relay.end(), 128 + signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
