"""The real server, by Python's client and by those of the other languages."""

import subprocess
import tempfile
import time
import unittest
from typing import Sequence

import languages
from paths import distance
from server_program import HANG, SPEED, World, needed
from playhouse_client import Access, Covariance, Mode, RequestRefused, connect
from playhouse_client.generated import position2d


@needed
class Radios(unittest.TestCase):
    def test_messages_come_whole_and_in_order_and_to_whom_they_are_sent(self) -> None:
        with World("radio.world") as world, connect(world.address) as client, connect(world.address) as other:
            radio, receiver = client.opaque(0), other.opaque(1)
            nearest = next(client.wifi(0).updates()).links[0].ip  # of robot 1
            radio.send(b"to all")
            radio.send_to(nearest, b"\0to one")
            radio.send_to("", b"")
            heard = receiver.updates()
            self.assertEqual([next(heard) for _ in range(3)], [b"to all", b"\0to one", b""])
            self.assertEqual(receiver.take_messages(), [])
            for address, message in (("10.0.9.9", b"x"), ("", b"x" * 2305)):
                with self.assertRaises(RequestRefused):
                    radio.send_to(address, message)

    def test_robots_hear_what_others_say(self) -> None:
        with World("radio.world") as world, connect(world.address) as client, connect(world.address) as other:
            first, second = client.speech(0), other.speech_recognition(1)
            heard = second.updates()
            for words in ("marco", "schön hier"):
                first.say(words)
                self.assertEqual(next(heard), words)
            client.speech(1).say("my own voice")
            first.say("polo")
            self.assertEqual(next(heard), "polo")
            self.assertEqual(second.take_texts(), [])


@needed
class Navigation(unittest.TestCase):
    def test_a_robot_is_localized_on_its_map_and_driven_along_a_path(self) -> None:
        with World("navigate.cfg", speed="20") as world, connect(world.address) as client:
            start = client.simulation(0).pose("r0")
            robot = client.robot("r0")
            place, guide, base, plan = robot.localize, robot.planner, robot.position2d, client.map(0)
            grid, cells = plan.grid(), plan.cells()
            self.assertAlmostEqual(grid.cell_size, 0.1, delta=1e-6)
            self.assertEqual([len(row) for row in cells], [grid.width] * grid.height)
            cell = grid.cell_of(start.x, start.y)
            assert cell is not None
            self.assertEqual(cells[cell.row][cell.column], -1, "a robot stands where nothing else is")
            rock = grid.cell_of(-7.9, -7.9)
            assert rock is not None
            self.assertEqual(cells[rock.row][rock.column], 1, "all around the cave")
            place.set_pose(*start, Covariance.of_deviations(0.2, 0.2, 0.1))
            guide.go_to(6.0, 4.0, 1.5)
            for state in guide.updates():
                self.assertLess(state.time, 100.0)
                if state.valid and state.pose.x > start.x + 0.5:
                    break
            path = guide.path()
            self.assertEqual((path.waypoints[-1], len(path.waypoints)), (state.goal, state.count))
            self.assertGreater(path.length, distance(start, state.goal))
            guide.stop()
            base.next_data()
            while base.velocity.x != 0.0:
                base.next_data()
            place.next_data()
            true = client.simulation(0).pose("r0")
            self.assertLess(distance(place.pose, true), 0.3)
            self.assertAlmostEqual(sum(one.weight for one in place.hypotheses), 1.0, delta=1e-6)
            self.assertGreaterEqual(len(place.particles()), 100)
            with self.assertRaises(RequestRefused):
                place.set_pose(*start, Covariance(xx=-1.0))
            guide.resume()
            for state in guide.updates():
                self.assertLess(state.time, 200.0)
                if guide.arrived:
                    break
            self.assertLess(distance(client.simulation(0).pose("r0"), state.goal), 0.6)


@needed
@languages.needed
class RobotsOfOtherLanguages(unittest.TestCase):
    def check(self, use: str, file: str = "", speed: str = SPEED, options: Sequence[str] = ()) -> None:
        def run(program: str) -> None:
            with World(file or f"{use}.world", *options, speed=speed) as world:
                command = [program, use, world.address]
                done = subprocess.run(command, stderr=subprocess.PIPE, text=True, timeout=HANG)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

        languages.check_each(self, languages.programs("robots"), run)

    def test_radios_take_messages_and_give_them(self) -> None:
        self.check("radio")

    def test_cameras_show_and_turn(self) -> None:
        self.check("camera")

    def test_voices_are_heard(self) -> None:
        self.check("voice", "radio.world")

    def test_inertial_units_receivers_and_lidars_measure(self) -> None:
        self.check("inertia", "outdoor.world")

    def test_a_guest_drives_with_the_right_token_and_is_told_of_a_wrong_one(self) -> None:
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as guests:
            guests.write("driver  driver-token-1  Gina\n")
            guests.flush()
            self.check("guest", "simple.world", options=("--guests", guests.name))

    def test_a_robot_is_localized_on_its_map_and_driven_along_a_path(self) -> None:
        self.check("course", "navigate.cfg", "20")


@needed
class Server(unittest.TestCase):
    world: World

    @classmethod
    def setUpClass(cls) -> None:
        cls.world = World("simple.world")

    @classmethod
    def tearDownClass(cls) -> None:
        cls.world.__exit__()

    def test_lists_its_devices_with_their_drivers(self) -> None:
        with connect(self.world.address) as client:
            listed = {entry.name: entry.driver for entry in client.devices()}
            wanted = {"simulation:0", "position2d:0", "ranger:0", "laser:0", "sonar:0"}
            self.assertLessEqual(wanted, set(listed))
            self.assertTrue(all(listed.values()), listed)
            self.assertTrue(client.banner.startswith("Player v."))

    def test_moves_models_and_refuses_names_it_does_not_have(self) -> None:
        with connect(self.world.address) as client, client.simulation(0) as simulator:
            simulator.set_pose("r0", 1.0, -1.0, 0.5)
            self.assertLess(distance(simulator.pose("r0"), (1.0, -1.0)), 1e-9)
            self.assertAlmostEqual(simulator.pose3d("r0").yaw, 0.5)
            with self.assertRaises(RequestRefused):
                simulator.pose("nosuch")

    def test_the_last_command_before_the_end_is_carried_out(self) -> None:
        with connect(self.world.address) as watcher, watcher.position2d(0, Access.READ) as robot:
            for _ in range(3):
                with connect(self.world.address) as client:
                    client.position2d(0).drive(0.1, 0.4)
                    client.read()
                robot.next_data()
                robot.next_data()
                self.assertEqual(robot.velocity.a, 0.0)

    def test_reading_access_does_not_drive(self) -> None:
        with connect(self.world.address) as client, client.position2d(0, Access.READ) as robot:
            robot.drive(0.3)
            robot.next_data()
            robot.next_data()
            self.assertEqual(robot.velocity.x, 0.0)
            with self.assertRaises(RequestRefused):
                robot.set_odometry(1.0, 2.0, 0.0)

    def test_odometry_is_set_and_data_are_pushed(self) -> None:
        with connect(self.world.address, mode=Mode.PUSH) as client, client.position2d(0) as robot:
            robot.set_odometry(4.0, 5.0, 1.0)
            robot.next_data()
            robot.next_data()
            self.assertLess(distance(robot.pose, (4.0, 5.0)), 0.01)

    def test_scans_of_laser_and_ranger_point_to_the_walls(self) -> None:
        with connect(self.world.address) as client:
            client.simulation(0).set_pose("r0", 0.0, 0.0, 0.0)
            laser, sonar = client.laser(0), client.ranger(0)
            for device in (laser, sonar):
                device.next_data()
                device.next_data()
            scan = laser.scan()
            self.assertEqual(len(scan.ranges), len(scan.angles))
            self.assertTrue(2.5 < scan.nearest(-0.05, 0.05) < 3.2)
            self.assertTrue(all(max(abs(x), abs(y)) < 3.5 for x, y in scan.points()))
            self.assertEqual(len(sonar.ranges), len(sonar.geom.element_poses))
            self.assertEqual(sonar.scan().angles[0], sonar.geom.element_poses[0].pyaw)

    def test_what_a_device_cannot_do_is_refused_at_once(self) -> None:
        with connect(self.world.address) as client, client.position2d(0) as robot:
            with self.assertRaises(RequestRefused):
                robot.get_property("nosuch", int)
            with self.assertRaises(RequestRefused):
                robot.request(position2d.REQ_SPEED_PROF, position2d.SpeedProfReq(-1.0, 0.0))
            with self.assertRaises(RequestRefused):
                client.position2d(99)


if __name__ == "__main__":
    unittest.main()
