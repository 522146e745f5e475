// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Descriptions of each kind in world files, in SI units and radians; members have the default values of
/// files. Frames: W world, P parent, M model, B its body, S sensor, O odometry.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/text/values.h"

namespace playhouse::scene {

/// The simulated kinds of models; models of any other type are kPlain.
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

/// A plain body. Models of every kind have its words.
struct PlainDesc {
  /// Pose in the parent. [frame X_PM, m, m, m, rad]
  geom::Pose X_PM;
  /// Roll and pitch in the parent, in the arena: turned about its x axis by the roll, then about y by the
  /// pitch, then by its heading; a positive pitch lowers its front. The stage engine keeps all models
  /// upright. [rad]
  double roll = 0;
  double pitch = 0;
  /// Pose of the body and of the sensors, relative to the model's pose. [frame X_MB, m, m, m, rad]
  geom::Pose X_MB;
  /// Bounding box that the body fills; 0 in x or y makes a wall 0.01 m thick. Else the kind's own. [m]
  geom::Size size;
  /// Name of an X11 color, or random, which is the same in every run. Else the kind's own.
  Color color;
  /// Collides with other models.
  bool obstacle_return = true;
  /// Intensity that rangers report; below 0 it is invisible to rangers.
  double ranger_return = 1;
  /// Marker id that fiducial finders report; 0: no marker.
  int fiducial_return = 0;
  /// Finders detect only markers of their own key.
  int fiducial_key = 0;
  /// Grippers can lift it, with all its parts: it must be a top-level model without a part that drives.
  bool gripper_return = false;
  /// Mass. Driving draws 10 W per kg and m/s, and per kg and rad/s. The stage engine has no dynamics and uses
  /// it for nothing else; the arena does. [kg]
  double mass = 0;
  /// Friction coefficient of its surface. No effect in the stage engine and in Stage, where nothing slides;
  /// the arena multiplies the coefficients of the two surfaces in contact.
  double friction = 0;
  /// Fractions of its friction along its x and y, in the arena: with [0.1 1] it slides along its x, like a
  /// sledge.
  double friction_x = 1;
  double friction_y = 1;
  /// Name of its material, as "glass": a property for detectors (sees, through), and its surface in the arena
  /// (docs/arena.md).
  std::string material;
  /// Fraction of the speed of impact with which it bounces off, in the arena; of two surfaces in contact the
  /// larger one applies. Else that of its material.
  std::optional<double> restitution;
  /// Roughness of its surface for light, from 0, a mirror, to 1, matt. For cameras of the arena engine and
  /// the page. Else that of its material.
  std::optional<double> roughness;
  /// Luminous intensity of an omnidirectional light in its color; a bulb of 60 W has 65. A lamp that can be
  /// switched off shines while it is lit. Rendered by cameras of the arena engine; a light for detectors.
  /// [cd]
  double lamp = 0;
  /// Measurement period of a sensor, at least one tick. [s]
  double update_interval = 0.1;
  /// Moves and measures without a subscriber.
  bool alwayson = false;
  /// A viewer may drag it in the page. Else 1, inside another model 0.
  bool gui_move = false;
  /// The page draws a point ahead of its body, as for every model that drives.
  bool gui_nose = false;
  /// The page draws the edges of its bounding box on the floor.
  bool gui_outline = false;
  /// The page draws a grid on its bounding box, one line per metre.
  bool gui_grid = false;
  /// Text that it says at the start, shown as a speech bubble in the page: one line, truncated to 1024 bytes.
  /// Controllers and clients can change it.
  std::string say;
  /// Number of past positions that the page draws.
  int trail_length = 20;
  /// Its controllers, each a name and arguments.
  std::vector<std::string> ctrl;
  /// Power drawn from its battery, or its parent's. Kinds with a power consumption of their own use that
  /// instead. [W]
  double watts = 0;
  /// Initial energy of its battery, and its capacity; below 0: infinite. Else no battery. [J]
  std::optional<double> joules;
  /// Capacity of its battery; initial energy above it is discarded. Else the initial energy. [J]
  std::optional<double> joules_capacity;
  /// As joules, in kJ; applied after joules and joules_capacity. Else no battery. [kJ]
  std::optional<double> kjoules;
  /// As joules_capacity, in kJ; applied last. Else the initial energy. [kJ]
  std::optional<double> kjoules_capacity;
  /// Power with which it charges models in contact with it. [W]
  double give_watts = 0;
  /// Power with which other models may charge it. [W]
  double take_watts = 0;
  /// Cell size of its device `map` ([drivers.md](../drivers.md)); with 0 it has none. [m]
  double map_resolution = 0.1;
  /// Height above the floor of the world at which its device `map` shows walls ([drivers.md](../drivers.md)).
  /// [m]
  double map_height = 0.2;

  friend bool operator==(const PlainDesc&, const PlainDesc&) = default;
};

/// Drive model.
enum class Drive : std::uint8_t { kDiff, kOmni, kWalk, kCar };

/// Source of its pose estimate.
enum class Localization : std::uint8_t { kGps, kOdometry };

/// A mobile base: a robot that drives in the plane.
struct PositionDesc {
  /// Drive model.
  Drive drive = Drive::kDiff;
  /// Source of its pose estimate.
  Localization localization = Localization::kGps;
  /// Pose in the world of the origin of its pose estimate. Else odom: the start pose, gps: 0 0 0 0. [frame
  /// X_WO, m, m, m, rad]
  std::optional<geom::Pose> localization_origin;
  /// Initial command. [m/s, m/s, m/s, rad/s]
  geom::Twist velocity;
  /// Minimum and maximum velocity along each axis. [m/s, m/s, m/s, rad/s]
  Bounds velocity_bounds[4] = {{-1, 1}, {-1, 1}, {-1, 1}, {geom::radians(-90), geom::radians(90)}};
  /// Minimum and maximum acceleration along each axis, for commanded accelerations of controllers. [m/s^2,
  /// m/s^2, m/s^2, rad/s^2]
  Bounds acceleration_bounds[4] = {{-1, 1}, {-1, 1}, {-1, 1}, {geom::radians(-90), geom::radians(90)}};
  /// Distance between the front and the rear axle of a car. [m]
  double wheelbase = 1;
  /// Largest force with which its motors push it along the ground, in the arena: with mass m it gains at most
  /// max_force / m of speed a second. Else as much as its wheels grip. [N]
  std::optional<double> max_force;
  /// Largest mechanical power of its motors, in the arena: at speed v they push with at most max_power / v.
  /// Else no limit. [W]
  std::optional<double> max_power;
  /// Odometry errors along each axis, as fractions of the motion. Else drawn per robot: up to 0.015 in x and
  /// y, 0.025 in heading.
  std::optional<geom::Twist> odom_error;

  friend bool operator==(const PositionDesc&, const PositionDesc&) = default;
};

/// A fiducial finder: detects markers (models with a fiducial_return) and reports their ids and poses.
struct FiducialDesc {
  /// Minimum range of detection. [m]
  double range_min = 0;
  /// Maximum range of detection. [m]
  double range_max = 8;
  /// Maximum range of identification; the id of a marker beyond it is reported as 0. [m]
  double range_max_id = 5;
  /// Horizontal field of view, symmetric about the axis. [rad]
  double fov = geom::radians(180);
  /// Detects markers at any height.
  bool ignore_zloc = false;

  friend bool operator==(const FiducialDesc&, const FiducialDesc&) = default;
};

/// A camera that reports regions of one color (blobs).
struct BlobfinderDesc {
  /// Number of colors, of those listed, that it detects; 0: all listed ones, and any color if none is listed.
  std::uint32_t colors_count = 0;
  /// Names of the colors that it detects.
  std::vector<Color> colors;
  /// Image size. [px]
  double width = 80;
  double height = 60;
  /// Maximum range. [m]
  double range = 12;
  /// Horizontal field of view, symmetric about the axis. [rad]
  double fov = geom::radians(60);
  /// Direction of view, positive to the left. [rad]
  double pan = 0;

  friend bool operator==(const BlobfinderDesc&, const BlobfinderDesc&) = default;
};

/// Contact switches.
struct BumperDesc {
  /// Number of switches.
  std::uint32_t bcount = 0;
  /// Centre of a switch's face and its outward direction, indexed from 0; without an index: of all other
  /// switches. [frame X_BS, m, m, m, rad]
  std::vector<geom::Pose> X_BS;
  /// Length of a switch's face, indexed from 0; without an index: of all other switches. [m]
  std::vector<double> blength;

  friend bool operator==(const BumperDesc&, const BumperDesc&) = default;
};

/// A flashing lamp.
struct BlinkenlightDesc {
  /// Period of the flashes; 0: steady light. [s]
  double period = 1.0;
  /// Fraction of the period in which it is lit, from the start of the period; 1 or more: steady light.
  double dutycycle = 1;
  /// Switched on at the start.
  bool enabled = true;

  friend bool operator==(const BlinkenlightDesc&, const BlinkenlightDesc&) = default;
};

/// Whether the paddles are open.
enum class Paddles : std::uint8_t { kOpen, kClosed };

/// Whether the paddles are raised.
enum class Lift : std::uint8_t { kDown, kUp };

/// A gripper: two paddles that close around an object and carry it.
struct GripperDesc {
  /// Size of a paddle, as fractions of the model's size.
  double paddle_length = 0.66;
  double paddle_width = 0.1;
  double paddle_height = 0.4;
  /// Whether the paddles are open.
  Paddles paddles = Paddles::kOpen;
  /// Whether the paddles are raised.
  Lift lift = Lift::kDown;
  /// Closes when an object is between the paddles, and opens when none is.
  bool autosnatch = false;

  friend bool operator==(const GripperDesc&, const GripperDesc&) = default;
};

/// Type of joint.
enum class ActuatorType : std::uint8_t { kLinear, kRotational };

/// A prismatic or revolute joint that moves the models on it.
struct ActuatorDesc {
  /// Type of joint.
  ActuatorType type = ActuatorType::kLinear;
  /// Direction of sliding in its own frame, of any length; [0 0 0] is ahead. A revolute joint turns about z
  /// alone, to the right if z is negative.
  double axis_x = 0;
  double axis_y = 0;
  double axis_z = 0;
  /// Lower limit of travel, relative to its pose. [m or rad]
  double min_position = 0;
  /// Upper limit of travel; if it is below the lower limit, the joint does not move. [m or rad]
  double max_position = 1;
  /// Maximum speed. [m/s or rad/s]
  double max_speed = 1;
  /// Initial position, relative to its pose. [m or rad]
  double start_position = 0;

  friend bool operator==(const ActuatorDesc&, const ActuatorDesc&) = default;
};

/// Propagation model.
enum class Propagation : std::uint8_t { kFriis, kSimple, kItuIndoor, kLogDistance, kRaytrace };

/// A radio: reports the received radios of its network with their signal levels, and carries messages between
/// them.
struct WifiDesc {
  /// Network address; default: 10.x.y.z, from its number.
  std::string ip;
  /// Hardware address; default: 02:00:00:xx:yy:zz, from its number.
  std::string mac;
  /// Name of its network; radios of other networks are not received.
  std::string essid;
  /// Carrier frequency. [MHz]
  double frequency = 2450;
  /// Reported bit rate. [bit/s]
  double bitrate = 11000000;
  /// Transmit power. [dBm]
  double power = 15;
  /// Minimum received level; weaker signals are not received. [dBm]
  double sensitivity = -70;
  /// Propagation model.
  Propagation propagation = Propagation::kFriis;
  /// Maximum range of reception, with model "simple". [m]
  double range = 30;
  /// Path loss in dB per decade of distance, with model "ITU indoor".
  double plc = 30;
  /// Path loss exponent, with model "log distance": 2 in free space, 3 to 5 in buildings.
  double ple = 3;
  /// Loss per wall on the straight line, with model "raytrace". [dB]
  double wall_factor = 5;
  /// Standard deviation of the fading of a link, drawn anew for each measurement. [dB]
  double fading = 0;
  /// Percentage of lost messages from received radios, drawn for each message.
  std::uint32_t loss = 0;

  friend bool operator==(const WifiDesc&, const WifiDesc&) = default;
};

/// Content of a pixel.
enum class ImageKind : std::uint8_t { kColor, kGray, kDepth, kSegmentation };

/// Encoding of images; depth and segmentation images are always raw.
enum class ImageCompression : std::uint8_t { kRaw, kJpeg };

/// A camera with pan, tilt and zoom. It renders color, gray, depth or segmentation images of bodies, floor
/// and sky.
struct CameraDesc {
  /// Image size. [px]
  double width = 32;
  double height = 32;
  /// Near and far clipping distance, along the optical axis. [m]
  double range_min = 0.2;
  double range_max = 8;
  /// Initial field of view. [rad]
  double fov_horizontal = geom::radians(70);
  double fov_vertical = geom::radians(40);
  /// Initial direction of view, positive to the left and upwards. [rad]
  double pan = 0;
  double tilt = 0;
  /// Pan limits for clients: right and left. [rad]
  double pan_min = geom::radians(-100);
  double pan_max = geom::radians(100);
  /// Tilt limits for clients: down and up. [rad]
  double tilt_min = geom::radians(-25);
  double tilt_max = geom::radians(25);
  /// Limits of the horizontal field of view for clients. [rad]
  double zoom_min = geom::radians(5);
  double zoom_max = geom::radians(70);
  /// Maximum speed of pan, tilt and field of view, per second. [rad]
  double pantilt_speed = geom::radians(90);
  /// Content of a pixel.
  ImageKind image = ImageKind::kColor;
  /// Encoding of images; depth and segmentation images are always raw.
  ImageCompression compression = ImageCompression::kRaw;
  /// JPEG quality, in percent.
  std::uint32_t quality = 85;
  /// Pixel noise: standard deviation of each of red, green and blue, as a fraction of full scale, and of
  /// depth, as a fraction of the distance.
  double noise_value = 0;
  double noise_depth = 0;

  friend bool operator==(const CameraDesc&, const CameraDesc&) = default;
};

/// A sensor specified in the world file: what it detects and penetrates, its range, resolution and noise
/// (docs/detectors.md).
struct DetectorDesc {
  /// Horizontal field of view, symmetric about the axis. Beams have equal shares of it; the first is the
  /// rightmost. [rad]
  double fov = geom::radians(60);
  /// Vertical field of view, symmetric about the horizontal; 0: lines are horizontal, at half its own height.
  /// [rad]
  double fov_vertical = 0;
  /// Minimum and maximum range of reported objects, along the line of sight. [m]
  double range_min = 0;
  double range_max = 8;
  /// Number of beams. A beam reports the range of the nearest object in its share of the field of view.
  std::uint32_t samples = 1;
  /// Number of lines of sight per beam, evenly spaced over its share: 1 is a thin beam like a laser's, many a
  /// wide one like a sonar's.
  std::uint32_t rays = 1;
  /// Number of elevations at which each line is cast, evenly spaced from below upwards.
  std::uint32_t layers = 1;
  /// Conditions that select reported objects, one of which must hold, as "kind=position color=red"
  /// (docs/detectors.md); without any, everything is reported.
  std::vector<std::string> sees;
  /// Conditions for bodies that do not obstruct, with the syntax of sees, as "material=glass".
  std::vector<std::string> through;
  /// Number of obstructing bodies that a line penetrates, in addition to those that match through.
  std::uint32_t walls = 0;
  /// Loss in each penetrated body, and per metre of path inside it. [dB]
  double loss_per_body = 0;
  double loss_per_metre = 0;
  /// Exponent of the path loss with distance, counted from 1 m: 2 for a lamp, 4 for a radar echo.
  double spread = 0;
  /// Maximum total loss of a reported object. Its level is the remaining budget. [dB]
  double budget = 100;
  /// Quantisation step of ranges; 0: none. [m]
  double resolution = 0;
  /// Standard deviations: of ranges, as a length and as a fraction of the range, and of bearings of detected
  /// objects. [m, 1, rad]
  double noise_constant = 0;
  double noise_proportional = 0;
  double noise_angular = 0;
  /// Probability of missing an object in view, drawn for each object in each measurement.
  double miss = 0;

  friend bool operator==(const DetectorDesc&, const DetectorDesc&) = default;
};

/// A model or sensor implemented in a shared library.
struct CustomDesc {
  /// Name of the library, followed by arguments.
  std::string library;

  friend bool operator==(const CustomDesc&, const CustomDesc&) = default;
};

/// An inertial measurement unit: measures specific force and turn rate, and estimates its orientation.
struct ImuDesc {
  /// Noise of the accelerometer along each axis: density of white noise, and density of the noise that drives
  /// the random walk of the bias. [m/s^2/sqrt(Hz), m/s^3/sqrt(Hz)]
  double acceleration_white = 0;
  double acceleration_walk = 0;
  /// The same for the gyroscope, about each axis. [rad/s/sqrt(Hz), rad/s^2/sqrt(Hz)]
  double gyro_white = 0;
  double gyro_walk = 0;
  /// Standard deviation of the initial bias of each accelerometer axis. [m/s^2]
  double acceleration_bias = 0;
  /// Standard deviation of the initial bias of each gyroscope axis. [rad/s]
  double gyro_bias = 0;
  /// Measuring range of each accelerometer axis; larger values saturate. The default is 16 times the earth's
  /// gravity. [m/s^2]
  double acceleration_range = 156.906;
  /// Measuring range of each gyroscope axis; larger values saturate. The default is 2000 degrees per second.
  /// [rad/s]
  double gyro_range = 34.9066;

  friend bool operator==(const ImuDesc&, const ImuDesc&) = default;
};

/// A satellite receiver: reports its position on the earth, derived from the world's latitude, longitude and
/// altitude.
struct GpsDesc {
  /// Standard deviations of white noise, drawn anew for every fix: east and north, and up. [m]
  double noise_horizontal = 0;
  double noise_vertical = 0;
  /// Standard deviations of slowly varying errors, such as those of the atmosphere and of satellite clocks.
  /// [m]
  double drift_horizontal = 0;
  double drift_vertical = 0;
  /// Time constant of the slowly varying errors: their autocorrelation falls to 1/e (Gauss-Markov process of
  /// first order). [s]
  double drift_time = 300;
  /// Standard deviation of its velocity: east and north. [m/s]
  double velocity_noise = 0;
  /// Number of received satellites; with less than four there is no fix.
  std::uint32_t satellites = 8;
  /// Dilutions of precision that it reports.
  double hdop = 1;
  double vdop = 1.5;

  friend bool operator==(const GpsDesc&, const GpsDesc&) = default;
};

/// Error model of its beams, in addition to noise, for distant, dark, oblique, specular or transparent
/// surfaces.
enum class RangerErrors : std::uint8_t { kNone, kLidar };

/// One transducer or scanner of a ranger.
struct RangerSensorDesc {
  /// Pose in the ranger. [frame X_BS, m, m, m, rad]
  geom::Pose X_BS;
  /// Size of the drawn transducer; beams start at half its height above the pose. [m]
  geom::Size size{0.02, 0.02, 0.02};
  /// Minimum and maximum reported range. [m]
  double range_min = 0;
  double range_max = 5;
  /// Horizontal angle over which the beams are spread, symmetric about the axis, the first the rightmost; a
  /// single beam points ahead. [rad]
  double fov = geom::radians(5.729577951308232);
  /// Number of beams.
  std::uint32_t samples = 1;
  /// Number of rows of beams, one above the other, as in lidars with several lasers. `samples` is the number
  /// of beams per row.
  std::uint32_t rings = 1;
  /// Elevations of the lowest and the highest ring; the others are evenly spaced between them. The stage
  /// engine simulates them as horizontal. [rad]
  double ring_lowest = 0;
  double ring_highest = 0;
  /// Error model of its beams, in addition to noise, for distant, dark, oblique, specular or transparent
  /// surfaces.
  RangerErrors errors = RangerErrors::kNone;
  /// With error "lidar": maximum range at normal incidence of a surface that returns a tenth of the light.
  /// [m]
  double range_dark = 10;
  /// With error "lidar": standard deviation of ranges at the weakest detectable echo. It falls with the power
  /// of the echo. [m]
  double noise_weak = 0;
  /// Range noise: a standard deviation, the largest uniform error as a fraction of the range, and the largest
  /// uniform error of a beam's direction. [m, 1, rad]
  double noise_constant = 0;
  double noise_proportional = 0;
  double noise_angular = 0;
  /// Name of an X11 color, or random, which is the same in every run. Else transparent blue.
  Color color{0, 0, 1, 0.15f};

  friend bool operator==(const RangerSensorDesc&, const RangerSensorDesc&) = default;
};

/// The view of the scene; the first window of a file is used.
struct WindowDesc {
  /// Position in the middle of the window, in metres, independent of the file's unit. [m]
  geom::Vec2 center;
  /// Pixels per metre; 0: the whole scene is shown. [px/m]
  double scale = 0;
  /// Direction of view, in degrees, independent of the file's unit. [rad]
  double pitch = 0;
  double yaw = 0;
  /// Sensor data are shown from the start.
  bool show_data = false;
  /// Name of the model that the view follows; none: a fixed view.
  std::string follow_model;

  friend bool operator==(const WindowDesc&, const WindowDesc&) = default;
};

/// The world file itself: words outside all entities, anywhere in the file.
struct WorldDesc {
  /// The name of the world. Else the file's path.
  std::string name;
  /// Simulated time per tick, in whole microseconds. [s]
  double interval = 0.1;
  /// Resolution of ranges that is reported to clients; geometry here is exact. [m]
  double resolution = 0.02;
  /// Acceleration of free fall in the arena, and specific force measured by an imu at rest; 1.62 is the
  /// moon's. [m/s^2]
  double gravity = 9.81;
  /// Material of the ground in the arena, one of those of models (docs/arena.md).
  std::string ground = "concrete";
  /// Simulated time at which the run ends; 0: never. [s]
  double quit_time = 0;
  /// Speed relative to real time; 0 or less: as fast as possible.
  double speedup = 1;
  /// The run starts paused.
  bool paused = false;
  /// Color of the sky in camera images, as components from 0 to 1.
  double sky_red = 0.6235;
  double sky_green = 0.7686;
  double sky_blue = 0.9098;
  /// Direction of the sun in the world frame, and its brightness; at an elevation of 0 or less it has set.
  /// For cameras of the arena engine. [rad, rad, 1]
  double sun_heading = geom::radians(-125);
  double sun_elevation = geom::radians(50);
  double sun_brightness = 1;
  /// Visibility: at this distance fog reduces contrast to 5 %; 0: no fog. For cameras of the arena engine.
  /// [m]
  double fog = 0;
  /// Color of the fog, as components from 0 to 1. For cameras of the arena engine.
  double fog_red = 0.8;
  double fog_green = 0.82;
  double fog_blue = 0.84;
  /// Latitude of the point 0 0 0, positive to the north (WGS84), for gps receivers. x is east there, y north.
  /// [rad]
  double latitude = 0;
  /// Longitude of the point 0 0 0, positive to the east. [rad]
  double longitude = 0;
  /// Altitude of the point 0 0 0 above the ellipsoid. [m]
  double altitude = 0;

  friend bool operator==(const WorldDesc&, const WorldDesc&) = default;
};

/// Descriptions of models in addition to PlainDesc: only that of the model's kind is set.
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

/// Whether a model has a pack: a battery that supplies a model and its descendants without one of their own.
inline bool has_pack(const PlainDesc& model) {
  return model.joules || model.joules_capacity || model.kjoules || model.kjoules_capacity;
}

}  // namespace playhouse::scene
