"""Interface opaque, code 51. Opaque bytes, defined by the driver and its clients.

Generated from interfaces/051_opaque.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 51

# Subtypes under their older names.
REQ = 1
CMD = 1


@dataclass
class Data(Struct):
    """Opaque bytes. (player_opaque_data_t)"""

    data: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("data", len(self.data), 33554392)
        writer.length("data", len(self.data), 33554392)
        writer.opaque(self.data)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        data_count = reader.number("I")
        self.data = reader.opaque(reader.length("data", data_count, 1))
        return self


# Bytes from the driver.
DATA_STATE = MessageType(51, Kind.DATA, 1, "opaque.data.state", Data)
# Bytes for the driver.
CMD_DATA = MessageType(51, Kind.CMD, 1, "opaque.cmd.data", Data)
# Bytes for the driver, which answers with bytes.
REQ_DATA = MessageType(51, Kind.REQ, 1, "opaque.req.data", Data)
