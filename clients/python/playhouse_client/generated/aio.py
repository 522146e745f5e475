"""Interface aio, code 21. Analog inputs and outputs.

Generated from interfaces/021_aio.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 21


@dataclass
class Data(Struct):
    """Voltages of the inputs. (player_aio_data_t)"""

    # In V.
    voltages: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("voltages", len(self.voltages), 8388598)
        writer.length("voltages", len(self.voltages), 8388598)
        writer.numbers("f", self.voltages)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        voltages_count = reader.number("I")
        self.voltages = reader.numbers("f", reader.length("voltages", voltages_count, 4))
        return self


@dataclass
class Cmd(Struct):
    """Commanded voltage of one output. (player_aio_cmd_t)"""

    # Index of the output.
    id: int = 0
    # In V.
    voltage: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.id)
        writer.number("f", self.voltage)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.id = reader.number("I")
        self.voltage = reader.number("f")
        return self


# Commanded voltage of one output.
CMD_STATE = MessageType(21, Kind.CMD, 1, "aio.cmd.state", Cmd)
# Voltages of the inputs.
DATA_STATE = MessageType(21, Kind.DATA, 1, "aio.data.state", Data)
