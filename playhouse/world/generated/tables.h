// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The tables of the world: the state of each kind, in columns. Units, frames, roles and writers are in
/// table_columns.h and on the pages of docs/kinds/.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/world/models.h"

namespace playhouse::world {

using PositionRow = Row<struct PositionTable>;
using RangerRow = Row<struct RangerTable>;
using SensorRow = Row<struct SensorTable>;
using FiducialRow = Row<struct FiducialTable>;
using BlobfinderRow = Row<struct BlobfinderTable>;
using BumperRow = Row<struct BumperTable>;
using BlinkenlightRow = Row<struct BlinkenlightTable>;
using LightindicatorRow = Row<struct LightindicatorTable>;
using GripperRow = Row<struct GripperTable>;
using ActuatorRow = Row<struct ActuatorTable>;
using WifiRow = Row<struct WifiTable>;
using CameraRow = Row<struct CameraTable>;
using DetectorRow = Row<struct DetectorTable>;
using CustomRow = Row<struct CustomTable>;
using ImuRow = Row<struct ImuTable>;
using GpsRow = Row<struct GpsTable>;
using PackRow = Row<struct PackTable>;

/// A mobile base: a robot that drives in the plane.
struct Positions {
  std::vector<ModelRow> model;  // The model of the base.
  std::vector<ControlMode> mode;  // Control mode, the meaning of the command.
  std::vector<geom::Twist> command;  // Commanded velocity or acceleration; for a car the turn rate is the steering angle, in heading mode the heading. [m/s, m/s, m/s, rad/s or m/s^2, m/s^2, m/s^2, rad/s^2]
  std::vector<geom::Pose> goal;  // Commanded pose, for position control. [m, m, m, rad]
  std::vector<geom::Twist> velocity;  // Velocity, within the bounds. [m/s, m/s, m/s, rad/s]
  std::vector<geom::Pose> X_OM;  // Estimated pose. [m, m, m, rad]
  std::vector<geom::Pose> X_WO;  // Pose of the odometry frame in the world. [m, m, m, rad]
  std::vector<geom::Twist> odom_error;  // Odometry errors, as fractions of the motion.
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::uint8_t> motor_on;  // 0: commands are stored and not executed.
  std::size_t size() const { return model.size(); }
};

/// Range finders of any type: a laser has one sensor with many samples, a sonar ring many sensors with one.
struct Rangers {
  std::vector<ModelRow> model;  // The model of the ranger.
  std::vector<std::uint32_t> first_sensor;  // Row of its first sensor.
  std::vector<std::uint32_t> sensor_count;  // Number of sensors.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest scan; 0: none yet.
  std::vector<std::vector<float>> ring_ranges;  // Ranges of the beams of all rings, of its sensors with several rings: sensor by sensor, rings from the lowest to the highest, each from right to left; empty with the stage engine. [m]
  std::vector<std::vector<float>> ring_intensities;  // Intensities of those beams.
  std::size_t size() const { return model.size(); }
};

/// One transducer or scanner of a ranger.
struct Sensors {
  std::vector<RangerRow> ranger;  // Row of its ranger.
  std::vector<std::uint32_t> first_beam;  // Row of its first beam, the rightmost.
  std::vector<std::uint32_t> beam_count;  // Number of beams.
  std::vector<float> ranges;  // Range of a beam; the maximum range without a hit. Of several rings the one nearest to level. [m] (beams)
  std::vector<float> intensities;  // The ranger_return of the hit surface; 0 without a hit. (beams)
  std::size_t size() const { return ranger.size(); }
};

/// A marker in view.
struct FiducialHit {
  ModelId target;  // The marked model.
  std::int32_t id = 0;  // Its id; 0 beyond range_max_id.
  double range = 0;  // Range from centre to centre. [m]
  double bearing = 0;  // Bearing of the marker. [rad]
  double heading = 0;  // Orientation of the marker. [rad]
  geom::Size size;  // Size of the marker. [m]
  friend bool operator==(const FiducialHit&, const FiducialHit&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(FiducialHit& value, const Visit& visit) {
  auto& [target, id, range, bearing, heading, size] = value;
  visit(target), visit(id), visit(range), visit(bearing), visit(heading), visit(size);
}
template <typename Visit>
void each_part(const FiducialHit& value, const Visit& visit) {
  const auto& [target, id, range, bearing, heading, size] = value;
  visit(target), visit(id), visit(range), visit(bearing), visit(heading), visit(size);
}

/// A fiducial finder: detects markers (models with a fiducial_return) and reports their ids and poses.
struct Fiducials {
  std::vector<ModelRow> model;  // The model of the finder.
  std::vector<std::vector<FiducialHit>> hits;  // Markers in view, by row.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest list; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A region of one color. Pixel coordinates start at the top left corner of the image.
struct Blob {
  scene::Color color;  // Color of the region; alpha is meaningless.
  std::uint32_t channel = 0;  // Index of the color among the detected ones; 0 if any color is detected.
  std::uint32_t left = 0;  // First column. [px]
  std::uint32_t right = 0;  // Last column. [px]
  std::uint32_t top = 0;  // First row. [px]
  std::uint32_t bottom = 0;  // Last row. [px]
  double range = 0;  // Mean range over its columns. [m]
  friend bool operator==(const Blob&, const Blob&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(Blob& value, const Visit& visit) {
  auto& [color, channel, left, right, top, bottom, range] = value;
  visit(color), visit(channel), visit(left), visit(right), visit(top), visit(bottom), visit(range);
}
template <typename Visit>
void each_part(const Blob& value, const Visit& visit) {
  const auto& [color, channel, left, right, top, bottom, range] = value;
  visit(color), visit(channel), visit(left), visit(right), visit(top), visit(bottom), visit(range);
}

/// A camera that reports regions of one color (blobs).
struct Blobfinders {
  std::vector<ModelRow> model;  // The model of the camera.
  std::vector<std::vector<Blob>> blobs;  // Detected blobs, from right to left.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest image; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// Contact switches.
struct Bumpers {
  std::vector<ModelRow> model;  // The model of the bumper.
  std::vector<std::vector<ModelId>> hits;  // Model that presses each switch, or none.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A flashing lamp.
struct Blinkenlights {
  std::vector<ModelRow> model;  // The model of the lamp.
  std::vector<std::uint8_t> enabled;  // Switched on, also between two flashes.
  std::vector<double> period;  // Period of the flashes; 0: steady light. [s]
  std::vector<double> dutycycle;  // Fraction of the period in which it is lit.
  std::vector<std::uint8_t> lit;  // Emits light now: it is switched on and in a flash.
  std::size_t size() const { return model.size(); }
};

/// A body that indicates an on/off state; it is darker while off, its initial state.
struct Lightindicators {
  std::vector<ModelRow> model;  // The model of the indicator.
  std::vector<std::uint8_t> lit;  // Switched on.
  std::size_t size() const { return model.size(); }
};

/// A gripper: two paddles that close around an object and carry it.
struct Grippers {
  std::vector<ModelRow> model;  // The model of the gripper.
  std::vector<double> paddles;  // Closure of the paddles: 0 open, 1 closed.
  std::vector<std::int32_t> closing;  // Motion of the paddles: 1 closing, -1 opening, 0 at rest.
  std::vector<double> lift;  // Height of the lift: 0 down, 1 up.
  std::vector<std::int32_t> rising;  // Motion of the lift: 1 rising, -1 sinking, 0 at rest.
  std::vector<double> close_limit;  // Maximum closure: less than 1 around an object.
  std::vector<ModelId> held;  // The held model, or none.
  std::vector<std::uint32_t> beams;  // Broken beams between the paddles: 1 the inner one, 2 the outer one, 3 both.
  std::vector<std::uint32_t> contacts;  // Paddles in contact: 1 the left one, 2 the right one, 3 both.
  std::vector<ModelId> touched;  // Model in contact with the closing paddles, the left one's first; else none.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement of beams and contacts; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A prismatic or revolute joint that moves the models on it.
struct Actuators {
  std::vector<ModelRow> model;  // The model of the joint.
  std::vector<ControlMode> mode;  // Control mode: velocity or position.
  std::vector<double> command;  // Commanded velocity. [m/s or rad/s]
  std::vector<double> goal;  // Commanded position, for position control. [m or rad]
  std::vector<double> speed;  // Maximum speed in position control. [m/s or rad/s]
  std::vector<double> velocity;  // Velocity along its axis, within its speed and travel limits. [m/s or rad/s]
  std::vector<double> position;  // Position along its axis. [m or rad]
  std::vector<geom::Pose> X_PJ;  // Pose in its parent at position 0. [m, m, m, rad]
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::uint8_t> motor_on;  // 0: commands are stored and not executed.
  std::vector<std::uint8_t> braked;  // 1: commands are stored and not executed.
  std::size_t size() const { return model.size(); }
};

/// A received radio.
struct WifiLink {
  ModelId station;  // The radio.
  double level = 0;  // Received level. [dBm]
  std::uint32_t quality = 0;  // Margin above the sensitivity: 100 from 30 dB on. [%]
  friend bool operator==(const WifiLink&, const WifiLink&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(WifiLink& value, const Visit& visit) {
  auto& [station, level, quality] = value;
  visit(station), visit(level), visit(quality);
}
template <typename Visit>
void each_part(const WifiLink& value, const Visit& visit) {
  const auto& [station, level, quality] = value;
  visit(station), visit(level), visit(quality);
}

/// A message between radios; its bytes are in a separate list, after those of the previous messages.
struct RadioMessage {
  ModelId station;  // Outgoing: the receiver, or none for a broadcast; incoming: the sender.
  std::uint32_t size = 0;  // Length of the payload. [byte]
  friend bool operator==(const RadioMessage&, const RadioMessage&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(RadioMessage& value, const Visit& visit) {
  auto& [station, size] = value;
  visit(station), visit(size);
}
template <typename Visit>
void each_part(const RadioMessage& value, const Visit& visit) {
  const auto& [station, size] = value;
  visit(station), visit(size);
}

/// A radio: reports the received radios of its network with their signal levels, and carries messages between
/// them.
struct Wifis {
  std::vector<ModelRow> model;  // The model of the radio.
  std::vector<std::vector<WifiLink>> links;  // Received radios, by id.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::vector<std::vector<RadioMessage>> outgoing;  // Messages to send in the next tick.
  std::vector<std::vector<std::uint8_t>> outgoing_bytes;  // Payloads of those messages, concatenated.
  std::vector<std::vector<RadioMessage>> incoming;  // Messages received in the last tick, by the id of the sender, then in the order of sending.
  std::vector<std::vector<std::uint8_t>> incoming_bytes;  // Payloads of those messages, concatenated.
  std::vector<std::uint64_t> dropped;  // Number of messages dropped for lack of space since the start, outgoing and incoming.
  std::size_t size() const { return model.size(); }
};

/// A pixel of an image.
struct Pixel {
  std::uint32_t sample = 0;  // 0xRRGGBB, brightness from 0 to 255, depth in mm, or an id plus 1; the last two are 0 if nothing is in range.
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(Pixel& value, const Visit& visit) {
  auto& [sample] = value;
  visit(sample);
}
template <typename Visit>
void each_part(const Pixel& value, const Visit& visit) {
  const auto& [sample] = value;
  visit(sample);
}

/// A camera with pan, tilt and zoom. It renders color, gray, depth or segmentation images of bodies, floor
/// and sky.
struct Cameras {
  std::vector<ModelRow> model;  // The model of the camera.
  std::vector<ControlMode> mode;  // Control mode: velocity or position.
  std::vector<double> goal_pan;  // Commanded pan, positive to the left. [rad]
  std::vector<double> goal_tilt;  // Commanded tilt, positive upwards. [rad]
  std::vector<double> goal_zoom;  // Commanded horizontal field of view. [rad]
  std::vector<double> command_pan;  // Commanded pan velocity, positive to the left. [rad/s]
  std::vector<double> command_tilt;  // Commanded tilt velocity, positive upwards. [rad/s]
  std::vector<double> pan;  // Pan angle, positive to the left. [rad]
  std::vector<double> tilt;  // Tilt angle, positive upwards. [rad]
  std::vector<double> zoom;  // Horizontal field of view. [rad]
  std::vector<double> pan_speed;  // Pan velocity, positive to the left. [rad/s]
  std::vector<double> tilt_speed;  // Tilt velocity, positive upwards. [rad/s]
  std::vector<std::vector<Pixel>> pixels;  // The image, in rows from top to bottom, each from left to right.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest image; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// Measurement of a beam.
struct Echo {
  float range = 0;  // Range of the nearest object; the maximum range if there is none. [m]
  float level = 0;  // Remaining budget of that object; 0 if there is none. [dB]
  friend bool operator==(const Echo&, const Echo&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(Echo& value, const Visit& visit) {
  auto& [range, level] = value;
  visit(range), visit(level);
}
template <typename Visit>
void each_part(const Echo& value, const Visit& visit) {
  const auto& [range, level] = value;
  visit(range), visit(level);
}

/// A detected object: a top-level model with all its parts.
struct Detection {
  ModelId target;  // The top-level model.
  std::int32_t number = 0;  // The fiducial_return of its detected part.
  double range = 0;  // Range of its nearest detected point. [m]
  double bearing = 0;  // Middle of the lines that detect it. [rad]
  double level = 0;  // Remaining budget at its nearest point. [dB]
  std::uint32_t bodies = 0;  // Number of bodies in front of that point.
  friend bool operator==(const Detection&, const Detection&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(Detection& value, const Visit& visit) {
  auto& [target, number, range, bearing, level, bodies] = value;
  visit(target), visit(number), visit(range), visit(bearing), visit(level), visit(bodies);
}
template <typename Visit>
void each_part(const Detection& value, const Visit& visit) {
  const auto& [target, number, range, bearing, level, bodies] = value;
  visit(target), visit(number), visit(range), visit(bearing), visit(level), visit(bodies);
}

/// A sensor specified in the world file: what it detects and penetrates, its range, resolution and noise
/// (docs/detectors.md).
struct Detectors {
  std::vector<ModelRow> model;  // The model of the detector.
  std::vector<std::vector<Echo>> echoes;  // Measurement of each beam, from right to left.
  std::vector<std::vector<Detection>> finds;  // Detected objects, by id.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A model or sensor implemented in a shared library.
struct Customs {
  std::vector<ModelRow> model;  // The model itself.
  std::vector<std::vector<double>> command;  // Command values, interpreted by its library.
  std::vector<std::vector<double>> state;  // State that its library keeps from tick to tick.
  std::vector<geom::Twist> velocity;  // Velocity. [m/s, m/s, m/s, rad/s]
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::vector<double>> readings;  // Measured values, interpreted by its library.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest readings; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// An inertial measurement unit: measures specific force and turn rate, and estimates its orientation.
struct Imus {
  std::vector<ModelRow> model;  // The model of the unit.
  std::vector<geom::SpatialVelocity> reading;  // Measured specific force and turn rates, with errors: means since the previous measurement. [m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s]
  std::vector<geom::SpatialVelocity> bias;  // Current biases (random walk). [m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s]
  std::vector<geom::Pose> X_WB;  // True pose at the newest measurement. [m, m, m, rad]
  std::vector<geom::Tilt> tilt_WB;  // True tilt at the newest measurement. [rad]
  std::vector<geom::Vec3> v_WB;  // True velocity at the newest measurement, along x, y and z. [m/s]
  std::vector<geom::Pose> X_WE;  // Estimated pose: its readings integrated from the pose at the first measurement. [m, m, m, rad]
  std::vector<geom::Tilt> tilt_WE;  // Estimated tilt. [rad]
  std::vector<geom::Vec3> v_WE;  // Estimated velocity, along x, y and z. [m/s]
  std::vector<double> heading_error;  // Drift of the heading: the integral of the errors of its turn rate. [rad]
  std::vector<double> reference_heading;  // Reference heading, reported as 0; set by a client. [rad]
  std::vector<geom::Tilt> reference_tilt;  // Reference tilt, reported as none; set by a client. [rad]
  std::vector<std::uint64_t> noted_tick;  // Tick of the true pose; 0: no measurement yet.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A satellite receiver: reports its position on the earth, derived from the world's latitude, longitude and
/// altitude.
struct Receivers {
  std::vector<ModelRow> model;  // The model of the receiver.
  std::vector<geom::Vec3> position;  // Measured position: x, y and z. [m]
  std::vector<geom::Vec3> velocity;  // Measured velocity along x, y and z, the mean since the previous fix. [m/s]
  std::vector<geom::Vec3> drift;  // Slowly varying part of its error, along x, y and z. [m]
  std::vector<geom::Vec3> p_WB;  // True position at the newest measurement: x, y and z. [m]
  std::vector<std::uint64_t> noted_tick;  // Tick of that position; 0: no measurement yet.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest fix; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A battery that supplies a model and its descendants without one of their own.
struct Packs {
  std::vector<ModelRow> model;  // The model with the battery.
  std::vector<double> stored;  // Stored energy; below 0: infinite. [J]
  std::vector<double> capacity;  // Capacity. [J]
  std::vector<double> dissipated;  // Energy consumed since the start, without energy given to other models. [J]
  std::vector<double> watts;  // Net power drawn in the last tick; below 0: charging exceeded consumption. [W]
  std::vector<std::uint8_t> charging;  // Charged in the last tick.
  std::vector<std::uint8_t> takes;  // May be charged.
  std::vector<std::uint8_t> gives;  // May charge other models.
  std::size_t size() const { return model.size(); }
};

/// Whether models of a kind move by themselves in the phase `move`, and take along what they carry.
constexpr bool moves(scene::ModelKind kind) {
  switch (kind) {
    case scene::ModelKind::kPosition:
    case scene::ModelKind::kActuator:
    case scene::ModelKind::kCustom:
      return true;
    default:
      return false;
  }
}

/// The state, in columns; columns.h lists them all, with what each is to a run.
struct Tables {
  Models models;
  Positions positions;
  Rangers rangers;
  Sensors sensors;
  Fiducials fiducials;
  Blobfinders blobfinders;
  Bumpers bumpers;
  Blinkenlights blinkenlights;
  Lightindicators lightindicators;
  Grippers grippers;
  Actuators actuators;
  Wifis wifis;
  Cameras cameras;
  Detectors detectors;
  Customs customs;
  Imus imus;
  Receivers receivers;
  Packs packs;
};

}  // namespace playhouse::world
