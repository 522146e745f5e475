"""Every interface of the Player protocol: values, and their encoding and decoding.

Generated from interfaces/ by codegen; do not edit.
"""

from typing import Dict, Optional

from ..wire import Kind, MessageType
from . import common
from . import (
    player,
    power,
    gripper,
    position2d,
    sonar,
    laser,
    blobfinder,
    ptz,
    audio,
    fiducial,
    speech,
    gps,
    bumper,
    dio,
    aio,
    ir,
    wifi,
    localize,
    position3d,
    simulation,
    blinkenlight,
    camera,
    map,
    planner,
    log,
    joystick,
    speech_recognition,
    opaque,
    position1d,
    actarray,
    limb,
    graphics2d,
    rfid,
    wsn,
    graphics3d,
    health,
    imu,
    pointcloud3d,
    ranger,
    vectormap,
    blackboard,
    stereo,
    coopobject,
)

# Code of an interface -> its name.
INTERFACES: Dict[int, str] = {
    1: "player",
    2: "power",
    3: "gripper",
    4: "position2d",
    5: "sonar",
    6: "laser",
    7: "blobfinder",
    8: "ptz",
    9: "audio",
    10: "fiducial",
    12: "speech",
    13: "gps",
    14: "bumper",
    20: "dio",
    21: "aio",
    22: "ir",
    23: "wifi",
    25: "localize",
    30: "position3d",
    31: "simulation",
    33: "blinkenlight",
    40: "camera",
    42: "map",
    44: "planner",
    45: "log",
    49: "joystick",
    50: "speech_recognition",
    51: "opaque",
    52: "position1d",
    53: "actarray",
    54: "limb",
    55: "graphics2d",
    56: "rfid",
    57: "wsn",
    58: "graphics3d",
    59: "health",
    60: "imu",
    61: "pointcloud3d",
    62: "ranger",
    63: "vectormap",
    64: "blackboard",
    65: "stereo",
    66: "coopobject",
}

_MODULES = (
    player,
    power,
    gripper,
    position2d,
    sonar,
    laser,
    blobfinder,
    ptz,
    audio,
    fiducial,
    speech,
    gps,
    bumper,
    dio,
    aio,
    ir,
    wifi,
    localize,
    position3d,
    simulation,
    blinkenlight,
    camera,
    map,
    planner,
    log,
    joystick,
    speech_recognition,
    opaque,
    position1d,
    actarray,
    limb,
    graphics2d,
    rfid,
    wsn,
    graphics3d,
    health,
    imu,
    pointcloud3d,
    ranger,
    vectormap,
    blackboard,
    stereo,
    coopobject,
)


def _catalogue() -> Dict[tuple, MessageType]:
    rows = {}
    for module in (common,) + _MODULES:
        for value in vars(module).values():
            if isinstance(value, MessageType):
                rows[(value.interface, value.kind, value.subtype)] = value
    return rows


_CATALOGUE = _catalogue()


def find_message(interface: int, kind: int, subtype: int) -> Optional[MessageType]:
    """The row of a message, or None. Answers have the row of their request; shared messages apply to every interface."""
    if kind in (Kind.ACK, Kind.NACK):
        kind = Kind.REQ
    return _CATALOGUE.get((0, kind, subtype)) or _CATALOGUE.get((interface, kind, subtype))
