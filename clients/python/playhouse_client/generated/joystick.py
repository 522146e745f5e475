"""Interface joystick, code 49. A joystick or gamepad.

Generated from interfaces/049_joystick.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 49


@dataclass
class Data(Struct):
    """Sticks and buttons. (player_joystick_data_t)"""

    # One per axis, from -scale to scale.
    pos: List[int] = field(default_factory=lambda: [0 for _ in range(8)])
    # Maximum value per axis.
    scale: List[int] = field(default_factory=lambda: [0 for _ in range(8)])
    # One bit per button, the first in the lowest bit.
    buttons: int = 0
    # Number of axes.
    axes_count: int = 0

    def write(self, writer: Writer) -> None:
        writer.exactly("pos", len(self.pos), 8)
        writer.numbers("i", self.pos)
        writer.exactly("scale", len(self.scale), 8)
        writer.numbers("i", self.scale)
        writer.number("I", self.buttons)
        writer.number("I", self.axes_count)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.pos = reader.numbers("i", 8)
        self.scale = reader.numbers("i", 8)
        self.buttons = reader.number("I")
        self.axes_count = reader.number("I")
        return self


# Sticks and buttons.
DATA_STATE = MessageType(49, Kind.DATA, 1, "joystick.data.state", Data)
