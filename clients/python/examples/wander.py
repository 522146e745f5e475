#!/usr/bin/env python3
"""Wanders about by laser and runs into nothing.

    wander.py [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)
"""

from typing import List

from program import Clock, run

from playhouse_client import Client

SPEED = 0.4  # m/s
TURN = 0.8  # rad/s
FRONT = 0.5  # rad to either side that the robot needs to pass
NEAR = 0.6  # m


def wander(client: Client, index: int, clock: Clock, _: List[int]) -> None:
    with client.position2d(index) as robot, client.laser(index) as laser:
        turning = 0.0
        for scan in laser.updates():
            if clock.up():
                break
            ahead = scan.nearest(-FRONT, FRONT)
            left, right = scan.nearest(FRONT, 1.5), scan.nearest(-1.5, -FRONT)
            if ahead < NEAR:
                turning = turning or (TURN if left > right else -TURN)  # latched until the way ahead is clear
                robot.drive(0.0, turning)
            else:
                turning = 0.0
                sway = 0.5 * (left - right) if min(left, right) < NEAR else 0.0
                robot.drive(min(SPEED, ahead - NEAR + 0.1), max(-TURN, min(TURN, sway)))


if __name__ == "__main__":
    run(wander, "wander.py [HOST:PORT [INDEX [SECONDS]]]")
