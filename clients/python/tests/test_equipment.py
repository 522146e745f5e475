"""Batteries, grippers, joints, lamps, blobfinders and radios, of the real server and of servers with more."""

import subprocess
import unittest
from pathlib import Path
from typing import Callable, List

import languages
from fake_server import FakeServer, Peer
from server_program import HANG, World, needed
from playhouse_client import (
    ActArray, BlinkenLight, Blobfinder, Charging, Client, Gripper, InvalidValue, Mode, NoData, Power,
    RequestRefused, Robot, Wifi, connect,
)
from playhouse_client.connection import Message
from playhouse_client.generated import actarray, blinkenlight, blobfinder, common, gripper, power, wifi
from playhouse_client.wire import Kind, MessageType, Struct

WORLD = str(Path(__file__).with_name("equipment.world"))
RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


@needed
class Equipment(unittest.TestCase):
    world: World
    client: Client
    robot: Robot

    def setUp(self) -> None:
        self.world = World(WORLD, speed="20")
        self.addCleanup(self.world.__exit__)
        self.client = connect(self.world.address)
        self.addCleanup(self.client.close)
        self.robot = self.client.robot("r0")

    def test_a_battery_tells_its_charge_and_is_told_whether_it_may_be_charged(self) -> None:
        battery = self.robot.power
        state = next(battery.updates())
        assert state.percent is not None and state.joules is not None and state.watts is not None
        self.assertEqual((state.volts, state.charging), (None, Charging.NO))
        self.assertTrue(0.0 < state.joules <= 1000.0 and state.watts >= 0.0, state)
        self.assertAlmostEqual(state.percent, state.joules / 20.0, delta=1e-3)
        self.assertEqual(state.time, battery.timestamp)
        battery.set_charging_policy(takes=False, gives=True)
        for state in battery.updates():
            if state.charging == Charging.IMPOSSIBLE:
                break

    def test_a_gripper_closes_around_a_puck_and_lets_it_go(self) -> None:
        hand = self.robot.gripper
        geometry = hand.geometry()
        self.assertAlmostEqual(geometry.pose.x, 0.3)
        self.assertEqual((geometry.size.x, geometry.size.y, geometry.beam_count), (0.2, 0.3, 2))
        self.assertTrue(0.0 < geometry.gap.y < geometry.size.y)
        state = next(hand.updates())
        self.assertEqual((state.open, state.closed, state.moving), (True, False, False))
        self.assertNotEqual(state.beams, 0, "the puck is between the fingers")
        hand.close_fingers()
        self.wait(hand, lambda: hand.state.moving)
        self.wait(hand, lambda: hand.state.closed)
        self.assertEqual(self.client.simulation(0).pose("puck"), (0.0, 0.0, 0.0), "in the gripper")
        hand.open_fingers()
        self.wait(hand, lambda: hand.state.moving)
        hand.stop()
        self.wait(hand, lambda: not hand.state.moving)
        self.assertFalse(hand.state.open or hand.state.closed, "it was stopped in between")

    def test_a_joint_moves_where_and_how_fast_it_is_told(self) -> None:
        arm = self.robot.actarray
        (joint,) = arm.geometry().joints
        self.assertFalse(joint.rotary)
        self.assertEqual((joint.lowest, joint.highest, joint.home), (0.0, 2.0, 0.5))
        self.assertEqual((joint.axis, joint.speed, joint.has_brakes), ((1.0, 0.0, 0.0), 1.0, True))
        self.assertAlmostEqual(arm.geometry().pose.y, 0.1)
        state = next(arm.updates())
        self.assertEqual((arm.joints[0].position, arm.joints[0].current, state.motors_on), (0.5, None, True))
        arm.move_to(0, 1.5)
        self.wait(arm, lambda: arm.joints[0].moving and arm.joints[0].speed > 0.0)
        self.wait(arm, lambda: abs(arm.joints[0].position - 1.5) < 1e-3)
        arm.home()
        self.wait(arm, lambda: abs(arm.joints[0].position - 0.5) < 1e-3)
        arm.set_speed(ActArray.ALL, 0.25)
        self.assertEqual(arm.geometry().joints[0].speed, 0.25)
        arm.move_all_to([1.0])
        self.wait(arm, lambda: abs(arm.joints[0].speed - 0.25) < 1e-3)
        arm.move_at(0, -0.5)
        self.wait(arm, lambda: arm.joints[0].position == 0.0)
        arm.move_all_at([0.125])
        self.wait(arm, lambda: arm.joints[0].speed == 0.125)
        arm.set_brakes(True)
        self.wait(arm, lambda: arm.joints[0].braked)
        arm.set_brakes(False)
        arm.set_motor_power(False)
        self.wait(arm, lambda: not arm.state.motors_on)
        with self.assertRaises(RequestRefused):
            arm.set_speed(0, 5.0)

    def test_a_lamp_is_switched_colored_and_made_to_flash(self) -> None:
        lamp = self.robot.blinkenlight
        self.assertEqual(next(lamp.updates())[:-1], (True, 0.5, 0.25, BLUE))
        lamp.set_power(False)
        lamp.set_color(RED)
        lamp.flash(2.0)
        self.wait(lamp, lambda: lamp.state[:-1] == (False, 2.0, 0.5, RED))
        lamp.set(True, 0.0, 1.0, GREEN)
        self.wait(lamp, lambda: lamp.state[:-1] == (True, 0.0, 1.0, GREEN))

    def test_a_blobfinder_finds_a_ball(self) -> None:
        eye = self.robot.blobfinder
        (blob,) = next(eye.updates())
        self.assertEqual((blob.channel, blob.color, eye.image_size), (1, RED, (80, 60)))
        self.assertTrue(blob.left <= blob.x <= blob.right, blob)
        self.assertTrue(blob.top <= blob.y <= blob.bottom, blob)
        self.assertEqual(blob.area, (blob.right - blob.left + 1) * (blob.bottom - blob.top + 1))
        self.assertAlmostEqual(blob.range, 3.0, delta=0.1)

    def test_a_radio_tells_its_links_with_signed_levels(self) -> None:
        radio = self.robot.wifi
        self.assertEqual(radio.mac(), "02:00:00:00:00:01")
        state = next(radio.updates())
        (link,) = radio.links
        self.assertEqual(state.links, [link])
        self.assertEqual((link.mac, link.ip, link.essid), ("02:00:00:00:00:02", "10.0.0.2", "lab"))
        self.assertEqual((link.mode, link.frequency, link.encrypted), (wifi.MODE_ADHOC, 2412, False))
        self.assertEqual((state.unit, state.max_quality, state.bitrate), (wifi.QUAL_DBM, 100, 11000000))
        self.assertTrue(-70 < link.level < 0 and 0 < link.quality <= 100, link)
        self.assertEqual(link.noise, -100)

    def test_a_robot_has_all_of_them_by_name(self) -> None:
        robot = self.robot
        all_of_them = (*robot.grippers, *robot.powers, *robot.blobfinders, *robot.wifis, *robot.actarrays,
                       *robot.blinkenlights)
        kinds = [Gripper, Power, Blobfinder, Wifi, ActArray, BlinkenLight]
        self.assertEqual([type(device) for device in all_of_them], kinds)

    def wait(self, device: "Gripper | ActArray | BlinkenLight", done: Callable[[], bool]) -> None:
        """Until data make it so, for half a minute of simulated time."""
        device.next_data()
        end = device.timestamp + 30.0
        while not done():
            self.assertLess(device.timestamp, end)
            device.next_data()


@needed
class Restarting(unittest.TestCase):
    def test_a_restarted_run_has_no_data_of_the_one_before(self) -> None:
        with World(WORLD, "--lock-step") as world, connect(world.address, mode=Mode.PUSH) as client:
            robot, simulation = client.robot("r0"), client.simulation(0)
            devices = [robot.gripper, robot.power, robot.blobfinder, robot.wifi, robot.actarray,
                       robot.blinkenlight]
            simulation.join("test")
            simulation.step(5)
            self.assertEqual([(each.fresh, each.timestamp) for each in devices], [(True, 0.5)] * 6)
            simulation.reset(7)
            self.assertEqual([(each.fresh, each.has_data) for each in devices], [(False, False)] * 6)
            for read in (lambda: robot.gripper.state, lambda: robot.power.state,
                         lambda: robot.blobfinder.blobs, lambda: robot.wifi.links,
                         lambda: robot.actarray.joints, lambda: robot.blinkenlight.state):
                with self.assertRaises(NoData):
                    read()
            simulation.step()
            self.assertEqual([(each.fresh, each.timestamp) for each in devices], [(True, 0.1)] * 6)


@needed
@languages.needed
class InCpp(unittest.TestCase):
    def test_it_is_used(self) -> None:
        program = languages.programs("robots")["cpp"]
        with World(WORLD, speed="20") as world:
            command = [program, "equipment", world.address]
            done = subprocess.run(command, stderr=subprocess.PIPE, text=True, timeout=HANG)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class OtherServers(unittest.TestCase):
    """A server that tells one message in each round."""

    def connect(self, message: MessageType, *values: Struct) -> Client:
        told = list(values)

        def rounds(peer: Peer, request: Message) -> None:
            if request.header.kind == Kind.CMD:
                return
            peer.answer(request)
            peer.data(message, told.pop(0), timestamp=2.5)
            peer.synch()

        self.server = FakeServer(lambda peer: peer.serve(rounds))
        self.server.__enter__()
        self.addCleanup(self.server.__exit__, None)
        client = connect(self.server.address)
        self.addCleanup(client.close)
        return client

    def commands(self) -> List[bytes]:
        """Their bodies, once the client has closed the connection."""
        self.server.__exit__(None)
        assert self.server.peer is not None
        return [message[40:] for message in self.server.peer.received if message[19] == Kind.CMD]

    def test_of_a_battery_only_what_is_valid_is_told(self) -> None:
        told = power.Data(power.MASK_VOLTS | power.MASK_CHARGING, 12.5, 50.0, 10.0, 3.0, 1)
        battery = self.connect(power.DATA_STATE, told, power.Data(0, 12.5, 50.0, 10.0, 3.0, 1)).power(0)
        self.assertEqual(next(battery.updates()), (12.5, None, None, None, Charging.YES, 2.5))
        self.assertEqual(next(battery.updates()), (None, None, None, None, None, 2.5))

    def test_a_faulty_gripper_is_neither_open_nor_closed(self) -> None:
        hand = self.connect(gripper.DATA_STATE, gripper.Data(gripper.STATE_ERROR, 0x80000001, 0)).gripper(0)
        self.assertEqual(next(hand.updates()), (False, False, False, 0x80000001, 2.5))

    def test_levels_without_a_unit_are_not_signed(self) -> None:
        link = wifi.Link(b"aa:bb\0", b"10.0.0.2", b"", wifi.MODE_INFRA, 2412, 1, 40, 200, -100)
        data = wifi.Data([link], 1, 2, wifi.MODE_INFRA, wifi.QUAL_REL, 70, 255, -1, b"cc:dd")
        radio = self.connect(wifi.DATA_STATE, data).wifi(0)
        state = next(radio.updates())
        wanted = ("aa:bb", "10.0.0.2", "", wifi.MODE_INFRA, 2412, True, 40, 200, 0xFFFFFF9C)
        self.assertEqual(state.links, [wanted])
        self.assertEqual(state[1:], (1, 2, wifi.MODE_INFRA, wifi.QUAL_REL, 70, 255, 0xFFFFFFFF, "cc:dd", 2.5))

    def test_an_arm_has_several_joints(self) -> None:
        told = actarray.Data([
            actarray.Actuator(1.0, 0.5, 0.25, 2.0, actarray.ACTSTATE_MOVING),
            actarray.Actuator(2.0, 0.0, 0.0, -1.0, actarray.ACTSTATE_STALLED),
        ], 1)
        client = self.connect(actarray.DATA_STATE, told)
        arm = client.actarray(0)
        state = next(arm.updates())
        self.assertEqual(state.joints[0], (1.0, 0.5, 0.25, 2.0, True, False, False))
        self.assertEqual(state.joints[1], (2.0, 0.0, 0.0, None, False, False, True))
        arm.move_all_to([0.5, 1.5])
        arm.home(1)
        nan = float("nan")
        for call in (lambda: arm.move_to(-1, 0.0), lambda: arm.move_to(0, nan), lambda: arm.home(-2),
                     lambda: arm.move_all_at([0.0, nan]), lambda: arm.set_speed(0, nan)):
            with self.assertRaises(InvalidValue):
                call()
        client.close()
        sent = [actarray.MultiPositionCmd([0.5, 1.5]), actarray.HomeCmd(1)]
        self.assertEqual(self.commands(), [each.encode() for each in sent])

    def test_a_device_has_several_lamps(self) -> None:
        told = blinkenlight.Data(0, 1.5, 0.5, common.Color(0, 1, 2, 3))
        client = self.connect(blinkenlight.DATA_STATE, told)
        lamps = client.blinkenlight(0)
        self.assertEqual(next(lamps.updates()), (False, 1.5, 0.5, (1, 2, 3), 2.5))
        lamps.set_color(GREEN, light=3)
        with self.assertRaises(InvalidValue):
            lamps.flash(float("inf"))
        client.close()
        self.assertEqual(self.commands(), [blinkenlight.CmdColor(3, common.Color(255, 0, 255, 0)).encode()])

    def test_a_blob_has_a_color_of_three_bytes(self) -> None:
        told = blobfinder.Data(160, 120, [blobfinder.Blob(4, 0x123456, 12, 1, 2, 3, 4, 5, 6, 0.0)])
        eye = self.connect(blobfinder.DATA_BLOBS, told).blobfinder(0)
        self.assertEqual(next(eye.updates()), [(4, (0x12, 0x34, 0x56), 12, 1, 2, 3, 4, 5, 6, 0.0)])
        self.assertEqual(eye.image_size, (160, 120))


if __name__ == "__main__":
    unittest.main()
