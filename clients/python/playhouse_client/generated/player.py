"""Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery
of data. Always open as player:0.

Generated from interfaces/001_player.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 1

# Values of DeviceReq.access.
OPEN_MODE = 1
CLOSE_MODE = 2
ERROR_MODE = 3

# Values of DeviceDatamodeReq.mode.
DATAMODE_PUSH = 1
DATAMODE_PULL = 2

# Values of AddReplaceRuleReq.replace.
MSG_REPLACE_RULE_ACCEPT = 0
MSG_REPLACE_RULE_REPLACE = 1
MSG_REPLACE_RULE_IGNORE = 2


@dataclass
class DeviceDevlist(Struct):
    """The devices of a server. (player_device_devlist_t)"""

    # In the order of creation, without player:0.
    devices: List[common.Devaddr] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("devices", len(self.devices), 4096)
        writer.length("devices", len(self.devices), 4096)
        for item in self.devices:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceDevlist":
        self = cls()
        reader.number("I")
        devices_length = reader.length("devices", 4096, 16)
        self.devices = [common.Devaddr.read(reader) for _ in range(devices_length)]
        return self


@dataclass
class DeviceDriverinfo(Struct):
    """A device and the driver behind it. (player_device_driverinfo_t)"""

    # The queried device.
    addr: common.Devaddr = field(default_factory=common.Devaddr)
    # NUL-terminated; empty in the request.
    driver_name: bytes = b""

    def write(self, writer: Writer) -> None:
        self.addr.write(writer)
        writer.length("driver_name", len(self.driver_name), 64)
        writer.length("driver_name", len(self.driver_name), 64)
        writer.opaque(self.driver_name)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceDriverinfo":
        self = cls()
        self.addr = common.Devaddr.read(reader)
        reader.number("I")
        self.driver_name = reader.opaque(reader.length("driver_name", 64, 1))
        return self


@dataclass
class DeviceReq(Struct):
    """Request to open or close a device, and its answer. (player_device_req_t)"""

    # The device; in the answer, completed with host and robot.
    addr: common.Devaddr = field(default_factory=common.Devaddr)
    # Requested or granted access.
    access: int = 0
    # NUL-terminated; empty in the request.
    driver_name: bytes = b""

    def write(self, writer: Writer) -> None:
        self.addr.write(writer)
        writer.number("B", self.access)
        writer.length("driver_name", len(self.driver_name), 64)
        writer.length("driver_name", len(self.driver_name), 64)
        writer.opaque(self.driver_name)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceReq":
        self = cls()
        self.addr = common.Devaddr.read(reader)
        self.access = reader.number("B")
        reader.number("I")
        self.driver_name = reader.opaque(reader.length("driver_name", 64, 1))
        return self


@dataclass
class DeviceDatamodeReq(Struct):
    """A delivery mode. (player_device_datamode_req_t)"""

    # Push or pull.
    mode: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.mode)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceDatamodeReq":
        self = cls()
        self.mode = reader.number("B")
        return self


@dataclass
class DeviceAuthReq(Struct):
    """A key. (player_device_auth_req_t)"""

    auth_key: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("auth_key", len(self.auth_key), 32)
        writer.length("auth_key", len(self.auth_key), 32)
        writer.opaque(self.auth_key)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceAuthReq":
        self = cls()
        reader.number("I")
        self.auth_key = reader.opaque(reader.length("auth_key", 32, 1))
        return self


@dataclass
class DeviceNameserviceReq(Struct):
    """A robot's name and its port. (player_device_nameservice_req_t)"""

    name: bytes = b""
    # 0 in the request.
    port: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 64)
        writer.length("name", len(self.name), 64)
        writer.opaque(self.name)
        writer.number("H", self.port)

    @classmethod
    def read(cls, reader: Reader) -> "DeviceNameserviceReq":
        self = cls()
        reader.number("I")
        self.name = reader.opaque(reader.length("name", 64, 1))
        self.port = reader.number("H")
        return self


@dataclass
class AddReplaceRuleReq(Struct):
    """Messages to which a rule applies, and its effect; -1 matches anything.
    (player_add_replace_rule_req_t)"""

    # Interface code, or -1.
    interf: int = 0
    # Device index, or -1.
    index: int = 0
    # Message type, or -1.
    type: int = 0
    # Message subtype, or -1.
    subtype: int = 0
    # Keep all, keep the newest, or drop.
    replace: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.interf)
        writer.number("i", self.index)
        writer.number("i", self.type)
        writer.number("i", self.subtype)
        writer.number("i", self.replace)

    @classmethod
    def read(cls, reader: Reader) -> "AddReplaceRuleReq":
        self = cls()
        self.interf = reader.number("i")
        self.index = reader.number("i")
        self.type = reader.number("i")
        self.subtype = reader.number("i")
        self.replace = reader.number("i")
        return self


# Lists the devices that this connection can open.
REQ_DEVLIST = MessageType(1, Kind.REQ, 1, "player.req.devlist", DeviceDevlist)
# Requests the name of the driver behind a device.
REQ_DRIVERINFO = MessageType(1, Kind.REQ, 2, "player.req.driverinfo", DeviceDriverinfo)
# Opens or closes a device; the answer has the granted access.
REQ_DEV = MessageType(1, Kind.REQ, 3, "player.req.dev", DeviceReq)
# Requests one round of data, in pull mode; a synch ends the round.
REQ_DATA = MessageType(1, Kind.REQ, 4, "player.req.data")
# Selects the delivery mode: immediately (push) or on request (pull).
REQ_DATAMODE = MessageType(1, Kind.REQ, 5, "player.req.datamode", DeviceDatamodeReq)
# Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
# admits nobody.
REQ_AUTH = MessageType(1, Kind.REQ, 7, "player.req.auth", DeviceAuthReq)
# Requests the port of a named robot; unused, answered by NACK.
REQ_NAMESERVICE = MessageType(1, Kind.REQ, 8, "player.req.nameservice", DeviceNameserviceReq)
# Adds a replace rule: which queued messages a newer one replaces.
REQ_ADD_REPLACE_RULE = MessageType(1, Kind.REQ, 10, "player.req.add_replace_rule", AddReplaceRuleReq)
# Ends a round of data; no message was dropped since the previous one.
SYNCH_OK = MessageType(1, Kind.SYNCH, 1, "player.synch.ok")
# Ends a round of data; the body is the number of messages dropped since the previous one.
SYNCH_OVERFLOW = MessageType(1, Kind.SYNCH, 2, "player.synch.overflow", common.Uint32)
