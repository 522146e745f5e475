"""Interface dio, code 20. Digital inputs and outputs.

Generated from interfaces/020_dio.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 20


@dataclass
class Data(Struct):
    """State of the inputs. (player_dio_data_t)"""

    # Number of valid bits.
    count: int = 0
    # One bit per input, the first in the lowest bit.
    bits: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.count)
        writer.number("I", self.bits)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.count = reader.number("I")
        self.bits = reader.number("I")
        return self


@dataclass
class Cmd(Struct):
    """Commanded state of the outputs. (player_dio_cmd_t)"""

    # Number of valid bits.
    count: int = 0
    # One bit per output, the first in the lowest bit.
    digout: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.count)
        writer.number("I", self.digout)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.count = reader.number("I")
        self.digout = reader.number("I")
        return self


# State of the inputs.
DATA_VALUES = MessageType(20, Kind.DATA, 1, "dio.data.values", Data)
# Commanded state of the outputs.
CMD_VALUES = MessageType(20, Kind.CMD, 1, "dio.cmd.values", Cmd)
