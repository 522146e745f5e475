"""Interface rfid, code 56. Reads and writes radio tags.

Generated from interfaces/056_rfid.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 56


@dataclass
class Tag(Struct):
    """One tag. (player_rfid_tag_t)"""

    # Type of tag.
    type: int = 0
    # Id of the tag, as bytes.
    guid: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.number("I", self.type)
        writer.length("guid", len(self.guid), 33554392)
        writer.length("guid", len(self.guid), 33554392)
        writer.opaque(self.guid)

    @classmethod
    def read(cls, reader: Reader) -> "Tag":
        self = cls()
        self.type = reader.number("I")
        guid_count = reader.number("I")
        self.guid = reader.opaque(reader.length("guid", guid_count, 1))
        return self


@dataclass
class Data(Struct):
    """Tags in range. (player_rfid_data_t)"""

    tags: List[Tag] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("tags", len(self.tags), 2796199)
        writer.length("tags", len(self.tags), 2796199)
        for item in self.tags:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        tags_count = reader.number("I")
        tags_length = reader.length("tags", tags_count, 12)
        self.tags = [Tag.read(reader) for _ in range(tags_length)]
        return self


# Tags in range.
DATA_TAGS = MessageType(56, Kind.DATA, 1, "rfid.data.tags", Data)
# Switches the reader on or off.
REQ_POWER = MessageType(56, Kind.REQ, 1, "rfid.req.power")
# Reads a tag.
REQ_READTAG = MessageType(56, Kind.REQ, 2, "rfid.req.readtag")
# Writes a tag.
REQ_WRITETAG = MessageType(56, Kind.REQ, 3, "rfid.req.writetag")
# Locks a tag against writing.
REQ_LOCKTAG = MessageType(56, Kind.REQ, 4, "rfid.req.locktag")
