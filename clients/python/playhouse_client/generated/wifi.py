"""Interface wifi, code 23. State of wireless network links.

Generated from interfaces/023_wifi.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 23

# Values of Data.qual_type: unit of link quality.
QUAL_DBM = 1
QUAL_REL = 2
QUAL_UNKNOWN = 3

# Values of Data.mode and Link.mode.
MODE_UNKNOWN = 0
MODE_AUTO = 1
MODE_ADHOC = 2
MODE_INFRA = 3
MODE_MASTER = 4
MODE_REPEAT = 5
MODE_SECOND = 6


@dataclass
class Link(Struct):
    """One link. (player_wifi_link_t)"""

    # Hardware address, as a string.
    mac: bytes = b""
    # Network address, as a string.
    ip: bytes = b""
    # Name of the network, as a string.
    essid: bytes = b""
    # Role in the network.
    mode: int = 0
    # In MHz.
    freq: int = 0
    # 0: open, else encrypted.
    encrypt: int = 0
    # Quality, up to Data.maxqual.
    qual: int = 0
    # Signal, up to Data.maxlevel (signed).
    level: int = 0
    # Noise, up to Data.maxnoise (signed).
    noise: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("mac", len(self.mac), 32)
        writer.length("mac", len(self.mac), 32)
        writer.opaque(self.mac)
        writer.length("ip", len(self.ip), 32)
        writer.length("ip", len(self.ip), 32)
        writer.opaque(self.ip)
        writer.length("essid", len(self.essid), 32)
        writer.length("essid", len(self.essid), 32)
        writer.opaque(self.essid)
        writer.number("I", self.mode)
        writer.number("I", self.freq)
        writer.number("I", self.encrypt)
        writer.number("I", self.qual)
        writer.number("i", self.level)
        writer.number("i", self.noise)

    @classmethod
    def read(cls, reader: Reader) -> "Link":
        self = cls()
        reader.number("I")
        self.mac = reader.opaque(reader.length("mac", 32, 1))
        reader.number("I")
        self.ip = reader.opaque(reader.length("ip", 32, 1))
        reader.number("I")
        self.essid = reader.opaque(reader.length("essid", 32, 1))
        self.mode = reader.number("I")
        self.freq = reader.number("I")
        self.encrypt = reader.number("I")
        self.qual = reader.number("I")
        self.level = reader.number("i")
        self.noise = reader.number("i")
        return self


@dataclass
class Data(Struct):
    """Every link and the state of the card. (player_wifi_data_t)"""

    links: List[Link] = field(default_factory=list)
    # Estimated throughput of the card (in bit/s).
    throughput: int = 0
    # Configured bit rate of the card (in bit/s).
    bitrate: int = 0
    # Role in the network.
    mode: int = 0
    # Unit of quality, level and noise.
    qual_type: int = 0
    # Maximum reported quality.
    maxqual: int = 0
    # Maximum reported signal level (signed).
    maxlevel: int = 0
    # Maximum reported noise level (signed).
    maxnoise: int = 0
    # Hardware address of the access point, as a string.
    ap: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("links", len(self.links), 699049)
        writer.length("links", len(self.links), 699049)
        for item in self.links:
            item.write(writer)
        writer.number("I", self.throughput)
        writer.number("I", self.bitrate)
        writer.number("I", self.mode)
        writer.number("I", self.qual_type)
        writer.number("I", self.maxqual)
        writer.number("i", self.maxlevel)
        writer.number("i", self.maxnoise)
        writer.fixed("ap", self.ap, 32)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        links_count = reader.number("I")
        links_length = reader.length("links", links_count, 48)
        self.links = [Link.read(reader) for _ in range(links_length)]
        self.throughput = reader.number("I")
        self.bitrate = reader.number("I")
        self.mode = reader.number("I")
        self.qual_type = reader.number("I")
        self.maxqual = reader.number("I")
        self.maxlevel = reader.number("i")
        self.maxnoise = reader.number("i")
        self.ap = reader.opaque(32)
        return self


@dataclass
class MacReq(Struct):
    """The card's own address. (player_wifi_mac_req_t)"""

    # Hardware address, as a string.
    mac: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("mac", len(self.mac), 32)
        writer.length("mac", len(self.mac), 32)
        writer.opaque(self.mac)

    @classmethod
    def read(cls, reader: Reader) -> "MacReq":
        self = cls()
        reader.number("I")
        self.mac = reader.opaque(reader.length("mac", 32, 1))
        return self


@dataclass
class IwspyAddrReq(Struct):
    """The address of a station. (player_wifi_iwspy_addr_req_t)"""

    # Hardware address, as a string.
    address: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.fixed("address", self.address, 32)

    @classmethod
    def read(cls, reader: Reader) -> "IwspyAddrReq":
        self = cls()
        self.address = reader.opaque(32)
        return self


# Requests the card's own address.
REQ_MAC = MessageType(23, Kind.REQ, 1, "wifi.req.mac", MacReq)
# Starts monitoring the links to an address.
REQ_IWSPY_ADD = MessageType(23, Kind.REQ, 2, "wifi.req.iwspy_add", IwspyAddrReq)
# Stops monitoring the links to an address.
REQ_IWSPY_DEL = MessageType(23, Kind.REQ, 3, "wifi.req.iwspy_del", IwspyAddrReq)
# Sends a packet to an address to measure its link.
REQ_IWSPY_PING = MessageType(23, Kind.REQ, 4, "wifi.req.iwspy_ping", IwspyAddrReq)
# Every link and the state of the card.
DATA_STATE = MessageType(23, Kind.DATA, 1, "wifi.data.state", Data)
