#include "playhouse/scene/world_models.h"

#include <algorithm>
#include <array>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {
namespace {

constexpr std::string_view kBoundsForm = "[xmin xmax ymin ymax zmin zmax amin amax]";

/// The index of the word that `key` has; fails on a word that is none of them.
std::size_t read_choice(const Properties& properties, std::string_view key,
                        std::span<const std::string_view> words) {
  if (!properties.has(key)) return 0;
  const std::string word = properties.text(key, words.front());
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string known;
  for (const std::string_view w : words) known += (known.empty() ? "" : ", ") + in_quotes(w);
  properties.state().fail(properties.where(key), in_quotes(key) + " is one of " + known + ", found " +
                                                     in_quotes(word) + did_you_mean(word, words));
  return 0;
}

void require(bool good, const Properties& properties, std::string_view key, std::string_view what) {
  if (!good) properties.state().fail(properties.where(key), in_quotes(key) + " " + std::string(what));
}

void read_bounds(const Properties& properties, std::string_view key, Bounds (&bounds)[4]) {
  std::array<double, 8> v = {-1, 1, -1, 1, -1, 1, -geom::kPi / 2, geom::kPi / 2};
  properties.tuple(key, "LLLLLLAA", v, kBoundsForm);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    bounds[axis] = {v[2 * axis], v[2 * axis + 1]};
    require(bounds[axis].min <= bounds[axis].max, properties, key, "has a minimum above its maximum");
  }
}

PositionDesc read_position(const Properties& properties) {
  static constexpr std::string_view kDrives[] = {"diff", "omni", "car"};
  static constexpr std::string_view kLocalizations[] = {"gps", "odom"};
  PositionDesc position;
  position.drive = static_cast<Drive>(read_choice(properties, "drive", kDrives));
  position.localization = static_cast<Localization>(read_choice(properties, "localization", kLocalizations));
  position.localization_origin = properties.pose("localization_origin");
  double v[4] = {};
  properties.tuple("velocity", "LLLA", v, "[x y z heading] per second");
  position.velocity = {v[0], v[1], v[2], v[3]};
  read_bounds(properties, "velocity_bounds", position.velocity_bounds);
  read_bounds(properties, "acceleration_bounds", position.acceleration_bounds);
  position.wheelbase = properties.length("wheelbase", 1.0);
  require(position.wheelbase > 0, properties, "wheelbase", "must be above 0");
  // Fractions, so no unit applies; the original turned the last one from degrees to radians.
  if (double e[4] = {}; properties.tuple("odom_error", "NNNN", e, "[x y z heading]")) {
    position.odom_error = geom::Twist{e[0], e[1], e[2], e[3]};
  }
  return position;
}

FiducialDesc read_fiducial(const Properties& properties) {
  FiducialDesc fiducial;
  fiducial.range_min = properties.length("range_min", fiducial.range_min);
  fiducial.range_max = properties.length("range_max", fiducial.range_max);
  fiducial.range_max_id = properties.length("range_max_id", fiducial.range_max_id);
  fiducial.fov = properties.angle("fov", fiducial.fov);
  fiducial.ignore_zloc = properties.flag("ignore_zloc", false);
  for (const std::string_view key : {"range_min", "range_max", "range_max_id", "fov"}) {
    require(properties.number(key, 0) >= 0, properties, key, "must not be negative");
  }
  return fiducial;
}

}  // namespace

void read_model(const Properties& properties, const ModelType& type, std::size_t row, double interval,
                ModelDesc& model) {
  model.type = std::string(type.name);
  model.kind = type.kind;
  model.X_PM = properties.pose("pose").value_or(geom::Pose{});
  model.X_MB = properties.pose("origin").value_or(geom::Pose{});
  model.size = properties.size("size", type.size);
  model.color = properties.color(type.color, row);
  model.obstacle_return = properties.flag("obstacle_return", true);
  model.ranger_return = properties.number("ranger_return", 1.0);
  model.fiducial_return = properties.integer("fiducial_return", 0);
  model.fiducial_key = properties.integer("fiducial_key", 0);
  model.gripper_return = properties.flag("gripper_return", false);
  model.mass = properties.number("mass", 0);
  const double update_ms = properties.number("update_interval", 100);
  if (update_ms < 0) {
    properties.state().warnings.add(Warning::kValue, properties.where("update_interval"),
                                    "\"update_interval\" is below 0; every tick is meant");
  }
  model.update_interval = std::max(update_ms / 1000, interval);
  model.alwayson = properties.flag("alwayson", false);
  model.gui_move = properties.flag("gui_move", model.parent < 0);
  model.say = properties.text("say", "");
  model.trail_length = std::max(0, properties.integer("trail_length", 20));
  model.ctrl = properties.texts("ctrl");
  std::erase(model.ctrl, "");
  if (type.kind == ModelKind::kPosition) model.position = read_position(properties);
  if (type.kind == ModelKind::kFiducial) model.fiducial = read_fiducial(properties);
}

RangerSensorDesc read_sensor(const Properties& properties, std::size_t row) {
  RangerSensorDesc sensor;
  sensor.X_BS = properties.pose("pose").value_or(geom::Pose{});
  sensor.size = properties.size("size", {0.02, 0.02, 0.02});
  double range[2] = {sensor.range_min, sensor.range_max};
  properties.tuple("range", "LL", range, "[min max]");
  require(range[0] >= 0 && range[0] <= range[1], properties, "range", "needs 0 <= min <= max");
  sensor.range_min = range[0];
  sensor.range_max = range[1];
  sensor.fov = properties.angle("fov", sensor.fov);
  require(sensor.fov >= 0, properties, "fov", "must not be negative");
  const int samples = properties.integer("samples", 1);
  require(samples >= 1 && samples <= limits::kRangerSamples, properties, "samples",
          "must be from 1 to " + std::to_string(limits::kRangerSamples));
  sensor.samples = static_cast<std::uint32_t>(std::max(1, samples));
  double noise[3] = {};
  properties.tuple("noise", "LNA", noise, "[constant proportional angular]");
  sensor.noise_constant = noise[0];
  sensor.noise_proportional = noise[1];
  sensor.noise_angular = noise[2];
  sensor.color = properties.color(sensor.color, row);
  return sensor;
}

WindowDesc read_window(const Properties& properties) {
  WindowDesc window;
  double center[2] = {};
  properties.tuple("center", "NN", center, "[x y]");
  window.center = {center[0], center[1]};
  window.scale = properties.number("scale", 0);
  require(window.scale >= 0, properties, "scale", "must not be negative");
  double rotate[2] = {};  // degrees, whatever the file's unit
  properties.tuple("rotate", "NN", rotate, "[pitch yaw]");
  window.pitch = geom::radians(rotate[0]);
  window.yaw = geom::radians(rotate[1]);
  window.show_data = properties.flag("show_data", false);
  window.follow_model = properties.text("follow_model", "");
  return window;
}

}  // namespace playhouse::scene
