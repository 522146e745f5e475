"""A Python client of Playhouse and of any Player 3 server.

    import playhouse_client

    with playhouse_client.connect("127.0.0.1:6665") as client:
        robot = client.position2d(0)
        robot.drive(0.2)
        for state in robot.updates():
            print(state.pose)
"""

from .client import Client, DeviceEntry, Mode, Rule, connect
from .device import Access, Device
from .errors import (
    ConnectionLost,
    DeviceClosed,
    DeviceGone,
    GoalRefused,
    InvalidValue,
    NoData,
    PlayerError,
    RequestRefused,
    RequestTimeout,
    RunEnded,
    WireError,
)
from .generated import proxies as _generated
from .generated.proxies import *  # noqa: F403
from .models import DeviceAddress, Model
from .robot import Robot
from .values import (
    Cell,
    Charging,
    Covariance,
    Grid,
    Image,
    Marker,
    Path,
    PlannerState,
    Pose,
    Pose3d,
    Scan,
    Size,
    Velocity,
)

__version__ = "0.2.0"

__all__ = [
    "Access", "Cell", "Charging", "Client", "ConnectionLost", "Covariance", "Device", "DeviceAddress", "DeviceClosed",
    "DeviceEntry", "DeviceGone", "GoalRefused", "Grid", "Image", "InvalidValue", "Marker", "Mode", "Model",
    "NoData", "Path", "PlannerState", "PlayerError", "Pose", "Pose3d", "RequestRefused", "RequestTimeout", "Robot", "Rule",
    "RunEnded", "Scan", "Size", "Velocity", "WireError", "connect",
    *_generated.__all__,
]
