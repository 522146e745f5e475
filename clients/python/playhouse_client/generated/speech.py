"""Interface speech, code 12. Speaks text.

Generated from interfaces/012_speech.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 12


@dataclass
class Cmd(Struct):
    """A text to speak. (player_speech_cmd_t)"""

    # NUL-terminated.
    string: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("string", len(self.string), 33554392)
        writer.length("string", len(self.string), 33554392)
        writer.opaque(self.string)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        string_count = reader.number("I")
        self.string = reader.opaque(reader.length("string", string_count, 1))
        return self


# Speaks a text; texts are spoken one after the other.
CMD_SAY = MessageType(12, Kind.CMD, 1, "speech.cmd.say", Cmd)
