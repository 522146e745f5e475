"""People and robots search a building for lost parcels, together.

    python3 scenarios/search/search.py                       # people join in the page
    python3 scenarios/search/search.py --stand-ins 2 --fast  # a script plays them

The seed determines the positions of the parcels. A robot finds a parcel by laser within 1.5 m, unless a member of the team is
there; a person finds one by standing within 1 m of it. Found parcels are removed. Rooms are claimed, so that none is searched
twice; the run ends when all parcels are found.
"""

import math
import pathlib
import sys
from typing import Any, Dict, List, Optional

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from bodies import LaserRobot, StandIn, say  # noqa: E402
from experiment import REFEREE, Experiment, main  # noqa: E402
from ground import Ground, Point, Rect, distance, read_things  # noqa: E402

WORLD = HERE / "building.world"
ROOMS = {
    f"{side} {place}": Rect(x, y, x + 4.6, y + 3.8)
    for side, y in (("north", 1.1), ("south", -4.9))
    for place, x in (("west", -6.9), ("middle", -2.3), ("east", 2.3))
}
PARCELS = [f"parcel{i}" for i in range(6)]
ENTRANCE = (-9.0, 0.0)
NAMES = ["ann", "bo"]
FOUND_BY_ROBOT, FOUND_BY_PERSON = 1.5, 1.0   # m
MISTAKEN = 0.4            # m, maximum distance between a detection and a parcel
FROM_WALLS = 0.7          # m, minimum distance of parcels from walls
NOTICED = 3.0             # m, range at which a stand-in detects a parcel
ROBOT_SPEED, WALK_SPEED = 0.8, 0.7           # m/s
LOOK_ROUND = 0.8          # rad/s


def middle(room: Rect) -> Point:
    return (room.x0 + room.x1) / 2, (room.y0 + room.y1) / 2


class Plan:
    """The rooms that are neither searched nor claimed."""

    def __init__(self, ground: Ground) -> None:
        self._ground = ground
        self._left = dict(ROOMS)

    def claim(self, at: Point) -> Optional[str]:
        """Claims the nearest unclaimed room by path length; None if all are searched or claimed."""
        name = min(self._left, key=lambda room: self._length(at, middle(self._left[room])), default=None)
        if name:
            del self._left[name]
        return name

    def _length(self, a: Point, b: Point) -> float:
        way = [a, *self._ground.way(a, b)]
        return sum(distance(p, q) for p, q in zip(way, way[1:])) if len(way) > 1 else math.inf


class Searcher(LaserRobot):
    """Drives to the middle of a room, turns once, and approaches possible parcels."""

    def __init__(self, client: Any, name: str, ground: Ground) -> None:
        super().__init__(client, name, ground)
        self.room: Optional[str] = None
        self._turned = 0.0

    def act(self, seen: Optional[Point], plan: Plan, seconds: float) -> None:
        if seen:
            return self.go(seen, ROBOT_SPEED, ignore=seen)
        if self.room is None:
            self.room, self._turned = plan.claim(self.at), 0.0
        if self.room is None:
            return self.base.drive(0.0, 0.0)
        if distance(self.at, middle(ROOMS[self.room])) > 0.6:
            return self.go(middle(ROOMS[self.room]), ROBOT_SPEED)
        self.base.drive(0.0, LOOK_ROUND)
        self._turned += LOOK_ROUND * seconds
        if self._turned > 2 * math.pi:
            self.say(f"{self.room} is searched")
            self.room = None


class Walker(StandIn):
    """Walks from room to room, and to visible parcels."""

    room: Optional[str] = None

    def act(self, at: Point, seen: Optional[Point], plan: Plan) -> None:
        if seen:
            return self.walk(seen, WALK_SPEED)
        if self.room and distance(at, middle(ROOMS[self.room])) < 0.5:
            self.room = None
        self.room = self.room or plan.claim(at)
        self.walk(middle(ROOMS[self.room]) if self.room else ENTRANCE, WALK_SPEED)


class Search(Experiment):
    name = "search"
    robot_names = ["robot0", "robot1"]

    def prepare(self) -> None:
        self.ground = Ground(list(read_things(WORLD, "wall").values()), 0.42)
        self.plan = Plan(self.ground)
        self.robots = [Searcher(self.client, name, self.ground) for name in self.robot_names]
        self.referee = self.client.robot(REFEREE).device("speech")
        self.parcels: Dict[str, Point] = {}
        for name in PARCELS:
            self.parcels[name] = self._lose(name)
        self.found: Dict[str, int] = {robot.name: 0 for robot in self.robots}
        self.mistakes: List[Point] = []   # false detections of robots
        self.walkers = {}
        for i, name in enumerate(self.stand_in_names):
            self.world.spawn(REFEREE, ENTRANCE[0] - 1, ENTRANCE[1] + 0.8 * i, 0.0, name)
            self.walkers[name] = Walker(self.client, name, self.ground)

    def arrived(self, person: str) -> None:
        self.found.setdefault(person, 0)
        if person not in self.walkers:
            self.world.set_pose(person, ENTRANCE[0] - 1, ENTRANCE[1] - 1, 0.0)

    def tick(self) -> bool:
        for parcel in self.parcels:   # people may kick them
            pose = self.world.pose(parcel)
            self.parcels[parcel] = (pose.x, pose.y)
        for robot in self.robots:
            robot.look()
            seen = self._seen_by(robot)
            if seen and distance(robot.at, seen) < FOUND_BY_ROBOT:
                self._take_up(robot, seen)
                seen = None
            robot.act(seen, self.plan, 0.1)
        for person, at in self.people.items():
            seen = self._seen_from(at)
            if seen and distance(at, self.parcels[seen]) < FOUND_BY_PERSON:
                self._find(seen, person)
            elif person in self.walkers:
                self.walkers[person].act(at, self.parcels[seen] if seen else None, self.plan)
        return bool(self.parcels)

    def score(self) -> Dict[str, Any]:
        return {
            "found": len(PARCELS) - len(self.parcels), "of": len(PARCELS), "mistakes": len(self.mistakes),
            "by": self.found,
        }

    def _lose(self, name: str) -> Point:
        """Places a parcel in a room, at least half a metre from others."""
        while True:
            room = ROOMS[self.random.choice(sorted(ROOMS))].grown(-FROM_WALLS)
            place = (self.random.uniform(room.x0, room.x1), self.random.uniform(room.y0, room.y1))
            if all(distance(place, other) > 0.5 for other in self.parcels.values()):
                self.world.set_pose(name, *place, 0.0)
                return place

    def _seen_by(self, robot: Searcher) -> Optional[Point]:
        team = [other.at for other in self.robots if other is not robot] + list(self.people.values())
        strangers = robot.strangers(team + self.mistakes, widest=0.5)
        inside = [p for p in strangers if any(room.grown(-0.2).holds(p) for room in ROOMS.values())]
        return min(inside, key=lambda p: distance(robot.at, p), default=None)

    def _seen_from(self, at: Point) -> Optional[str]:
        near = [name for name, p in self.parcels.items() if distance(at, p) < NOTICED and self.ground.sees(at, p)]
        return min(near, key=lambda name: distance(at, self.parcels[name]), default=None)

    def _take_up(self, robot: Searcher, seen: Point) -> None:
        parcel = min(self.parcels, key=lambda name: distance(self.parcels[name], seen), default=None)
        if parcel and distance(self.parcels[parcel], seen) < MISTAKEN:
            return self._find(parcel, robot.name)
        self.mistakes.append(seen)
        self.tell("took something else for a parcel", robot.name)

    def _find(self, parcel: str, who: str) -> None:
        self.found[who] += 1
        del self.parcels[parcel]
        self.world.remove(parcel)
        self.tell("found", who, what=parcel)
        say(self.referee, f"{who} found {parcel}, {len(self.parcels)} to go")


if __name__ == "__main__":
    main(Search, WORLD, __doc__.splitlines()[0], NAMES, 300)
