#!/usr/bin/env python3
"""Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.

    navigate.py [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is done)
"""

from typing import List

from program import Clock, run

from playhouse_client import Client, Pose

PLACES = [Pose(6.0, 4.0, 1.5), Pose(-5.8, 5.0, 3.0)]  # m, m, rad


def navigate(client: Client, index: int, clock: Clock, _: List[int]) -> None:
    with client.planner(index) as planner:
        for place in PLACES:
            planner.go_to(*place)
            for state in planner.updates():
                if clock.up():
                    return
                if planner.arrived:
                    print(f"arrived at ({state.pose.x:.2f}, {state.pose.y:.2f}) m", flush=True)
                    break


if __name__ == "__main__":
    run(navigate, "navigate.py [HOST:PORT [INDEX [SECONDS]]]")
