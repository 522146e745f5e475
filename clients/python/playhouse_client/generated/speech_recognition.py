"""Interface speech_recognition, code 50. Reports recognised speech.

Generated from interfaces/050_speech_recognition.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 50


@dataclass
class Data(Struct):
    """Recognised speech. (player_speech_recognition_data_t)"""

    # NUL-terminated.
    text: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("text", len(self.text), 33554392)
        writer.length("text", len(self.text), 33554392)
        writer.opaque(self.text)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        text_count = reader.number("I")
        self.text = reader.opaque(reader.length("text", text_count, 1))
        return self


# Recognised words.
DATA_STRING = MessageType(50, Kind.DATA, 1, "speech_recognition.data.string", Data)
