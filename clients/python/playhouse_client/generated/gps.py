"""Interface gps, code 13. A satellite receiver.

Generated from interfaces/013_gps.toml by codegen; do not edit.
"""

from dataclasses import dataclass

from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 13


@dataclass
class Data(Struct):
    """A fix. (player_gps_data_t)"""

    # Time of the fix since 1970: whole seconds (in s).
    time_sec: int = 0
    # Time of the fix: microseconds of the second (in us).
    time_usec: int = 0
    # Positive north, WGS84 (in 1e-7 deg).
    latitude: int = 0
    # Positive east, WGS84 (in 1e-7 deg).
    longitude: int = 0
    # Above the ellipsoid (in mm).
    altitude: int = 0
    # Over ground (in m/s).
    speed: float = 0.0
    # Direction of travel, clockwise from north (in rad).
    course: float = 0.0
    # UTM easting (in m).
    utm_e: float = 0.0
    # UTM northing (in m).
    utm_n: float = 0.0
    # 0: no fix, 1: plain, 2: differential.
    quality: int = 0
    # Satellites used.
    num_sats: int = 0
    # Horizontal dilution of precision (in 0.1).
    hdop: int = 0
    # Vertical dilution of precision (in 0.1).
    vdop: int = 0
    # Expected horizontal error (in m).
    err_horz: float = 0.0
    # Expected vertical error (in m).
    err_vert: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.time_sec)
        writer.number("I", self.time_usec)
        writer.number("i", self.latitude)
        writer.number("i", self.longitude)
        writer.number("i", self.altitude)
        writer.number("d", self.speed)
        writer.number("d", self.course)
        writer.number("d", self.utm_e)
        writer.number("d", self.utm_n)
        writer.number("I", self.quality)
        writer.number("I", self.num_sats)
        writer.number("I", self.hdop)
        writer.number("I", self.vdop)
        writer.number("d", self.err_horz)
        writer.number("d", self.err_vert)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.time_sec = reader.number("I")
        self.time_usec = reader.number("I")
        self.latitude = reader.number("i")
        self.longitude = reader.number("i")
        self.altitude = reader.number("i")
        self.speed = reader.number("d")
        self.course = reader.number("d")
        self.utm_e = reader.number("d")
        self.utm_n = reader.number("d")
        self.quality = reader.number("I")
        self.num_sats = reader.number("I")
        self.hdop = reader.number("I")
        self.vdop = reader.number("I")
        self.err_horz = reader.number("d")
        self.err_vert = reader.number("d")
        return self


# The newest fix.
DATA_STATE = MessageType(13, Kind.DATA, 1, "gps.data.state", Data)
