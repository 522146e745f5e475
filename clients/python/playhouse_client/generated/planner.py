"""Interface planner, code 44. Plans and follows a path to a goal.

Generated from interfaces/044_planner.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 44


@dataclass
class Data(Struct):
    """Progress of the robot along its path. (player_planner_data_t)"""

    # 1 if there is a path to the goal.
    valid: int = 0
    # 1 if the goal is reached.
    done: int = 0
    # The robot (in m, m, rad, frame X_MR).
    pos: common.Pose2d = field(default_factory=common.Pose2d)
    # The goal (in m, m, rad, frame X_MG).
    goal: common.Pose2d = field(default_factory=common.Pose2d)
    # Current waypoint of the robot (in m, m, rad, frame X_MP).
    waypoint: common.Pose2d = field(default_factory=common.Pose2d)
    # Index of that waypoint in the path; -1 if there is none.
    waypoint_idx: int = 0
    # Number of waypoints of the path.
    waypoints_count: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.valid)
        writer.number("B", self.done)
        self.pos.write(writer)
        self.goal.write(writer)
        self.waypoint.write(writer)
        writer.number("i", self.waypoint_idx)
        writer.number("I", self.waypoints_count)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.valid = reader.number("B")
        self.done = reader.number("B")
        self.pos = common.Pose2d.read(reader)
        self.goal = common.Pose2d.read(reader)
        self.waypoint = common.Pose2d.read(reader)
        self.waypoint_idx = reader.number("i")
        self.waypoints_count = reader.number("I")
        return self


@dataclass
class Cmd(Struct):
    """A goal. (player_planner_cmd_t)"""

    # Goal pose (in m, m, rad, frame X_MG).
    goal: common.Pose2d = field(default_factory=common.Pose2d)

    def write(self, writer: Writer) -> None:
        self.goal.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.goal = common.Pose2d.read(reader)
        return self


@dataclass
class WaypointsReq(Struct):
    """The planned path. (player_planner_waypoints_req_t)"""

    # Length of the path (in m).
    waypoints_distance: float = 0.0
    # From the robot to the goal (in m, m, rad, frame X_MP).
    waypoints: List[common.Pose2d] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.number("d", self.waypoints_distance)
        writer.length("waypoints", len(self.waypoints), 1398099)
        writer.length("waypoints", len(self.waypoints), 1398099)
        for item in self.waypoints:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "WaypointsReq":
        self = cls()
        self.waypoints_distance = reader.number("d")
        waypoints_count = reader.number("I")
        waypoints_length = reader.length("waypoints", waypoints_count, 24)
        self.waypoints = [common.Pose2d.read(reader) for _ in range(waypoints_length)]
        return self


@dataclass
class EnableReq(Struct):
    """The planner's switch. (player_planner_enable_req_t)"""

    # 1: may move, 0: stop.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "EnableReq":
        self = cls()
        self.state = reader.number("B")
        return self


# Progress of the robot along its path.
DATA_STATE = MessageType(44, Kind.DATA, 1, "planner.data.state", Data)
# Sets the goal.
CMD_GOAL = MessageType(44, Kind.CMD, 1, "planner.cmd.goal", Cmd)
# Sets the goal and starts to move.
CMD_START = MessageType(44, Kind.CMD, 2, "planner.cmd.start", Cmd)
# Requests the planned path.
REQ_GET_WAYPOINTS = MessageType(44, Kind.REQ, 1, "planner.req.get_waypoints", WaypointsReq)
# Enables or stops the robot.
REQ_ENABLE = MessageType(44, Kind.REQ, 2, "planner.req.enable", EnableReq)
