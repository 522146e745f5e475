"""Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink.

Generated from interfaces/033_blinkenlight.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 33


@dataclass
class Data(Struct):
    """State of the light. (player_blinkenlight_data_t)"""

    # 1: on, 0: off.
    enable: int = 0
    # Blinking period; 0: steady light (in s).
    period: float = 0.0
    # Duty cycle: fraction of the period in which the light is on, 0 to 1.
    dutycycle: float = 0.0
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.number("B", self.enable)
        writer.number("f", self.period)
        writer.number("f", self.dutycycle)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.enable = reader.number("B")
        self.period = reader.number("f")
        self.dutycycle = reader.number("f")
        self.color = common.Color.read(reader)
        return self


@dataclass
class Cmd(Struct):
    """Commanded state of one light. (player_blinkenlight_cmd_t)"""

    # Index of the light.
    id: int = 0
    # 1: on, 0: off.
    enable: int = 0
    # Blinking period; 0: steady light (in s).
    period: float = 0.0
    # Duty cycle: fraction of the period in which the light is on, 0 to 1.
    dutycycle: float = 0.0
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.number("H", self.id)
        writer.number("B", self.enable)
        writer.number("f", self.period)
        writer.number("f", self.dutycycle)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.id = reader.number("H")
        self.enable = reader.number("B")
        self.period = reader.number("f")
        self.dutycycle = reader.number("f")
        self.color = common.Color.read(reader)
        return self


@dataclass
class CmdPower(Struct):
    """Switch of one light. (player_blinkenlight_cmd_power_t)"""

    # Index of the light.
    id: int = 0
    # 1: on, 0: off.
    enable: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("H", self.id)
        writer.number("B", self.enable)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPower":
        self = cls()
        self.id = reader.number("H")
        self.enable = reader.number("B")
        return self


@dataclass
class CmdColor(Struct):
    """Color of one light. (player_blinkenlight_cmd_color_t)"""

    # Index of the light.
    id: int = 0
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.number("H", self.id)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "CmdColor":
        self = cls()
        self.id = reader.number("H")
        self.color = common.Color.read(reader)
        return self


@dataclass
class CmdFlash(Struct):
    """Blinking of one light. (player_blinkenlight_cmd_flash_t)"""

    # Index of the light.
    id: int = 0
    # Blinking period (in s).
    period: float = 0.0
    # Duty cycle: fraction of the period in which the light is on, 0 to 1.
    dutycycle: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("H", self.id)
        writer.number("f", self.period)
        writer.number("f", self.dutycycle)

    @classmethod
    def read(cls, reader: Reader) -> "CmdFlash":
        self = cls()
        self.id = reader.number("H")
        self.period = reader.number("f")
        self.dutycycle = reader.number("f")
        return self


# State of the light.
DATA_STATE = MessageType(33, Kind.DATA, 1, "blinkenlight.data.state", Data)
# Sets all properties of one light.
CMD_STATE = MessageType(33, Kind.CMD, 1, "blinkenlight.cmd.state", Cmd)
# Switches one light.
CMD_POWER = MessageType(33, Kind.CMD, 2, "blinkenlight.cmd.power", CmdPower)
# Colors one light.
CMD_COLOR = MessageType(33, Kind.CMD, 3, "blinkenlight.cmd.color", CmdColor)
# Makes one light blink.
CMD_FLASH = MessageType(33, Kind.CMD, 4, "blinkenlight.cmd.flash", CmdFlash)
