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
from .equipment import (
    ActArray,
    ActArrayGeometry,
    ActArrayState,
    BlinkenLight,
    Blob,
    Blobfinder,
    Charging,
    Gripper,
    GripperGeometry,
    GripperState,
    ImageSize,
    Joint,
    JointGeometry,
    LightState,
    Link,
    Power,
    PowerState,
    Wifi,
    WifiState,
)
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
from .models import DeviceAddress, Model
from .proxies import (
    Aio,
    Bumper,
    Camera,
    Cell,
    Covariance,
    Face,
    Fiducial,
    Fix,
    Geometry,
    Gps,
    Grid,
    Hypothesis,
    Image,
    Imu,
    Inertia,
    Laser,
    Localize,
    Map,
    Marker,
    Opaque,
    Particle,
    Path,
    Planner,
    PlannerState,
    Point,
    PointCloud3d,
    Pose,
    Pose3d,
    Position2d,
    Position3d,
    Ptz,
    Ranger,
    Scan,
    Simulation,
    Size,
    Sonar,
    Speech,
    SpeechRecognition,
    State,
    State3d,
    Velocity,
    View,
)
from .robot import Robot

__version__ = "0.2.0"

__all__ = [
    "Access", "ActArray", "ActArrayGeometry", "ActArrayState", "Aio", "BlinkenLight", "Blob", "Blobfinder",
    "Bumper", "Camera", "Cell", "Charging", "Client", "ConnectionLost", "Covariance", "Device",
    "DeviceAddress", "DeviceClosed", "DeviceEntry", "DeviceGone", "Face", "Fiducial", "Fix", "Geometry",
    "GoalRefused", "Gps", "Grid", "Gripper", "GripperGeometry", "GripperState", "Hypothesis", "Image",
    "ImageSize", "Imu", "Inertia", "InvalidValue", "Joint", "JointGeometry", "Laser", "LightState", "Link",
    "Localize", "Map", "Marker", "Mode", "Model", "NoData", "Opaque", "Particle", "Path", "Planner",
    "PlannerState", "PlayerError", "Point", "PointCloud3d", "Pose", "Pose3d", "Position2d", "Position3d",
    "Power", "PowerState", "Ptz", "Ranger", "RequestRefused", "RequestTimeout", "Robot", "Rule", "RunEnded",
    "Scan", "Simulation", "Size", "Sonar", "Speech", "SpeechRecognition", "State", "State3d", "Velocity",
    "View", "Wifi", "WifiState", "WireError", "connect",
]
