"""The proxies that are written by hand: of a map, a planner and the simulation itself. The others are generated
(docs/adr/0029).

Reading a device's data never waits: it returns the data of the last Client.read(), and raises NoData before the
first data of the device. next_data() and updates() wait.
"""

import math
import struct
import zlib
from array import array
from typing import Iterator, List, Optional, Sequence, cast

from .convert import pose3d_of, pose_of
from .device import Device
from .errors import GoalRefused, RequestRefused, RunEnded, WireError
from .generated import common, planner, simulation
from .generated import map as grid_map
from .values import Grid, Path, PlannerState, Pose, Pose3d
from .wire import MessageType, Struct, c_string, text

_ENDED = "the run has ended"  # the server's reason to refuse a step then
_TILE = 512  # cells along a side of a tile of a map, so that any map fits into messages
_MOST_CELLS = 1 << 26  # of a map
_REFUSAL_PERIOD = 1.0  # of the server's time (s), between two questions of a refusal while there is a path
_STATES_UNDER_WAY = 2  # of another goal, after an answer


class Planner(Device):
    """A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront cancels the
    goal when the last one closes it."""

    _goal: Optional[Pose] = None

    @property
    def state(self) -> PlannerState:
        data, time = self._stamped(planner.DATA_STATE)
        return PlannerState(bool(data.valid), bool(data.done), pose_of(data.pos), pose_of(data.goal), pose_of(data.waypoint),
                            data.waypoint_idx, data.waypoints_count, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[PlannerState]:
        """Reads for ever: one PlannerState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    @property
    def arrived(self) -> bool:
        """Whether the last data say that the goal of the last go_to() is reached; data of another goal do not count."""
        data = cast(Optional[planner.Data], self.latest(planner.DATA_STATE))
        return data is not None and bool(data.done) and self._goal is not None and _same(pose_of(data.goal), self._goal)

    def go_to(self, x: float, y: float, a: float) -> None:
        """Plans a path to a pose on the map and drives there; after stop(), from resume() on."""
        self._insist_on_finite(x=x, y=y, a=a)
        self._goal = Pose(x, y, a)
        self.command(planner.CMD_GOAL, planner.Cmd(common.Pose2d(x, y, a)))

    def why_refused(self) -> str:
        """Requests why the planner does not drive to the goal of the last go_to(), as its log says; empty if it does, has
        arrived, has not planned yet, or is a driver that gives no reasons."""
        return self._why_refused()

    def drive_to(self, x: float, y: float, a: float, timeout: Optional[float] = None) -> PlannerState:
        """go_to(), and reads until the goal is reached. Raises GoalRefused as soon as why_refused() has a reason or the
        planner has another goal, as another client's, and RequestTimeout after `timeout` s without data."""
        self.go_to(x, y, a)
        asked, others = -math.inf, 0
        for state in self.updates(timeout):
            if self.arrived:
                break
            is_mine = self._goal is not None and _same(state.goal, self._goal)
            # Once a request was answered, which came after the goal, data of before it may still be on their way.
            others = 0 if is_mine or asked == -math.inf else others + 1
            if others > _STATES_UNDER_WAY:
                raise GoalRefused(f"{self._session.peer}: {self.name}: it has another goal, or no longer one")
            if state.valid and is_mine and asked <= state.time < asked + _REFUSAL_PERIOD:
                continue
            asked = state.time
            why = self.why_refused()
            if why:
                raise GoalRefused(f"{self._session.peer}: {self.name}: {why}")
        return state

    def stop(self) -> None:
        """Stops the robot until resume(); the planner keeps its goal."""
        self.request(planner.REQ_ENABLE, planner.EnableReq(0))

    def resume(self) -> None:
        """Ends stop()."""
        self.request(planner.REQ_ENABLE, planner.EnableReq(1))

    def path(self) -> Path:
        """The path as it was planned last; without waypoints if there is none."""
        answer = cast(planner.WaypointsReq, self._ask(planner.REQ_GET_WAYPOINTS))
        return Path([pose_of(one) for one in answer.waypoints], answer.waypoints_distance)


class Map(Device):
    """A grid map."""

    def grid(self) -> Grid:
        """Size and place of the map, without its cells. Raises WireError if the numbers are those of no map."""
        info = cast(grid_map.Info, self._ask(grid_map.REQ_GET_INFO))
        made = Grid(info.scale, info.width, info.height, pose_of(info.origin))
        if not (made.cell_size > 0.0 and all(map(math.isfinite, (made.cell_size, *made.origin)))):
            raise WireError(f"{self.name}: invalid map: cells of {made.cell_size} m from {tuple(made.origin)} on")
        return made

    def cells(self) -> List[Sequence[int]]:
        """The whole map, row by row from the bottom: cells()[row][column] is 1 if the cell is occupied, -1 if it is free, 0 if
        that is unknown. Raises WireError for a map of more than 2^26 cells, and for faulty answers."""
        grid = self.grid()
        if grid.width * grid.height > _MOST_CELLS:
            raise WireError(f"{self.name}: {grid.width} x {grid.height} cells are over the limit of {_MOST_CELLS}")
        rows: List[Sequence[int]] = []
        for row in range(0, grid.height if grid.width > 0 else 0, _TILE):
            rows += self._band(row, grid.width, min(_TILE, grid.height - row))
        return rows

    def _band(self, row: int, width: int, height: int) -> "List[array[int]]":
        """All cells of the rows from `row` on, as high as a tile."""
        rows = [array("b") for _ in range(height)]
        for column in range(0, width, _TILE):
            part = min(_TILE, width - column)
            cells = self._tile(column, row, part, height)
            for i in range(height):
                rows[i].extend(cells[i * part : (i + 1) * part])
        return rows

    def _tile(self, column: int, row: int, width: int, height: int) -> "array[int]":
        asked = grid_map.Data(column, row, width, height)
        tile = cast(grid_map.Data, self._ask(grid_map.REQ_GET_DATA, asked))
        values = _uncompressed(tile.data, width * height)
        if len(values) != width * height:
            raise WireError(f"{self.name}: a tile of {width} x {height} cells is damaged")
        return array("b", values.translate(_occupancies(tile.data_range)))


class Simulation(Device):
    """The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level model."""

    def pose(self, name: str) -> Pose:
        """Raises RequestRefused if there is no model of that name."""
        request = simulation.Pose2dReq(name=c_string(name))
        answer = cast(simulation.Pose2dReq, self._of_model(name, simulation.REQ_GET_POSE2D, request))
        return pose_of(answer.pose)

    def set_pose(self, name: str, x: float, y: float, a: float) -> None:
        self._insist_on_finite(x=x, y=y, a=a)
        request = simulation.Pose2dReq(c_string(name), common.Pose2d(x, y, a))
        self._of_model(name, simulation.REQ_SET_POSE2D, request)

    def pose3d(self, name: str) -> Pose3d:
        request = simulation.Pose3dReq(name=c_string(name))
        answer = cast(simulation.Pose3dReq, self._of_model(name, simulation.REQ_GET_POSE3D, request))
        return pose3d_of(answer.pose)

    def set_pose3d(self, name: str, pose: Pose3d) -> None:
        self._insist_on_finite(**Pose3d(*pose)._asdict())
        request = simulation.Pose3dReq(c_string(name), common.Pose3d(*pose))
        self._of_model(name, simulation.REQ_SET_POSE3D, request)

    def pause(self) -> None:
        """Pauses or resumes the clock."""
        self.command(simulation.CMD_PAUSE)

    def save(self) -> None:
        """Saves the current world to the file of `playhouse run --save-world`; without that option it has no
        effect."""
        self.command(simulation.CMD_SAVE)

    def reset(self, seed: Optional[int] = None) -> None:
        """Moves everything back to its pose in the world file, while time continues. With a seed the run restarts with
        that seed: at tick 0, with the initial models and their ids, and devices have no data until new ones arrive. That
        requires lock-step, else the server refuses: RequestRefused."""
        if seed is None:
            self.command(simulation.CMD_RESET)
            return
        self._insist_on_whole("seed", seed, 0, (1 << 64) - 1)
        self._of_world("reset", struct.pack("<Q", seed))
        self._client.forget_run()

    def join(self, name: str) -> None:
        """Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps.
        Open devices first. Raises RequestRefused with the reason."""
        self._of_world("join", c_string(name))

    def step(self, ticks: int = 1, timeout: Optional[float] = None) -> None:
        """Runs this number of ticks and waits until they are done, in lock-step until all members have requested them:
        at most `timeout` seconds, None: no limit. In push mode all data of the ticks have then been delivered to the
        devices, by multicast those that have arrived; in pull mode they are queued for read(). Without lock-step a running world refuses: pause() first."""
        self._insist_on_whole("ticks", ticks, 1, 1 << 20)
        self._of_world("step", struct.pack("<I", ticks), timeout=math.inf if timeout is None else timeout)
        self._client.deliver_pushed()

    def spawn(self, like: str, x: float, y: float, a: float, name: str = "") -> str:
        """Spawns a robot like the model `like` at a pose in the world (m, m, rad); returns its name."""
        self._insist_on_finite(x=x, y=y, a=a)
        value = struct.pack("<ddd", x, y, a) + (c_string(name) if name else b"")
        return text(self._of_world("spawn", value, like).value)

    def remove(self, name: str) -> None:
        """Removes a top-level model from the world, with its descendants."""
        self._of_world("remove", b"", name)

    def _of_world(
        self, prop: str, value: bytes, name: str = "", timeout: Optional[float] = None
    ) -> simulation.PropertyReq:
        request = simulation.PropertyReq(c_string(name), c_string(prop), 0, value)
        try:
            return cast(simulation.PropertyReq, self.request(simulation.REQ_SET_PROPERTY, request, timeout) or request)
        except RequestRefused as error:
            why = text(simulation.PropertyReq.decode(error.body).value) if error.body else "the server does not do that"
            if why == _ENDED:
                raise RunEnded(f"{self._session.peer}: {why}") from None
            raise RequestRefused(f"{self._session.peer}: {prop} was refused: {why}") from None

    def _of_model(self, name: str, message: MessageType, request: Struct) -> Optional[Struct]:
        try:
            return self.request(message, request)
        except RequestRefused:
            raise RequestRefused(f'{self._session.peer}: {message.name} of model "{name}" was refused') from None


def _same(one: Pose, other: Pose) -> bool:
    """Whether two poses are the same, whole turns aside, which drivers drop."""
    return one[:2] == other[:2] and abs(math.remainder(one.a - other.a, math.tau)) < 1e-6


def _uncompressed(data: bytes, count: int) -> bytes:
    """At most one byte more than `count`; the data themselves if they are not a zlib stream, as of a server without it."""
    try:
        return zlib.decompressobj().decompress(data, count + 1)
    except zlib.error:
        return data


def _occupancies(data_range: int) -> bytes:
    """For each byte of a map what it says as an int8: 1 and -1 beyond half of `data_range`, else 0."""
    twice = [2 * (byte - 256 if byte > 127 else byte) for byte in range(256)]
    limit = max(data_range, 1)
    return array("b", [(each > limit) - (each < -limit) for each in twice]).tobytes()
