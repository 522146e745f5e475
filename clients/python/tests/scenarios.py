"""What the programs behind the recorded sessions did, done with this package.

Run as a program it plays one: scenarios.py NAME HOST:PORT. Its twin is clients/cpp/tests/scenarios.cc.
"""

import sys
from typing import Callable, Dict

import package  # noqa: F401
import playhouse_client
from playhouse_client import Client, Mode, RequestRefused, Rule
from playhouse_client.generated import common, laser, map, ranger

PI = 3.141592653589793


def reads(client: Client, count: int) -> None:
    for _ in range(count):
        client.read()


def print_position(address: str) -> None:
    """playerprint -r 5 -c 3 position2d"""
    with playhouse_client.connect(address) as client:
        with client.position2d(0):
            client.set_mode(Mode.PULL)
            client.set_replace_rule(Rule.ACCEPT)
            reads(client, 3)


def print_defaults(address: str) -> None:
    """playerprint -c 2 position2d"""
    with playhouse_client.connect(address) as client:
        with client.position2d(0):
            reads(client, 2)


def check_position(address: str) -> None:
    """the original test program, position2d"""
    with playhouse_client.connect(address) as client:
        with client.position2d(0) as robot:
            reads(client, 23)
            robot.set_odometry(0.1, -0.2, PI)
            reads(client, 10)
            robot.set_odometry(0.0, 0.0, 0.0)
            robot.set_motor_power(True)
            robot.drive(0.1)
            robot.drive(-0.1)
            robot.drive(0.0, vy=0.1)
            robot.drive(0.0, vy=-0.1)
            robot.drive(0.0, va=-25 * PI / 180)
            robot.drive(0.0, va=25 * PI / 180)
            robot.drive(0.0, vy=0.1, va=45 * PI / 180)
            robot.drive(0.0, vy=-0.1, va=-45 * PI / 180)
            robot.stop()
            robot.set_motor_power(False)
            robot.set_odometry(0.0, 0.0, 0.0)


def check_laser(address: str) -> None:
    """the original test program, laser: it ends at the refusal"""
    with playhouse_client.connect(address) as client:
        with client.laser(0) as scanner:
            reads(client, 20)
            refused(lambda: scanner.set_config(laser.Config(-PI / 2, PI / 2, 100.0, 0.0, 1.0, 1, 10.0)))


def check_ranger(address: str) -> None:
    """the original test program, ranger"""
    with playhouse_client.connect(address) as client:
        with client.ranger(1) as scanner:
            reads(client, 60)
            scanner.request(ranger.REQ_GET_GEOM)
            reads(client, 3)


def ask_map(address: str) -> None:
    with playhouse_client.connect(address, mode=Mode.PUSH) as client:
        with client.device("map", 0) as device:
            device.request(map.REQ_GET_INFO)
            device.request(map.REQ_GET_DATA, map.Data(col=0, row=0, width=20, height=10))
            device.request(map.REQ_GET_DATA, map.Data(col=495, row=0, width=50, height=3))
            refused(lambda: device.request(map.REQ_GET_VECTOR))


def ask_simulation(address: str) -> None:
    with playhouse_client.connect(address, mode=Mode.PUSH) as client:
        with client.simulation(0) as simulator:
            simulator.pose("r0")
            simulator.set_pose("r0", -6.0, -6.0, 0.5)
            refused(lambda: simulator.pose("nosuch"))
            simulator.pose3d("r0")


def ask_properties(address: str) -> None:
    with playhouse_client.connect(address, mode=Mode.PUSH) as client:
        lights, stream = client.device("dio", 0), client.device("opaque", 1)
        lights.get_property("skip_lines", int)
        lights.set_property("skip_lines", 7)
        lights.get_property("skip_lines", int)
        lights.get_property("max_diff_pixels", float)
        lights.set_property("max_diff_pixels", 0.25)
        lights.get_property("max_diff_pixels", float)
        lights.get_property("max_diff_pixels", int)
        refused(lambda: lights.get_property("nope", int))
        lights.has_capability(common.REQ_CAPABILITIES)
        stream.get_property("ip", str)
        stream.set_property("ip", "127.0.0.2")
        stream.get_property("ip", str)
        refused(lambda: stream.get_property("nobool", bool))


def refused(action: Callable[[], object]) -> None:
    try:
        action()
    except RequestRefused:
        return
    raise AssertionError("the server should have refused this")


SCENARIOS: Dict[str, Callable[[str], None]] = {
    "05_playerprint_position2d": print_position,
    "06_playerprint_defaults": print_defaults,
    "10_cxxtest_position2d": check_position,
    "11_cxxtest_laser": check_laser,
    "12_cxxtest_ranger": check_ranger,
    "13_raw_map": ask_map,
    "14_raw_simulation": ask_simulation,
    "15_raw_properties": ask_properties,
}

if __name__ == "__main__":
    SCENARIOS[sys.argv[1]](sys.argv[2])
