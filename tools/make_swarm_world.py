#!/usr/bin/env python3
"""Prints worlds/swarm.world: hundreds of small robots, packed like the seeds of a sunflower, that spread out."""

import argparse
import colorsys
import math

HEAD = """\
# {count} small robots start packed like the seeds of a sunflower and spread out until each has room.
# Written by tools/make_swarm_world.py; change that, not this.
#
#   playhouse run worlds/swarm.world

name "swarm"

window( center [0 0] rotate [40 0] scale {scale:.1f} show_data 0 )

define wall model ( color "DimGray" gui_move 0 )
wall( pose [ 0.000 {at:6.3f} 0 0] size [{long:.3f} 0.200 0.300] )
wall( pose [ 0.000 {minus:6.3f} 0 0] size [{long:.3f} 0.200 0.300] )
wall( pose [{at:6.3f}  0.000 0 0] size [0.200 {side:.3f} 0.300] )
wall( pose [{minus:6.3f}  0.000 0 0] size [0.200 {side:.3f} 0.300] )

# Twelve infrared sensors all round, two metres far.
define eye sensor ( range [0 2.000] fov 30 samples 1 color_rgba [1 0.300 0.200 0.080] )
define seed position
(
  size [0.160 0.160 0.100]
  block
  (
    points 8
    point[0] [ 2  1]  point[1] [ 1  2]  point[2] [-1  2]  point[3] [-2  1]
    point[4] [-2 -1]  point[5] [-1 -2]  point[6] [ 1 -2]  point[7] [ 2 -1]
    z [0 1]
  )
  ranger
  (
    pose [0 0 -0.050 0]
    size [0 0 0]
    eye( pose [0 0 0   0] ) eye( pose [0 0 0  30] ) eye( pose [0 0 0  60] ) eye( pose [0 0 0  90] )
    eye( pose [0 0 0 120] ) eye( pose [0 0 0 150] ) eye( pose [0 0 0 180] ) eye( pose [0 0 0 210] )
    eye( pose [0 0 0 240] ) eye( pose [0 0 0 270] ) eye( pose [0 0 0 300] ) eye( pose [0 0 0 330] )
  )
  ctrl "expand_swarm"
  trail_length 100
)

"""


def robots(text):
    count = int(text)
    if count < 1:
        raise ValueError(text)
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog="example: tools/make_swarm_world.py > worlds/swarm.world")
    parser.add_argument("robots", metavar="ROBOTS", nargs="?", type=robots, default=400, help="how many, 1 or more (%(default)s)")
    count = parser.parse_args().robots
    side = 1.1 * math.sqrt(count)
    at = side / 2 + 0.1
    print(HEAD.format(count=count, scale=900 / side, at=at, minus=-at, long=side + 0.4, side=side), end="")
    for k in range(count):
        turn = k * math.pi * (3 - math.sqrt(5))
        radius = 0.19 * math.sqrt(k + 0.5)
        red, green, blue = colorsys.hsv_to_rgb(math.sqrt(k / count), 0.75, 0.95)
        print(f'seed( name "s{k}" pose [{radius * math.cos(turn):.3f} {radius * math.sin(turn):.3f} 0 '
              f'{math.degrees(turn) % 360:.1f}] color_rgba [{red:.3f} {green:.3f} {blue:.3f} 1] )')


if __name__ == "__main__":
    main()
