"""Interface stereo, code 65. A pair of cameras, their disparity and the points in space.

Generated from interfaces/065_stereo.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import camera
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 65


@dataclass
class Pointcloud3dStereoElement(Struct):
    """One point. (player_pointcloud3d_stereo_element_t)"""

    # In m, frame p_SP.
    px: float = 0.0
    # In m, frame p_SP.
    py: float = 0.0
    # In m, frame p_SP.
    pz: float = 0.0
    red: int = 0
    green: int = 0
    blue: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.px)
        writer.number("f", self.py)
        writer.number("f", self.pz)
        writer.number("B", self.red)
        writer.number("B", self.green)
        writer.number("B", self.blue)

    @classmethod
    def read(cls, reader: Reader) -> "Pointcloud3dStereoElement":
        self = cls()
        self.px = reader.number("f")
        self.py = reader.number("f")
        self.pz = reader.number("f")
        self.red = reader.number("B")
        self.green = reader.number("B")
        self.blue = reader.number("B")
        return self


@dataclass
class Data(Struct):
    """A pair of images, and the results computed from it. (player_stereo_data_t)"""

    # Image of the left camera.
    left_channel: camera.Data = field(default_factory=camera.Data)
    # Image of the right camera.
    right_channel: camera.Data = field(default_factory=camera.Data)
    # Disparity, as an image.
    disparity: camera.Data = field(default_factory=camera.Data)
    # Points in space.
    points: List[Pointcloud3dStereoElement] = field(default_factory=list)
    # Driver-specific.
    mode: int = 0

    def write(self, writer: Writer) -> None:
        self.left_channel.write(writer)
        self.right_channel.write(writer)
        self.disparity.write(writer)
        writer.length("points", len(self.points), 1398099)
        writer.length("points", len(self.points), 1398099)
        for item in self.points:
            item.write(writer)
        writer.number("I", self.mode)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.left_channel = camera.Data.read(reader)
        self.right_channel = camera.Data.read(reader)
        self.disparity = camera.Data.read(reader)
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 24)
        self.points = [Pointcloud3dStereoElement.read(reader) for _ in range(points_length)]
        self.mode = reader.number("I")
        return self


# A pair of images, and the results computed from it.
DATA_STATE = MessageType(65, Kind.DATA, 1, "stereo.data.state", Data)
