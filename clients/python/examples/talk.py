#!/usr/bin/env python3
"""Tells the other robots by radio where it is, twice a second, and prints what it hears of them.

    talk.py [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C)

Start it once for each robot that is to talk: it only looks at the robot, and whoever drives it goes on.
"""

from typing import List

from program import Clock, run

from playhouse_client import Access, Client

PERIOD = 0.5  # s, simulated


def talk(client: Client, index: int, clock: Clock, _: List[int]) -> None:
    with client.position2d(index, Access.READ) as robot, client.opaque(index) as radio:
        next_time = 0.0
        for state in robot.updates():
            if clock.up():
                break
            for message in radio.take_messages():
                print(f"{state.time:.1f} s: {message.decode(errors='replace')}", flush=True)
            if state.time >= next_time:
                radio.send(f"robot {index} is at {state.pose.x:.2f} {state.pose.y:.2f}".encode())
                next_time = state.time + PERIOD


if __name__ == "__main__":
    run(talk, "talk.py [HOST:PORT [INDEX [SECONDS]]]")
