"""Clients and a running world: everything between a client's bytes and a simulated robot."""

import contextlib
import os
import signal
import socket
import struct
import subprocess
import sys
import unittest
import urllib.request

from house import (ACK, BLACKBOARD, CMD, DATA, FIDUCIAL, HEALTH, LASER, NACK, PATIENCE, PLAYER, POSITION2D, POSITION3D, PROGRAM, RANGER, REQ, ROOT, SIMULATION, SPEECH, SPEECH_RECOGNITION, SONAR, SYNCH,
                   Client, House, HouseTest, frame, ranges_of, text, wait_until)


class Serving(HouseTest):
    def setUp(self):
        super().setUp()
        self.house = self.enterContext(self.run_house())
        self.port = self.house.port()

    def client(self) -> Client:
        client = Client(self.port)
        self.addCleanup(client.close)
        return client

    def test_lists_every_robots_devices_in_the_documented_order(self):
        client = self.client()
        self.assertTrue(client.banner.startswith(b"Player v."))
        self.assertEqual(client.devices(), [
            (SIMULATION, 0), (POSITION2D, 0), (POSITION3D, 0), (SPEECH, 0), (SPEECH_RECOGNITION, 0), (RANGER, 0), (LASER, 0), (RANGER, 1), (SONAR, 0),
            (POSITION2D, 1), (POSITION3D, 1), (SPEECH, 1), (SPEECH_RECOGNITION, 1), (RANGER, 2), (LASER, 1), (RANGER, 3), (SONAR, 1),
            (BLACKBOARD, 0), (HEALTH, 0)])

    def test_a_robot_drives_as_commanded_and_says_so(self):
        client = self.client()
        client.open(POSITION2D, 0)
        client.drive(0, 0.5)
        speeds = []
        x = 0.0
        while x < 0.3:
            x, y, a, vx = struct.unpack(">dddd", client.next_data(POSITION2D, 0).body[:32])
            speeds.append(vx)
        self.assertAlmostEqual(speeds[-1], 0.5)
        self.assertAlmostEqual(y, 0)
        client.drive(0, 0)
        wait_until(lambda: struct.unpack(">d", client.next_data(POSITION2D, 0).body[24:32])[0] == 0, "stopped")

    def test_data_are_stamped_with_simulated_time_that_grows_by_the_interval(self):
        client = self.client()
        client.open(POSITION2D, 1)
        times = [client.next_data(POSITION2D, 1).time for _ in range(4)]
        for before, after in zip(times, times[1:]):
            self.assertAlmostEqual(after - before, 0.1)

    def test_the_laser_sees_the_wall_where_it_is(self):
        client = self.client()
        client.open(LASER, 0)
        scan = client.next_data(LASER, 0)
        ranges = ranges_of(scan)
        self.assertEqual(len(ranges), 181)
        self.assertAlmostEqual(ranges[90], 2.9, places=5)
        self.assertEqual(ranges[0], 8.0) if ranges[0] > 3.1 else self.assertGreater(ranges[0], 2)

    def test_geometry_and_configuration_are_answered(self):
        client = self.client()
        client.open(LASER, 0)
        position = client.request(POSITION2D, 0, 1)
        self.assertEqual((position.type, position.size), (ACK, 72))
        self.assertEqual(struct.unpack(">ddd", position.body[48:]), (0.4, 0.4, 0.2))
        laser = client.request(LASER, 0, 3)
        self.assertEqual((laser.type, laser.size), (ACK, 28))
        self.assertAlmostEqual(struct.unpack(">f", laser.body[8:12])[0], 0.01745329, places=6)

    def test_what_cannot_be_served_is_answered_no(self):
        client = self.client()
        client.open(POSITION2D, 0)
        self.assertEqual(client.request(POSITION2D, 0, 9, struct.pack(">ff", -1, 0)).type, NACK)  # SPEED_PROF
        self.assertEqual(client.request(POSITION2D, 9, 1).type, NACK)                  # no such robot
        self.assertEqual(client.request(SIMULATION, 0, 1, text("nobody") + bytes(24)).type, NACK)

    def test_capabilities_are_told(self):
        client = self.client()
        client.open(POSITION2D, 0)
        self.assertEqual(client.request(POSITION2D, 0, 255, struct.pack(">II", REQ, 1)).type, ACK)
        self.assertEqual(client.request(POSITION2D, 0, 255, struct.pack(">II", REQ, 100)).type, NACK)

    def test_a_reader_may_look_but_not_drive(self):
        reader, driver = self.client(), self.client()
        answer = reader.open(POSITION2D, 0, access=ord("r"))
        self.assertEqual(answer.type, ACK)
        reader.drive(0, 0.5)
        self.assertEqual(reader.request(POSITION2D, 0, 6).type, NACK)                  # RESET_ODOM
        self.assertEqual(reader.request(POSITION2D, 0, 1).type, ACK)                   # GET_GEOM
        for _ in range(3):
            self.assertEqual(struct.unpack(">d", reader.next_data(POSITION2D, 0).body[24:32])[0], 0)
        driver.open(POSITION2D, 0, access=ord("w"))
        driver.drive(0, 0.25)
        wait_until(lambda: struct.unpack(">d", reader.next_data(POSITION2D, 0).body[24:32])[0] == 0.25, "driven")

    def test_poses_are_read_and_set_by_name(self):
        client = self.client()
        client.open(SIMULATION, 0)
        self.assertEqual(client.pose("r1")[:2], (0, -3))
        answer = client.request(SIMULATION, 0, 2, text("r1") + struct.pack(">ddd", -2, -2, 0.5))
        self.assertEqual(answer.type, ACK)
        self.assertEqual(client.pose("r1"), (-2, -2, 0.5))

    def test_pausing_stops_data_and_not_answers(self):
        with self.run_house("--fast") as house, Client(house.port()) as client:
            client.open(POSITION2D, 0)
            client.next_data(POSITION2D, 0)
            client.send(SIMULATION, 0, CMD, 1)
            client.pose("r0")                   # answered by the tick thread, so the pause has been seen
            client.data.clear()
            for _ in range(300):                # many ticks of a world that runs
                self.assertEqual(client.pose("r0"), (0, 0, 0))
            self.assertEqual(client.data, [])
            client.send(SIMULATION, 0, CMD, 1)
            client.next_data(POSITION2D, 0)

    def test_two_clients_share_a_robot_and_the_newer_command_counts(self):
        one, two = self.client(), self.client()
        for client in (one, two):
            client.open(POSITION2D, 0)
        one.drive(0, 0.3)
        wait_until(lambda: struct.unpack(">d", two.next_data(POSITION2D, 0).body[24:32])[0] == 0.3, "driven by one")
        two.drive(0, 0.1)
        wait_until(lambda: struct.unpack(">d", one.next_data(POSITION2D, 0).body[24:32])[0] == 0.1, "driven by two")

    def test_a_robot_stops_when_its_last_user_closes(self):
        client, watcher = self.client(), self.client()
        client.open(POSITION2D, 0)
        client.drive(0, 0.5)
        wait_until(lambda: watcher.pose("r0")[0] > 0, "moved")
        client.close()
        watcher.open(POSITION2D, 1)  # whose messages are a clock

        def stands_still():
            here = watcher.pose("r0")
            watcher.data.clear()
            for _ in range(3):
                watcher.next_data(POSITION2D, 1)
            return watcher.pose("r0") == here
        wait_until(stands_still, "stopped")

    def test_a_killed_client_costs_the_others_nothing(self):
        survivor = self.client()
        survivor.open(POSITION2D, 0)
        script = ("import sys; sys.path.insert(0, sys.argv[1])\n"
                  "from house import *\n"
                  "c = Client(int(sys.argv[2])); c.open(POSITION2D, 0); c.open(LASER, 0); c.drive(0, 0.2)\n"
                  "print('open', flush=True)\n"
                  "while True: c.receive()\n")
        victim = subprocess.Popen([sys.executable, "-c", script, str(ROOT / "tests" / "e2e"), str(self.port)],
                                  stdout=subprocess.PIPE, text=True)
        self.addCleanup(victim.stdout.close)
        self.assertEqual(victim.stdout.readline().strip(), "open")
        victim.send_signal(signal.SIGKILL)
        victim.wait(PATIENCE)
        for _ in range(5):
            survivor.next_data(POSITION2D, 0)
        survivor.drive(0, 0.1)
        wait_until(lambda: struct.unpack(">d", survivor.next_data(POSITION2D, 0).body[24:32])[0] == 0.1, "driven")

    def test_a_broken_frame_ends_its_own_session_only(self):
        other = self.client()
        other.open(POSITION2D, 0)
        broken = self.client()
        broken.socket.sendall(struct.pack(">IIIIIIdII", 0, 0, POSITION2D, 0, REQ, 1, 0.0, 0, 0x7FFFFFFF))
        self.assertRaises(OSError, broken.receive)
        other.next_data(POSITION2D, 0)
        self.assertEqual(other.request(POSITION2D, 0, 1).type, ACK)

    def test_a_flood_of_commands_leaves_the_last_one(self):
        client = self.client()
        client.open(POSITION2D, 0)
        flood = b"".join(frame(POSITION2D, 0, CMD, 1, struct.pack(">dddI", i / 1e5, 0, 0, 1)) for i in range(20000))
        client.socket.sendall(flood)
        client.drive(0, 0.125)
        wait_until(lambda: struct.unpack(">d", client.next_data(POSITION2D, 0).body[24:32])[0] == 0.125, "settled")

    def test_a_robot_that_believes_its_odometry_takes_a_new_one(self):
        client = self.client()
        client.open(POSITION2D, 1)
        self.assertEqual(client.request(POSITION2D, 1, 5, struct.pack(">ddd", 5, 6, 0.25)).type, ACK)
        client.data.clear()
        x, y, a = struct.unpack(">ddd", client.next_data(POSITION2D, 1).body[:24])
        self.assertEqual((x, y), (5, 6))
        self.assertAlmostEqual(a, 0.25)


class Stalled(HouseTest):
    def test_a_client_that_reads_nothing_costs_the_others_nothing(self):
        with self.run_house("--fast") as house, Client(house.port()) as stalled, Client(house.port()) as reader:
            stalled.open(LASER, 0)
            stalled.open(RANGER, 0)
            reader.open(POSITION2D, 0)
            reader.request(PLAYER, 0, 5, struct.pack(">I", 2))      # PULL: read at our own pace
            for _ in range(200):
                reader.send(PLAYER, 0, REQ, 4)
                reader.next_data(POSITION2D, 0)
            self.assertIsNone(house.process.poll())


class EndOfARun(HouseTest):
    def count(self, poses: int, ask_when) -> tuple[int, int]:
        """Of a run of so many poses: how many a client in PULL mode gets, and how many it is told it missed."""
        with self.run_house("--fast", "--paused", "--duration", poses / 10) as house, \
                Client(house.port()) as client, Client(house.port()) as other:
            client.request(PLAYER, 0, 5, struct.pack(">I", 2))
            for each in (client, other):
                each.open(POSITION2D, 0)
            client.send(SIMULATION, 0, CMD, 1)      # PAUSE: resumes
            ask_when(other)
            got = missed = 0
            with contextlib.suppress(ConnectionError):
                while True:
                    client.send(PLAYER, 0, REQ, 4)
                    while (message := client.receive()).type != SYNCH:
                        got += message.key() == (POSITION2D, 0, DATA, 1)
                    missed += struct.unpack(">I", message.body)[0] if message.body else 0
            self.assertEqual(house.wait(), 0)
            return got, missed

    def after_the_last(self, poses: int):
        def wait(other):
            while other.next_data(POSITION2D, 0).time < poses / 10 - 0.01:
                pass
        return wait

    def test_a_client_in_pull_mode_that_reads_all_the_time_gets_everything(self):
        self.assertEqual(self.count(600, lambda _: None), (600, 0))

    def test_a_client_in_pull_mode_that_asks_after_the_last_tick_gets_everything_that_fits(self):
        self.assertEqual(self.count(600, self.after_the_last(600)), (600, 0))

    def test_a_client_in_pull_mode_is_told_what_did_not_fit(self):
        self.assertEqual(self.count(2000, self.after_the_last(2000)), (1024, 976))

    def test_a_client_that_never_reads_does_not_keep_the_program_from_ending(self):
        with self.run_house("--fast", "--paused", "--duration", 10) as house, Client(house.port()) as client:
            client.request(PLAYER, 0, 5, struct.pack(">I", 2))
            client.open(POSITION2D, 0)
            client.send(SIMULATION, 0, CMD, 1)
            self.assertEqual(house.wait(), 0)


class Crowded(HouseTest):
    def test_a_flood_of_web_connections_is_one_line_of_the_log(self):
        with House("run", self.world(), "--port", 0, "--web", 0) as house, contextlib.ExitStack() as crowd:
            port = int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/$").group(1))
            peers = [crowd.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE)) for _ in range(300)]
            peers[0].settimeout(PATIENCE)
            try:
                self.assertEqual(peers[0].recv(1), b"")     # who waits longest gives way
            except ConnectionResetError:
                pass    # closed all the same
            self.assertEqual(house.end(), 143)
            self.assertEqual(house.log().count("many connections"), 1, house.log())


    def test_player_clients_leave_descriptors_for_the_page(self):
        limited = House("--nofile=64:64", PROGRAM, "run", self.world(), "--port", 0, "--web", 0, program="prlimit")
        with limited as house, contextlib.ExitStack() as crowd:
            port = house.port()
            page = house.wait_for_line(r"^web page: (http://127\.0\.0\.1:\d+/)$").group(1)
            for _ in range(80):
                crowd.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE))
            with urllib.request.urlopen(page, timeout=PATIENCE) as answer:
                self.assertEqual(answer.status, 200)
            self.assertRegex(house.log(), r"\d+ Player clients at most: the limit on open files is 64")


class Configured(HouseTest):
    CFG = """
    driver( name "stage" provides ["simulation:0"] plugin "stageplugin" worldfile "test.world" usegui 0 )
    driver( name "stage" provides ["position2d:0" "ranger:0" "ranger:1"] model "r0" )
    driver( name "stage" provides ["position2d:1"] model "r1" alwayson 1 )
    driver( name "rangertolaser" provides ["laser:0"] requires ["ranger:0"] )
    """

    def test_serve_gives_the_devices_that_the_file_names(self):
        self.world()
        with House("serve", self.write("test.cfg", self.CFG), "--port", 0, "--headless") as house:
            with Client(house.port()) as client:
                self.assertEqual(client.devices(), [(SIMULATION, 0), (POSITION2D, 0), (RANGER, 0), (RANGER, 1),
                                                    (POSITION2D, 1), (LASER, 0)])
                opened = client.open(LASER, 0)
                self.assertIn(b"rangertolaser", opened.body)
                self.assertAlmostEqual(ranges_of(client.next_data(LASER, 0))[90], 2.9, places=5)
                self.assertEqual(client.request(LASER, 0, 3).size, 28)
                self.assertEqual(client.request(LASER, 0, 1).size, 72)
            self.assertEqual(house.end(), 128 + signal.SIGTERM)

    def test_a_file_may_use_several_ports(self):
        self.world()
        with House("run", self.world(), "--port", 0, "--headless") as other:
            free = other.port()     # certainly not free while this runs; freed below
        cfg = self.CFG.replace('"position2d:1"', f'"{free}:position2d:0"')
        with House("serve", self.write("test.cfg", cfg), "--port", 0, "--headless") as house:
            house.wait_for_line(rf"^Player clients: 127\.0\.0\.1:{free}$")
            with Client(free) as client:
                self.assertEqual(client.devices(), [(POSITION2D, 0)])

    def test_the_default_port_may_be_named_as_well(self):
        self.world()
        with House("run", self.world(), "--port", 0, "--headless") as other:
            free = other.port()
        cfg = self.CFG.replace('"position2d:1"', f'"{free}:position2d:1"')
        with House("serve", self.write("test.cfg", cfg), "--port", free, "--headless") as house:
            with Client(house.port()) as client:
                self.assertIn((POSITION2D, 1), client.devices())


if __name__ == "__main__":
    unittest.main()
