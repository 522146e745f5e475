"""Runs shared by several processes: the same bits as alone, whoever joins, is lost, watches or drives."""

import json
import re
import signal
import socket
import struct
import sys
import unittest

from house import ACK, PATIENCE, POSITION2D, RANGER, ROOT, Client, House, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import connect  # noqa: E402

SWARM = """
interval_sim 100
define robot position( size [0.44 0.38 0.22] localization "odom"
  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 60 noise [0.01 0.01 0] ) ) ctrl "wander" )
model( name "walls" size [20 20 1] boundary 1 noblocks 1 )
""" + "\n".join(f"robot( name \"r{i}\" pose [{-8 + i % 8 * 2.1} {-8 + i // 8 * 2.1} 0 {i * 37 % 360}] )" for i in range(48))


class Cluster(HouseTest):
    def head(self, world, *arguments, nodes=0, command="run") -> House:
        return House(command, world, "--port", 0, "--headless", "--json", "--cluster", 0, "--nodes", nodes, *arguments)

    def node(self, head: House, *arguments) -> House:
        return House("node", head.wait_for_line(r"^cluster nodes: (127\.0\.0\.1:\d+)$").group(1), *arguments)

    def result_of(self, head: House) -> dict:
        self.assertEqual(head.wait(), 0, head.log())
        result = json.loads(head.output())
        return {key: result[key] for key in ("ticks", "robots", "rays", "hash", "sensed_hash")}

    def alone(self, world, *arguments) -> dict:
        with House("run", world, "--port", 0, "--headless", "--json", *arguments) as run:
            return self.result_of(run)

    def test_the_worlds_of_this_tree_are_the_same_with_two_nodes(self):
        # A recording subscribes every sensor.
        for engine in ("stage", "arena"):
            for name in ("cave", "fiducial", "detectors", "radio", "gripper", "camera", "outdoor", "swarm"):
                world = ROOT / "worlds" / f"{name}.world"
                with self.subTest(name, engine=engine):
                    options = ("--fast", "--duration", 1 if engine == "arena" else 4, "--engine", engine)
                    alone = self.alone(world, *options, "--record", self.folder / "alone.mcap")
                    with self.head(world, *options, "--record", self.folder / "shared.mcap", nodes=2) as head, \
                            self.node(head) as one, self.node(head, "--workers", 2) as two:
                        self.assertEqual(self.result_of(head), alone, head.log())
                        for node in (one, two):
                            self.assertEqual(node.wait(), 0, node.log())
                            self.assertRegex(node.log(), f"the run has ended: a share of {alone['ticks']} ticks")
                for file in self.folder.iterdir():
                    file.unlink()

    def test_a_recording_of_a_shared_run_runs_again_alone(self):
        file = self.folder / "shared.mcap"
        with self.head(self.world(SWARM), "--fast", "--duration", 10, "--record", file, nodes=1) as head, self.node(head):
            result = self.result_of(head)
        again = finish("run", "--again", file, "--json")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(json.loads(again.stdout)["hash"], result["hash"])

    def test_clients_in_lock_step_drive_the_same_run(self):
        world = self.world(SWARM)

        def drive(head: House) -> dict:
            with connect(f"127.0.0.1:{head.port()}") as client:
                laser, base, simulation = client.laser(3), client.position2d(5), client.simulation(0)
                for step in range(30):
                    simulation.step(5)
                    if step == 10:
                        simulation.set_pose("r7", 9.0, 9.0, 0.0)
                    if step == 15:
                        simulation.spawn("r1", 0.0, 9.0, 0.0)
                    base.drive(0.1 * (step % 3), 0.2)
                laser.next_data()
            return self.result_of(head)

        with House("run", world, "--port", 0, "--headless", "--json", "--lock-step", "--duration", 15) as run:
            alone = drive(run)
        with self.head(world, "--lock-step", "--duration", 15, nodes=2) as head, self.node(head) as one, self.node(head):
            self.assertEqual(drive(head), alone, head.log())
            self.assertEqual(one.wait(), 0, one.log())

    def test_nodes_join_and_are_lost_and_the_run_goes_on(self):
        world = self.world(SWARM)
        joined, lost = "takes part from", r"cluster: 127\.0\.0\.1:\d+ is lost: "
        with self.head(world, "--speed", 20) as head, Client(head.port()) as client:
            with self.node(head) as killed, self.node(head) as ended:
                head.wait_for_lines(joined, 2)
                killed.end(signal.SIGKILL)
                head.wait_for_lines(lost, 1)
                self.assertEqual(ended.end(signal.SIGTERM), 128 + signal.SIGTERM)
                head.wait_for_lines(lost, 2)
            with self.node(head) as late:
                head.wait_for_lines(joined, 3)
                self.assertEqual(client.open(POSITION2D, 0).type, ACK)
                self.assertEqual(client.open(RANGER, 0).type, ACK)
                client.next_data(RANGER, 0)
                self.assertEqual(head.end(signal.SIGINT), 130)
                self.assertEqual(late.wait(), 0, late.log())
            shared = json.loads(head.output())
        alone = self.alone(world, "--fast", "--duration", shared["sim_time"])
        self.assertEqual((shared["ticks"], shared["hash"]), (alone["ticks"], alone["hash"]))

    def test_configurations_have_nodes_too(self):
        with self.head(ROOT / "worlds/avoid.cfg", "--fast", "--duration", 5, nodes=1, command="serve") as head, \
                self.node(head) as node:
            self.assertEqual(head.wait(), 0, head.log())
            self.assertEqual(node.wait(), 0, node.log())

    def test_strangers_and_ends_have_a_line(self):
        with self.head(self.world(SWARM), "--speed", 1) as head:
            port = int(head.wait_for_line(r"^cluster nodes: 127\.0\.0\.1:(\d+)$").group(1))
            with socket.create_connection(("127.0.0.1", port)) as stranger:
                stranger.sendall(b"GET / HTTP/1.1\r\n\r\n")
                self.assertEqual(stranger.recv(1), b"")
            head.wait_for_line(r"warning: cluster: 127\.0\.0\.1:\d+: sent a message of \d+ bytes, 4096 at most")
            with socket.create_connection(("127.0.0.1", port)) as stranger:
                stranger.sendall(struct.pack("<IB", 7, 1) + b"\x03abc\x02de")
                self.assertTrue(stranger.recv(1))
            with self.node(head) as node:
                head.wait_for_line("takes part from")
                head.end(signal.SIGKILL)
                self.assertEqual(node.wait(), 1)
                self.assertRegex(node.log(), rf"error: 127\.0\.0\.1:{port}: (closed the connection|Connection reset by peer)")

    def test_a_stranger_that_shares_nonsense_does_not_end_the_run(self):
        world = self.world(SWARM)
        with self.head(world, "--speed", 1, "--duration", 3) as head:
            port = int(head.wait_for_line(r"^cluster nodes: 127\.0\.0\.1:(\d+)$").group(1))
            build = "{} ({})".format(*re.match(r"playhouse (\S+) \(commit ([^,]+),", finish("--version").stdout).groups())
            hello = b"".join(bytes([len(text)]) + text for text in (b"playhouse cluster 3", build.encode(), b""))
            with socket.create_connection(("127.0.0.1", port), timeout=PATIENCE) as stranger:
                stranger.sendall(struct.pack("<IB", len(hello), 1) + hello + struct.pack("<IB", 0, 3))
                stranger.sendall(struct.pack("<IB", 16, 6) + bytes(16))
                head.wait_for_line(r"warning: cluster: 127\.0\.0\.1:\d+ is lost: at [\d.]+ s its world differs")
            shared = self.result_of(head)
        self.assertEqual(shared, self.alone(world, "--fast", "--duration", 3))

    def test_beyond_this_machine_nodes_need_a_token(self):
        world = self.world(SWARM)
        with self.head(world, "--speed", 1, "--bind", "0.0.0.0", "--insecure") as head:
            line = head.wait_for_line(r"^cluster nodes: [^ ]+:(\d+) --token (\w{26})$")
            address = f"127.0.0.1:{line.group(1)}"
            refused = finish("node", address, "--wait", 1)
            self.assertEqual(refused.returncode, 1)
            self.assertIn("refuses this node: its token is not that of the run; node --token takes it", refused.stderr)
            with House("node", address, "--token", line.group(2)) as node:
                head.wait_for_line("takes part from")
                self.assertEqual(head.end(signal.SIGTERM), 128 + signal.SIGTERM)
                self.assertEqual(node.wait(), 0, node.log())
        with self.head(world, "--fast", "--duration", 2, "--cluster-token", "ours", nodes=1) as head:
            port = head.wait_for_line(r"^cluster nodes: 127\.0\.0\.1:(\d+) --token ours$").group(1)
            with House("node", f"127.0.0.1:{port}", "--token", "ours") as node:
                self.assertEqual(head.wait(), 0, head.log())
                self.assertEqual(node.wait(), 0, node.log())

    def test_a_head_that_is_silent_is_left(self):
        with socket.create_server(("127.0.0.1", 0)) as server, \
                House("node", f"127.0.0.1:{server.getsockname()[1]}", "--wait", 0) as node:
            peer, _ = server.accept()
            with peer:
                peer.sendall(struct.pack("<IB", 0xFFFFFFFF, 2))
                self.assertEqual(node.wait(), 1)
            self.assertIn("sent a message of 4294967295 bytes, 1073741824 at most", node.log())

    def test_a_run_that_never_begins(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            port = server.getsockname()[1]
        done = finish("node", f"127.0.0.1:{port}", "--wait", 0.3)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, rf"waiting for a run at 127\.0\.0\.1:{port}\n.*error: 127\.0\.0\.1:{port}: Connection refused")

    def test_ctrl_c_ends_a_head_that_waits_for_nodes(self):
        with self.head(self.world(SWARM), "--fast", nodes=3) as head:
            head.wait_for_line("waiting for nodes: 0 of 3 are there")
            self.assertEqual(head.end(signal.SIGINT), 130)

    def test_options_are_checked(self):
        for command in (["run", self.world(SWARM), "--nodes", 1], ["run", self.world(SWARM), "--cluster", "x"]):
            done = finish(*command, "--port", 0, "--headless")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertTrue(re.search("--cluster", done.stderr), done.stderr)


if __name__ == "__main__":
    unittest.main()
