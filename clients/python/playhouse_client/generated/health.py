"""Interface health, code 59. Load of a computer.

Generated from interfaces/059_health.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 59


@dataclass
class Cpu(Struct):
    """Processor load. (player_health_cpu_t)"""

    # Idle time (in %).
    idle: float = 0.0
    # Time in the operating system (in %).
    system: float = 0.0
    # Time in programs (in %).
    user: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.idle)
        writer.number("f", self.system)
        writer.number("f", self.user)

    @classmethod
    def read(cls, reader: Reader) -> "Cpu":
        self = cls()
        self.idle = reader.number("f")
        self.system = reader.number("f")
        self.user = reader.number("f")
        return self


@dataclass
class Memory(Struct):
    """Usage of a type of memory. (player_health_memory_t)"""

    # In byte.
    total: int = 0
    # In byte.
    used: int = 0
    # In byte.
    free: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("q", self.total)
        writer.number("q", self.used)
        writer.number("q", self.free)

    @classmethod
    def read(cls, reader: Reader) -> "Memory":
        self = cls()
        self.total = reader.number("q")
        self.used = reader.number("q")
        self.free = reader.number("q")
        return self


@dataclass
class Data(Struct):
    """Load of processor and memory. (player_health_data_t)"""

    cpu_usage: Cpu = field(default_factory=Cpu)
    mem: Memory = field(default_factory=Memory)
    swap: Memory = field(default_factory=Memory)

    def write(self, writer: Writer) -> None:
        self.cpu_usage.write(writer)
        self.mem.write(writer)
        self.swap.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.cpu_usage = Cpu.read(reader)
        self.mem = Memory.read(reader)
        self.swap = Memory.read(reader)
        return self


# Load of processor and memory.
DATA_STATE = MessageType(59, Kind.DATA, 1, "health.data.state", Data)
