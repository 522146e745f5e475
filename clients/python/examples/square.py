#!/usr/bin/env python3
"""Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.

    square.py [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)
"""

import math
from typing import List

from program import Clock, run

from playhouse_client import Client, Pose

SIDE = 1.5  # m
REACHED = 0.03  # m
ALIGNED = 0.02  # rad
SPEED = 0.4  # m/s
TURN = 1.0  # rad/s


def square(client: Client, index: int, clock: Clock, _: List[int]) -> None:
    with client.position2d(index) as robot:
        robot.next_data()
        start = robot.pose
        corners = [(SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE), (0.0, 0.0)]
        for state in robot.updates():
            if clock.up() or not corners:
                break
            here = seen_from(start, state.pose)
            ahead, left = corners[0][0] - here.x, corners[0][1] - here.y
            if math.hypot(ahead, left) < REACHED:
                print(f"corner {4 - len(corners) + 1} at ({here.x:.2f}, {here.y:.2f}) m")
                corners.pop(0)
                robot.stop()
                continue
            aside = normalized(math.atan2(left, ahead) - here.a)
            turn = max(-TURN, min(TURN, 2.0 * aside))
            if abs(aside) > 0.15:
                robot.drive(0.0, turn)
            else:
                robot.drive(min(SPEED, max(0.05, math.hypot(ahead, left))), turn)
        for state in robot.updates():
            aside = normalized(start.a - state.pose.a)
            if clock.up() or abs(aside) < ALIGNED:
                break
            robot.drive(0.0, max(-TURN, min(TURN, 2.0 * aside)))


def seen_from(origin: Pose, pose: Pose) -> Pose:
    """The same place in the frame of `origin`."""
    dx, dy = pose.x - origin.x, pose.y - origin.y
    c, s = math.cos(origin.a), math.sin(origin.a)
    return Pose(c * dx + s * dy, c * dy - s * dx, normalized(pose.a - origin.a))


def normalized(angle: float) -> float:
    return math.atan2(math.sin(angle), math.cos(angle))


if __name__ == "__main__":
    run(square, "square.py [HOST:PORT [INDEX [SECONDS]]]")
