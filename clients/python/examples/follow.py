#!/usr/bin/env python3
"""Follows a marker and keeps a metre away from it.

    follow.py [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]

Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any number),
seen by the fiducial finder FINDER (INDEX).
"""

from typing import List, Optional

from program import Clock, run

from playhouse_client import Client, Marker

DISTANCE = 1.0  # m
SPEED = 0.5  # m/s
TURN = 1.0  # rad/s


def follow(client: Client, index: int, clock: Clock, more: List[int]) -> None:
    wanted = more[0] if more else None
    with client.position2d(index) as robot, client.fiducial(more[1] if len(more) > 1 else index) as finder:
        lost_to_the_left = True
        for markers in finder.updates():
            if clock.up():
                break
            marker = choose(markers, wanted)
            if marker is None:
                # Marker lost: search, turning first to the side where it was last seen.
                robot.drive(0.0, TURN / 2 if lost_to_the_left else -TURN / 2)
                continue
            lost_to_the_left = marker.bearing > 0
            speed = max(-SPEED, min(SPEED, marker.distance - DISTANCE))
            turn = max(-TURN, min(TURN, 2.0 * marker.bearing))
            robot.drive(speed if abs(marker.bearing) < 1.0 else 0.0, turn)


def choose(markers: List[Marker], wanted: Optional[int]) -> Optional[Marker]:
    """The nearest marker of the wanted number."""
    fitting = [marker for marker in markers if wanted is None or marker.id == wanted]
    return min(fitting, key=lambda marker: marker.distance, default=None)


if __name__ == "__main__":
    run(follow, "follow.py [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]")
