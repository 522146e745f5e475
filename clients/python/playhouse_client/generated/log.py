"""Interface log, code 45. Records data of devices to a file, or plays back such a file.

Generated from interfaces/045_log.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 45

# Values of GetState.type.
TYPE_READ = 1
TYPE_WRITE = 2


@dataclass
class SetWriteState(Struct):
    """Whether data is being recorded. (player_log_set_write_state_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "SetWriteState":
        self = cls()
        self.state = reader.number("B")
        return self


@dataclass
class SetReadState(Struct):
    """Whether the file is being played. (player_log_set_read_state_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "SetReadState":
        self = cls()
        self.state = reader.number("B")
        return self


@dataclass
class GetState(Struct):
    """Type and state of the device. (player_log_get_state_t)"""

    # Reader or writer.
    type: int = 0
    # 1: running, 0: stopped.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.type)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "GetState":
        self = cls()
        self.type = reader.number("B")
        self.state = reader.number("B")
        return self


@dataclass
class SetFilename(Struct):
    """The file to write to. (player_log_set_filename_t)"""

    # NUL-terminated.
    filename: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("filename", len(self.filename), 256)
        writer.length("filename", len(self.filename), 256)
        writer.opaque(self.filename)

    @classmethod
    def read(cls, reader: Reader) -> "SetFilename":
        self = cls()
        reader.number("I")
        self.filename = reader.opaque(reader.length("filename", 256, 1))
        return self


# Starts or stops writing.
REQ_SET_WRITE_STATE = MessageType(45, Kind.REQ, 1, "log.req.set_write_state", SetWriteState)
# Starts or stops playing.
REQ_SET_READ_STATE = MessageType(45, Kind.REQ, 2, "log.req.set_read_state", SetReadState)
# Requests the type and state of the device.
REQ_GET_STATE = MessageType(45, Kind.REQ, 3, "log.req.get_state", GetState)
# Rewinds to the start of the file.
REQ_SET_READ_REWIND = MessageType(45, Kind.REQ, 4, "log.req.set_read_rewind")
# Sets the file to write to.
REQ_SET_FILENAME = MessageType(45, Kind.REQ, 5, "log.req.set_filename", SetFilename)
