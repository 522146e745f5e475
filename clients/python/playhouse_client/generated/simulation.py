"""Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it.

Generated from interfaces/031_simulation.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 31


@dataclass
class Data(Struct):
    """Not sent by any message. (player_simulation_data_t)"""

    # Without meaning.
    data: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.data)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.data = reader.number("B")
        return self


@dataclass
class Cmd(Struct):
    """Not sent by any message. (player_simulation_cmd_t)"""

    # Without meaning.
    cmd: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.cmd)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.cmd = reader.number("B")
        return self


@dataclass
class Pose2dReq(Struct):
    """A model and its pose. (player_simulation_pose2d_req_t)"""

    # Of the model, NUL-terminated.
    name: bytes = b""
    # Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, rad,
    # frame X_PT).
    pose: common.Pose2d = field(default_factory=common.Pose2d)

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        self.pose.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Pose2dReq":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        self.pose = common.Pose2d.read(reader)
        return self


@dataclass
class Pose3dReq(Struct):
    """A model, its pose and the time. (player_simulation_pose3d_req_t)"""

    # Of the model, NUL-terminated.
    name: bytes = b""
    # Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, m,
    # rad, rad, rad, frame X_PT).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Simulated time of the pose, as counted by Stage; set in answers only (in us).
    simtime: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        self.pose.write(writer)
        writer.number("d", self.simtime)

    @classmethod
    def read(cls, reader: Reader) -> "Pose3dReq":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        self.pose = common.Pose3d.read(reader)
        self.simtime = reader.number("d")
        return self


@dataclass
class PropertyReq(Struct):
    """A property of a model. (player_simulation_property_req_t)"""

    # Name of the model, NUL-terminated; empty for a property of the world.
    name: bytes = b""
    # Name of the property, NUL-terminated.
    prop: bytes = b""
    # Element of a list property: in a request the first one requested, in an answer the first of the next
    # request, 0 at the end of the list.
    index: int = 0
    # Bytes of the property, in a simulator-specific format; empty in a request.
    value: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        writer.length("prop", len(self.prop), 33554392)
        writer.length("prop", len(self.prop), 33554392)
        writer.opaque(self.prop)
        writer.number("I", self.index)
        writer.length("value", len(self.value), 33554392)
        writer.length("value", len(self.value), 33554392)
        writer.opaque(self.value)

    @classmethod
    def read(cls, reader: Reader) -> "PropertyReq":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        prop_count = reader.number("I")
        self.prop = reader.opaque(reader.length("prop", prop_count, 1))
        self.index = reader.number("I")
        value_count = reader.number("I")
        self.value = reader.opaque(reader.length("value", value_count, 1))
        return self


# Requests the pose of a model by name.
REQ_GET_POSE2D = MessageType(31, Kind.REQ, 1, "simulation.req.get_pose2d", Pose2dReq)
# Moves a model by name.
REQ_SET_POSE2D = MessageType(31, Kind.REQ, 2, "simulation.req.set_pose2d", Pose2dReq)
# Requests the pose of a model by name, and the time.
REQ_GET_POSE3D = MessageType(31, Kind.REQ, 3, "simulation.req.get_pose3d", Pose3dReq)
# Moves a model by name.
REQ_SET_POSE3D = MessageType(31, Kind.REQ, 4, "simulation.req.set_pose3d", Pose3dReq)
# Requests a property of a model by name; without a name, for "models", the list of all with their devices
# (docs/drivers.md).
REQ_GET_PROPERTY = MessageType(31, Kind.REQ, 5, "simulation.req.get_property", PropertyReq)
# Sets a property of a model by name.
REQ_SET_PROPERTY = MessageType(31, Kind.REQ, 6, "simulation.req.set_property", PropertyReq)
# Pauses or resumes the simulated clock.
CMD_PAUSE = MessageType(31, Kind.CMD, 1, "simulation.cmd.pause")
# Resets the world to its start.
CMD_RESET = MessageType(31, Kind.CMD, 2, "simulation.cmd.reset")
# Saves the current world.
CMD_SAVE = MessageType(31, Kind.CMD, 3, "simulation.cmd.save")
