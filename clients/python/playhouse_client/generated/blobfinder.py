"""Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images.

Generated from interfaces/007_blobfinder.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 7


@dataclass
class Blob(Struct):
    """A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t)"""

    # Channel that detected it.
    id: int = 0
    # 0xRRGGBB, for display.
    color: int = 0
    # Area in pixels (in px).
    area: int = 0
    # Column of its centre (in px).
    x: int = 0
    # Row of its centre (in px).
    y: int = 0
    # First column (in px).
    left: int = 0
    # Last column (in px).
    right: int = 0
    # First row (in px).
    top: int = 0
    # Last row (in px).
    bottom: int = 0
    # Distance; 0 if unknown (in m).
    range: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.id)
        writer.number("I", self.color)
        writer.number("I", self.area)
        writer.number("I", self.x)
        writer.number("I", self.y)
        writer.number("I", self.left)
        writer.number("I", self.right)
        writer.number("I", self.top)
        writer.number("I", self.bottom)
        writer.number("f", self.range)

    @classmethod
    def read(cls, reader: Reader) -> "Blob":
        self = cls()
        self.id = reader.number("I")
        self.color = reader.number("I")
        self.area = reader.number("I")
        self.x = reader.number("I")
        self.y = reader.number("I")
        self.left = reader.number("I")
        self.right = reader.number("I")
        self.top = reader.number("I")
        self.bottom = reader.number("I")
        self.range = reader.number("f")
        return self


@dataclass
class Data(Struct):
    """The blobs of one image. (player_blobfinder_data_t)"""

    # Of the image (in px).
    width: int = 0
    # Of the image (in px).
    height: int = 0
    blobs: List[Blob] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.number("I", self.width)
        writer.number("I", self.height)
        writer.length("blobs", len(self.blobs), 838859)
        writer.length("blobs", len(self.blobs), 838859)
        for item in self.blobs:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.width = reader.number("I")
        self.height = reader.number("I")
        blobs_count = reader.number("I")
        blobs_length = reader.length("blobs", blobs_count, 40)
        self.blobs = [Blob.read(reader) for _ in range(blobs_length)]
        return self


@dataclass
class ColorConfig(Struct):
    """The colors that a channel detects, as ranges of red, green and blue.
    (player_blobfinder_color_config_t)"""

    # Channel; -1 means all (signed).
    channel: int = 0
    rmin: int = 0
    rmax: int = 0
    gmin: int = 0
    gmax: int = 0
    bmin: int = 0
    bmax: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.channel)
        writer.number("I", self.rmin)
        writer.number("I", self.rmax)
        writer.number("I", self.gmin)
        writer.number("I", self.gmax)
        writer.number("I", self.bmin)
        writer.number("I", self.bmax)

    @classmethod
    def read(cls, reader: Reader) -> "ColorConfig":
        self = cls()
        self.channel = reader.number("i")
        self.rmin = reader.number("I")
        self.rmax = reader.number("I")
        self.gmin = reader.number("I")
        self.gmax = reader.number("I")
        self.bmin = reader.number("I")
        self.bmax = reader.number("I")
        return self


@dataclass
class ImagerConfig(Struct):
    """Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t)"""

    # 0 to 255.
    brightness: int = 0
    # 0 to 255.
    contrast: int = 0
    # 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance.
    colormode: int = 0
    # 0 off, 1 on.
    autogain: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.brightness)
        writer.number("i", self.contrast)
        writer.number("i", self.colormode)
        writer.number("i", self.autogain)

    @classmethod
    def read(cls, reader: Reader) -> "ImagerConfig":
        self = cls()
        self.brightness = reader.number("i")
        self.contrast = reader.number("i")
        self.colormode = reader.number("i")
        self.autogain = reader.number("i")
        return self


# The blobs of one image.
DATA_BLOBS = MessageType(7, Kind.DATA, 1, "blobfinder.data.blobs", Data)
# Sets the colors that a channel detects.
REQ_SET_COLOR = MessageType(7, Kind.REQ, 1, "blobfinder.req.set_color", ColorConfig)
# Sets brightness, contrast and other settings of the camera.
REQ_SET_IMAGER_PARAMS = MessageType(7, Kind.REQ, 2, "blobfinder.req.set_imager_params", ImagerConfig)
# Requests the colors that a channel detects.
REQ_GET_COLOR = MessageType(7, Kind.REQ, 3, "blobfinder.req.get_color", ColorConfig)
