// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// What world files say of each kind, in SI units and radians; members begin as a file has them that says
/// nothing. Frames: W world, P parent, M model, B its body, S sensor, O odometry.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/values.h"

namespace playhouse::scene {

/// The kinds of model that this build simulates; those of any other type are kPlain.
enum class ModelKind : std::uint8_t {
  kPlain = 0,
  kPosition = 1,
  kRanger = 2,
  kFiducial = 3,
  kBlobfinder = 4,
  kBumper = 5,
  kBlinkenlight = 6,
  kLightindicator = 7,
  kGripper = 8,
  kActuator = 9,
  kWifi = 10,
  kCamera = 11,
  kDetector = 12,
  kCustom = 13,
  kImu = 14,
  kGps = 15,
};

/// A plain body; its words are those of every model, whatever its kind.
struct PlainDesc {
  /// Where the model is in its parent. [frame X_PM, m, m, m, rad]
  geom::Pose X_PM;
  /// Where body and sensors are, from the pose. [frame X_MB, m, m, m, rad]
  geom::Pose X_MB;
  /// The box that the body fills; 0 in x or y is a wall 0.01 m thick. Else the kind's own. [m]
  geom::Size size;
  /// The name of an X11 color, or random, which is the same in each run. Else the kind's own.
  Color color;
  /// It collides.
  bool obstacle_return = true;
  /// The intensity that rangers report; below 0 they do not see it.
  double ranger_return = 1;
  /// The number that fiducial finders see; 0: none sees it.
  int fiducial_return = 0;
  /// Finders see marks of their own key only.
  int fiducial_key = 0;
  /// Grippers see it, and take it up with all its parts: it has to be at the top level, and holds nothing
  /// that drives.
  bool gripper_return = false;
  /// Driving it takes 10 W for each kg and m/s, and for each rad/s. In the plane nothing is pushed, so that
  /// it means nothing else; it is kept for engines with forces. [kg]
  double mass = 0;
  /// How much its faces rub. In the plane nothing slides, so that it means nothing there, as in Stage; the
  /// arena multiplies it with that of what it touches.
  double friction = 0;
  /// Shares of its friction along its x and y, in the arena: with [0.1 1] it slides along its x, as a sledge.
  double friction_x = 1;
  double friction_y = 1;
  /// What it is made of, as "glass": a name that detectors may look for, or through.
  std::string material;
  /// How bright it shines, every way alike, in its color; a bulb of 60 W has 65. A lamp that can be switched
  /// off shines while it is lit. For cameras of the arena engine, and a light for detectors. [cd]
  double lamp = 0;
  /// Time between two measurements of a sensor, at least a tick. [s]
  double update_interval = 0.1;
  /// It moves or measures although nobody has opened it.
  bool alwayson = false;
  /// A person may drag it in the page. Else 1, inside another model 0.
  bool gui_move = false;
  /// The page draws a point ahead of its body, as it does of everything that drives.
  bool gui_nose = false;
  /// The page draws the edges of its box on the floor.
  bool gui_outline = false;
  /// The page draws a line per metre of its box.
  bool gui_grid = false;
  /// What it says at the start, in a bubble of the page: one line, of which 1024 bytes count. Controllers and
  /// clients have it say something else.
  std::string say;
  /// How many places of the past the page draws.
  int trail_length = 20;
  /// The controllers that drive it, each a name and its arguments.
  std::vector<std::string> ctrl;
  /// Power that it draws from its battery, or its parent's; kinds that say what they draw have that instead.
  /// [W]
  double watts = 0;
  /// Energy in its battery, which is full of it; below 0 without end. Else no battery. [J]
  std::optional<double> joules;
  /// Energy that its battery can hold; what does not fit is not in it. Else what is in it. [J]
  std::optional<double> joules_capacity;
  /// As joules, in thousands; counts after both words in joules. Else no battery. [kJ]
  std::optional<double> kjoules;
  /// As joules_capacity, in thousands; counts last. Else what is in it. [kJ]
  std::optional<double> kjoules_capacity;
  /// Power with which it charges others that touch it. [W]
  double give_watts = 0;
  /// Power with which others may charge it. [W]
  double take_watts = 0;

  friend bool operator==(const PlainDesc&, const PlainDesc&) = default;
};

/// How it can move.
enum class Drive : std::uint8_t { kDiff, kOmni, kWalk, kCar };

/// What it believes about its pose.
enum class Localization : std::uint8_t { kGps, kOdometry };

/// A robot that drives in the plane.
struct PositionDesc {
  /// How it can move.
  Drive drive = Drive::kDiff;
  /// What it believes about its pose.
  Localization localization = Localization::kGps;
  /// Where in the world its coordinates begin. Else odom: the start pose, gps: 0 0 0 0. [frame X_WO, m, m, m,
  /// rad]
  std::optional<geom::Pose> localization_origin;
  /// Its first command. [m/s, m/s, m/s, rad/s]
  geom::Twist velocity;
  /// The least and the largest velocity along each axis. [m/s, m/s, m/s, rad/s]
  Bounds velocity_bounds[4] = {{-1, 1}, {-1, 1}, {-1, 1}, {geom::radians(-90), geom::radians(90)}};
  /// The same of accelerations, which count when a controller commands them. [m/s^2, m/s^2, m/s^2, rad/s^2]
  Bounds acceleration_bounds[4] = {{-1, 1}, {-1, 1}, {-1, 1}, {geom::radians(-90), geom::radians(90)}};
  /// Of a car, from the front axle to the rear one. [m]
  double wheelbase = 1;
  /// Errors of odometry along each axis, as fractions of the motion. Else drawn per robot: up to 0.015 in x
  /// and y, 0.025 in heading.
  std::optional<geom::Twist> odom_error;

  friend bool operator==(const PositionDesc&, const PositionDesc&) = default;
};

/// A finder of marks: sees models with a fiducial_return and tells which they are and where.
struct FiducialDesc {
  /// Nearer marks are not seen. [m]
  double range_min = 0;
  /// Farther marks are not seen. [m]
  double range_max = 8;
  /// Of farther marks the number cannot be told, and is 0. [m]
  double range_max_id = 5;
  /// The field of view, half to each side. [rad]
  double fov = geom::radians(180);
  /// Marks are seen at any height.
  bool ignore_zloc = false;

  friend bool operator==(const FiducialDesc&, const FiducialDesc&) = default;
};

/// A camera that finds patches of a colour.
struct BlobfinderDesc {
  /// How many of the colors it looks for; 0: all that it names, and any color if it names none.
  std::uint32_t colors_count = 0;
  /// The names of the colors that it looks for.
  std::vector<Color> colors;
  /// The size of the image. [px]
  double width = 80;
  double height = 60;
  /// How far it sees. [m]
  double range = 12;
  /// The field of view, half to each side. [rad]
  double fov = geom::radians(60);
  /// How far it is turned to the left. [rad]
  double pan = 0;

  friend bool operator==(const BlobfinderDesc&, const BlobfinderDesc&) = default;
};

/// Switches that feel a touch.
struct BumperDesc {
  /// How many switches it has.
  std::uint32_t bcount = 0;
  /// The middle of the face of a switch, counted from 0, and where the face looks; without a number that of
  /// all others. [frame X_BS, m, m, m, rad]
  std::vector<geom::Pose> X_BS;
  /// The length of the face of a switch, counted from 0; without a number that of all others. [m]
  std::vector<double> blength;

  friend bool operator==(const BumperDesc&, const BumperDesc&) = default;
};

/// A lamp that can blink.
struct BlinkenlightDesc {
  /// Time from one flash to the next; 0: it burns steadily. [s]
  double period = 1.0;
  /// The share of the period in which it is lit, from its begin on; 1 or more: it burns steadily.
  double dutycycle = 1;
  /// It is on at the start.
  bool enabled = true;

  friend bool operator==(const BlinkenlightDesc&, const BlinkenlightDesc&) = default;
};

/// Whether the paddles are apart.
enum class Paddles : std::uint8_t { kOpen, kClosed };

/// Whether the paddles are raised.
enum class Lift : std::uint8_t { kDown, kUp };

/// Two paddles that close around a thing and carry it.
struct GripperDesc {
  /// How large a paddle is, as fractions of the model's size.
  double paddle_length = 0.66;
  double paddle_width = 0.1;
  double paddle_height = 0.4;
  /// Whether the paddles are apart.
  Paddles paddles = Paddles::kOpen;
  /// Whether the paddles are raised.
  Lift lift = Lift::kDown;
  /// It closes by itself when something is between the paddles, and opens when nothing is.
  bool autosnatch = false;

  friend bool operator==(const GripperDesc&, const GripperDesc&) = default;
};

/// How it moves.
enum class ActuatorType : std::uint8_t { kLinear, kRotational };

/// A joint that slides or turns, with what it carries.
struct ActuatorDesc {
  /// How it moves.
  ActuatorType type = ActuatorType::kLinear;
  /// The direction in which it slides, of any length, in its own frame; [0 0 0] is ahead. It turns about z
  /// alone, to the right if z is negative.
  double axis_x = 0;
  double axis_y = 0;
  double axis_z = 0;
  /// Where it stops at the lower end, counted from its pose. [m or rad]
  double min_position = 0;
  /// Where it stops at the upper end; where that is below the lower one, it does not move. [m or rad]
  double max_position = 1;
  /// How fast it can move. [m/s or rad/s]
  double max_speed = 1;
  /// Where it is at the start, counted from its pose. [m or rad]
  double start_position = 0;

  friend bool operator==(const ActuatorDesc&, const ActuatorDesc&) = default;
};

/// How what it hears has become weaker on its way.
enum class Propagation : std::uint8_t { kFriis, kSimple, kItuIndoor, kLogDistance, kRaytrace };

/// A radio: tells which others of its network it hears, and how well, and carries messages between them.
struct WifiDesc {
  /// Its network address; without one 10.x.y.z by its number.
  std::string ip;
  /// Its hardware address; without one 02:00:00:xx:yy:zz by its number.
  std::string mac;
  /// The name of its network: radios of other networks are not heard.
  std::string essid;
  /// Where it sends. [MHz]
  double frequency = 2450;
  /// What it is set to. [bit/s]
  double bitrate = 11000000;
  /// How strongly it sends. [dBm]
  double power = 15;
  /// What arrives weaker is not heard. [dBm]
  double sensitivity = -70;
  /// How what it hears has become weaker on its way.
  Propagation propagation = Propagation::kFriis;
  /// How far it hears, with model "simple". [m]
  double range = 30;
  /// Loss for ten times the distance in dB, with model "ITU indoor".
  double plc = 30;
  /// The power of the distance by which it gets weaker, with model "log distance": 2 in free space, 3 to 5 in
  /// buildings.
  double ple = 3;
  /// Loss for each wall on the straight line, with model "raytrace". [dB]
  double wall_factor = 5;
  /// Standard deviation of what else makes a link stronger or weaker, drawn anew each time it is measured.
  /// [dB]
  double fading = 0;
  /// Of the messages of radios that it hears, how many are lost, in percent; drawn for each message.
  std::uint32_t loss = 0;

  friend bool operator==(const WifiDesc&, const WifiDesc&) = default;
};

/// What a pixel says.
enum class ImageKind : std::uint8_t { kColor, kGray, kDepth, kSegmentation };

/// How images are sent; those of distances and of models always raw.
enum class ImageCompression : std::uint8_t { kRaw, kJpeg };

/// A camera: takes images of the bodies, the floor and the sky, in colours, in grey, of distances, or of
/// which model is where, and pans, tilts and zooms.
struct CameraDesc {
  /// The size of the image. [px]
  double width = 32;
  double height = 32;
  /// The nearest and the farthest thing that it shows, along the way it looks. [m]
  double range_min = 0.2;
  double range_max = 8;
  /// The field of view at the start. [rad]
  double fov_horizontal = geom::radians(70);
  double fov_vertical = geom::radians(40);
  /// Where it looks at the start: to the left, and up. [rad]
  double pan = 0;
  double tilt = 0;
  /// How far clients may turn it to the right and to the left. [rad]
  double pan_min = geom::radians(-100);
  double pan_max = geom::radians(100);
  /// How far clients may turn it down and up. [rad]
  double tilt_min = geom::radians(-25);
  double tilt_max = geom::radians(25);
  /// The smallest and the largest horizontal field of view that clients may ask for. [rad]
  double zoom_min = geom::radians(5);
  double zoom_max = geom::radians(70);
  /// How fast it turns at most, and changes its field of view, in a second. [rad]
  double pantilt_speed = geom::radians(90);
  /// What a pixel says.
  ImageKind image = ImageKind::kColor;
  /// How images are sent; those of distances and of models always raw.
  ImageCompression compression = ImageCompression::kRaw;
  /// That of JPEG files, in percent.
  std::uint32_t quality = 85;
  /// Errors of a pixel: the standard deviation of red, green and blue each, as a share of the brightest, and
  /// that of distances, as a share of them.
  double noise_value = 0;
  double noise_depth = 0;

  friend bool operator==(const CameraDesc&, const CameraDesc&) = default;
};

/// A sensor made up in the world file: what it sees, what it sees through, how far, how finely and how well
/// (docs/detectors.md).
struct DetectorDesc {
  /// The field of view, half to each side. Its beams have equal shares of it, the first the rightmost. [rad]
  double fov = geom::radians(60);
  /// The field of view upwards and downwards, half to each; with 0 it sees what is at half its own height.
  /// [rad]
  double fov_vertical = 0;
  /// The nearest and the farthest thing that it tells of, along the line to it. [m]
  double range_min = 0;
  double range_max = 8;
  /// How many beams it has. A beam tells the range of the nearest thing in its share of the field of view.
  std::uint32_t samples = 1;
  /// The lines along which each beam looks, evenly spread over its share: 1 is as thin as a laser, many are
  /// as wide as a sonar.
  std::uint32_t rays = 1;
  /// How often each of them looks, evenly spread from below upwards.
  std::uint32_t layers = 1;
  /// What it tells of: conditions of which one holds, as "kind=position color=red" (docs/detectors.md);
  /// without any, everything.
  std::vector<std::string> sees;
  /// What is no hindrance: conditions as of sees, as "material=glass".
  std::vector<std::string> through;
  /// How many bodies it sees through on a line, beside those of through.
  std::uint32_t walls = 0;
  /// What is lost in each body that it sees through, and for each metre of the way in it. [dB]
  double loss_per_body = 0;
  double loss_per_metre = 0;
  /// The power of the distance by which what comes back gets weaker, from 1 m on: 2 for a lamp, 4 for a
  /// radar's echo.
  double spread = 0;
  /// How much may be lost on the way to what it still tells of. What is left of that is told as the level.
  /// [dB]
  double budget = 100;
  /// Ranges are told in steps of this; 0: as they are. [m]
  double resolution = 0;
  /// Standard deviations of errors: of a range, as a length and as a share of it, and of the bearing of what
  /// is found. [m, 1, rad]
  double noise_constant = 0;
  double noise_proportional = 0;
  double noise_angular = 0;
  /// The probability that something in view is not noticed, for each thing in each measurement.
  double miss = 0;

  friend bool operator==(const DetectorDesc&, const DetectorDesc&) = default;
};

/// A model or a sensor whose code is in a shared library.
struct CustomDesc {
  /// The library's name, and arguments behind it.
  std::string library;

  friend bool operator==(const CustomDesc&, const CustomDesc&) = default;
};

/// An inertial measurement unit: feels how it is accelerated, with gravity, and how fast it turns, and tells
/// how it stands.
struct ImuDesc {
  /// Errors along each axis: the density of white noise, and that of the noise by which the bias wanders.
  /// [m/s^2/sqrt(Hz), m/s^3/sqrt(Hz)]
  double acceleration_white = 0;
  double acceleration_walk = 0;
  /// The same of the turn rate about each axis. [rad/s/sqrt(Hz), rad/s^2/sqrt(Hz)]
  double gyro_white = 0;
  double gyro_walk = 0;
  /// The standard deviation of the bias of each axis with which it begins. [m/s^2]
  double acceleration_bias = 0;
  /// The same of the turn rate about each axis. [rad/s]
  double gyro_bias = 0;
  /// More than this along an axis reads as this, here 16 times the gravity of the earth. [m/s^2]
  double acceleration_range = 156.906;
  /// More than this about an axis reads as this, here 2000 degrees per second. [rad/s]
  double gyro_range = 34.9066;

  friend bool operator==(const ImuDesc&, const ImuDesc&) = default;
};

/// A satellite receiver: tells where on the earth it is, as the world's latitude, longitude and altitude have
/// it.
struct GpsDesc {
  /// Standard deviations of the errors that every fix has anew, to the east and to the north, and upwards.
  /// [m]
  double noise_horizontal = 0;
  double noise_vertical = 0;
  /// Standard deviations of the errors that vary slowly, as what the air and the satellites' clocks add. [m]
  double drift_horizontal = 0;
  double drift_vertical = 0;
  /// After this time the errors that vary slowly have lost all but a share of 1/e of what they were (Gauss-
  /// Markov process of first order). [s]
  double drift_time = 300;
  /// The standard deviation of its velocity, to the east and to the north. [m/s]
  double velocity_noise = 0;
  /// How many it hears; with less than four it has no fix.
  std::uint32_t satellites = 8;
  /// How well they are spread over the sky, as it is told: dilutions of precision.
  double hdop = 1;
  double vdop = 1.5;

  friend bool operator==(const GpsDesc&, const GpsDesc&) = default;
};

/// How its beams fail, beyond their noise, at surfaces that are far away, dark, slanted, shiny or clear.
enum class RangerErrors : std::uint8_t { kNone, kLidar };

/// One transducer or scanner of a ranger.
struct RangerSensorDesc {
  /// Where the sensor is in the ranger. [frame X_BS, m, m, m, rad]
  geom::Pose X_BS;
  /// For drawing; beams start at half its height above the pose. [m]
  geom::Size size{0.02, 0.02, 0.02};
  /// The nearest and the farthest thing that it reports. [m]
  double range_min = 0;
  double range_max = 5;
  /// Beams spread over this angle, half to each side, the first rightmost; a single one looks ahead. [rad]
  double fov = geom::radians(5.729577951308232);
  /// How many beams it has.
  std::uint32_t samples = 1;
  /// How many rows of beams it has, one above the other, as lidars with several lasers do. `samples` is how
  /// many beams each row has.
  std::uint32_t rings = 1;
  /// The elevations of the lowest ring and of the highest, between which the others are spread evenly. With
  /// the stage engine all are level. [rad]
  double ring_lowest = 0;
  double ring_highest = 0;
  /// How its beams fail, beyond their noise, at surfaces that are far away, dark, slanted, shiny or clear.
  RangerErrors errors = RangerErrors::kNone;
  /// Of error "lidar": how far away it still sees a surface that it looks at straight on and that returns a
  /// tenth of the light. [m]
  double range_dark = 10;
  /// Of error "lidar": the standard deviation of a range that is told by the weakest echo that it notices. It
  /// falls as echoes get stronger. [m]
  double noise_weak = 0;
  /// Errors: a standard deviation, a fraction of the range, and the angle by which a beam may be turned. [m,
  /// 1, rad]
  double noise_constant = 0;
  double noise_proportional = 0;
  double noise_angular = 0;
  /// The name of an X11 color, or random, which is the same in each run. Else blue, which one can see
  /// through.
  Color color{0, 0, 1, 0.15f};

  friend bool operator==(const RangerSensorDesc&, const RangerSensorDesc&) = default;
};

/// How to look at the scene; the first window of a file counts.
struct WindowDesc {
  /// The place in the middle of the window, in metres whatever the file's unit. [m]
  geom::Vec2 center;
  /// Pixels per metre; 0: the whole scene is shown. [px/m]
  double scale = 0;
  /// The direction of view, in degrees whatever the file's unit. [rad]
  double pitch = 0;
  double yaw = 0;
  /// Sensors are shown from the start.
  bool show_data = false;
  /// The name of a model that stays in the middle; none: the view stands still.
  std::string follow_model;

  friend bool operator==(const WindowDesc&, const WindowDesc&) = default;
};

/// The world file itself: words that stand outside of all entities, anywhere in the file.
struct WorldDesc {
  /// The name of the world. Else the file's path.
  std::string name;
  /// Simulated time of one tick, in whole microseconds. [s]
  double interval = 0.1;
  /// Told to clients as the resolution of ranges; geometry here is exact. [m]
  double resolution = 0.02;
  /// How fast what falls gets faster, in the arena, and what an imu feels that stands still; 1.62 is the
  /// moon's. [m/s^2]
  double gravity = 9.81;
  /// What the ground is made of, in the arena: a material, as of models (docs/arena.md).
  std::string ground = "concrete";
  /// Simulated time after which the run ends; 0: never. [s]
  double quit_time = 0;
  /// Times real time; 0 or less: as fast as possible.
  double speedup = 1;
  /// The run starts paused.
  bool paused = false;
  /// The color of the sky in the images of cameras, as shares from 0 to 1.
  double sky_red = 0.6235;
  double sky_green = 0.7686;
  double sky_blue = 0.9098;
  /// Where the sun is, seen from the world, and how bright; one that is not above the horizon has set. Of
  /// cameras of the arena engine. [rad, rad, 1]
  double sun_heading = geom::radians(-125);
  double sun_elevation = geom::radians(50);
  double sun_brightness = 1;
  /// How far one sees: at this distance fog leaves 5 % of a contrast; 0: there is none. Of cameras of the
  /// arena engine. [m]
  double fog = 0;
  /// The color of the fog, as shares from 0 to 1. Of cameras of the arena engine.
  double fog_red = 0.8;
  double fog_green = 0.82;
  double fog_blue = 0.84;
  /// Where on the earth the point 0 0 0 is, positive to the north (WGS84): what gps receivers tell follows
  /// from it. x is east there, y north. [rad]
  double latitude = 0;
  /// The same, positive to the east. [rad]
  double longitude = 0;
  /// The same, above the ellipsoid. [m]
  double altitude = 0;

  friend bool operator==(const WorldDesc&, const WorldDesc&) = default;
};

/// What models say beyond PlainDesc: what is not of a model's kind is empty.
struct KindDescs {
  std::optional<PositionDesc> position;  // kPosition
  std::vector<RangerSensorDesc> sensors;  // kRanger
  std::optional<FiducialDesc> fiducial;  // kFiducial
  std::optional<BlobfinderDesc> blobfinder;  // kBlobfinder
  std::optional<BumperDesc> bumper;  // kBumper
  std::optional<BlinkenlightDesc> blinkenlight;  // kBlinkenlight
  std::optional<GripperDesc> gripper;  // kGripper
  std::optional<ActuatorDesc> actuator;  // kActuator
  std::optional<WifiDesc> wifi;  // kWifi
  std::optional<CameraDesc> camera;  // kCamera
  std::optional<DetectorDesc> detector;  // kDetector
  std::optional<CustomDesc> custom;  // kCustom
  std::optional<ImuDesc> imu;  // kImu
  std::optional<GpsDesc> gps;  // kGps

  friend bool operator==(const KindDescs&, const KindDescs&) = default;
};

/// Whether a model has a pack: a battery, from which a model draws, and what is inside it and has none of its
/// own.
inline bool has_pack(const PlainDesc& model) {
  return model.joules || model.joules_capacity || model.kjoules || model.kjoules_capacity;
}

}  // namespace playhouse::scene
