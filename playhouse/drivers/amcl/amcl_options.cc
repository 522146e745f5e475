#include "playhouse/drivers/amcl/amcl_options.h"

#include <fmt/format.h>

#include <cmath>

#include "playhouse/drivers/amcl/amcl.h"

namespace playhouse::drivers {
namespace {

constexpr int kMostParticles = 1000000;
constexpr double kLeastLength = 1e-3;  // m

constexpr DeviceText kAmclProvides[] = {
    {"localize"},
    {"position2d", {}, HowMany::kOneOrNone, "the odometry with the pose on the map"},
};
constexpr DeviceText kAmclUses[] = {
    {"position2d", {}, HowMany::kOne, "the robot's odometry"},
    {"laser", {}, HowMany::kOneOfThese, "on the robot"},
    {"ranger", {}, HowMany::kOneOfThese, "on the robot"},
    {"sonar", {}, HowMany::kOneOfThese, "on the robot"},
    {"map"},
};

/// The standard deviations of `init_pose_var`, squared.
PoseBelief start_of(SectionFields& fields) {
  PoseBelief start = AmclOptions().start;
  geom::Pose& mean = start.mean;
  const double any = SectionFields::kAnyNumber;
  mean.x =
      fields.length({"init_pose", "Where the robot is on the map at first: x, y, heading."}, mean.x, any, 0);
  mean.y = fields.length({"init_pose"}, mean.y, any, 1);
  mean.a = geom::normalize(fields.angle({"init_pose"}, mean.a, 2, any));
  auto& cov = start.cov;
  const double x = fields.length({"init_pose_var", "Standard deviations of init_pose."}, std::sqrt(cov[0]), 0,
                                 0),
               y = fields.length({"init_pose_var"}, std::sqrt(cov[1]), 0, 1),
               a = fields.angle({"init_pose_var"}, std::sqrt(cov[2]), 2);
  cov = {x * x, y * y, a * a, 0, 0, 0};
  return start;
}

/// How a sensor's scans count; the words begin with its interface.
void read_sensor(SectionFields& fields, std::string_view sensor, AmclOptions& options) {
  const auto of_sensor = [&](std::string_view word) { return fmt::format("{}_{}", sensor, word); };
  const std::string beams = of_sensor("max_beams"), range = of_sensor("range_max"),
                    error = of_sensor("range_var"), bad = of_sensor("range_bad");
  options.max_beams = static_cast<std::size_t>(fields.integer(
      {beams, "Beams of a scan that are used."}, static_cast<int>(options.max_beams), 1, 100000));
  options.max_range = fields.length(
      {range, "Longer ranges are misses, as those at the sensor's own maximum."}, options.max_range, 0);
  options.sensor.error = fields.length({error, "Standard deviation of a range from the map's surface."},
                                       options.sensor.error, kLeastLength);
  options.sensor.bad =
      fields.number({bad, "Probability of a bad reading, less than 1."}, options.sensor.bad, 1e-6);
  fields.expect(options.sensor.bad < 1, bad, "is less than 1");
}

void tell_all(SectionFields fields) {
  for (const ScanInterface scans : kScanInterfaces) static_cast<void>(amcl_options(fields, name_of(scans)));
}

}  // namespace

constinit const DriverDefinition kAmclDriver{
    .name = "amcl",
    .doc = "Tells where a robot is on a map, by Monte Carlo localization.",
    .provides = kAmclProvides,
    .uses = kAmclUses,
    .read_options = tell_all,
    .make = make_amcl,
};

Result<AmclOptions> amcl_options(SectionFields fields, std::string_view sensor) {
  AmclOptions options;
  const auto least = static_cast<int>(options.min_particles), most = static_cast<int>(options.max_particles);
  options.min_particles = static_cast<std::size_t>(
      fields.integer({"pf_min_samples", "Least number of particles."}, least, 2, kMostParticles));
  options.max_particles = static_cast<std::size_t>(
      fields.integer({"pf_max_samples", "Greatest number of particles; not below pf_min_samples."}, most, 2,
                     kMostParticles));
  fields.expect(options.max_particles >= options.min_particles, "pf_max_samples",
                "is not below pf_min_samples");
  options.kld_error = fields.number(
      {"pf_err",
       "Error of the particles' distribution: more particles for a wide belief, fewer for a narrow one."},
      options.kld_error, 1e-4);
  options.kld_z =
      fields.number({"pf_z", "Normal quantile of the probability that pf_err is kept."}, options.kld_z);
  options.slow_rate = fields.number({"pf_slow_rate",
                                     "Rate of the slow one of two averages whose ratio tells how many "
                                     "particles are random; 0, as pf_fast_rate: none "
                                     "ever. Not above pf_fast_rate."},
                                    options.slow_rate);
  options.fast_rate = fields.number({"pf_fast_rate", "Rate of the fast one, 1 at most."}, options.fast_rate);
  fields.expect(options.fast_rate <= 1, "pf_fast_rate", "is 1 at most");
  fields.expect(options.slow_rate <= options.fast_rate, "pf_slow_rate", "is not above pf_fast_rate");
  options.start = start_of(fields);
  options.update_distance =
      fields.length({"update_thresh", "Distance and angle that a robot moves or turns by between two steps."},
                    options.update_distance, 0, 0);
  options.update_angle = fields.angle({"update_thresh"}, options.update_angle, 1);
  constexpr std::string_view kPer[] = {"metre along x", "metre along y", "radian"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = fmt::format("odom_drift[{}]", i);
    const std::string doc = fmt::format(
        "Standard deviations of the error along x, y [m] and of the heading [rad] per {} of a motion.",
        kPer[i]);
    for (std::size_t j = 0; j < 3; ++j)
      options.drift[i][j] = fields.number({name, doc}, options.drift[i][j], 0, j);
  }
  read_sensor(fields, sensor, options);
  for (const std::string_view word : {"enable_gui", "odom_init"})
    fields.no_effect({word, "Accepted, as files of the original have it."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
