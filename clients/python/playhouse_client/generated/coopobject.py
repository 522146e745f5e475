"""Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that report
to each other.

Generated from interfaces/066_coopobject.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 66

# Values of Header.origin.
ORIGIN_STATICBASE = 0
ORIGIN_MOBILEBASE = 1
ORIGIN_MOTE = 2
ORIGIN_ROBOT = 3

# Types of messages between nodes.
MSG_NONE = -1
MSG_HEALTH = 0
MSG_POSITION = 1
MSG_RSSI = 2
MSG_SENSOR = 3
MSG_ALARM = 4
MSG_REQUEST = 5
MSG_COMMAND = 6

# Values of Sensor.type.
TEMPERATURE = 0
HUMIDITY = 1
PRESSURE = 2
LIGHT_1 = 3
LIGHT_2 = 4
ACCEL_X = 5
ACCEL_Y = 6
ACCEL_Z = 7
MAGNETOMETER_X = 8
MAGNETOMETER_Y = 9
MAGNETOMETER_Z = 10
COMPASS = 11
CO = 12
CO2 = 13
H2 = 14
SMOKE = 15
OPTSWITCH = 16


@dataclass
class Header(Struct):
    """Id of the node. (player_coopobject_header_t)"""

    # Type of node.
    origin: int = 0
    id: int = 0
    # Node that relayed the message.
    parent_id: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.origin)
        writer.number("H", self.id)
        writer.number("H", self.parent_id)

    @classmethod
    def read(cls, reader: Reader) -> "Header":
        self = cls()
        self.origin = reader.number("B")
        self.id = reader.number("H")
        self.parent_id = reader.number("H")
        return self


@dataclass
class Rssi(Struct):
    """Radio signal strength. (player_coopobject_rssi_t)"""

    header: Header = field(default_factory=Header)
    # Node that sent the signal.
    sender_id: int = 0
    # As the radio reports it.
    rssi: int = 0
    # Counter of measurements.
    stamp: int = 0
    # Clock of the node: upper half.
    nodeTimeHigh: int = 0
    # Clock of the node: lower half.
    nodeTimeLow: int = 0
    # Position of the receiver (in m, frame p_WS).
    x: float = 0.0
    # In m, frame p_WS.
    y: float = 0.0
    # In m, frame p_WS.
    z: float = 0.0

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.number("H", self.sender_id)
        writer.number("H", self.rssi)
        writer.number("H", self.stamp)
        writer.number("I", self.nodeTimeHigh)
        writer.number("I", self.nodeTimeLow)
        writer.number("f", self.x)
        writer.number("f", self.y)
        writer.number("f", self.z)

    @classmethod
    def read(cls, reader: Reader) -> "Rssi":
        self = cls()
        self.header = Header.read(reader)
        self.sender_id = reader.number("H")
        self.rssi = reader.number("H")
        self.stamp = reader.number("H")
        self.nodeTimeHigh = reader.number("I")
        self.nodeTimeLow = reader.number("I")
        self.x = reader.number("f")
        self.y = reader.number("f")
        self.z = reader.number("f")
        return self


@dataclass
class Position(Struct):
    """Position of a node. (player_coopobject_position_t)"""

    header: Header = field(default_factory=Header)
    # In m, frame p_WS.
    x: float = 0.0
    # In m, frame p_WS.
    y: float = 0.0
    # In m, frame p_WS.
    z: float = 0.0
    # Driver-specific.
    status: int = 0

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.number("f", self.x)
        writer.number("f", self.y)
        writer.number("f", self.z)
        writer.number("B", self.status)

    @classmethod
    def read(cls, reader: Reader) -> "Position":
        self = cls()
        self.header = Header.read(reader)
        self.x = reader.number("f")
        self.y = reader.number("f")
        self.z = reader.number("f")
        self.status = reader.number("B")
        return self


@dataclass
class Sensor(Struct):
    """One reading. (player_coopobject_sensor_t)"""

    # Measured quantity.
    type: int = 0
    # As the sensor reports it.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.type)
        writer.number("h", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "Sensor":
        self = cls()
        self.type = reader.number("B")
        self.value = reader.number("h")
        return self


@dataclass
class DataSensor(Struct):
    """Readings of a node. (player_coopobject_data_sensor_t)"""

    header: Header = field(default_factory=Header)
    data: List[Sensor] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.length("data", len(self.data), 4194299)
        writer.length("data", len(self.data), 4194299)
        for item in self.data:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataSensor":
        self = cls()
        self.header = Header.read(reader)
        data_count = reader.number("I")
        data_length = reader.length("data", data_count, 8)
        self.data = [Sensor.read(reader) for _ in range(data_length)]
        return self


@dataclass
class DataUserdefined(Struct):
    """Bytes from or to a node. (player_coopobject_data_userdefined_t)"""

    header: Header = field(default_factory=Header)
    # User-specific.
    type: int = 0
    data: bytes = b""

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.number("B", self.type)
        writer.length("data", len(self.data), 33554392)
        writer.length("data", len(self.data), 33554392)
        writer.opaque(self.data)

    @classmethod
    def read(cls, reader: Reader) -> "DataUserdefined":
        self = cls()
        self.header = Header.read(reader)
        self.type = reader.number("B")
        data_count = reader.number("I")
        self.data = reader.opaque(reader.length("data", data_count, 1))
        return self


@dataclass
class Req(Struct):
    """A request. (player_coopobject_req_t)"""

    header: Header = field(default_factory=Header)
    # Which.
    request: int = 0
    # Request-specific.
    parameters: bytes = b""

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.number("B", self.request)
        writer.length("parameters", len(self.parameters), 33554392)
        writer.length("parameters", len(self.parameters), 33554392)
        writer.opaque(self.parameters)

    @classmethod
    def read(cls, reader: Reader) -> "Req":
        self = cls()
        self.header = Header.read(reader)
        self.request = reader.number("B")
        parameters_count = reader.number("I")
        self.parameters = reader.opaque(reader.length("parameters", parameters_count, 1))
        return self


@dataclass
class Cmd(Struct):
    """A command. (player_coopobject_cmd_t)"""

    header: Header = field(default_factory=Header)
    # Which.
    command: int = 0
    # Command-specific.
    parameters: bytes = b""

    def write(self, writer: Writer) -> None:
        self.header.write(writer)
        writer.number("B", self.command)
        writer.length("parameters", len(self.parameters), 33554392)
        writer.length("parameters", len(self.parameters), 33554392)
        writer.opaque(self.parameters)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.header = Header.read(reader)
        self.command = reader.number("B")
        parameters_count = reader.number("I")
        self.parameters = reader.opaque(reader.length("parameters", parameters_count, 1))
        return self


# A node is alive.
DATA_HEALTH = MessageType(66, Kind.DATA, 1, "coopobject.data.health", Header)
# Signal strength received by a node.
DATA_RSSI = MessageType(66, Kind.DATA, 2, "coopobject.data.rssi", Rssi)
# Readings of a node.
DATA_SENSOR = MessageType(66, Kind.DATA, 3, "coopobject.data.sensor", DataSensor)
# Readings of a node that crossed a threshold.
DATA_ALARM = MessageType(66, Kind.DATA, 4, "coopobject.data.alarm", DataSensor)
# Bytes from a node.
DATA_USERDEFINED = MessageType(66, Kind.DATA, 5, "coopobject.data.userdefined", DataUserdefined)
# A request of a node.
DATA_REQUEST = MessageType(66, Kind.DATA, 6, "coopobject.data.request", Req)
# A command of a node.
DATA_COMMAND = MessageType(66, Kind.DATA, 7, "coopobject.data.command", Cmd)
# Position of a node.
DATA_POSITION = MessageType(66, Kind.DATA, 8, "coopobject.data.position", Position)
# Sends a command to a node.
CMD_STANDARD = MessageType(66, Kind.CMD, 1, "coopobject.cmd.standard", Cmd)
# Sends bytes to a node.
CMD_DATA = MessageType(66, Kind.CMD, 2, "coopobject.cmd.data", DataUserdefined)
# Sends the position of a node to a node.
CMD_POSITION = MessageType(66, Kind.CMD, 3, "coopobject.cmd.position", Position)
# Sends a request to a node.
REQ_STANDARD = MessageType(66, Kind.REQ, 1, "coopobject.req.standard", Req)
