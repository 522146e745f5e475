"""Robots guard a fenced yard by lidar, people try to reach the cargo in its middle.

    python3 scenarios/perimeter/perimeter.py                       # people join in the page
    python3 scenarios/perimeter/perimeter.py --stand-ins 3 --fast  # a script plays them

A person within 1.3 m of the cargo's centre scores for the intruders. A person detected by a robot's laser within 1.5 m is
caught and scores for the guards. In both cases the person restarts outside the fence.
"""

import pathlib
import sys
from typing import Any, Dict, List, Optional

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from bodies import LaserRobot, StandIn, say  # noqa: E402
from experiment import REFEREE, Experiment, main  # noqa: E402
from ground import Ground, Point, Rect, distance, read_things  # noqa: E402

WORLD = HERE / "yard.world"
YARD = Rect(-10, -8, 10, 8)
CARGO = (0.0, 0.0)
REACHED, CAUGHT = 1.3, 1.5   # m
MISTAKEN = 0.8               # m, maximum distance between a detection and a person
PATROLS = {
    "guard0": [(6.0, 6.0), (-6.0, 6.0)], "guard1": [(-8.0, 3.0), (-4.5, -6.0)], "guard2": [(8.0, -3.0), (2.0, -6.0)],
}
GAPS = [(5.0, 8.0), (-5.0, -8.0), (-10.0, 3.0), (10.0, -3.0)]
OUTSIDE = [(5.0, 11.0), (-5.0, -11.0), (-13.0, 3.0), (13.0, -3.0)]
NAMES = ["ann", "bo", "cy", "di"]
PATROL_SPEED, CHASE_SPEED, SNEAK_SPEED, RUN_SPEED = 0.5, 0.9, 1.0, 1.6  # m/s
FRIGHT = 2.2                 # m, distance of a robot at which a stand-in flees
REST = 3.0                   # s outside before a stand-in tries again


class Guard(LaserRobot):
    """Patrols between its points; pursues the nearest of those detections of all guards to which it is the nearest guard."""

    def __init__(self, client: Any, name: str, ground: Ground) -> None:
        super().__init__(client, name, ground)
        self._patrol, self._next = PATROLS[name], 0

    def act(self, target: Optional[Point]) -> None:
        if target:
            return self.go(target, CHASE_SPEED, ignore=target)
        if distance(self.at, self._patrol[self._next]) < 0.6:
            self._next = (self._next + 1) % len(self._patrol)
        self.go(self._patrol[self._next], PATROL_SPEED)


class Intruder(StandIn):
    """Walks through a gap to the cargo, flees when a robot is near, and then tries another gap."""

    def __init__(self, client: Any, name: str, ground: Ground, start: int) -> None:
        super().__init__(client, name, ground)
        self.rests_until, self.gap, self.is_running = 0.0, start, False

    def act(self, at: Point, guards: List[Point], time: float, choose: Any) -> None:
        near = min(distance(at, guard) for guard in guards)
        if YARD.holds(at) and near < FRIGHT:
            self.is_running = True
        if self.is_running:
            self.walk(OUTSIDE[self.gap], RUN_SPEED)
            if YARD.grown(1).holds(at):
                return
            self.send_out(time, choose)
        if time < self.rests_until:
            return self.stand()
        self.walk(CARGO if YARD.holds(at) or distance(at, GAPS[self.gap]) < 1 else GAPS[self.gap], SNEAK_SPEED)

    def send_out(self, time: float, choose: Any) -> None:
        self.is_running, self.rests_until = False, time + REST
        self.gap = choose(range(len(GAPS)))
        self.guide.forget()


class Perimeter(Experiment):
    name = "perimeter"
    robot_names = list(PATROLS)

    def prepare(self) -> None:
        things = list(read_things(WORLD, "fence", "hedge", "cargo").values())
        ground = Ground(things, 0.45)
        self.guards = [Guard(self.client, name, ground) for name in PATROLS]
        self.referee = self.client.robot(REFEREE).device("speech")
        self.intruders = {}
        for i, name in enumerate(self.stand_in_names):
            x, y = OUTSIDE[i]
            self.world.spawn(REFEREE, x, y, 0.0, name)
            self.intruders[name] = Intruder(self.client, name, ground, i)
        self.caught: Dict[str, int] = {}
        self.reached: Dict[str, int] = {}

    def arrived(self, person: str) -> None:
        self.caught.setdefault(person, 0)
        self.reached.setdefault(person, 0)
        if person not in self.intruders:
            self._send_out(person)

    def tick(self) -> bool:
        for guard in self.guards:
            guard.look()
        places = [guard.at for guard in self.guards]
        seen = [self._seen_by(guard, places) for guard in self.guards]
        for guard, strangers in zip(self.guards, seen):
            self._catch(guard, strangers)
        self._count_reached()
        targets = [p for strangers in seen for p in strangers]
        for guard in self.guards:
            guard.act(self._target_of(guard, targets, places))
        for name, intruder in self.intruders.items():
            if name in self.people:
                intruder.act(self.people[name], places, self.time, self.random.choice)
        return True

    def score(self) -> Dict[str, Any]:
        return {
            "guards": sum(self.caught.values()), "intruders": sum(self.reached.values()),
            "people": {who: {"caught": self.caught[who], "reached": self.reached[who]} for who in self.caught},
        }

    @staticmethod
    def _seen_by(guard: Guard, places: List[Point]) -> List[Point]:
        others = [p for p in places if p != guard.at]
        return [p for p in guard.strangers(others, widest=0.9) if YARD.holds(p)]

    @staticmethod
    def _target_of(guard: Guard, targets: List[Point], places: List[Point]) -> Optional[Point]:
        """The nearest target to which no other guard is nearer."""
        own = [t for t in targets if distance(guard.at, t) <= min(distance(p, t) for p in places)]
        return min(own, key=lambda t: distance(guard.at, t), default=None)

    def _catch(self, guard: Guard, strangers: List[Point]) -> None:
        for p in strangers:
            if distance(guard.at, p) > CAUGHT:
                continue
            for person, at in self.people.items():
                if distance(at, p) < MISTAKEN:
                    self.caught[person] += 1
                    self.tell("was caught", person, by=guard.name)
                    guard.say(f"caught {person}")
                    self._begin_again(person)
                    break

    def _count_reached(self) -> None:
        for person, at in self.people.items():
            if distance(at, CARGO) < REACHED:
                self.reached[person] += 1
                self.tell("reached the cargo", person)
                self._begin_again(person)

    def _begin_again(self, person: str) -> None:
        self._send_out(person)
        if person in self.intruders:
            self.intruders[person].send_out(self.time, self.random.choice)
        score = self.score()
        say(self.referee, f"guards {score['guards']}, intruders {score['intruders']}")

    def _send_out(self, person: str) -> None:
        place = OUTSIDE[list(self.caught).index(person) % len(OUTSIDE)]
        self.people[person] = place
        self.world.set_pose(person, *place, 0.0)


if __name__ == "__main__":
    main(Perimeter, WORLD, __doc__.splitlines()[0], NAMES, 180)
