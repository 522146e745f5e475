"""Interface wsn, code 57. A network of wireless sensor nodes.

Generated from interfaces/057_wsn.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 57


@dataclass
class NodeData(Struct):
    """Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t)"""

    # In 1 or lx.
    light: float = 0.0
    mic: float = 0.0
    # In 1 or m/s^2.
    accel_x: float = 0.0
    # In 1 or m/s^2.
    accel_y: float = 0.0
    # In 1 or m/s^2.
    accel_z: float = 0.0
    # In 1 or G.
    magn_x: float = 0.0
    # In 1 or G.
    magn_y: float = 0.0
    # In 1 or G.
    magn_z: float = 0.0
    # In 1 or degC.
    temperature: float = 0.0
    # In 1 or V.
    battery: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.light)
        writer.number("f", self.mic)
        writer.number("f", self.accel_x)
        writer.number("f", self.accel_y)
        writer.number("f", self.accel_z)
        writer.number("f", self.magn_x)
        writer.number("f", self.magn_y)
        writer.number("f", self.magn_z)
        writer.number("f", self.temperature)
        writer.number("f", self.battery)

    @classmethod
    def read(cls, reader: Reader) -> "NodeData":
        self = cls()
        self.light = reader.number("f")
        self.mic = reader.number("f")
        self.accel_x = reader.number("f")
        self.accel_y = reader.number("f")
        self.accel_z = reader.number("f")
        self.magn_x = reader.number("f")
        self.magn_y = reader.number("f")
        self.magn_z = reader.number("f")
        self.temperature = reader.number("f")
        self.battery = reader.number("f")
        return self


@dataclass
class Data(Struct):
    """Readings of one node. (player_wsn_data_t)"""

    # Type of node.
    node_type: int = 0
    # Id of the node.
    node_id: int = 0
    # Node that relayed the readings.
    node_parent_id: int = 0
    data_packet: NodeData = field(default_factory=NodeData)

    def write(self, writer: Writer) -> None:
        writer.number("I", self.node_type)
        writer.number("I", self.node_id)
        writer.number("I", self.node_parent_id)
        self.data_packet.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.node_type = reader.number("I")
        self.node_id = reader.number("I")
        self.node_parent_id = reader.number("I")
        self.data_packet = NodeData.read(reader)
        return self


@dataclass
class Cmd(Struct):
    """Switch of an actuator of a node. (player_wsn_cmd_t)"""

    # Id of the node; -1: all.
    node_id: int = 0
    # Group of the node; -1: all.
    group_id: int = 0
    # Actuator, such as a light or a buzzer.
    device: int = 0
    # 1: on, 0: off.
    enable: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.node_id)
        writer.number("i", self.group_id)
        writer.number("I", self.device)
        writer.number("B", self.enable)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.node_id = reader.number("i")
        self.group_id = reader.number("i")
        self.device = reader.number("I")
        self.enable = reader.number("B")
        return self


@dataclass
class PowerConfig(Struct):
    """Sleep mode of nodes. (player_wsn_power_config_t)"""

    # Id of the node; -1: all.
    node_id: int = 0
    # Group of the node; -1: all.
    group_id: int = 0
    # 0: asleep, 1: awake, 2: driver-specific.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.node_id)
        writer.number("i", self.group_id)
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "PowerConfig":
        self = cls()
        self.node_id = reader.number("i")
        self.group_id = reader.number("i")
        self.value = reader.number("B")
        return self


@dataclass
class DatatypeConfig(Struct):
    """Format of readings. (player_wsn_datatype_config_t)"""

    # 0: raw, 1: converted.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "DatatypeConfig":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class DatafreqConfig(Struct):
    """Rate of reports. (player_wsn_datafreq_config_t)"""

    # Id of the node; -1: all.
    node_id: int = 0
    # Group of the node; -1: all.
    group_id: int = 0
    # In Hz.
    frequency: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.node_id)
        writer.number("i", self.group_id)
        writer.number("d", self.frequency)

    @classmethod
    def read(cls, reader: Reader) -> "DatafreqConfig":
        self = cls()
        self.node_id = reader.number("i")
        self.group_id = reader.number("i")
        self.frequency = reader.number("d")
        return self


# Readings of one node.
DATA_STATE = MessageType(57, Kind.DATA, 1, "wsn.data.state", Data)
# Switches an actuator of a node.
CMD_DEVSTATE = MessageType(57, Kind.CMD, 1, "wsn.cmd.devstate", Cmd)
# Puts nodes to sleep or wakes them.
REQ_POWER = MessageType(57, Kind.REQ, 1, "wsn.req.power", PowerConfig)
# Selects between raw and converted readings.
REQ_DATATYPE = MessageType(57, Kind.REQ, 2, "wsn.req.datatype", DatatypeConfig)
# Sets the reporting rate of nodes.
REQ_DATAFREQ = MessageType(57, Kind.REQ, 3, "wsn.req.datafreq", DatafreqConfig)
