// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/scene/generated/read_kinds.h"

#include "playhouse/base/limits.h"
#include "playhouse/scene/text/read_word.h"

namespace playhouse::scene {
namespace {

void read(const Properties& properties, PositionDesc& to) {
  static constexpr std::string_view kWordsOfDrive[] = {"diff", "omni", "walk", "car"};
  to.drive = static_cast<Drive>(read_choice(properties, "drive", kWordsOfDrive, static_cast<std::size_t>(to.drive)));
  static constexpr std::string_view kWordsOfLocalization[] = {"gps", "odom"};
  to.localization = static_cast<Localization>(read_choice(properties, "localization", kWordsOfLocalization, static_cast<std::size_t>(to.localization)));
  to.localization_origin = properties.pose("localization_origin");
  if (properties.has("velocity")) to.velocity = read_twist(properties, "velocity", "LLLA", "[x y z heading] per second");
  read_bounds(properties, "velocity_bounds", "LLLLLLAA", to.velocity_bounds);
  read_bounds(properties, "acceleration_bounds", "LLLLLLAA", to.acceleration_bounds);
  to.wheelbase = properties.length("wheelbase", to.wheelbase);
  require(to.wheelbase > 0, properties, "wheelbase", "must be above 0");
  if (properties.has("max_force")) to.max_force = properties.number("max_force", {});
  require(to.max_force.value_or(1) > 0, properties, "max_force", "must be above 0 N");
  if (properties.has("max_power")) to.max_power = properties.number("max_power", {});
  require(to.max_power.value_or(1) > 0, properties, "max_power", "must be above 0 W");
  if (properties.has("odom_error")) to.odom_error = read_twist(properties, "odom_error", "NNNN", "[x y z heading]");
}

void read(const Properties& properties, FiducialDesc& to) {
  to.range_min = properties.length("range_min", to.range_min);
  require(to.range_min >= 0, properties, "range_min", "must not be negative");
  to.range_max = properties.length("range_max", to.range_max);
  require(to.range_max >= 0, properties, "range_max", "must not be negative");
  to.range_max_id = properties.length("range_max_id", to.range_max_id);
  require(to.range_max_id >= 0, properties, "range_max_id", "must not be negative");
  to.fov = properties.angle("fov", to.fov);
  require(to.fov >= 0, properties, "fov", "must not be negative");
  to.ignore_zloc = properties.flag("ignore_zloc", to.ignore_zloc);
}

void read(const Properties& properties, BlobfinderDesc& to) {
  to.colors_count = read_count(properties, "colors_count", to.colors_count, 0, 256);
  to.colors = read_colors(properties, "colors");
  double image[2] = {to.width, to.height};
  properties.tuple("image", "NN", image, "[width height]");
  require(image[0] >= 1 && image[0] <= 4096 && image[1] >= 1 && image[1] <= 4096, properties, "image", "needs numbers from 1 to 4096");
  to.width = image[0];
  to.height = image[1];
  to.range = properties.number("range", to.range);
  require(to.range >= 0, properties, "range", "must not be negative");
  to.fov = properties.angle("fov", to.fov);
  require(to.fov >= 0, properties, "fov", "must not be negative");
  to.pan = properties.angle("pan", to.pan);
}

void read(const Properties& properties, BumperDesc& to) {
  to.bcount = read_count(properties, "bcount", to.bcount, 0, 256);
  geom::Pose bpose;
  to.X_BS = read_each(properties, "bpose", "bcount", to.bcount, bpose, [&](std::string_view key, geom::Pose& each) {
    each = properties.pose(key).value_or(each);
  });
  double blength = 0;
  to.blength = read_each(properties, "blength", "bcount", to.bcount, blength, [&](std::string_view key, double& each) {
    each = properties.length(key, each);
    require(each >= 0, properties, key, "must not be negative");
  });
}

void read(const Properties& properties, BlinkenlightDesc& to) {
  to.period = read_milliseconds(properties, "period", to.period);
  require(to.period >= 0, properties, "period", "must not be negative");
  to.dutycycle = properties.number("dutycycle", to.dutycycle);
  require(to.dutycycle >= 0, properties, "dutycycle", "must not be negative");
  to.enabled = properties.flag("enabled", to.enabled);
}

void read(const Properties& properties, GripperDesc& to) {
  double paddle_size[3] = {to.paddle_length, to.paddle_width, to.paddle_height};
  properties.tuple("paddle_size", "NNN", paddle_size, "[x y z]");
  require(paddle_size[0] >= 0 && paddle_size[0] <= 1 && paddle_size[1] >= 0 && paddle_size[1] <= 1 && paddle_size[2] >= 0 && paddle_size[2] <= 1, properties, "paddle_size", "needs numbers from 0 to 1");
  to.paddle_length = paddle_size[0];
  to.paddle_width = paddle_size[1];
  to.paddle_height = paddle_size[2];
  static constexpr std::string_view kWordsOfPaddles[] = {"open", "closed"};
  static constexpr std::string_view kWordsOfLift[] = {"down", "up"};
  Choice paddle_state[2] = {{"paddles", kWordsOfPaddles, static_cast<std::size_t>(to.paddles)}, {"lift", kWordsOfLift, static_cast<std::size_t>(to.lift)}};
  read_choices(properties, "paddle_state", paddle_state, "[paddles lift]");
  to.paddles = static_cast<Paddles>(paddle_state[0].value);
  to.lift = static_cast<Lift>(paddle_state[1].value);
  to.autosnatch = properties.flag("autosnatch", to.autosnatch);
}

void read(const Properties& properties, ActuatorDesc& to) {
  static constexpr std::string_view kWordsOfType[] = {"linear", "rotational"};
  to.type = static_cast<ActuatorType>(read_choice(properties, "type", kWordsOfType, static_cast<std::size_t>(to.type)));
  double axis[3] = {to.axis_x, to.axis_y, to.axis_z};
  properties.tuple("axis", "NNN", axis, "[x y z]");
  to.axis_x = axis[0];
  to.axis_y = axis[1];
  to.axis_z = axis[2];
  to.min_position = properties.number("min_position", to.min_position);
  to.max_position = properties.number("max_position", to.max_position);
  to.max_speed = properties.number("max_speed", to.max_speed);
  require(to.max_speed >= 0, properties, "max_speed", "must not be negative");
  to.start_position = properties.number("start_position", to.start_position);
}

void read(const Properties& properties, WifiDesc& to) {
  to.ip = properties.text("ip", to.ip);
  to.mac = properties.text("mac", to.mac);
  to.essid = properties.text("essid", to.essid);
  to.frequency = properties.number("freq", to.frequency);
  require(to.frequency >= 0, properties, "freq", "must not be negative");
  to.bitrate = properties.number("bitrate", to.bitrate);
  require(to.bitrate >= 0, properties, "bitrate", "must not be negative");
  to.power = properties.number("power", to.power);
  to.sensitivity = properties.number("sensitivity", to.sensitivity);
  static constexpr std::string_view kWordsOfModel[] = {"friis", "simple", "ITU indoor", "log distance", "raytrace"};
  to.propagation = static_cast<Propagation>(read_choice(properties, "model", kWordsOfModel, static_cast<std::size_t>(to.propagation)));
  to.range = properties.number("range", to.range);
  require(to.range >= 0, properties, "range", "must not be negative");
  to.plc = properties.number("plc", to.plc);
  require(to.plc >= 0, properties, "plc", "must not be negative");
  to.ple = properties.number("ple", to.ple);
  require(to.ple >= 0, properties, "ple", "must not be negative");
  to.wall_factor = properties.number("wall_factor", to.wall_factor);
  require(to.wall_factor >= 0, properties, "wall_factor", "must not be negative");
  to.fading = properties.number("fading", to.fading);
  require(to.fading >= 0, properties, "fading", "must not be negative");
  to.loss = read_count(properties, "loss", to.loss, 0, 100);
}

void read(const Properties& properties, CameraDesc& to) {
  double resolution[2] = {to.width, to.height};
  properties.tuple("resolution", "NN", resolution, "[width height]");
  require(resolution[0] >= 1 && resolution[0] <= 2048 && resolution[1] >= 1 && resolution[1] <= 2048, properties, "resolution", "needs numbers from 1 to 2048");
  to.width = resolution[0];
  to.height = resolution[1];
  double range[2] = {to.range_min, to.range_max};
  properties.tuple("range", "LL", range, "[min max]");
  require(0 <= range[0] && range[0] <= range[1], properties, "range", "needs 0 <= min <= max");
  to.range_min = range[0];
  to.range_max = range[1];
  double fov[2] = {to.fov_horizontal, to.fov_vertical};
  properties.tuple("fov", "AA", fov, "[horizontal vertical]");
  require(fov[0] >= geom::radians(1) && fov[0] <= geom::radians(170) && fov[1] >= geom::radians(1) && fov[1] <= geom::radians(170), properties, "fov", "needs numbers from 1 to 170");
  to.fov_horizontal = fov[0];
  to.fov_vertical = fov[1];
  double pantilt[2] = {to.pan, to.tilt};
  properties.tuple("pantilt", "AA", pantilt, "[pan tilt]");
  to.pan = pantilt[0];
  to.tilt = pantilt[1];
  double pan_limits[2] = {to.pan_min, to.pan_max};
  properties.tuple("pan_limits", "AA", pan_limits, "[min max]");
  to.pan_min = pan_limits[0];
  to.pan_max = pan_limits[1];
  double tilt_limits[2] = {to.tilt_min, to.tilt_max};
  properties.tuple("tilt_limits", "AA", tilt_limits, "[min max]");
  to.tilt_min = tilt_limits[0];
  to.tilt_max = tilt_limits[1];
  double zoom_limits[2] = {to.zoom_min, to.zoom_max};
  properties.tuple("zoom_limits", "AA", zoom_limits, "[min max]");
  require(zoom_limits[0] >= geom::radians(1) && zoom_limits[0] <= geom::radians(170) && zoom_limits[1] >= geom::radians(1) && zoom_limits[1] <= geom::radians(170), properties, "zoom_limits", "needs numbers from 1 to 170");
  to.zoom_min = zoom_limits[0];
  to.zoom_max = zoom_limits[1];
  to.pantilt_speed = properties.angle("pantilt_speed", to.pantilt_speed);
  require(to.pantilt_speed >= 0, properties, "pantilt_speed", "must not be negative");
  static constexpr std::string_view kWordsOfImage[] = {"color", "gray", "depth", "segmentation"};
  to.image = static_cast<ImageKind>(read_choice(properties, "image", kWordsOfImage, static_cast<std::size_t>(to.image)));
  static constexpr std::string_view kWordsOfCompression[] = {"raw", "jpeg"};
  to.compression = static_cast<ImageCompression>(read_choice(properties, "compression", kWordsOfCompression, static_cast<std::size_t>(to.compression)));
  to.quality = read_count(properties, "quality", to.quality, 1, 100);
  double noise[2] = {to.noise_value, to.noise_depth};
  properties.tuple("noise", "NN", noise, "[value depth]");
  require(noise[0] >= 0 && noise[0] <= 1 && noise[1] >= 0 && noise[1] <= 1, properties, "noise", "needs numbers from 0 to 1");
  to.noise_value = noise[0];
  to.noise_depth = noise[1];
}

void read(const Properties& properties, DetectorDesc& to) {
  to.fov = properties.angle("fov", to.fov);
  require(to.fov >= 0 && to.fov <= geom::radians(360), properties, "fov", "must be from 0 to 360");
  to.fov_vertical = properties.angle("fov_vertical", to.fov_vertical);
  require(to.fov_vertical >= 0 && to.fov_vertical <= geom::radians(170), properties, "fov_vertical", "must be from 0 to 170");
  double range[2] = {to.range_min, to.range_max};
  properties.tuple("range", "LL", range, "[min max]");
  require(0 <= range[0] && range[0] <= range[1], properties, "range", "needs 0 <= min <= max");
  to.range_min = range[0];
  to.range_max = range[1];
  static_assert(limits::kRangerSamples == 65536);
  to.samples = read_count(properties, "samples", to.samples, 1, limits::kRangerSamples);
  to.rays = read_count(properties, "rays", to.rays, 1, 1024);
  to.layers = read_count(properties, "layers", to.layers, 1, 256);
  to.sees = read_texts(properties, "sees");
  to.through = read_texts(properties, "through");
  to.walls = read_count(properties, "walls", to.walls, 0, 1000);
  double attenuation[2] = {to.loss_per_body, to.loss_per_metre};
  properties.tuple("attenuation", "NN", attenuation, "[body metre]");
  require(attenuation[0] >= 0 && attenuation[0] <= 1000 && attenuation[1] >= 0 && attenuation[1] <= 1000, properties, "attenuation", "needs numbers from 0 to 1000");
  to.loss_per_body = attenuation[0];
  to.loss_per_metre = attenuation[1];
  to.spread = properties.number("spread", to.spread);
  require(to.spread >= 0, properties, "spread", "must not be negative");
  to.budget = properties.number("budget", to.budget);
  require(to.budget >= 0, properties, "budget", "must not be negative");
  to.resolution = properties.length("resolution", to.resolution);
  require(to.resolution >= 0, properties, "resolution", "must not be negative");
  double noise[3] = {to.noise_constant, to.noise_proportional, to.noise_angular};
  properties.tuple("noise", "LNA", noise, "[constant proportional angular]");
  require(noise[0] >= 0 && noise[0] <= 360 && noise[1] >= 0 && noise[1] <= 360 && noise[2] >= geom::radians(0) && noise[2] <= geom::radians(360), properties, "noise", "needs numbers from 0 to 360");
  to.noise_constant = noise[0];
  to.noise_proportional = noise[1];
  to.noise_angular = noise[2];
  to.miss = properties.number("miss", to.miss);
  require(to.miss >= 0 && to.miss <= 1, properties, "miss", "must be from 0 to 1");
}

void read(const Properties& properties, CustomDesc& to) {
  to.library = properties.text("library", to.library);
}

void read(const Properties& properties, ImuDesc& to) {
  double acceleration_noise[2] = {to.acceleration_white, to.acceleration_walk};
  properties.tuple("acceleration_noise", "NN", acceleration_noise, "[white walk]");
  require(acceleration_noise[0] >= 0 && acceleration_noise[0] <= 1000 && acceleration_noise[1] >= 0 && acceleration_noise[1] <= 1000, properties, "acceleration_noise", "needs numbers from 0 to 1000");
  to.acceleration_white = acceleration_noise[0];
  to.acceleration_walk = acceleration_noise[1];
  double gyro_noise[2] = {to.gyro_white, to.gyro_walk};
  properties.tuple("gyro_noise", "NN", gyro_noise, "[white walk]");
  require(gyro_noise[0] >= 0 && gyro_noise[0] <= 1000 && gyro_noise[1] >= 0 && gyro_noise[1] <= 1000, properties, "gyro_noise", "needs numbers from 0 to 1000");
  to.gyro_white = gyro_noise[0];
  to.gyro_walk = gyro_noise[1];
  to.acceleration_bias = properties.number("acceleration_bias", to.acceleration_bias);
  require(to.acceleration_bias >= 0, properties, "acceleration_bias", "must not be negative");
  to.gyro_bias = properties.number("gyro_bias", to.gyro_bias);
  require(to.gyro_bias >= 0, properties, "gyro_bias", "must not be negative");
  to.acceleration_range = properties.number("acceleration_range", to.acceleration_range);
  require(to.acceleration_range > 0, properties, "acceleration_range", "must be above 0 m/s^2");
  to.gyro_range = properties.number("gyro_range", to.gyro_range);
  require(to.gyro_range > 0, properties, "gyro_range", "must be above 0 rad/s");
}

void read(const Properties& properties, GpsDesc& to) {
  double noise[2] = {to.noise_horizontal, to.noise_vertical};
  properties.tuple("noise", "LL", noise, "[horizontal vertical]");
  require(noise[0] >= 0 && noise[0] <= 1000000 && noise[1] >= 0 && noise[1] <= 1000000, properties, "noise", "needs numbers from 0 to 1000000");
  to.noise_horizontal = noise[0];
  to.noise_vertical = noise[1];
  double drift[2] = {to.drift_horizontal, to.drift_vertical};
  properties.tuple("drift", "LL", drift, "[horizontal vertical]");
  require(drift[0] >= 0 && drift[0] <= 1000000 && drift[1] >= 0 && drift[1] <= 1000000, properties, "drift", "needs numbers from 0 to 1000000");
  to.drift_horizontal = drift[0];
  to.drift_vertical = drift[1];
  to.drift_time = properties.number("drift_time", to.drift_time);
  require(to.drift_time > 0, properties, "drift_time", "must be above 0 s");
  to.velocity_noise = properties.number("velocity_noise", to.velocity_noise);
  require(to.velocity_noise >= 0, properties, "velocity_noise", "must not be negative");
  to.satellites = read_count(properties, "satellites", to.satellites, 0, 64);
  double dop[2] = {to.hdop, to.vdop};
  properties.tuple("dop", "NN", dop, "[horizontal vertical]");
  require(dop[0] >= 0 && dop[0] <= 100 && dop[1] >= 0 && dop[1] <= 100, properties, "dop", "needs numbers from 0 to 100");
  to.hdop = dop[0];
  to.vdop = dop[1];
}

}  // namespace

void read(const Properties& properties, std::size_t row, PlainDesc& to) {
  to.X_PM = properties.pose("pose").value_or(to.X_PM);
  double tilt[2] = {to.roll, to.pitch};
  properties.tuple("tilt", "AA", tilt, "[roll pitch]");
  require(tilt[0] >= geom::radians(-180) && tilt[0] <= geom::radians(180) && tilt[1] >= geom::radians(-180) && tilt[1] <= geom::radians(180), properties, "tilt", "needs numbers from -180 to 180");
  to.roll = tilt[0];
  to.pitch = tilt[1];
  to.X_MB = properties.pose("origin").value_or(to.X_MB);
  to.size = properties.size("size", to.size);
  to.color = properties.color(to.color, row);
  to.obstacle_return = properties.flag("obstacle_return", to.obstacle_return);
  to.ranger_return = properties.number("ranger_return", to.ranger_return);
  to.fiducial_return = properties.integer("fiducial_return", to.fiducial_return);
  to.fiducial_key = properties.integer("fiducial_key", to.fiducial_key);
  to.gripper_return = properties.flag("gripper_return", to.gripper_return);
  to.mass = properties.number("mass", to.mass);
  to.mass = at_least_zero(properties, "mass", to.mass, "no mass is meant");
  to.friction = properties.number("friction", to.friction);
  to.friction = at_least_zero(properties, "friction", to.friction, "no friction is meant");
  double friction_axes[2] = {to.friction_x, to.friction_y};
  properties.tuple("friction_axes", "NN", friction_axes, "[x y]");
  require(friction_axes[0] >= 0 && friction_axes[0] <= 1 && friction_axes[1] >= 0 && friction_axes[1] <= 1, properties, "friction_axes", "needs numbers from 0 to 1");
  to.friction_x = friction_axes[0];
  to.friction_y = friction_axes[1];
  to.material = properties.text("material", to.material);
  not_misspelt_material(properties, "material", to.material);
  if (properties.has("restitution")) to.restitution = properties.number("restitution", {});
  require(to.restitution.value_or(0) >= 0 && to.restitution.value_or(0) <= 1, properties, "restitution", "must be from 0 to 1");
  if (properties.has("roughness")) to.roughness = properties.number("roughness", {});
  require(to.roughness.value_or(0) >= 0 && to.roughness.value_or(0) <= 1, properties, "roughness", "must be from 0 to 1");
  to.lamp = properties.number("lamp", to.lamp);
  require(to.lamp >= 0, properties, "lamp", "must not be negative");
  to.update_interval = read_milliseconds(properties, "update_interval", to.update_interval);
  to.update_interval = at_least_zero(properties, "update_interval", to.update_interval, "every tick is meant");
  to.alwayson = properties.flag("alwayson", to.alwayson);
  to.gui_move = properties.flag("gui_move", to.gui_move);
  to.gui_nose = properties.flag("gui_nose", to.gui_nose);
  to.gui_outline = properties.flag("gui_outline", to.gui_outline);
  to.gui_grid = properties.flag("gui_grid", to.gui_grid);
  to.say = properties.text("say", to.say);
  to.trail_length = properties.integer("trail_length", to.trail_length);
  to.trail_length = at_least_zero(properties, "trail_length", to.trail_length, "no trail is meant");
  to.ctrl = read_texts(properties, "ctrl");
  to.watts = properties.number("watts", to.watts);
  require(to.watts >= 0, properties, "watts", "must not be negative");
  if (properties.has("joules")) to.joules = properties.number("joules", {});
  if (properties.has("joules_capacity")) to.joules_capacity = properties.number("joules_capacity", {});
  require(to.joules_capacity.value_or(0) >= 0, properties, "joules_capacity", "must not be negative");
  if (properties.has("kjoules")) to.kjoules = properties.number("kjoules", {});
  if (properties.has("kjoules_capacity")) to.kjoules_capacity = properties.number("kjoules_capacity", {});
  require(to.kjoules_capacity.value_or(0) >= 0, properties, "kjoules_capacity", "must not be negative");
  to.give_watts = properties.number("give_watts", to.give_watts);
  require(to.give_watts >= 0, properties, "give_watts", "must not be negative");
  to.take_watts = properties.number("take_watts", to.take_watts);
  require(to.take_watts >= 0, properties, "take_watts", "must not be negative");
  to.map_resolution = properties.length("map_resolution", to.map_resolution);
  require(to.map_resolution >= 0, properties, "map_resolution", "must not be negative");
  to.map_height = properties.length("map_height", to.map_height);
}

void read(const Properties& properties, std::size_t row, RangerSensorDesc& to) {
  to.X_BS = properties.pose("pose").value_or(to.X_BS);
  to.size = properties.size("size", to.size);
  double range[2] = {to.range_min, to.range_max};
  properties.tuple("range", "LL", range, "[min max]");
  require(0 <= range[0] && range[0] <= range[1], properties, "range", "needs 0 <= min <= max");
  to.range_min = range[0];
  to.range_max = range[1];
  to.fov = properties.angle("fov", to.fov);
  require(to.fov >= 0 && to.fov <= geom::radians(36000), properties, "fov", "must be from 0 to 36000");
  static_assert(limits::kRangerSamples == 65536);
  to.samples = read_count(properties, "samples", to.samples, 1, limits::kRangerSamples);
  to.rings = read_count(properties, "rings", to.rings, 1, 256);
  double ring_fov[2] = {to.ring_lowest, to.ring_highest};
  properties.tuple("ring_fov", "AA", ring_fov, "[lowest highest]");
  require(ring_fov[0] >= geom::radians(-89) && ring_fov[0] <= geom::radians(89) && ring_fov[1] >= geom::radians(-89) && ring_fov[1] <= geom::radians(89), properties, "ring_fov", "needs numbers from -89 to 89");
  to.ring_lowest = ring_fov[0];
  to.ring_highest = ring_fov[1];
  static constexpr std::string_view kWordsOfError[] = {"none", "lidar"};
  to.errors = static_cast<RangerErrors>(read_choice(properties, "error", kWordsOfError, static_cast<std::size_t>(to.errors)));
  to.range_dark = properties.length("range_dark", to.range_dark);
  require(to.range_dark > 0, properties, "range_dark", "must be above 0");
  to.noise_weak = properties.length("noise_weak", to.noise_weak);
  require(to.noise_weak >= 0, properties, "noise_weak", "must not be negative");
  double noise[3] = {to.noise_constant, to.noise_proportional, to.noise_angular};
  properties.tuple("noise", "LNA", noise, "[constant proportional angular]");
  to.noise_constant = noise[0];
  to.noise_proportional = noise[1];
  to.noise_angular = noise[2];
  to.color = properties.color(to.color, row);
}

void read(const Properties& properties, WindowDesc& to) {
  to.center = read_point(properties, "center", to.center);
  to.scale = properties.number("scale", to.scale);
  require(to.scale >= 0, properties, "scale", "must not be negative");
  double rotate[2] = {geom::degrees(to.pitch), geom::degrees(to.yaw)};
  properties.tuple("rotate", "NN", rotate, "[pitch yaw]");
  to.pitch = geom::radians(rotate[0]);
  to.yaw = geom::radians(rotate[1]);
  to.show_data = properties.flag("show_data", to.show_data);
  to.follow_model = properties.text("follow_model", to.follow_model);
}

void read(const Properties& properties, WorldDesc& to) {
  to.name = properties.text("name", to.name);
  to.interval = read_milliseconds(properties, "interval_sim", to.interval);
  require(to.interval > 0, properties, "interval_sim", "must be above 0 ms");
  to.resolution = properties.number("resolution", to.resolution);
  require(to.resolution > 0, properties, "resolution", "must be above 0 m");
  to.gravity = properties.number("gravity", to.gravity);
  to.gravity = at_least_zero(properties, "gravity", to.gravity, "no gravity is meant");
  to.ground = properties.text("ground", to.ground);
  known_material(properties, "ground", to.ground);
  to.quit_time = properties.number("quit_time", to.quit_time);
  to.quit_time = at_least_zero(properties, "quit_time", to.quit_time, "no end is meant");
  to.speedup = properties.number("speedup", to.speedup);
  to.paused = properties.flag("paused", to.paused);
  double sky[3] = {to.sky_red, to.sky_green, to.sky_blue};
  properties.tuple("sky", "NNN", sky, "[red green blue]");
  require(sky[0] >= 0 && sky[0] <= 1 && sky[1] >= 0 && sky[1] <= 1 && sky[2] >= 0 && sky[2] <= 1, properties, "sky", "needs numbers from 0 to 1");
  to.sky_red = sky[0];
  to.sky_green = sky[1];
  to.sky_blue = sky[2];
  double sun[3] = {to.sun_heading, to.sun_elevation, to.sun_brightness};
  properties.tuple("sun", "AAN", sun, "[heading elevation brightness]");
  to.sun_heading = sun[0];
  to.sun_elevation = sun[1];
  to.sun_brightness = sun[2];
  to.fog = properties.length("fog", to.fog);
  require(to.fog >= 0, properties, "fog", "must not be negative");
  double fog_color[3] = {to.fog_red, to.fog_green, to.fog_blue};
  properties.tuple("fog_color", "NNN", fog_color, "[red green blue]");
  require(fog_color[0] >= 0 && fog_color[0] <= 1 && fog_color[1] >= 0 && fog_color[1] <= 1 && fog_color[2] >= 0 && fog_color[2] <= 1, properties, "fog_color", "needs numbers from 0 to 1");
  to.fog_red = fog_color[0];
  to.fog_green = fog_color[1];
  to.fog_blue = fog_color[2];
  to.latitude = properties.angle("latitude", to.latitude);
  to.longitude = properties.angle("longitude", to.longitude);
  to.altitude = properties.number("altitude", to.altitude);
}

void read_kind(const Properties& properties, ModelKind kind, KindDescs& to) {
  switch (kind) {
    case ModelKind::kPosition:
      read(properties, to.position.emplace());
      break;
    case ModelKind::kFiducial:
      read(properties, to.fiducial.emplace());
      break;
    case ModelKind::kBlobfinder:
      read(properties, to.blobfinder.emplace());
      break;
    case ModelKind::kBumper:
      read(properties, to.bumper.emplace());
      break;
    case ModelKind::kBlinkenlight:
      read(properties, to.blinkenlight.emplace());
      break;
    case ModelKind::kGripper:
      read(properties, to.gripper.emplace());
      break;
    case ModelKind::kActuator:
      read(properties, to.actuator.emplace());
      break;
    case ModelKind::kWifi:
      read(properties, to.wifi.emplace());
      break;
    case ModelKind::kCamera:
      read(properties, to.camera.emplace());
      break;
    case ModelKind::kDetector:
      read(properties, to.detector.emplace());
      break;
    case ModelKind::kCustom:
      read(properties, to.custom.emplace());
      break;
    case ModelKind::kImu:
      read(properties, to.imu.emplace());
      break;
    case ModelKind::kGps:
      read(properties, to.gps.emplace());
      break;
    case ModelKind::kPlain:
    case ModelKind::kRanger:
    case ModelKind::kLightindicator:
      break;
  }
}

bool is_described(ModelKind kind, const KindDescs& by) {
  switch (kind) {
    case ModelKind::kPosition:
      return by.position.has_value();
    case ModelKind::kFiducial:
      return by.fiducial.has_value();
    case ModelKind::kBlobfinder:
      return by.blobfinder.has_value();
    case ModelKind::kBumper:
      return by.bumper.has_value();
    case ModelKind::kBlinkenlight:
      return by.blinkenlight.has_value();
    case ModelKind::kGripper:
      return by.gripper.has_value();
    case ModelKind::kActuator:
      return by.actuator.has_value();
    case ModelKind::kWifi:
      return by.wifi.has_value();
    case ModelKind::kCamera:
      return by.camera.has_value();
    case ModelKind::kDetector:
      return by.detector.has_value();
    case ModelKind::kCustom:
      return by.custom.has_value();
    case ModelKind::kImu:
      return by.imu.has_value();
    case ModelKind::kGps:
      return by.gps.has_value();
    default:
      return true;
  }
}

}  // namespace playhouse::scene
