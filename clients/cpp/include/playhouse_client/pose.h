#pragma once

/// Poses, velocities and sizes of the client API, under the same names in C++ and Python
/// (docs/clients.md). SI units and radians; x forward, y left, z up, angles counter-clockwise.

namespace playhouse::client {

/// A planar pose: x and y in m, a in rad.
struct Pose {
  double x = 0, y = 0, a = 0;
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// In the robot's frame: x and y in m/s, a in rad/s.
struct Velocity {
  double x = 0, y = 0, a = 0;
  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// A pose in space: m and rad.
struct Pose3d {
  double x = 0, y = 0, z = 0;
  double roll = 0, pitch = 0, yaw = 0;
  friend bool operator==(const Pose3d&, const Pose3d&) = default;
};

/// A point of the plane, in m.
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Extents in m along x, y and z.
struct Size {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

/// Pose of a device on its robot (for a base: its own centre), and its extents.
struct Geometry {
  Pose3d pose;
  Size size;
};

}  // namespace playhouse::client
