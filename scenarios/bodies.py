"""Robots and scripted people as clients: detection of unmapped objects by laser, and path following."""

import math
from typing import Iterable, List, Optional

from ground import Ground, Point, distance

_CANDIDATES = [math.radians(degrees) for degrees in range(-90, 91, 10)]
_WIDTH = 0.35      # m, half width of the corridor that a robot needs
_STOP = 0.55       # m, stopping distance from obstacles
_ARRIVED = 0.35    # m, tolerance at a waypoint
_FAR = 7.9         # m; a SICK laser reports 8 without a hit


def turn_to(angle: float) -> float:
    """The angle in (-pi, pi]."""
    return math.atan2(math.sin(angle), math.cos(angle))


class Guide:
    """Path follower; replans when the goal has moved by more than half a metre."""

    def __init__(self, ground: Ground) -> None:
        self._ground = ground
        self._goal: Optional[Point] = None
        self._way: List[Point] = []

    def next(self, at: Point, goal: Point) -> Point:
        """Next waypoint from `at` to `goal`."""
        if self._goal is None or distance(goal, self._goal) > 0.5:
            self._goal, self._way = goal, self._ground.way(at, goal)
        while len(self._way) > 1 and distance(at, self._way[0]) < _ARRIVED:
            self._way.pop(0)
        return self._way[0] if self._way else goal

    def forget(self) -> None:
        self._goal = None


class LaserRobot:
    """A robot with a laser, a known pose and a map of fixed obstacles. It avoids obstacles by its own scans."""

    def __init__(self, client, name: str, ground: Ground) -> None:
        robot = client.robot(name)
        self.name = name
        self.base, self.laser = robot.position2d, robot.laser
        self.voice = robot.device("speech")
        self.guide = Guide(ground)
        self._ground = ground

    @property
    def at(self) -> Point:
        pose = self.base.pose
        return pose.x, pose.y

    def look(self) -> None:
        """Reads the newest scan: `points` in the robot's frame, `points_W` in the world frame."""
        pose = self.base.pose
        c, s = math.cos(pose.a), math.sin(pose.a)
        scan = self.laser.scan()
        self.points = [(r * math.cos(a), r * math.sin(a)) for r, a in zip(scan.ranges, scan.angles) if 0.05 < r < _FAR]
        self.points_W = [(pose.x + c * x - s * y, pose.y + s * x + c * y) for x, y in self.points]

    def strangers(self, known: Iterable[Point], widest: float) -> List[Point]:
        """Centres of detected objects up to `widest` m wide that are neither on the map nor near a point of `known`."""
        near = [thing.grown(0.25) for thing in self._ground.things]
        clusters: List[List[Point]] = []
        for p in self.points_W:
            if any(r.holds(p) for r in near) or any(distance(p, k) < 0.7 for k in known):
                continue
            if clusters and distance(clusters[-1][-1], p) < 0.35:
                clusters[-1].append(p)
            else:
                clusters.append([p])
        return [
            (sum(x for x, _ in c) / len(c), sum(y for _, y in c) / len(c))
            for c in clusters
            if len(c) > 1 and distance(c[0], c[-1]) <= widest
        ]

    def go(self, goal: Point, speed: float, ignore: Optional[Point] = None) -> None:
        """Drives to `goal` along a planned path, and avoids detected obstacles except those within 0.6 m of `ignore`."""
        pose = self.base.pose
        step = self.guide.next(self.at, goal)
        wanted = turn_to(math.atan2(step[1] - pose.y, step[0] - pose.x) - pose.a)
        ahead = [p for p, w in zip(self.points, self.points_W) if ignore is None or distance(w, ignore) > 0.6]
        if abs(wanted) > math.radians(100):  # behind it, outside the field of view
            return self.base.drive(0.0, math.copysign(1.0, wanted))
        heading = min(_CANDIDATES, key=lambda h: abs(turn_to(h - wanted)) + 3 * max(0.0, 1 - _clear(ahead, h)))
        room = _clear(ahead, heading) - _STOP
        forward = max(0.0, min(speed, room, distance(self.at, step))) * max(0.0, math.cos(heading))
        self.base.drive(forward, max(-1.2, min(1.2, 2 * heading if forward > 0.02 or abs(heading) > 0.1 else 0.8)))

    def say(self, words: str) -> None:
        say(self.voice, words)


def _clear(points: List[Point], heading: float) -> float:
    """Free distance along a heading, at most 2 m."""
    c, s = math.cos(heading), math.sin(heading)
    clear = 2.0
    for x, y in points:
        ahead = c * x + s * y
        if 0 < ahead < clear and abs(c * y - s * x) < _WIDTH:
            clear = ahead
    return clear


class StandIn:
    """A scripted person, with ground-truth perception in place of sensors."""

    def __init__(self, client, name: str, ground: Ground) -> None:
        robot = client.robot(name)
        self.name = name
        self.base = robot.position2d
        self.guide = Guide(ground)

    def walk(self, goal: Point, speed: float) -> None:
        pose = self.base.pose
        at = (pose.x, pose.y)
        step = self.guide.next(at, goal)
        left = distance(at, step)
        if left < 0.1:
            return self.base.drive(0.0, 0.0)
        heading = turn_to(math.atan2(step[1] - at[1], step[0] - at[0]) - pose.a)
        speed = min(speed, 2 * left) * max(0.0, math.cos(heading))
        self.base.drive(speed, max(-3.0, min(3.0, 4 * heading)))

    def stand(self) -> None:
        self.base.drive(0.0, 0.0)


def say(voice, words: str) -> None:
    """Says a line by a device of the speech interface."""
    from playhouse_client.generated import speech

    voice.command(speech.CMD_SAY, speech.Cmd(words.encode() + b"\0"))
