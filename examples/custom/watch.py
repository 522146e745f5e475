"""Opens the gate of yard.world and drives up to the screen: the count rate rises.

    python3 watch.py 127.0.0.1:6665
"""

import sys

import playhouse_client

with playhouse_client.connect(*sys.argv[1:2]) as client:
    rover, gate = client.robot("rover"), client.robot("gate")
    counter, bar, base = rover.aio, gate.aio, rover.position2d
    bar.set(0, 1)
    for angle, blocked in bar.updates():
        if angle > 1.39:
            break
    print("the gate is open")
    base.drive(0.5)
    for counts, total, sources in counter.updates():
        x = base.state.pose.x
        print(f"{x:5.2f} m ahead: {counts:3.0f} counts, {total:4.0f} in all")
        if x > 2.5:
            break
    base.stop()
