// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/scene/generated/write_kinds.h"

#include <algorithm>
#include <array>
#include <string>

namespace playhouse::scene {
namespace {

void write(const PositionDesc& from, const PositionDesc& unsaid, Words& to) {
  static constexpr std::string_view kWordsOfDrive[] = {"diff", "omni", "walk", "car"};
  if (from.drive != unsaid.drive) to.text("drive", kWordsOfDrive[static_cast<std::size_t>(from.drive)]);
  static constexpr std::string_view kWordsOfLocalization[] = {"gps", "odom"};
  if (from.localization != unsaid.localization) to.text("localization", kWordsOfLocalization[static_cast<std::size_t>(from.localization)]);
  if (from.localization_origin) to.pose("localization_origin", *from.localization_origin);
  if (from.velocity != unsaid.velocity) to.twist("velocity", "LLLA", from.velocity);
  if (!std::ranges::equal(from.velocity_bounds, unsaid.velocity_bounds)) to.bounds("velocity_bounds", "LLLLLLAA", from.velocity_bounds);
  if (!std::ranges::equal(from.acceleration_bounds, unsaid.acceleration_bounds)) to.bounds("acceleration_bounds", "LLLLLLAA", from.acceleration_bounds);
  if (from.wheelbase != unsaid.wheelbase) to.length("wheelbase", from.wheelbase);
  if (from.max_force) to.number("max_force", *from.max_force);
  if (from.max_power) to.number("max_power", *from.max_power);
  if (from.odom_error) to.twist("odom_error", "NNNN", *from.odom_error);
}

void write(const FiducialDesc& from, const FiducialDesc& unsaid, Words& to) {
  if (from.range_min != unsaid.range_min) to.length("range_min", from.range_min);
  if (from.range_max != unsaid.range_max) to.length("range_max", from.range_max);
  if (from.range_max_id != unsaid.range_max_id) to.length("range_max_id", from.range_max_id);
  if (from.fov != unsaid.fov) to.angle("fov", from.fov);
  if (from.ignore_zloc != unsaid.ignore_zloc) to.flag("ignore_zloc", from.ignore_zloc);
}

void write(const BlobfinderDesc& from, const BlobfinderDesc& unsaid, Words& to) {
  if (from.colors_count != unsaid.colors_count) to.integer("colors_count", from.colors_count);
  if (from.colors != unsaid.colors) to.colors("colors", from.colors);
  const double image[] = {from.width, from.height};
  if (from.width != unsaid.width || from.height != unsaid.height) to.tuple("image", "NN", image);
  if (from.range != unsaid.range) to.number("range", from.range);
  if (from.fov != unsaid.fov) to.angle("fov", from.fov);
  if (from.pan != unsaid.pan) to.angle("pan", from.pan);
}

void write(const BumperDesc& from, const BumperDesc& unsaid, Words& to) {
  if (from.bcount != unsaid.bcount) to.integer("bcount", from.bcount);
  for (std::size_t i = 0; i < from.X_BS.size(); ++i) to.pose("bpose[" + std::to_string(i) + "]", from.X_BS[i]);
  for (std::size_t i = 0; i < from.blength.size(); ++i) to.length("blength[" + std::to_string(i) + "]", from.blength[i]);
}

void write(const BlinkenlightDesc& from, const BlinkenlightDesc& unsaid, Words& to) {
  if (from.period != unsaid.period) to.milliseconds("period", from.period);
  if (from.dutycycle != unsaid.dutycycle) to.number("dutycycle", from.dutycycle);
  if (from.enabled != unsaid.enabled) to.flag("enabled", from.enabled);
}

void write(const GripperDesc& from, const GripperDesc& unsaid, Words& to) {
  const double paddle_size[] = {from.paddle_length, from.paddle_width, from.paddle_height};
  if (from.paddle_length != unsaid.paddle_length || from.paddle_width != unsaid.paddle_width || from.paddle_height != unsaid.paddle_height) to.tuple("paddle_size", "NNN", paddle_size);
  static constexpr std::string_view kWordsOfPaddles[] = {"open", "closed"};
  static constexpr std::string_view kWordsOfLift[] = {"down", "up"};
  if (from.paddles != unsaid.paddles || from.lift != unsaid.lift) to.texts("paddle_state", std::array{std::string(kWordsOfPaddles[static_cast<std::size_t>(from.paddles)]), std::string(kWordsOfLift[static_cast<std::size_t>(from.lift)])});
  if (from.autosnatch != unsaid.autosnatch) to.flag("autosnatch", from.autosnatch);
}

void write(const ActuatorDesc& from, const ActuatorDesc& unsaid, Words& to) {
  static constexpr std::string_view kWordsOfType[] = {"linear", "rotational"};
  if (from.type != unsaid.type) to.text("type", kWordsOfType[static_cast<std::size_t>(from.type)]);
  const double axis[] = {from.axis_x, from.axis_y, from.axis_z};
  if (from.axis_x != unsaid.axis_x || from.axis_y != unsaid.axis_y || from.axis_z != unsaid.axis_z) to.tuple("axis", "NNN", axis);
  if (from.min_position != unsaid.min_position) to.number("min_position", from.min_position);
  if (from.max_position != unsaid.max_position) to.number("max_position", from.max_position);
  if (from.max_speed != unsaid.max_speed) to.number("max_speed", from.max_speed);
  if (from.start_position != unsaid.start_position) to.number("start_position", from.start_position);
}

void write(const WifiDesc& from, const WifiDesc& unsaid, Words& to) {
  if (from.ip != unsaid.ip) to.text("ip", from.ip);
  if (from.mac != unsaid.mac) to.text("mac", from.mac);
  if (from.essid != unsaid.essid) to.text("essid", from.essid);
  if (from.frequency != unsaid.frequency) to.number("freq", from.frequency);
  if (from.bitrate != unsaid.bitrate) to.number("bitrate", from.bitrate);
  if (from.power != unsaid.power) to.number("power", from.power);
  if (from.sensitivity != unsaid.sensitivity) to.number("sensitivity", from.sensitivity);
  static constexpr std::string_view kWordsOfModel[] = {"friis", "simple", "ITU indoor", "log distance", "raytrace"};
  if (from.propagation != unsaid.propagation) to.text("model", kWordsOfModel[static_cast<std::size_t>(from.propagation)]);
  if (from.range != unsaid.range) to.number("range", from.range);
  if (from.plc != unsaid.plc) to.number("plc", from.plc);
  if (from.ple != unsaid.ple) to.number("ple", from.ple);
  if (from.wall_factor != unsaid.wall_factor) to.number("wall_factor", from.wall_factor);
  if (from.fading != unsaid.fading) to.number("fading", from.fading);
  if (from.loss != unsaid.loss) to.integer("loss", from.loss);
}

void write(const CameraDesc& from, const CameraDesc& unsaid, Words& to) {
  const double resolution[] = {from.width, from.height};
  if (from.width != unsaid.width || from.height != unsaid.height) to.tuple("resolution", "NN", resolution);
  const double range[] = {from.range_min, from.range_max};
  if (from.range_min != unsaid.range_min || from.range_max != unsaid.range_max) to.tuple("range", "LL", range);
  const double fov[] = {from.fov_horizontal, from.fov_vertical};
  if (from.fov_horizontal != unsaid.fov_horizontal || from.fov_vertical != unsaid.fov_vertical) to.tuple("fov", "AA", fov);
  const double pantilt[] = {from.pan, from.tilt};
  if (from.pan != unsaid.pan || from.tilt != unsaid.tilt) to.tuple("pantilt", "AA", pantilt);
  const double pan_limits[] = {from.pan_min, from.pan_max};
  if (from.pan_min != unsaid.pan_min || from.pan_max != unsaid.pan_max) to.tuple("pan_limits", "AA", pan_limits);
  const double tilt_limits[] = {from.tilt_min, from.tilt_max};
  if (from.tilt_min != unsaid.tilt_min || from.tilt_max != unsaid.tilt_max) to.tuple("tilt_limits", "AA", tilt_limits);
  const double zoom_limits[] = {from.zoom_min, from.zoom_max};
  if (from.zoom_min != unsaid.zoom_min || from.zoom_max != unsaid.zoom_max) to.tuple("zoom_limits", "AA", zoom_limits);
  if (from.pantilt_speed != unsaid.pantilt_speed) to.angle("pantilt_speed", from.pantilt_speed);
  static constexpr std::string_view kWordsOfImage[] = {"color", "gray", "depth", "segmentation"};
  if (from.image != unsaid.image) to.text("image", kWordsOfImage[static_cast<std::size_t>(from.image)]);
  static constexpr std::string_view kWordsOfCompression[] = {"raw", "jpeg"};
  if (from.compression != unsaid.compression) to.text("compression", kWordsOfCompression[static_cast<std::size_t>(from.compression)]);
  if (from.quality != unsaid.quality) to.integer("quality", from.quality);
  const double noise[] = {from.noise_value, from.noise_depth};
  if (from.noise_value != unsaid.noise_value || from.noise_depth != unsaid.noise_depth) to.tuple("noise", "NN", noise);
}

void write(const DetectorDesc& from, const DetectorDesc& unsaid, Words& to) {
  if (from.fov != unsaid.fov) to.angle("fov", from.fov);
  if (from.fov_vertical != unsaid.fov_vertical) to.angle("fov_vertical", from.fov_vertical);
  const double range[] = {from.range_min, from.range_max};
  if (from.range_min != unsaid.range_min || from.range_max != unsaid.range_max) to.tuple("range", "LL", range);
  if (from.samples != unsaid.samples) to.integer("samples", from.samples);
  if (from.rays != unsaid.rays) to.integer("rays", from.rays);
  if (from.layers != unsaid.layers) to.integer("layers", from.layers);
  if (from.sees != unsaid.sees) to.texts("sees", from.sees);
  if (from.through != unsaid.through) to.texts("through", from.through);
  if (from.walls != unsaid.walls) to.integer("walls", from.walls);
  const double attenuation[] = {from.loss_per_body, from.loss_per_metre};
  if (from.loss_per_body != unsaid.loss_per_body || from.loss_per_metre != unsaid.loss_per_metre) to.tuple("attenuation", "NN", attenuation);
  if (from.spread != unsaid.spread) to.number("spread", from.spread);
  if (from.budget != unsaid.budget) to.number("budget", from.budget);
  if (from.resolution != unsaid.resolution) to.length("resolution", from.resolution);
  const double noise[] = {from.noise_constant, from.noise_proportional, from.noise_angular};
  if (from.noise_constant != unsaid.noise_constant || from.noise_proportional != unsaid.noise_proportional || from.noise_angular != unsaid.noise_angular) to.tuple("noise", "LNA", noise);
  if (from.miss != unsaid.miss) to.number("miss", from.miss);
}

void write(const CustomDesc& from, const CustomDesc& unsaid, Words& to) {
  if (from.library != unsaid.library) to.text("library", from.library);
}

void write(const ImuDesc& from, const ImuDesc& unsaid, Words& to) {
  const double acceleration_noise[] = {from.acceleration_white, from.acceleration_walk};
  if (from.acceleration_white != unsaid.acceleration_white || from.acceleration_walk != unsaid.acceleration_walk) to.tuple("acceleration_noise", "NN", acceleration_noise);
  const double gyro_noise[] = {from.gyro_white, from.gyro_walk};
  if (from.gyro_white != unsaid.gyro_white || from.gyro_walk != unsaid.gyro_walk) to.tuple("gyro_noise", "NN", gyro_noise);
  if (from.acceleration_bias != unsaid.acceleration_bias) to.number("acceleration_bias", from.acceleration_bias);
  if (from.gyro_bias != unsaid.gyro_bias) to.number("gyro_bias", from.gyro_bias);
  if (from.acceleration_range != unsaid.acceleration_range) to.number("acceleration_range", from.acceleration_range);
  if (from.gyro_range != unsaid.gyro_range) to.number("gyro_range", from.gyro_range);
}

void write(const GpsDesc& from, const GpsDesc& unsaid, Words& to) {
  const double noise[] = {from.noise_horizontal, from.noise_vertical};
  if (from.noise_horizontal != unsaid.noise_horizontal || from.noise_vertical != unsaid.noise_vertical) to.tuple("noise", "LL", noise);
  const double drift[] = {from.drift_horizontal, from.drift_vertical};
  if (from.drift_horizontal != unsaid.drift_horizontal || from.drift_vertical != unsaid.drift_vertical) to.tuple("drift", "LL", drift);
  if (from.drift_time != unsaid.drift_time) to.number("drift_time", from.drift_time);
  if (from.velocity_noise != unsaid.velocity_noise) to.number("velocity_noise", from.velocity_noise);
  if (from.satellites != unsaid.satellites) to.integer("satellites", from.satellites);
  const double dop[] = {from.hdop, from.vdop};
  if (from.hdop != unsaid.hdop || from.vdop != unsaid.vdop) to.tuple("dop", "NN", dop);
}

void write(const RangerSensorDesc& from, const RangerSensorDesc& unsaid, Words& to) {
  if (from.X_BS != unsaid.X_BS) to.pose("pose", from.X_BS);
  if (from.size != unsaid.size) to.size("size", from.size);
  const double range[] = {from.range_min, from.range_max};
  if (from.range_min != unsaid.range_min || from.range_max != unsaid.range_max) to.tuple("range", "LL", range);
  if (from.fov != unsaid.fov) to.angle("fov", from.fov);
  if (from.samples != unsaid.samples) to.integer("samples", from.samples);
  if (from.rings != unsaid.rings) to.integer("rings", from.rings);
  const double ring_fov[] = {from.ring_lowest, from.ring_highest};
  if (from.ring_lowest != unsaid.ring_lowest || from.ring_highest != unsaid.ring_highest) to.tuple("ring_fov", "AA", ring_fov);
  static constexpr std::string_view kWordsOfError[] = {"none", "lidar"};
  if (from.errors != unsaid.errors) to.text("error", kWordsOfError[static_cast<std::size_t>(from.errors)]);
  if (from.range_dark != unsaid.range_dark) to.length("range_dark", from.range_dark);
  if (from.noise_weak != unsaid.noise_weak) to.length("noise_weak", from.noise_weak);
  const double noise[] = {from.noise_constant, from.noise_proportional, from.noise_angular};
  if (from.noise_constant != unsaid.noise_constant || from.noise_proportional != unsaid.noise_proportional || from.noise_angular != unsaid.noise_angular) to.tuple("noise", "LNA", noise);
  if (from.color != unsaid.color) to.color(from.color);
}

}  // namespace

void write(const PlainDesc& from, const PlainDesc& unsaid, double z, Words& to) {
  if (from.X_PM != unsaid.X_PM) to.pose("pose", from.X_PM, z);
  const double tilt[] = {from.roll, from.pitch};
  if (from.roll != unsaid.roll || from.pitch != unsaid.pitch) to.tuple("tilt", "AA", tilt);
  if (from.X_MB != unsaid.X_MB) to.pose("origin", from.X_MB);
  if (from.size != unsaid.size) to.size("size", from.size);
  if (from.color != unsaid.color) to.color(from.color);
  if (from.obstacle_return != unsaid.obstacle_return) to.flag("obstacle_return", from.obstacle_return);
  if (from.ranger_return != unsaid.ranger_return) to.number("ranger_return", from.ranger_return);
  if (from.fiducial_return != unsaid.fiducial_return) to.integer("fiducial_return", from.fiducial_return);
  if (from.fiducial_key != unsaid.fiducial_key) to.integer("fiducial_key", from.fiducial_key);
  if (from.gripper_return != unsaid.gripper_return) to.flag("gripper_return", from.gripper_return);
  if (from.mass != unsaid.mass) to.number("mass", from.mass);
  if (from.friction != unsaid.friction) to.number("friction", from.friction);
  const double friction_axes[] = {from.friction_x, from.friction_y};
  if (from.friction_x != unsaid.friction_x || from.friction_y != unsaid.friction_y) to.tuple("friction_axes", "NN", friction_axes);
  if (from.material != unsaid.material) to.text("material", from.material);
  if (from.restitution) to.number("restitution", *from.restitution);
  if (from.roughness) to.number("roughness", *from.roughness);
  if (from.lamp != unsaid.lamp) to.number("lamp", from.lamp);
  if (from.update_interval != unsaid.update_interval) to.milliseconds("update_interval", from.update_interval);
  if (from.alwayson != unsaid.alwayson) to.flag("alwayson", from.alwayson);
  if (from.gui_move != unsaid.gui_move) to.flag("gui_move", from.gui_move);
  if (from.gui_nose != unsaid.gui_nose) to.flag("gui_nose", from.gui_nose);
  if (from.gui_outline != unsaid.gui_outline) to.flag("gui_outline", from.gui_outline);
  if (from.gui_grid != unsaid.gui_grid) to.flag("gui_grid", from.gui_grid);
  if (from.say != unsaid.say) to.text("say", from.say);
  if (from.trail_length != unsaid.trail_length) to.integer("trail_length", from.trail_length);
  if (from.ctrl != unsaid.ctrl) to.texts("ctrl", from.ctrl);
  if (from.watts != unsaid.watts) to.number("watts", from.watts);
  if (from.joules) to.number("joules", *from.joules);
  if (from.joules_capacity) to.number("joules_capacity", *from.joules_capacity);
  if (from.kjoules) to.number("kjoules", *from.kjoules);
  if (from.kjoules_capacity) to.number("kjoules_capacity", *from.kjoules_capacity);
  if (from.give_watts != unsaid.give_watts) to.number("give_watts", from.give_watts);
  if (from.take_watts != unsaid.take_watts) to.number("take_watts", from.take_watts);
  if (from.map_resolution != unsaid.map_resolution) to.length("map_resolution", from.map_resolution);
  if (from.map_height != unsaid.map_height) to.length("map_height", from.map_height);
}

void write(const WindowDesc& from, const WindowDesc& unsaid, Words& to) {
  if (from.center != unsaid.center) to.point("center", from.center);
  if (from.scale != unsaid.scale) to.number("scale", from.scale);
  const double rotate[] = {from.pitch, from.yaw};
  if (from.pitch != unsaid.pitch || from.yaw != unsaid.yaw) to.tuple("rotate", "DD", rotate);
  if (from.show_data != unsaid.show_data) to.flag("show_data", from.show_data);
  if (from.follow_model != unsaid.follow_model) to.text("follow_model", from.follow_model);
}

void write(const WorldDesc& from, const WorldDesc& unsaid, Words& to) {
  if (from.name != unsaid.name) to.text("name", from.name);
  if (from.interval != unsaid.interval) to.milliseconds("interval_sim", from.interval);
  if (from.resolution != unsaid.resolution) to.number("resolution", from.resolution);
  if (from.gravity != unsaid.gravity) to.number("gravity", from.gravity);
  if (from.ground != unsaid.ground) to.text("ground", from.ground);
  if (from.quit_time != unsaid.quit_time) to.number("quit_time", from.quit_time);
  if (from.speedup != unsaid.speedup) to.number("speedup", from.speedup);
  if (from.paused != unsaid.paused) to.flag("paused", from.paused);
  const double sky[] = {from.sky_red, from.sky_green, from.sky_blue};
  if (from.sky_red != unsaid.sky_red || from.sky_green != unsaid.sky_green || from.sky_blue != unsaid.sky_blue) to.tuple("sky", "NNN", sky);
  const double sun[] = {from.sun_heading, from.sun_elevation, from.sun_brightness};
  if (from.sun_heading != unsaid.sun_heading || from.sun_elevation != unsaid.sun_elevation || from.sun_brightness != unsaid.sun_brightness) to.tuple("sun", "AAN", sun);
  if (from.fog != unsaid.fog) to.length("fog", from.fog);
  const double fog_color[] = {from.fog_red, from.fog_green, from.fog_blue};
  if (from.fog_red != unsaid.fog_red || from.fog_green != unsaid.fog_green || from.fog_blue != unsaid.fog_blue) to.tuple("fog_color", "NNN", fog_color);
  if (from.latitude != unsaid.latitude) to.angle("latitude", from.latitude);
  if (from.longitude != unsaid.longitude) to.angle("longitude", from.longitude);
  if (from.altitude != unsaid.altitude) to.number("altitude", from.altitude);
}

void write_kind(const KindDescs& from, const Units& units, Entity& to) {
  Words words(units, to.words);
  if (from.position) write(*from.position, {}, words);
  if (from.fiducial) write(*from.fiducial, {}, words);
  if (from.blobfinder) write(*from.blobfinder, {}, words);
  if (from.bumper) write(*from.bumper, {}, words);
  if (from.blinkenlight) write(*from.blinkenlight, {}, words);
  if (from.gripper) write(*from.gripper, {}, words);
  if (from.actuator) write(*from.actuator, {}, words);
  if (from.wifi) write(*from.wifi, {}, words);
  if (from.camera) write(*from.camera, {}, words);
  if (from.detector) write(*from.detector, {}, words);
  if (from.custom) write(*from.custom, {}, words);
  if (from.imu) write(*from.imu, {}, words);
  if (from.gps) write(*from.gps, {}, words);
  for (const RangerSensorDesc& part : from.sensors) {
    Words words_of_part(units, to.parts.emplace_back(Entity{"sensor", {}, {}}).words);
    write(part, {}, words_of_part);
  }
}

}  // namespace playhouse::scene
