"""Interface camera, code 40. Images.

Generated from interfaces/040_camera.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 40

# Values of Data.format.
FORMAT_MONO8 = 1
FORMAT_MONO16 = 2
FORMAT_RGB565 = 4
FORMAT_RGB888 = 5

# Values of Data.compression.
COMPRESS_RAW = 0
COMPRESS_JPEG = 1


@dataclass
class Data(Struct):
    """One image. (player_camera_data_t)"""

    # In px.
    width: int = 0
    # In px.
    height: int = 0
    # Per pixel (in bit).
    bpp: int = 0
    # Order and size of the colors.
    format: int = 0
    # Divides the values of a disparity image; 1 otherwise.
    fdiv: int = 0
    # Raw or JPEG.
    compression: int = 0
    # Rows from the top, pixels from the left, or a JPEG file.
    image: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.number("I", self.width)
        writer.number("I", self.height)
        writer.number("I", self.bpp)
        writer.number("I", self.format)
        writer.number("I", self.fdiv)
        writer.number("I", self.compression)
        writer.length("image", len(self.image), 33554392)
        writer.length("image", len(self.image), 33554392)
        writer.opaque(self.image)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.width = reader.number("I")
        self.height = reader.number("I")
        self.bpp = reader.number("I")
        self.format = reader.number("I")
        self.fdiv = reader.number("I")
        self.compression = reader.number("I")
        image_count = reader.number("I")
        self.image = reader.opaque(reader.length("image", image_count, 1))
        return self


@dataclass
class Source(Struct):
    """An input of the camera. (player_camera_source_t)"""

    # Video norm, such as PAL or NTSC, NUL-terminated.
    norm: bytes = b""
    # Index of the input.
    source: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("norm", len(self.norm), 33554392)
        writer.length("norm", len(self.norm), 33554392)
        writer.opaque(self.norm)
        writer.number("i", self.source)

    @classmethod
    def read(cls, reader: Reader) -> "Source":
        self = cls()
        norm_count = reader.number("I")
        self.norm = reader.opaque(reader.length("norm", norm_count, 1))
        self.source = reader.number("i")
        return self


# One image.
DATA_STATE = MessageType(40, Kind.DATA, 1, "camera.data.state", Data)
# Requests the camera's input and norm.
REQ_GET_SOURCE = MessageType(40, Kind.REQ, 1, "camera.req.get_source", Source)
# Selects the input and norm.
REQ_SET_SOURCE = MessageType(40, Kind.REQ, 2, "camera.req.set_source", Source)
# Requests one image now.
REQ_GET_IMAGE = MessageType(40, Kind.REQ, 3, "camera.req.get_image", Data)
