#include "playhouse/drivers/amcl/amcl_options.h"

#include <fmt/format.h>

#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {
namespace {

constexpr int kMostParticles = 1000000;
constexpr double kLeastLength = 1e-3;  // m

/// The standard deviations of `init_pose_var`, squared.
PoseBelief start_of(const scene::CfgSection& section, SectionFields& fields) {
  PoseBelief start;
  start.mean = {section.length("init_pose", 0, 0), section.length("init_pose", 0, 1), 0,
                geom::normalize(section.angle("init_pose", 0, 2))};
  const double x = fields.length("init_pose_var", 1, 0, 0), y = fields.length("init_pose_var", 1, 0, 1),
               a = fields.angle("init_pose_var", geom::kTwoPi, 2);
  start.cov = {x * x, y * y, a * a, 0, 0, 0};
  return start;
}

}  // namespace

Result<AmclOptions> amcl_options(const scene::CfgSection& section, std::string_view sensor) {
  AmclOptions options;
  SectionFields fields(section);
  const auto least = static_cast<int>(options.min_particles), most = static_cast<int>(options.max_particles);
  options.min_particles =
      static_cast<std::size_t>(fields.integer("pf_min_samples", least, 2, kMostParticles));
  options.max_particles = static_cast<std::size_t>(fields.integer("pf_max_samples", most, 2, kMostParticles));
  fields.expect(options.max_particles >= options.min_particles, "pf_max_samples",
                "is not below pf_min_samples");
  options.kld_error = fields.number("pf_err", options.kld_error, 1e-4);
  options.kld_z = fields.number("pf_z", options.kld_z);
  options.slow_rate = fields.number("pf_slow_rate", options.slow_rate);
  options.fast_rate = fields.number("pf_fast_rate", options.fast_rate);
  fields.expect(options.fast_rate <= 1, "pf_fast_rate", "is 1 at most");
  fields.expect(options.slow_rate <= options.fast_rate, "pf_slow_rate", "is not above pf_fast_rate");
  options.start = start_of(section, fields);
  options.update_distance = fields.length("update_thresh", options.update_distance, 0, 0);
  options.update_angle = fields.angle("update_thresh", options.update_angle, 1);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      options.drift[i][j] = fields.number(fmt::format("odom_drift[{}]", i), options.drift[i][j], 0, j);
  const auto of_sensor = [&](std::string_view word) { return fmt::format("{}_{}", sensor, word); };
  options.max_beams = static_cast<std::size_t>(
      fields.integer(of_sensor("max_beams"), static_cast<int>(options.max_beams), 1, 100000));
  options.max_range = fields.length(of_sensor("range_max"), options.max_range, 0);
  options.sensor.error = fields.length(of_sensor("range_var"), options.sensor.error, kLeastLength);
  options.sensor.bad = fields.number(of_sensor("range_bad"), options.sensor.bad, 1e-6);
  fields.expect(options.sensor.bad < 1, of_sensor("range_bad"), "is less than 1");
  for (const std::string_view word : {"enable_gui", "odom_init"}) section.flag(word, false);  // no effect
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
