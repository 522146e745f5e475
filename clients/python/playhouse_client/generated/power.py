"""Interface power, code 2. Battery and charger of a robot.

Generated from interfaces/002_power.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 2

# Bits of Data.valid: valid fields.
MASK_VOLTS = 1
MASK_WATTS = 2
MASK_JOULES = 4
MASK_PERCENT = 8
MASK_CHARGING = 16


@dataclass
class Data(Struct):
    """State of charge; only the fields flagged in `valid` apply. (player_power_data_t)"""

    # Bits of the valid fields.
    valid: int = 0
    # In V.
    volts: float = 0.0
    # Percentage of a full charge, 0 to 100 (in %).
    percent: float = 0.0
    # Remaining energy (in J).
    joules: float = 0.0
    # Power drawn from the battery; negative while charging (in W).
    watts: float = 0.0
    # 1 charging, 0 not, -1 charging is impossible.
    charging: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.valid)
        writer.number("f", self.volts)
        writer.number("f", self.percent)
        writer.number("f", self.joules)
        writer.number("f", self.watts)
        writer.number("i", self.charging)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.valid = reader.number("I")
        self.volts = reader.number("f")
        self.percent = reader.number("f")
        self.joules = reader.number("f")
        self.watts = reader.number("f")
        self.charging = reader.number("i")
        return self


@dataclass
class ChargepolicyConfig(Struct):
    """Enabled flows of power. (player_power_chargepolicy_config_t)"""

    # 1: the battery may be charged.
    enable_input: int = 0
    # 1: the battery may supply others.
    enable_output: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.enable_input)
        writer.number("B", self.enable_output)

    @classmethod
    def read(cls, reader: Reader) -> "ChargepolicyConfig":
        self = cls()
        self.enable_input = reader.number("B")
        self.enable_output = reader.number("B")
        return self


# State of charge.
DATA_STATE = MessageType(2, Kind.DATA, 1, "power.data.state", Data)
# Enables or disables charging and discharging of the battery.
REQ_SET_CHARGING_POLICY = MessageType(2, Kind.REQ, 1, "power.req.set_charging_policy", ChargepolicyConfig)
