"""What a client makes of servers that are slow, silent, busy, faulty or gone."""

import math
import struct
import unittest
import zlib
from typing import Callable, List

import package  # noqa: F401
from fake_server import FakeServer, Peer
from playhouse_client import (
    Access, Cell, Client, ConnectionLost, Covariance, DeviceClosed, Face, GoalRefused, Grid, Hypothesis, InvalidValue, Mode,
    NoData, Particle, Path, PlannerState, PlayerError, Pose, Pose3d, RequestRefused, RequestTimeout, WireError, connect,
)
from playhouse_client.connection import Message
from playhouse_client.device import did_you_mean
from playhouse_client.generated import aio, bumper, camera, common, gps, imu, laser, localize, planner, player, pointcloud3d, position2d
from playhouse_client.generated import map as grid_map
from playhouse_client.generated import opaque, position3d, ptz, simulation
from playhouse_client.wire import Kind, c_string, text

DATA_REQUEST = player.REQ_DATA.subtype


def state(x: float) -> position2d.Data:
    return position2d.Data(pos=common.Pose2d(x, 0.0, 0.0))


def script(rounds: Callable[[Peer, Message], None]) -> Callable[[Peer], None]:
    return lambda peer: peer.serve(rounds)


def commands(server: FakeServer) -> List[position2d.CmdVel]:
    assert server.peer is not None
    return [position2d.CmdVel.decode(m[40:]) for m in server.peer.received if m[19] == Kind.CMD]


class Suggestions(unittest.TestCase):
    """The same words as those of the program and of the C++ library: tests of playhouse/base/nearest_word.h."""

    def test_the_nearest_word_is_suggested_and_no_stranger(self) -> None:
        words = ("position", "ranger", "fiducial")
        for word, known, near in (("positoin", words, "position"), ("zzzzzz", words, ""), ("6", ("ir", "-h"), ""),
                                  ("it", ("ir", "-h"), "ir"), ("rangr", words, "ranger"), ("R0", ("r0", "r1"), "r0"),
                                  ("r7", ("r0", "r1"), "r0"), ("r" * 65, ("r" * 64,), ""), ("laser", (), "")):
            with self.subTest(word):
                self.assertEqual(did_you_mean(word, known), f' (did you mean "{near}"?)' if near else "")


class Connecting(unittest.TestCase):
    def test_nobody_there(self) -> None:
        with FakeServer(lambda peer: None) as server:
            address = server.address
            connect(address, mode=Mode.PUSH).close()
        with self.assertRaisesRegex(ConnectionLost, "cannot connect"):
            connect(address)

    def test_a_server_of_another_kind(self) -> None:
        with FakeServer(lambda peer: None, banner=b"220 mail.example.org ESMTP ready now") as server:
            with self.assertRaisesRegex(ConnectionLost, "not a Player server"):
                connect(server.address)

    def test_a_banner_in_pieces(self) -> None:
        def pieces(peer: Peer) -> None:
            for byte in b"Player v.3.1".ljust(32, b"\0"):
                peer.send(bytes([byte]))

        with FakeServer(pieces, banner=b"") as server:
            with connect(server.address, mode=Mode.PUSH) as client:
                self.assertEqual(client.banner, "Player v.3.1")

    def test_an_ipv6_address_is_in_brackets(self) -> None:
        with self.assertRaisesRegex(ConnectionLost, r"::1:1: cannot connect"):
            connect("[::1]:1")
        with self.assertRaisesRegex(ConnectionLost, "is not HOST or HOST:PORT"):
            connect("[::1]:")

    def test_an_address_without_a_host_is_this_machine_without_a_name_to_resolve(self) -> None:
        with self.assertRaisesRegex(ConnectionLost, r"127\.0\.0\.1:1: cannot connect"):
            connect(":1")

    def test_a_host_that_is_no_name(self) -> None:
        for host in ("a..b", "x" * 70, "nul\0", "no such host"):
            with self.assertRaisesRegex(ConnectionLost, "cannot connect"):
                connect(host)
        with self.assertRaisesRegex(ConnectionLost, "cannot connect"):
            Client("127.0.0.1", 70000)

    def test_an_address_that_is_none(self) -> None:
        with self.assertRaisesRegex(ConnectionLost, "is not HOST or HOST:PORT"):
            connect("localhost:port")


class Reading(unittest.TestCase):
    def test_a_round_ends_with_synch_and_brings_everything(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0))
            peer.data(position2d.DATA_STATE, state(2.0), timestamp=7.5)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            self.assertEqual(client.read(), 2)
            self.assertEqual((robot.pose.x, robot.timestamp), (2.0, 7.5))

    def test_messages_in_single_bytes_arrive_whole(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            plain, sent = peer.send, []
            peer.send = sent.append  # type: ignore[method-assign]
            peer.data(position2d.DATA_STATE, state(3.0))
            peer.synch()
            peer.send = plain  # type: ignore[method-assign]
            for byte in b"".join(sent):
                peer.send(bytes([byte]))

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            self.assertEqual(client.read(), 1)
            self.assertEqual(robot.pose.x, 3.0)

    def test_a_round_that_ends_while_a_request_waits_is_the_next_read(self) -> None:
        asked: List[Message] = []

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.subtype == DATA_REQUEST:
                asked.append(message)
                return peer.answer(message)  # and nothing else
            peer.data(position2d.DATA_STATE, state(4.0))
            peer.synch()
            peer.answer(message, body=position2d.Geom().encode())

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            with self.assertRaises(RequestTimeout):
                client.read(timeout=0.02)
            robot.geometry()
            self.assertEqual(client.read(), 1)
            self.assertEqual(len(asked), 1)

    def test_no_data_in_time_is_an_error_and_the_round_goes_on(self) -> None:
        asked: List[Message] = []

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.subtype == DATA_REQUEST:
                asked.append(message)
                peer.answer(message)  # and nothing else
            else:
                peer.answer(message, body=position2d.Geom().encode())
                peer.data(position2d.DATA_STATE, state(4.0))
                peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            with self.assertRaisesRegex(RequestTimeout, "no data in time"):
                client.read(timeout=0.02)
            robot.geometry()
            self.assertEqual(client.read(), 1)
            self.assertEqual(robot.pose.x, 4.0)
            self.assertEqual(len(asked), 1)

    def test_lost_messages_are_counted_and_not_an_error(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0))
            peer.synch(lost=41)

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            client.position2d(0)
            client.read()
            self.assertEqual(client.overflow_count, 41)

    def test_data_that_come_before_an_answer_wait_for_read(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(5.0))
            peer.answer(message, body=position2d.Geom().encode())

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot = client.position2d(0)
            robot.geometry()
            with self.assertRaises(NoData):
                robot.pose
            client.read()
            self.assertEqual(robot.pose.x, 5.0)

    def test_before_the_first_data_there_is_no_value(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message, Kind.NACK)

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot, scanner = client.position2d(0), client.laser(0)
            ring, finder, ranger, skirt = client.sonar(0), client.fiducial(0), client.ranger(0), client.bumper(0)
            for look in (
                lambda: robot.state, lambda: robot.pose, lambda: robot.velocity, lambda: robot.stalled,
                scanner.scan, lambda: scanner.ranges, lambda: scanner.intensities, lambda: ring.ranges,
                lambda: finder.markers, ranger.scan, lambda: ranger.ranges, lambda: ranger.intensities,
                lambda: skirt.pressed,
            ):
                with self.assertRaisesRegex(NoData, r":0 has sent no data yet; next_data\(\) waits for them"):
                    look()
            self.assertIsNone(robot.latest(position2d.DATA_STATE))

    def test_states_and_scans_tell_their_time(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0), timestamp=7.5)
            peer.data(laser.DATA_SCAN, laser.Data(ranges=[1.0, 2.0], max_range=8.0), timestamp=8.5)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot, scanner = client.position2d(0), client.laser(0)
            client.read()
            self.assertEqual((robot.state.time, scanner.scan().time), (7.5, 8.5))

    def test_a_camera_tells_its_pixels(self) -> None:
        pictures = [
            camera.Data(2, 1, 24, camera.FORMAT_RGB888, 1, camera.COMPRESS_RAW, bytes([1, 2, 3, 4, 5, 6])),
            camera.Data(1, 2, 16, camera.FORMAT_MONO16, 1, camera.COMPRESS_RAW, bytes([0x34, 0x12, 0, 0])),
            camera.Data(2, 1, 24, camera.FORMAT_RGB888, 1, camera.COMPRESS_JPEG, b"\xff\xd8"),
            camera.Data(2, 1, 24, camera.FORMAT_RGB888, 1, camera.COMPRESS_RAW, bytes([1, 2, 3, 4, 5])),
            camera.Data(2, 1, 24, camera.FORMAT_RGB888, 1, camera.COMPRESS_RAW, bytes([0, 0, 0, 0, 0, 1])),
        ]

        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(camera.DATA_STATE, pictures.pop(0), timestamp=2.5)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            eye = client.camera(0)
            client.read()
            self.assertEqual((eye.image.pixel(0, 0), eye.image.pixel(1, 0)), ((1, 2, 3), (4, 5, 6)))
            self.assertEqual(eye.image.time, 2.5)
            self.assertEqual(eye.image.model_id(1, 0), 0x040505)
            with self.assertRaisesRegex(InvalidValue, "2, 0 is outside the 2 x 1 picture"):
                eye.image.pixel(2, 0)
            client.read()
            self.assertEqual((eye.image.pixel(0, 0), eye.image.pixel(0, 1)), ((0x1234,), (0,)))
            with self.assertRaisesRegex(InvalidValue, "RGB888 alone"):
                eye.image.model_id(0, 0)
            client.read()
            self.assertTrue(eye.image.is_jpeg)
            with self.assertRaisesRegex(InvalidValue, "raw MONO8, MONO16 and RGB888 alone"):
                eye.image.pixel(0, 0)
            client.read()
            self.assertEqual(eye.image.pixel(0, 0), (1, 2, 3))
            with self.assertRaisesRegex(InvalidValue, "fewer bytes than pixels: 5"):
                eye.image.pixel(1, 0)
            client.read()
            self.assertEqual((eye.image.model_id(0, 0), eye.image.model_id(1, 0)), (None, 0), "none, and the first model")

    def test_a_bumper_tells_which_switches_are_pressed_and_where_they_are(self) -> None:
        front = bumper.Define(common.Pose3d(0.25, 0.0, 0.1, 0.0, 0.0, 0.5), 0.5, 0.0)

        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message, body=bumper.Geom([front]).encode())
            peer.data(bumper.DATA_STATE, bumper.Data(bytes([0, 1, 255])))
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.bumper(0) as skirt:
            self.assertEqual(next(skirt.updates()), [False, True, True])
            self.assertEqual(skirt.pressed, [False, True, True])
            self.assertEqual(skirt.faces(), [Face(Pose3d(0.25, 0.0, 0.1, 0.0, 0.0, 0.5), 0.5, 0.0)])

    def test_an_inertial_unit_tells_what_it_feels_and_how_it_stands(self) -> None:
        felt = imu.DataCalib(0.5, 0.25, 9.75, 0.0, 0.0, 1.5, 0.0, 0.5, -0.5)
        at = common.Pose3d(1.0, 2.0, 3.0, 0.0, 0.0, 0.5)

        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(imu.DATA_STATE, imu.DataState(common.Pose3d()), timestamp=1.0)
            peer.data(imu.DATA_EULER, imu.DataEuler(felt, common.Orientation3d(0.1, 0.2, 0.3)), timestamp=2.0)
            peer.data(imu.DATA_QUAT, imu.DataQuat(felt, 1.0, 0.0, 0.0, 0.0), timestamp=3.0)
            peer.data(imu.DATA_FULLSTATE, imu.DataFullstate(at, common.Pose3d(0.25), common.Pose3d()), timestamp=4.0)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.imu(0) as unit:
            with self.assertRaises(NoData):
                unit.inertia
            unit.send(imu.DATA_EULER)
            unit.next_data()
            self.assertEqual(unit.inertia, ((0.5, 0.25, 9.75), (0.0, 0.0, 1.5), (0.0, 0.5, -0.5)))
            self.assertEqual(unit.attitude, (0.1, 0.2, 0.3))
            self.assertEqual(unit.quaternion, (1.0, 0.0, 0.0, 0.0))
            self.assertEqual(unit.pose, Pose3d(1.0, 2.0, 3.0, 0.0, 0.0, 0.5), "the newer of two kinds of data")
            self.assertEqual(unit.velocity.x, 0.25)
            unit.reset_orientation()
            with self.assertRaisesRegex(InvalidValue, "yaw is nan"):
                unit.reset_attitude(0.0, 0.0, float("nan"))
            assert server.peer is not None
            asked = [m for m in server.peer.received if m[11] == 60 and m[19] == Kind.REQ]
            self.assertEqual([m[40:] for m in asked], [b"\0\0\0\x04", b"\0\0\0\0"], "euler, and the heading")

    def test_data_of_another_kind_are_named(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(imu.DATA_STATE, imu.DataState(common.Pose3d()))
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.imu(0) as unit:
            unit.next_data()
            line = r"imu:0 sends imu\.data\.state, not imu\.data\.calib; send\(imu\.DATA_CALIB\) selects it$"
            with self.assertRaisesRegex(NoData, line):
                unit.inertia

    def test_a_receiver_tells_degrees_and_metres_and_a_cloud_points(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(gps.DATA_STATE, gps.Data(1, 0, 507747000, -60839000, 220500, 0.5, 1.5, 294000.0, 5628000.0, 1, 8, 10, 15, 2.0, 3.0))
            red = pointcloud3d.Element(common.Point3d(1.0, 2.0, 3.0), common.Color(255, 200, 0, 0))
            peer.data(pointcloud3d.DATA_STATE, pointcloud3d.Data([red]))
            peer.data(position3d.DATA_STATE, position3d.Data(common.Pose3d(1.0, 2.0, 3.0, 0.1, 0.2, 0.3), common.Pose3d(0.5), 1))
            peer.answer(message)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            receiver, cloud, base = client.gps(0), client.pointcloud3d(0), client.position3d(0)
            fix = next(receiver.updates())
            self.assertAlmostEqual(fix.latitude, 50.7747, delta=1e-9)
            self.assertAlmostEqual(fix.longitude, -6.0839, delta=1e-9)
            self.assertEqual((fix.altitude, fix.quality, fix.satellites, fix.horizontal_error), (220.5, 1, 8, 2.0))
            self.assertEqual(cloud.points, [(1.0, 2.0, 3.0, (200, 0, 0, 255))])
            self.assertEqual(base.state.pose.roll, 0.1)
            self.assertTrue(base.state.stalled)
            with self.assertRaisesRegex(ValueError, "vz is inf"):
                base.drive(0.1, vz=float("inf"))
            base.drive(0.5, 0.25)
            base.close()
            assert server.peer is not None
            sent = [position3d.CmdVel.decode(m[40:]) for m in server.peer.received if m[19] == Kind.CMD]
            self.assertEqual([(one.vel.px, one.vel.pyaw) for one in sent], [(0.5, 0.25), (0.0, 0.0)], "stopped as it closes")

    def test_analog_inputs_are_voltages_and_outputs_are_set_one_by_one(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(aio.DATA_STATE, aio.Data([0.5, -3.0]))
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.aio(0) as box:
            self.assertEqual(next(box.updates()), [0.5, -3.0])
            self.assertEqual(box.voltages, [0.5, -3.0])
            with self.assertRaisesRegex(InvalidValue, "voltage is nan, not a finite number"):
                box.set(1, float("nan"))

    def test_a_localization_tells_where_the_robot_may_be_and_is_told(self) -> None:
        spread = [0.25, 0.5, 0.125, 0.1, 0.2, 0.3]
        told = [[localize.Hypoth(common.Pose2d(1.0, 2.0, 0.5), spread, 0.75), localize.Hypoth(alpha=0.25)], []]

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.interface == localize.CODE:
                refused = message.header.subtype == 1 and localize.SetPose.decode(message.body).cov[0] < 0.0
                few = localize.GetParticles(particles=[localize.Particle(common.Pose2d(3.0, 4.0, 1.0), 0.5)])
                peer.answer(message, Kind.NACK if refused else Kind.ACK, few.encode() if message.header.subtype == 2 else b"")
                return
            peer.answer(message)
            peer.data(localize.DATA_HYPOTHS, localize.Data(0, 1.0, told.pop(0)))
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.localize(0) as place:
            with self.assertRaisesRegex(NoData, "localize:0 has sent no data yet"):
                place.pose
            first = Hypothesis(Pose(1.0, 2.0, 0.5), Covariance(xx=0.25, yy=0.5, aa=0.125, xy=0.1, ya=0.2, xa=0.3), 0.75)
            self.assertEqual(next(place.updates()), [first, Hypothesis(Pose(), Covariance(), 0.25)])
            self.assertEqual(place.pose, Pose(1.0, 2.0, 0.5))
            client.read()
            with self.assertRaisesRegex(NoData, "localize:0 has no hypothesis"):
                place.pose
            place.set_pose(1.0, 2.0, 0.5, Covariance.of_deviations(0.5, 2.0, 3.0))
            with self.assertRaisesRegex(RequestRefused, "localize.req.set_pose of localize:0 was refused"):
                place.set_pose(1.0, 2.0, 0.5, Covariance(xx=-1.0))
            for pose, covariance in (((1.0, float("nan"), 0.5), Covariance()), ((1.0, 2.0, 0.5), Covariance(xa=float("inf")))):
                with self.assertRaisesRegex(InvalidValue, "localize:0: (y is nan|xa is inf), not a finite number"):
                    place.set_pose(*pose, covariance)
            self.assertEqual(place.particles(), [Particle(Pose(3.0, 4.0, 1.0), 0.5)])
            assert server.peer is not None
            sent = [localize.SetPose.decode(m[40:]) for m in server.peer.received if (m[11], m[23]) == (25, 1)]
            self.assertEqual(sent[0], localize.SetPose(common.Pose2d(1.0, 2.0, 0.5), [0.25, 4.0, 9.0, 0.0, 0.0, 0.0]))
            self.assertEqual(len(sent), 2)

    def test_a_planner_goes_to_a_goal_and_tells_when_the_robot_is_there(self) -> None:
        goal, way = common.Pose2d(6.0, 4.0, 1.5), common.Pose2d(2.0, 1.0, 0.0)
        told = [
            planner.Data(1, 1, common.Pose2d(), common.Pose2d(), common.Pose2d(), -1, 2),  # of a goal before
            planner.Data(1, 0, common.Pose2d(0.5), goal, way, 1, 3),
            planner.Data(1, 1, goal, goal, common.Pose2d(), -1, 3),
        ]

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.kind == Kind.CMD:
                return
            path = planner.WaypointsReq(7.5, [way, goal]) if message.header.interface == planner.CODE else None
            peer.answer(message, body=path.encode() if path and message.header.subtype == 1 else b"")
            if path is None:
                peer.data(planner.DATA_STATE, told.pop(0), timestamp=2.5)
                peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.planner(0) as guide:
            with self.assertRaisesRegex(NoData, "planner:0 has sent no data yet"):
                guide.state
            self.assertFalse(guide.arrived)
            guide.go_to(6.0, 4.0, 1.5 + 4.0 * math.pi)
            states = []
            for state in guide.updates():
                states.append(state)
                if guide.arrived:
                    break
            self.assertEqual(len(states), 3)
            at, to = Pose(0.5), Pose(6.0, 4.0, 1.5)
            self.assertEqual(states[1], PlannerState(True, False, at, to, Pose(2.0, 1.0), 1, 3, 2.5))
            guide.stop()
            guide.resume()
            self.assertEqual(guide.path(), Path([Pose(2.0, 1.0), to], 7.5))
            guide.go_to(6.0, 4.0, 0.0)
            self.assertFalse(guide.arrived, "another heading")
            with self.assertRaisesRegex(InvalidValue, "planner:0: y is inf, not a finite number"):
                guide.go_to(0.0, float("inf"), 0.0)
            guide.close()
            assert server.peer is not None
            sent = [(m[19], m[23], m[40:]) for m in server.peer.received if m[11] == planner.CODE]
            self.assertEqual(sent[1:3], [(Kind.REQ, 2, b"\0\0\0\0"), (Kind.REQ, 2, b"\0\0\0\1")])
            self.assertEqual([kind for kind, _, _ in sent], [Kind.CMD, Kind.REQ, Kind.REQ, Kind.REQ, Kind.CMD])
            self.assertEqual([subtype for _, subtype, _ in sent], [1, 2, 2, 1, 1])

    def test_a_planner_is_followed_to_its_goal_unless_it_refuses_it(self) -> None:
        goal, off, own = common.Pose2d(6.0, 4.0, 1.5), common.Pose2d(99.0, 0.0, 0.0), common.Pose2d(2.0, 3.0, 0.0)
        told = [
            planner.Data(0, 0, common.Pose2d(), goal, common.Pose2d(), -1, 0),  # a server without reasons
            planner.Data(1, 0, common.Pose2d(), goal, goal, 0, 1),
            planner.Data(1, 1, goal, goal, common.Pose2d(), -1, 1),
            planner.Data(0, 0, common.Pose2d(), off, common.Pose2d(), -1, 0),  # has not planned yet
            planner.Data(0, 0, common.Pose2d(), off, common.Pose2d(), -1, 0),
            planner.Data(1, 0, common.Pose2d(), own, own, 0, 1),
            *3 * [planner.Data(1, 0, common.Pose2d(), goal, goal, 0, 1)],  # of another client
        ]
        reasons = [None, None, "", "no path", "", "", ""]

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.kind == Kind.CMD:
                return
            if message.header.interface == planner.CODE:
                asked = common.StrpropReq.decode(message.body)
                assert text(asked.key) == "refusal"
                why = reasons.pop(0)
                if why is None:
                    peer.answer(message, Kind.NACK)
                else:
                    peer.answer(message, body=common.StrpropReq(asked.key, c_string(why)).encode())
                return
            peer.answer(message)
            peer.data(planner.DATA_STATE, told.pop(0), timestamp=2.5)
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client, client.planner(0) as guide:
            self.assertTrue(guide.drive_to(6.0, 4.0, 1.5).done)
            self.assertEqual(guide.why_refused(), "")
            with self.assertRaisesRegex(GoalRefused, "planner:0: no path$"):
                guide.drive_to(99.0, 0.0, 0.0)
            with self.assertRaisesRegex(GoalRefused, "planner:0: it has another goal, or no longer one$"):
                guide.drive_to(2.0, 3.0, 0.0)
        self.assertEqual((told, reasons), ([], []))

    def test_a_map_comes_whole_in_tiles(self) -> None:
        width, height = 600, 514

        def value(column: int, row: int) -> int:
            return (column + 3 * row) % 201 - 100

        def rounds(peer: Peer, message: Message) -> None:
            if message.header.subtype == grid_map.REQ_GET_INFO.subtype:
                return peer.answer(message, body=grid_map.Info(0.5, width, height, common.Pose2d(-1.0, 2.0, 0.0)).encode())
            tile = grid_map.Data.decode(message.body)
            values = [value(tile.col + i % tile.width, tile.row + i // tile.width) for i in range(tile.width * tile.height)]
            tile.data, tile.data_range = struct.pack(f"{len(values)}b", *values), 100
            if tile.row == 0:
                tile.data = zlib.compress(tile.data)  # and others as a server without zlib
            peer.answer(message, body=tile.encode())

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            plan = client.map(0)
            self.assertEqual(plan.grid(), Grid(0.5, width, height, Pose(-1.0, 2.0, 0.0)))
            cells = plan.cells()
            self.assertEqual([len(row) for row in cells], [width] * height)
            for row in range(height):
                wanted = [(value(column, row) > 50) - (value(column, row) < -50) for column in range(width)]
                self.assertEqual(list(cells[row]), wanted)
            assert server.peer is not None
            tiles = [grid_map.Data.decode(m[40:]) for m in server.peer.received if (m[11], m[23]) == (42, 2)]
            self.assertEqual([(one.col, one.row, one.width, one.height) for one in tiles],
                             [(0, 0, 512, 512), (512, 0, 88, 512), (0, 512, 512, 2), (512, 512, 88, 2)])

    def test_a_point_of_the_world_is_in_a_cell_or_beyond_the_map(self) -> None:
        grid = Grid(0.5, 4, 2, Pose(10.0, 20.0, math.pi / 2))  # columns go along y, rows against x
        self.assertEqual(grid.cell_of(9.9, 20.1), Cell(column=0, row=0))
        self.assertEqual(grid.cell_of(9.4, 21.9), Cell(column=3, row=1))
        for x, y in ((10.1, 20.1), (9.9, 19.9), (9.9, 22.1), (8.9, 20.1), (float("nan"), 20.1), (9.9, float("inf"))):
            self.assertIsNone(grid.cell_of(x, y))

    def test_maps_that_make_no_sense_are_an_error(self) -> None:
        infos = [
            grid_map.Info(0.0, 2, 2), grid_map.Info(float("nan"), 2, 2), grid_map.Info(0.5, 2, 2, common.Pose2d(float("inf"))),
            grid_map.Info(0.5, 1 << 14, (1 << 12) + 1), grid_map.Info(0.5, 2, 2), grid_map.Info(0.5, 2, 2), grid_map.Info(0.5, 0, 1 << 31),
        ]
        tiles = [zlib.compress(b"\1\1\1"), zlib.compress(bytes(1 << 20))]

        def rounds(peer: Peer, message: Message) -> None:
            asks_info = message.header.subtype == grid_map.REQ_GET_INFO.subtype
            answer = infos.pop(0) if asks_info else grid_map.Data(0, 0, 2, 2, 1, tiles.pop(0))
            peer.answer(message, body=answer.encode())

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            plan = client.map(0)
            for fault in ["invalid map"] * 3 + ["16384 x 4097 cells are over the limit"] + ["a tile of 2 x 2 cells is damaged"] * 2:
                with self.assertRaisesRegex(WireError, f"map:0: .*{fault}"):
                    plan.cells()
            self.assertEqual(plan.cells(), [])

    def test_data_of_others_do_not_prolong_the_time_out_of_one(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(laser.DATA_SCAN, laser.Data())
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot, scanner = client.position2d(0), client.laser(0)
            with self.assertRaisesRegex(RequestTimeout, "no data of position2d:0 in 0.05 s"):
                robot.next_data(timeout=0.05)
            self.assertTrue(scanner.fresh)

    def test_a_server_that_refuses_data_is_an_error(self) -> None:
        with FakeServer(script(lambda peer, message: peer.answer(message, Kind.NACK))) as server:
            with connect(server.address) as client:
                for _ in range(2):
                    with self.assertRaisesRegex(RequestRefused, "refuses to send data"):
                        client.read()

    def test_what_makes_no_sense_is_skipped_and_counted(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.say(4, 0, Kind.DATA, 99, b"1234")  # no such kind of data
            peer.say(4, 0, Kind.DATA, 1, b"1234")  # too short
            peer.say(4, 9, Kind.DATA, 1, state(1.0).encode())  # a device that is not open
            peer.say(4, 0, Kind.NACK, 5, b"")  # nobody asked
            peer.say(4, 0, 77, 5, b"")  # no such kind of message
            peer.data(position2d.DATA_STATE, state(6.0))
            peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            self.assertEqual(client.read(), 1)
            self.assertEqual((robot.pose.x, client.skipped_count), (6.0, 5))

    def test_a_size_over_the_limit_ends_the_connection(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.send(struct.pack(">6Id2I", 0, 0, 4, 0, 1, 1, 0.0, 0, 0x7FFFFFFF))

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            client.position2d(0)
            with self.assertRaisesRegex(ConnectionLost, "over the limit"):
                client.read()
            self.assertFalse(client.connected)

    def test_callbacks_may_ask_but_not_read(self) -> None:
        faults: List[str] = []

        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message, body=b"" if message.header.interface == 1 else position2d.Geom().encode())
            if message.header.interface == 1:
                peer.data(position2d.DATA_STATE, state(1.0))
                peer.synch()

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)

            def react(kind: object, value: object, timestamp: float) -> None:
                robot.geometry()
                try:
                    client.read()
                except PlayerError as error:
                    faults.append(str(error))

            robot.on_data(react)
            client.read()
        self.assertEqual(len(faults), 1)
        self.assertIn("from a callback", faults[0])


class Asking(unittest.TestCase):
    def test_a_refusal_is_an_error_and_the_connection_stays(self) -> None:
        answers = [Kind.NACK, Kind.ACK]

        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message, answers.pop(0), position2d.Geom().encode())

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            with self.assertRaisesRegex(RequestRefused, "position2d.req.get_geom"):
                robot.geometry()
            robot.geometry()

    def test_a_late_answer_is_not_taken_for_anothers(self) -> None:
        held: List[Message] = []

        def rounds(peer: Peer, message: Message) -> None:
            held.append(message)
            if len(held) == 2:
                for number, request in enumerate(held, 1):
                    peer.answer(request, body=common.IntpropReq(b"x\0", number).encode())

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            device = client.device("dio", 0)
            with self.assertRaisesRegex(RequestTimeout, "no answer to universal.req.get_intprop"):
                device.request(common.REQ_GET_INTPROP, common.IntpropReq(b"x\0"), timeout=0.02)
            self.assertEqual(device.get_property("x", int), 2)

    def test_a_late_answer_of_a_server_that_does_not_number_is_told_apart_too(self) -> None:
        held: List[Message] = []

        def rounds(peer: Peer, message: Message) -> None:
            held.append(message)
            if len(held) == 2:
                for number, request in enumerate(held, 1):
                    peer.answer(request, body=common.IntpropReq(b"x\0", number).encode(), sequence=0)

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            device = client.device("dio", 0)
            with self.assertRaises(RequestTimeout):
                device.request(common.REQ_GET_INTPROP, common.IntpropReq(b"x\0"), timeout=0.02)
            self.assertEqual(device.get_property("x", int), 2)

    def test_an_answer_that_does_not_decode_names_the_fault(self) -> None:
        with FakeServer(script(lambda peer, message: peer.answer(message, body=b"1234"))) as server:
            with connect(server.address) as client:
                robot = client.position2d(0)
                with self.assertRaisesRegex(WireError, "position2d.Geom"):
                    robot.geometry()

    def test_a_server_that_goes_is_noticed(self) -> None:
        def leave(peer: Peer, message: Message) -> None:
            raise ConnectionError

        with FakeServer(script(leave)) as server, connect(server.address) as client:
            robot = client.position2d(0)
            with self.assertRaises(ConnectionLost):
                robot.geometry()
            self.assertFalse(client.connected)
            with self.assertRaises(ConnectionLost):
                robot.drive(1.0)

    def test_errors_name_the_device_and_what_was_asked_of_it(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message, Kind.NACK)

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            with self.assertRaisesRegex(RequestRefused, "position2d.req.get_geom of position2d:3 was refused"):
                client.position2d(3).geometry()
            with self.assertRaisesRegex(RequestRefused, 'dio:0 has no int property "lamp"'):
                client.device("dio").get_property("lamp", int)
            with self.assertRaisesRegex(RequestRefused, "dio:0 refuses 7 as \"lamp\""):
                client.device("dio").set_property("lamp", 7)
            with self.assertRaisesRegex(RequestRefused, 'get_pose2d of model "nosuch" was refused'):
                client.simulation(0).pose("nosuch")

    def test_a_reset_drops_what_came_before_its_answer_and_keeps_what_comes_after(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(2.0), timestamp=2.0)
            peer.data(opaque.DATA_STATE, opaque.Data(b"old"), timestamp=2.0)
            peer.answer(message, body=message.body)
            peer.data(position2d.DATA_STATE, state(3.0), timestamp=0.5)

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot, radio, simulator = client.position2d(0), client.opaque(0), client.simulation(0)
            simulator.step()
            self.assertTrue(robot.has_data and radio.has_data)
            simulator.reset(7)
            for device in (robot, radio):
                self.assertEqual((device.has_data, device.fresh, device.timestamp), (False, False, 0.0))
            self.assertEqual(radio.take_messages(), [])
            with self.assertRaises(NoData):
                robot.pose
            robot.next_data()
            self.assertEqual((robot.pose.x, robot.timestamp), (3.0, 0.5))

    def test_a_refused_reset_drops_nothing(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(2.0))
            peer.answer(message, Kind.NACK)

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot, simulator = client.position2d(0), client.simulation(0)
            with self.assertRaises(RequestRefused):
                simulator.reset(7)
            client.read()
            self.assertEqual(robot.pose.x, 2.0)

    def test_a_time_that_goes_back_drops_what_other_devices_have_of_a_later_one(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(1.0), 0, 0.5)
            peer.data(position2d.DATA_STATE, state(2.0), 1, 1.0)
            peer.data(position2d.DATA_STATE, state(3.0), 2, 2.0)
            peer.data(position2d.DATA_STATE, state(4.0), 1, 0.5)
            peer.answer(message, body=message.body)

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            before, back, later = (client.position2d(index) for index in range(3))
            client.simulation(0).step()
            self.assertEqual((before.pose.x, back.pose.x, later.has_data), (1.0, 4.0, False))

    def test_values_that_mean_nothing_are_not_sent(self) -> None:
        nan, inf = float("nan"), float("inf")

        def rounds(peer: Peer, message: Message) -> None:
            raise AssertionError(f"this was sent: {message}")

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot, simulator, finder = client.position2d(0), client.simulation(0), client.fiducial(0)
            for act in (
                lambda: robot.drive(nan), lambda: robot.drive(0.0, inf), lambda: robot.drive(0.0, 0.0, -inf),
                lambda: robot.drive(10**400), lambda: robot.drive_car(0.1, nan),
                lambda: robot.go_to(nan, 0.0, 0.0), lambda: robot.set_odometry(0.0, 0.0, nan),
                lambda: simulator.set_pose("r0", 0.0, nan, 0.0),
                lambda: simulator.set_pose3d("r0", (0.0, 0.0, 0.0, 0.0, 0.0, nan)),
                lambda: finder.set_field_of_view(0.0, inf, 1.0),
            ):
                with self.assertRaisesRegex(InvalidValue, "is (-?inf|nan|10*), not a finite number"):
                    act()
            with self.assertRaisesRegex(ValueError, "position2d:0: vx is nan"):
                robot.drive(nan)
            for ticks in (0, -1, 1.5, 2**20 + 1, "1", None):
                with self.assertRaisesRegex(InvalidValue, f"simulation:0: ticks is {ticks!r}, not a whole number from 1 to"):
                    simulator.step(ticks)  # type: ignore[arg-type]
            for seed in (-1, 1.5, 2**64, "1"):
                with self.assertRaisesRegex(InvalidValue, f"simulation:0: seed is {seed!r}, not a whole number from 0 to"):
                    simulator.reset(seed)  # type: ignore[arg-type]
            for index in (-1, 65536):
                with self.assertRaisesRegex(InvalidValue, f"there is no position2d:{index}"):
                    client.position2d(index)
            for timeout in (-1.0, nan):
                with self.assertRaisesRegex(InvalidValue, "invalid time-out of"):
                    client.read(timeout)
            for value in (None, [1]):
                with self.assertRaisesRegex(InvalidValue, "a property is a bool"):
                    robot.set_property("key", value)  # type: ignore[arg-type]
            with self.assertRaisesRegex(WireError, "has a NUL in it"):
                simulator.pose("r0\0")
            with self.assertRaisesRegex(WireError, "cannot be sent as UTF-8"):
                simulator.pose("r\udcff")

    def test_a_time_out_may_be_infinite(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0))
            peer.synch()

        forever = float("inf")
        with FakeServer(script(rounds)) as server, connect(server.address, timeout=forever) as client:
            robot = client.position2d(0)
            robot.next_data()
            self.assertEqual(client.read(timeout=forever), 1)

    def test_a_closed_device_says_so(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            raise AssertionError(f"this was sent: {message}")

        with FakeServer(script(rounds)) as server:
            with connect(server.address) as client:
                robot, other = client.position2d(0), client.position2d(1)
                robot.close()
            for closed in (robot, other):
                self.assertFalse(closed.is_open)
                for act in (lambda: closed.drive(0.1), closed.geometry, closed.next_data):
                    with self.assertRaisesRegex(DeviceClosed, f"{closed.name} is closed"):
                        act()
            with self.assertRaisesRegex(ConnectionLost, "the connection is closed"):
                client.read()
            with self.assertRaisesRegex(ConnectionLost, "the connection is closed"):
                client.position2d(0)

    def test_a_device_that_is_not_there_cannot_be_opened(self) -> None:
        def refuse(peer: Peer) -> None:
            while True:
                message = peer.receive()
                if message is None:
                    return
                peer.answer(message, Kind.NACK if message.header.subtype == 3 else Kind.ACK)

        with FakeServer(refuse) as server, connect(server.address) as client:
            with self.assertRaisesRegex(RequestRefused, "there is no position2d:3 to open"):
                client.position2d(3)
            with self.assertRaisesRegex(InvalidValue, r'no interface "lazer" \(did you mean "laser"\?\)'):
                client.device("lazer", 0)
            with self.assertRaisesRegex(InvalidValue, 'no interface "xyzzy"$'):
                client.device("xyzzy", 0)

    def test_a_driver_that_refuses_to_start_is_an_error(self) -> None:
        def refuse(peer: Peer) -> None:
            while True:
                message = peer.receive()
                if message is None:
                    return
                body = player.DeviceReq(common.Devaddr(0, 0, 4, 0), player.ERROR_MODE).encode()
                peer.answer(message, body=body if message.header.subtype == 3 else b"")

        with FakeServer(refuse) as server, connect(server.address) as client:
            with self.assertRaisesRegex(RequestRefused, "cannot open position2d:0"):
                client.position2d(0)


class TheEnd(unittest.TestCase):
    """A server that ends has often just said the last things; they are delivered before the error."""

    def check(self, end: Callable[[Peer, Message], None], mode: Mode, wanted: List[float]) -> Client:
        def rounds(peer: Peer, message: Message) -> None:
            end(peer, message)
            peer.finish()

        with FakeServer(script(rounds)) as server, connect(server.address, mode=mode) as client:
            robot = client.position2d(0)
            seen: List[float] = []
            robot.on_data(lambda kind, value, timestamp: seen.append(value.pos.px))
            if mode == Mode.PUSH:
                robot.drive(0.1)  # anything, for the script to go on
            counted = 0
            with self.assertRaisesRegex(ConnectionLost, "the server closed the connection"):
                while True:
                    counted += client.read()
            self.assertEqual((seen, counted), (wanted, len(wanted)))
            with self.assertRaisesRegex(ConnectionLost, "the server closed the connection"):
                client.read()
            self.assertFalse(client.connected)
        return client

    def test_a_round_that_is_never_closed_is_delivered(self) -> None:
        def end(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0))
            peer.data(position2d.DATA_STATE, state(2.0))

        self.check(end, Mode.PULL, [1.0, 2.0])

    def test_data_instead_of_an_answer_are_delivered_and_their_losses_counted(self) -> None:
        wanted = [float(n) for n in range(3000)]  # more than wait for an ordinary request

        def end(peer: Peer, message: Message) -> None:
            for x in wanted:
                peer.data(position2d.DATA_STATE, state(x))
            peer.synch(lost=551)

        self.assertEqual(self.check(end, Mode.PULL, wanted).overflow_count, 551)

    def test_pushed_data_are_delivered(self) -> None:
        def end(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(1.0))
            peer.data(position2d.DATA_STATE, state(2.0))

        self.check(end, Mode.PUSH, [1.0, 2.0])

    def test_data_that_came_before_a_command_failed_can_still_be_read(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.data(position2d.DATA_STATE, state(1.0))
            raise ConnectionError  # what is sent there from now on is answered with a reset

        with FakeServer(script(rounds)) as server, connect(server.address, mode=Mode.PUSH) as client:
            robot = client.position2d(0)
            with self.assertRaisesRegex(ConnectionLost, "the server is gone"):
                while True:
                    robot.drive(0.1)
            client.read()
            self.assertEqual(robot.pose.x, 1.0)
            with self.assertRaisesRegex(ConnectionLost, "the server is gone"):
                client.read()

    def test_updates_end_with_the_last_data(self) -> None:
        def rounds(peer: Peer, message: Message) -> None:
            peer.answer(message)
            peer.data(position2d.DATA_STATE, state(1.0))
            raise ConnectionError

        with FakeServer(script(rounds)) as server, connect(server.address) as client:
            seen = []
            with self.assertRaises(ConnectionLost):
                for each in client.position2d(0).updates():
                    seen.append(each.pose.x)
            self.assertEqual(seen, [1.0])


class Ending(unittest.TestCase):
    def test_a_moving_robot_is_stopped_before_its_device_is_closed(self) -> None:
        with FakeServer(script(lambda peer, message: None)) as server:
            with connect(server.address) as client:
                client.position2d(0).drive(0.4, 0.1)
        self.assertEqual([c.vel.px for c in commands(server)], [0.4, 0.0])
        assert server.peer is not None
        self.assertEqual(server.peer.received[-1][40 + 19], player.CLOSE_MODE)

    def test_a_robot_that_stands_gets_no_further_command(self) -> None:
        with FakeServer(script(lambda peer, message: None)) as server:
            with connect(server.address) as client, client.position2d(0) as robot:
                robot.drive(0.4)
                robot.stop()
        self.assertEqual([c.vel.px for c in commands(server)], [0.4, 0.0])

    def test_reading_access_is_asked_for_by_its_character(self) -> None:
        with FakeServer(script(lambda peer, message: None)) as server:
            with connect(server.address) as client:
                client.position2d(0, Access.READ)
        assert server.peer is not None
        opened = player.DeviceReq.decode(server.peer.received[1][40:])
        self.assertEqual(opened.access, ord("r"))


if __name__ == "__main__":
    unittest.main()
