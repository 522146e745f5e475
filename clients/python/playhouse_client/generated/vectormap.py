"""Interface vectormap, code 63. Maps of points, lines and areas in layers.

Generated from interfaces/063_vectormap.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 63


@dataclass
class FeatureData(Struct):
    """One feature. (player_vectormap_feature_data_t)"""

    name: bytes = b""
    # Its shape, as OGC well-known binary, in map coordinates.
    wkb: bytes = b""
    # Free text.
    attrib: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        writer.length("wkb", len(self.wkb), 33554392)
        writer.length("wkb", len(self.wkb), 33554392)
        writer.opaque(self.wkb)
        writer.length("attrib", len(self.attrib), 33554392)
        writer.length("attrib", len(self.attrib), 33554392)
        writer.opaque(self.attrib)

    @classmethod
    def read(cls, reader: Reader) -> "FeatureData":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        wkb_count = reader.number("I")
        self.wkb = reader.opaque(reader.length("wkb", wkb_count, 1))
        attrib_count = reader.number("I")
        self.attrib = reader.opaque(reader.length("attrib", attrib_count, 1))
        return self


@dataclass
class LayerInfo(Struct):
    """Description of a layer. (player_vectormap_layer_info_t)"""

    name: bytes = b""
    # Bounding box of all its features (in m, frame p_MP).
    extent: common.Extent2d = field(default_factory=common.Extent2d)

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        self.extent.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "LayerInfo":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        self.extent = common.Extent2d.read(reader)
        return self


@dataclass
class LayerData(Struct):
    """A layer's features. (player_vectormap_layer_data_t)"""

    name: bytes = b""
    features: List[FeatureData] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("name", len(self.name), 33554392)
        writer.length("name", len(self.name), 33554392)
        writer.opaque(self.name)
        writer.length("features", len(self.features), 1398099)
        writer.length("features", len(self.features), 1398099)
        for item in self.features:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "LayerData":
        self = cls()
        name_count = reader.number("I")
        self.name = reader.opaque(reader.length("name", name_count, 1))
        features_count = reader.number("I")
        features_length = reader.length("features", features_count, 24)
        self.features = [FeatureData.read(reader) for _ in range(features_length)]
        return self


@dataclass
class Info(Struct):
    """List of layers. (player_vectormap_info_t)"""

    # Id of the spatial reference system; 0: none.
    srid: int = 0
    layers: List[LayerInfo] = field(default_factory=list)
    # Bounding box of all layers (in m, frame p_MP).
    extent: common.Extent2d = field(default_factory=common.Extent2d)

    def write(self, writer: Writer) -> None:
        writer.number("I", self.srid)
        writer.length("layers", len(self.layers), 838859)
        writer.length("layers", len(self.layers), 838859)
        for item in self.layers:
            item.write(writer)
        self.extent.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Info":
        self = cls()
        self.srid = reader.number("I")
        layers_count = reader.number("I")
        layers_length = reader.length("layers", layers_count, 40)
        self.layers = [LayerInfo.read(reader) for _ in range(layers_length)]
        self.extent = common.Extent2d.read(reader)
        return self


# Requests the list of layers.
REQ_GET_MAP_INFO = MessageType(63, Kind.REQ, 1, "vectormap.req.get_map_info", Info)
# Requests the features of a layer.
REQ_GET_LAYER_DATA = MessageType(63, Kind.REQ, 3, "vectormap.req.get_layer_data", LayerData)
# Replaces the features of a layer.
REQ_WRITE_LAYER = MessageType(63, Kind.REQ, 4, "vectormap.req.write_layer", LayerData)
