// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The tables of the world: what there is of each kind, in columns. Units, frames, roles and writers are in
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

/// A robot that drives in the plane.
struct Positions {
  std::vector<ModelRow> model;  // The model that drives.
  std::vector<ControlMode> mode;  // What the command means.
  std::vector<geom::Twist> command;  // Wanted velocity or acceleration; of a car the steering angle, by heading the heading itself, stands for the turn rate. [m/s, m/s, m/s, rad/s or m/s^2, m/s^2, m/s^2, rad/s^2]
  std::vector<geom::Pose> goal;  // Wanted pose, for control by position. [m, m, m, rad]
  std::vector<geom::Twist> velocity;  // Velocity within the bounds. [m/s, m/s, m/s, rad/s]
  std::vector<geom::Pose> X_OM;  // What the robot believes. [m, m, m, rad]
  std::vector<geom::Pose> X_WO;  // Where the frame of odometry is in the world. [m, m, m, rad]
  std::vector<geom::Twist> odom_error;  // Errors as fractions of the motion.
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::uint8_t> motor_on;  // Where it is 0 commands are kept and move nothing.
  std::size_t size() const { return model.size(); }
};

/// Range finders of any kind: a laser has one sensor with many samples, a ring of sonars many with one.
struct Rangers {
  std::vector<ModelRow> model;  // The model that measures.
  std::vector<std::uint32_t> first_sensor;  // The first of its sensors.
  std::vector<std::uint32_t> sensor_count;  // How many sensors it has.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest scan; 0: none yet.
  std::vector<std::vector<float>> ring_ranges;  // Along the beams of all rings of those of its sensors that have several, sensor by sensor: from the lowest ring to the highest, each from the right to the left; empty with the stage engine. [m]
  std::vector<std::vector<float>> ring_intensities;  // What came back along those beams.
  std::size_t size() const { return model.size(); }
};

/// One transducer or scanner of a ranger.
struct Sensors {
  std::vector<RangerRow> ranger;  // The ranger that it is part of.
  std::vector<std::uint32_t> first_beam;  // Its first beam, the rightmost.
  std::vector<std::uint32_t> beam_count;  // How many beams it has.
  std::vector<float> ranges;  // Along the beam; the largest range where nothing is hit. Of several rings the one that is nearest to level. [m] (beams)
  std::vector<float> intensities;  // The ranger_return of what was hit, else 0. (beams)
  std::size_t size() const { return ranger.size(); }
};

/// A mark in view.
struct FiducialHit {
  ModelId target;  // The model that is marked.
  std::int32_t id = 0;  // Its number; 0 beyond range_max_id.
  double range = 0;  // From centre to centre. [m]
  double bearing = 0;  // Where it is seen. [rad]
  double heading = 0;  // How it is turned. [rad]
  geom::Size size;  // How large it is. [m]
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

/// A finder of marks: sees models with a fiducial_return and tells which they are and where.
struct Fiducials {
  std::vector<ModelRow> model;  // The model that sees.
  std::vector<std::vector<FiducialHit>> hits;  // The marks in view, by row.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest list; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A patch of one color. Pixels count from the top left corner of the image.
struct Blob {
  scene::Color color;  // As it is seen; its alpha says nothing.
  std::uint32_t channel = 0;  // The place of the color among those that are looked for; 0 where any is.
  std::uint32_t left = 0;  // Its first column. [px]
  std::uint32_t right = 0;  // Its last column. [px]
  std::uint32_t top = 0;  // Its first row. [px]
  std::uint32_t bottom = 0;  // Its last row. [px]
  double range = 0;  // The mean over its columns. [m]
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

/// A camera that finds patches of a colour.
struct Blobfinders {
  std::vector<ModelRow> model;  // The model that sees.
  std::vector<std::vector<Blob>> blobs;  // What it sees, from right to left.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest image; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// Switches that feel a touch.
struct Bumpers {
  std::vector<ModelRow> model;  // The model that feels.
  std::vector<std::vector<ModelId>> hits;  // Who presses each switch, none where it is free.
  std::vector<std::uint64_t> measured_tick;  // Tick at which it felt last; 0: never.
  std::size_t size() const { return model.size(); }
};

/// A lamp that can blink.
struct Blinkenlights {
  std::vector<ModelRow> model;  // The model that is a lamp.
  std::vector<std::uint8_t> enabled;  // It is on, if need be between two flashes.
  std::vector<double> period;  // Time from one flash to the next; 0: it burns steadily. [s]
  std::vector<double> dutycycle;  // The share of the period in which it is lit.
  std::vector<std::uint8_t> lit;  // It is on, and this is a flash.
  std::size_t size() const { return model.size(); }
};

/// A body that is darker while it is off, as it is at the start.
struct Lightindicators {
  std::vector<ModelRow> model;  // The model that shows it.
  std::vector<std::uint8_t> lit;  // It is on.
  std::size_t size() const { return model.size(); }
};

/// Two paddles that close around a thing and carry it.
struct Grippers {
  std::vector<ModelRow> model;  // The model that grips.
  std::vector<double> paddles;  // How far they are closed: 0 open, 1 closed.
  std::vector<std::int32_t> closing;  // What the paddles do: 1 they close, -1 they open, 0 they stand.
  std::vector<double> lift;  // How far the paddles are raised: 0 down, 1 up.
  std::vector<std::int32_t> rising;  // What the lift does: 1 it rises, -1 it sinks, 0 it stands.
  std::vector<double> close_limit;  // How far the paddles can close: less than 1 around a thing.
  std::vector<ModelId> held;  // What it took up, or none.
  std::vector<std::uint32_t> beams;  // Which beams between the paddles are broken: 1 the inner one, 2 the outer one, 3 both.
  std::vector<std::uint32_t> contacts;  // Which paddles touch something: 1 the left one, 2 the right one, 3 both.
  std::vector<ModelId> touched;  // What they met while they closed, the left one's first; else none.
  std::vector<std::uint64_t> measured_tick;  // Tick in which beams and contacts were measured; 0: not yet.
  std::size_t size() const { return model.size(); }
};

/// A joint that slides or turns, with what it carries.
struct Actuators {
  std::vector<ModelRow> model;  // The model that moves.
  std::vector<ControlMode> mode;  // What the command means: a velocity, or a position.
  std::vector<double> command;  // Wanted velocity. [m/s or rad/s]
  std::vector<double> goal;  // Wanted position, for control by position. [m or rad]
  std::vector<double> speed;  // How fast it goes to a position, at most. [m/s or rad/s]
  std::vector<double> velocity;  // Velocity along its axis, within its speed and its ends. [m/s or rad/s]
  std::vector<double> position;  // How far it is along its axis. [m or rad]
  std::vector<geom::Pose> X_PJ;  // Where it is in its parent when its position is 0. [m, m, m, rad]
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::uint8_t> motor_on;  // Where it is 0 commands are kept and move nothing.
  std::vector<std::uint8_t> braked;  // Where it is 1 commands are kept and move nothing.
  std::size_t size() const { return model.size(); }
};

/// A radio that is heard.
struct WifiLink {
  ModelId station;  // The radio.
  double level = 0;  // How strongly it arrives. [dBm]
  std::uint32_t quality = 0;  // How far that is above the sensitivity: 100 from 30 dB on. [%]
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

/// A message between radios; its bytes are in a list of their own, behind those of the messages before it.
struct RadioMessage {
  ModelId station;  // Of one to be sent: for whom it is, or none: for all; of one that arrived: who sent it.
  std::uint32_t size = 0;  // How long it is. [byte]
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

/// A radio: tells which others of its network it hears, and how well, and carries messages between them.
struct Wifis {
  std::vector<ModelRow> model;  // The model that hears.
  std::vector<std::vector<WifiLink>> links;  // The radios that it hears, by id.
  std::vector<std::uint64_t> measured_tick;  // Tick at which it listened last; 0: never.
  std::vector<std::vector<RadioMessage>> outgoing;  // What it sends in the next tick.
  std::vector<std::vector<std::uint8_t>> outgoing_bytes;  // The bytes of those messages, one after the other.
  std::vector<std::vector<RadioMessage>> incoming;  // What arrived in the last tick, by the id of the sender and then as it was sent.
  std::vector<std::vector<std::uint8_t>> incoming_bytes;  // The bytes of those messages, one after the other.
  std::vector<std::uint64_t> dropped;  // How many messages had no room, to be sent or as they arrived, since the start.
  std::size_t size() const { return model.size(); }
};

/// A pixel of an image.
struct Pixel {
  std::uint32_t sample = 0;  // 0xRRGGBB, brightness from 0 to 255, mm, or an id plus 1; the last two 0 where nothing is in range.
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

/// A camera: takes images of the bodies, the floor and the sky, in colours, in grey, of distances, or of
/// which model is where, and pans, tilts and zooms.
struct Cameras {
  std::vector<ModelRow> model;  // The model that sees.
  std::vector<ControlMode> mode;  // What commands mean: a velocity, or a position.
  std::vector<double> goal_pan;  // Where it shall look, to the left. [rad]
  std::vector<double> goal_tilt;  // Where it shall look, up. [rad]
  std::vector<double> goal_zoom;  // The field of view that it shall have. [rad]
  std::vector<double> command_pan;  // Wanted velocity to the left. [rad/s]
  std::vector<double> command_tilt;  // Wanted velocity upwards. [rad/s]
  std::vector<double> pan;  // Where it looks, to the left. [rad]
  std::vector<double> tilt;  // Where it looks, up. [rad]
  std::vector<double> zoom;  // Its horizontal field of view. [rad]
  std::vector<double> pan_speed;  // How fast it turns to the left. [rad/s]
  std::vector<double> tilt_speed;  // How fast it turns upwards. [rad/s]
  std::vector<std::vector<Pixel>> pixels;  // The image, row by row from the top, from left to right.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest image; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// What a beam tells.
struct Echo {
  float range = 0;  // The nearest thing; the largest range where there is none. [m]
  float level = 0;  // How far that is above the faintest that it tells of; 0 where there is none. [dB]
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

/// A thing that is found: a model of the top level with all that is part of it.
struct Detection {
  ModelId target;  // The model of the top level.
  std::int32_t number = 0;  // The fiducial_return of what is seen of it.
  double range = 0;  // To the nearest that is seen of it. [m]
  double bearing = 0;  // The middle of the lines along which it is seen. [rad]
  double level = 0;  // How far it is above the faintest that is told of, where it is nearest. [dB]
  std::uint32_t bodies = 0;  // How many bodies are before it there.
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

/// A sensor made up in the world file: what it sees, what it sees through, how far, how finely and how well
/// (docs/detectors.md).
struct Detectors {
  std::vector<ModelRow> model;  // The model that sees.
  std::vector<std::vector<Echo>> echoes;  // What each beam tells, from right to left.
  std::vector<std::vector<Detection>> finds;  // The things that are found, by id.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A model or a sensor whose code is in a shared library.
struct Customs {
  std::vector<ModelRow> model;  // The model that it is.
  std::vector<std::vector<double>> command;  // What it is told, as its library means it.
  std::vector<std::vector<double>> state;  // What its library remembers from tick to tick.
  std::vector<geom::Twist> velocity;  // How it moves. [m/s, m/s, m/s, rad/s]
  std::vector<std::uint8_t> stall;  // The last motion was blocked.
  std::vector<std::vector<double>> readings;  // What it measured, as its library means it.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest readings; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// An inertial measurement unit: feels how it is accelerated, with gravity, and how fast it turns, and tells
/// how it stands.
struct Imus {
  std::vector<ModelRow> model;  // The model that measures.
  std::vector<geom::SpatialVelocity> reading;  // What it feels, with its errors: acceleration without that of free fall, and turn rates, means since the measurement before. [m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s]
  std::vector<geom::SpatialVelocity> bias;  // Errors that wander. [m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s]
  std::vector<geom::Pose> X_WB;  // Where it was when it measured. [m, m, m, rad]
  std::vector<geom::Tilt> tilt_WB;  // How it stood then. [rad]
  std::vector<geom::Vec3> v_WB;  // How it moved then, along x, y and z. [m/s]
  std::vector<geom::Pose> X_WE;  // Where it believes to be: its reading integrated twice, from where it measured first. [m, m, m, rad]
  std::vector<geom::Tilt> tilt_WE;  // How it believes to stand. [rad]
  std::vector<geom::Vec3> v_WE;  // How it believes to move, along x, y and z. [m/s]
  std::vector<double> heading_error;  // By how much its heading has drifted: the errors of its turn rate, integrated. [rad]
  std::vector<double> reference_heading;  // The heading that is 0 for it, as a client has it. [rad]
  std::vector<geom::Tilt> reference_tilt;  // The tilt that is none for it, as a client has it. [rad]
  std::vector<std::uint64_t> noted_tick;  // Tick at which it was there; 0: it never measured.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest measurement; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A satellite receiver: tells where on the earth it is, as the world's latitude, longitude and altitude have
/// it.
struct Receivers {
  std::vector<ModelRow> model;  // The model that receives.
  std::vector<geom::Vec3> position;  // Where it believes to be, x, y and z. [m]
  std::vector<geom::Vec3> velocity;  // How fast it believes to move along x, y and z, a mean since the fix before. [m/s]
  std::vector<geom::Vec3> drift;  // The part of its error that varies slowly, along x, y and z. [m]
  std::vector<geom::Vec3> p_WB;  // Where it was when it measured, x, y and z. [m]
  std::vector<std::uint64_t> noted_tick;  // Tick at which it was there; 0: it never measured.
  std::vector<std::uint64_t> measured_tick;  // Tick of the newest fix; 0: none yet.
  std::size_t size() const { return model.size(); }
};

/// A battery, from which a model draws, and what is inside it and has none of its own.
struct Packs {
  std::vector<ModelRow> model;  // The model that has it.
  std::vector<double> stored;  // What is in it; below 0 it never ends. [J]
  std::vector<double> capacity;  // What it can hold. [J]
  std::vector<double> dissipated;  // What was drawn from it since the start, without what it gave to others. [J]
  std::vector<double> watts;  // What flowed out of it in the last tick; below 0 it was charged with more than it lost. [W]
  std::vector<std::uint8_t> charging;  // It was charged in the last tick.
  std::vector<std::uint8_t> takes;  // It may be charged.
  std::vector<std::uint8_t> gives;  // It may charge others.
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
