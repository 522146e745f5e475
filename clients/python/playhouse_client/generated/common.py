"""What every interface shares. Types shared by several interfaces, and requests to any device.

Generated from interfaces/000_common.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

# Limits shared by all implementations of the protocol.
MAX_MESSAGE_SIZE = 8388608
MAX_DRIVER_STRING_LEN = 64
MAX_DEVICES = 4096
MSGQUEUE_DEFAULT_MAXLEN = 1024
IDENT_STRLEN = 32
KEYLEN = 32


@dataclass
class Devaddr(Struct):
    """Address of a device. (player_devaddr_t)"""

    # Host of the device's server; receivers compare only interf and index.
    host: int = 0
    # TCP port of the device's server: its name space.
    robot: int = 0
    # Interface code.
    interf: int = 0
    # Index of the device within its interface.
    index: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.host)
        writer.number("I", self.robot)
        writer.number("H", self.interf)
        writer.number("H", self.index)

    @classmethod
    def read(cls, reader: Reader) -> "Devaddr":
        self = cls()
        self.host = reader.number("I")
        self.robot = reader.number("I")
        self.interf = reader.number("H")
        self.index = reader.number("H")
        return self


@dataclass
class Point2d(Struct):
    """A point or vector in the plane. (player_point_2d_t)"""

    # In m.
    px: float = 0.0
    # In m.
    py: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.px)
        writer.number("d", self.py)

    @classmethod
    def read(cls, reader: Reader) -> "Point2d":
        self = cls()
        self.px = reader.number("d")
        self.py = reader.number("d")
        return self


@dataclass
class Point3d(Struct):
    """A point or vector in space. (player_point_3d_t)"""

    # In m.
    px: float = 0.0
    # In m.
    py: float = 0.0
    # In m.
    pz: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.px)
        writer.number("d", self.py)
        writer.number("d", self.pz)

    @classmethod
    def read(cls, reader: Reader) -> "Point3d":
        self = cls()
        self.px = reader.number("d")
        self.py = reader.number("d")
        self.pz = reader.number("d")
        return self


@dataclass
class Orientation3d(Struct):
    """An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
    (player_orientation_3d_t)"""

    # About x (in rad).
    proll: float = 0.0
    # About y (in rad).
    ppitch: float = 0.0
    # About z (in rad).
    pyaw: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.proll)
        writer.number("d", self.ppitch)
        writer.number("d", self.pyaw)

    @classmethod
    def read(cls, reader: Reader) -> "Orientation3d":
        self = cls()
        self.proll = reader.number("d")
        self.ppitch = reader.number("d")
        self.pyaw = reader.number("d")
        return self


@dataclass
class Pose2d(Struct):
    """A pose in the plane, or, if the message says so, a velocity with the same three components.
    (player_pose2d_t)"""

    # In m.
    px: float = 0.0
    # In m.
    py: float = 0.0
    # Heading, counter-clockwise from x (in rad).
    pa: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.px)
        writer.number("d", self.py)
        writer.number("d", self.pa)

    @classmethod
    def read(cls, reader: Reader) -> "Pose2d":
        self = cls()
        self.px = reader.number("d")
        self.py = reader.number("d")
        self.pa = reader.number("d")
        return self


@dataclass
class Pose3d(Struct):
    """A pose in space, or, if the message says so, a velocity or acceleration with the same six
    components. (player_pose3d_t)"""

    # In m.
    px: float = 0.0
    # In m.
    py: float = 0.0
    # In m.
    pz: float = 0.0
    # About x (in rad).
    proll: float = 0.0
    # About y (in rad).
    ppitch: float = 0.0
    # About z (in rad).
    pyaw: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.px)
        writer.number("d", self.py)
        writer.number("d", self.pz)
        writer.number("d", self.proll)
        writer.number("d", self.ppitch)
        writer.number("d", self.pyaw)

    @classmethod
    def read(cls, reader: Reader) -> "Pose3d":
        self = cls()
        self.px = reader.number("d")
        self.py = reader.number("d")
        self.pz = reader.number("d")
        self.proll = reader.number("d")
        self.ppitch = reader.number("d")
        self.pyaw = reader.number("d")
        return self


@dataclass
class Bbox2d(Struct):
    """Size of a bounding rectangle. (player_bbox2d_t)"""

    # Width, along y (in m).
    sw: float = 0.0
    # Length, along x (in m).
    sl: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.sw)
        writer.number("d", self.sl)

    @classmethod
    def read(cls, reader: Reader) -> "Bbox2d":
        self = cls()
        self.sw = reader.number("d")
        self.sl = reader.number("d")
        return self


@dataclass
class Bbox3d(Struct):
    """Size of a bounding box. (player_bbox3d_t)"""

    # Width, along y (in m).
    sw: float = 0.0
    # Length, along x (in m).
    sl: float = 0.0
    # Height, along z (in m).
    sh: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.sw)
        writer.number("d", self.sl)
        writer.number("d", self.sh)

    @classmethod
    def read(cls, reader: Reader) -> "Bbox3d":
        self = cls()
        self.sw = reader.number("d")
        self.sl = reader.number("d")
        self.sh = reader.number("d")
        return self


@dataclass
class BlackboardEntry(Struct):
    """One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t)"""

    # Name of the entry within its group.
    key: bytes = b""
    # Name of the group, a namespace of keys.
    group: bytes = b""
    # Category of `data`: simple values or types of other interfaces.
    type: int = 0
    # Exact type of `data`; of simple values: string, integer or floating-point number.
    subtype: int = 0
    # Bytes of the value, opaque to the blackboard.
    data: bytes = b""
    # Time at which the value was set: whole seconds (in s).
    timestamp_sec: int = 0
    # Time at which the value was set: microseconds of the second (in us).
    timestamp_usec: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("key", len(self.key), 33554392)
        writer.length("key", len(self.key), 33554392)
        writer.opaque(self.key)
        writer.length("group", len(self.group), 33554392)
        writer.length("group", len(self.group), 33554392)
        writer.opaque(self.group)
        writer.number("H", self.type)
        writer.number("H", self.subtype)
        writer.length("data", len(self.data), 33554392)
        writer.length("data", len(self.data), 33554392)
        writer.opaque(self.data)
        writer.number("I", self.timestamp_sec)
        writer.number("I", self.timestamp_usec)

    @classmethod
    def read(cls, reader: Reader) -> "BlackboardEntry":
        self = cls()
        key_count = reader.number("I")
        self.key = reader.opaque(reader.length("key", key_count, 1))
        group_count = reader.number("I")
        self.group = reader.opaque(reader.length("group", group_count, 1))
        self.type = reader.number("H")
        self.subtype = reader.number("H")
        data_count = reader.number("I")
        self.data = reader.opaque(reader.length("data", data_count, 1))
        self.timestamp_sec = reader.number("I")
        self.timestamp_usec = reader.number("I")
        return self


@dataclass
class Segment(Struct):
    """A line segment. (player_segment_t)"""

    # x of the start (in m).
    x0: float = 0.0
    # y of the start (in m).
    y0: float = 0.0
    # x of the end (in m).
    x1: float = 0.0
    # y of the end (in m).
    y1: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.x0)
        writer.number("d", self.y0)
        writer.number("d", self.x1)
        writer.number("d", self.y1)

    @classmethod
    def read(cls, reader: Reader) -> "Segment":
        self = cls()
        self.x0 = reader.number("d")
        self.y0 = reader.number("d")
        self.x1 = reader.number("d")
        self.y1 = reader.number("d")
        return self


@dataclass
class Extent2d(Struct):
    """An axis-aligned rectangle, given by two corners. (player_extent2d_t)"""

    # Smallest x (in m).
    x0: float = 0.0
    # Smallest y (in m).
    y0: float = 0.0
    # Largest x (in m).
    x1: float = 0.0
    # Largest y (in m).
    y1: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.x0)
        writer.number("d", self.y0)
        writer.number("d", self.x1)
        writer.number("d", self.y1)

    @classmethod
    def read(cls, reader: Reader) -> "Extent2d":
        self = cls()
        self.x0 = reader.number("d")
        self.y0 = reader.number("d")
        self.x1 = reader.number("d")
        self.y1 = reader.number("d")
        return self


@dataclass
class Color(Struct):
    """A color with opacity, each component from 0 to 255. (player_color_t)"""

    # 255 is opaque, 0 invisible.
    alpha: int = 0
    red: int = 0
    green: int = 0
    blue: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.alpha)
        writer.number("B", self.red)
        writer.number("B", self.green)
        writer.number("B", self.blue)

    @classmethod
    def read(cls, reader: Reader) -> "Color":
        self = cls()
        self.alpha = reader.number("B")
        self.red = reader.number("B")
        self.green = reader.number("B")
        self.blue = reader.number("B")
        return self


@dataclass
class Bool(Struct):
    """A switch. (player_bool_t)"""

    # 0: off, else on.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "Bool":
        self = cls()
        self.state = reader.number("B")
        return self


@dataclass
class Uint32(Struct):
    """One integer. (player_uint32_t)"""

    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "Uint32":
        self = cls()
        self.value = reader.number("I")
        return self


@dataclass
class CapabilitiesReq(Struct):
    """The queried message. (player_capabilities_req_t)"""

    # Type of the message, as in a header.
    type: int = 0
    # Subtype of the message, as in a header.
    subtype: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.type)
        writer.number("I", self.subtype)

    @classmethod
    def read(cls, reader: Reader) -> "CapabilitiesReq":
        self = cls()
        self.type = reader.number("I")
        self.subtype = reader.number("I")
        return self


@dataclass
class BoolpropReq(Struct):
    """A named switch. (player_boolprop_req_t)"""

    # Name of the property, NUL-terminated.
    key: bytes = b""
    # 0 false, else true; ignored in a request.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("key", len(self.key), 33554392)
        writer.length("key", len(self.key), 33554392)
        writer.opaque(self.key)
        writer.number("b", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "BoolpropReq":
        self = cls()
        key_count = reader.number("I")
        self.key = reader.opaque(reader.length("key", key_count, 1))
        self.value = reader.number("b")
        return self


@dataclass
class IntpropReq(Struct):
    """A named integer. (player_intprop_req_t)"""

    # Name of the property, NUL-terminated.
    key: bytes = b""
    # Ignored in a question.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("key", len(self.key), 33554392)
        writer.length("key", len(self.key), 33554392)
        writer.opaque(self.key)
        writer.number("i", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "IntpropReq":
        self = cls()
        key_count = reader.number("I")
        self.key = reader.opaque(reader.length("key", key_count, 1))
        self.value = reader.number("i")
        return self


@dataclass
class DblpropReq(Struct):
    """A named number. (player_dblprop_req_t)"""

    # Name of the property, NUL-terminated.
    key: bytes = b""
    # In the driver's unit for the property; ignored in a request.
    value: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.length("key", len(self.key), 33554392)
        writer.length("key", len(self.key), 33554392)
        writer.opaque(self.key)
        writer.number("d", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "DblpropReq":
        self = cls()
        key_count = reader.number("I")
        self.key = reader.opaque(reader.length("key", key_count, 1))
        self.value = reader.number("d")
        return self


@dataclass
class StrpropReq(Struct):
    """A named string. (player_strprop_req_t)"""

    # Name of the property, NUL-terminated.
    key: bytes = b""
    # NUL-terminated; ignored in a request.
    value: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("key", len(self.key), 33554392)
        writer.length("key", len(self.key), 33554392)
        writer.opaque(self.key)
        writer.length("value", len(self.value), 33554392)
        writer.length("value", len(self.value), 33554392)
        writer.opaque(self.value)

    @classmethod
    def read(cls, reader: Reader) -> "StrpropReq":
        self = cls()
        key_count = reader.number("I")
        self.key = reader.opaque(reader.length("key", key_count, 1))
        value_count = reader.number("I")
        self.value = reader.opaque(reader.length("value", value_count, 1))
        return self


# Queries whether the device supports a message: an empty ACK means yes, NACK no.
REQ_CAPABILITIES = MessageType(0, Kind.REQ, 255, "universal.req.capabilities", CapabilitiesReq)
# Reads a named integer of the driver; the answer repeats the key.
REQ_GET_INTPROP = MessageType(0, Kind.REQ, 254, "universal.req.get_intprop", IntpropReq)
# Changes a named integer of the driver.
REQ_SET_INTPROP = MessageType(0, Kind.REQ, 253, "universal.req.set_intprop", IntpropReq)
# Reads a named number of the driver; the answer repeats the key.
REQ_GET_DBLPROP = MessageType(0, Kind.REQ, 252, "universal.req.get_dblprop", DblpropReq)
# Changes a named number of the driver.
REQ_SET_DBLPROP = MessageType(0, Kind.REQ, 251, "universal.req.set_dblprop", DblpropReq)
# Reads a named string of the driver; the answer repeats the key.
REQ_GET_STRPROP = MessageType(0, Kind.REQ, 250, "universal.req.get_strprop", StrpropReq)
# Changes a named string of the driver.
REQ_SET_STRPROP = MessageType(0, Kind.REQ, 249, "universal.req.set_strprop", StrpropReq)
# Reads a named switch of the driver; the answer repeats the key.
REQ_GET_BOOLPROP = MessageType(0, Kind.REQ, 248, "universal.req.get_boolprop", BoolpropReq)
# Changes a named switch of the driver.
REQ_SET_BOOLPROP = MessageType(0, Kind.REQ, 247, "universal.req.set_boolprop", BoolpropReq)
