/// DetectorSense: the phase that measures with detectors that are subscribed and due. A detector traces
/// straight lines; along each it hits bodies in order, reports those that match its filter, and passes
/// through those that are transparent to it, until its limits on occluders or on attenuation are reached.
///
/// In: poses, bodies, properties of models; the description of each detector.
/// Out: the nearest hit of each beam, and each detection.
/// Cost: for each horizontal direction the walls along it and the bodies near it (slice.h); for each layer a
///   sort of the bodies hit, and a filter test for each of them.
/// Source: attenuation adds in dB; spreading loss is 10 n log10(d / 1 m).

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "playhouse/base/rng.h"
#include "playhouse/geom/logarithm.h"
#include "playhouse/rays/slice.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/world/conditions.h"

namespace playhouse::senses {
namespace {

using scene::DetectorDesc;
using world::Detection;
using world::Echo;

constexpr bodies::SeenByBits kAnybody = static_cast<bodies::SeenByBits>(~0u);

/// Precomputed directions of all detectors of one description.
struct Aim {
  std::vector<geom::Rotation> ahead;  // of lines from right to left, relative to the detector's heading
  struct Layer {
    double slope;   // m of rise per metre on the floor
    double length;  // m of line per metre on the floor
  };
  std::vector<Layer> layers;  // bottom to top
  world::Conditions sees, through;
};

Aim aim_of(const world::World& world, const DetectorDesc& detector) {
  Aim aim{{}, {}, {world, detector.sees}, {world, detector.through}};
  const std::uint32_t lines = detector.samples * detector.rays;
  for (std::uint32_t i = 0; i < lines; ++i)
    aim.ahead.push_back(geom::Rotation::of(detector.fov * ((i + 0.5) / lines - 0.5)));
  for (std::uint32_t i = 0; i < detector.layers; ++i) {
    const geom::SinCos up = geom::sincos(detector.fov_vertical * ((i + 0.5) / detector.layers - 0.5));
    aim.layers.push_back({up.sin / up.cos, 1 / up.cos});
  }
  return aim;
}

/// Two-way spreading loss, without attenuation by bodies.  [m, dB]
double spread_loss(const DetectorDesc& detector, double distance) {
  return detector.spread > 0 && distance > 1 ? 10 * detector.spread * geom::log10(distance) : 0;
}

/// A body hit by a line.
struct Met {
  double from, to;  // m on the floor
  bodies::SolidRow solid;
};

/// A detection, accumulated over lines.
struct Found {
  Detection told;
  world::ModelRow root;
  double cos = 0, sin = 0;  // sums of directions in which it was seen, relative to the heading
};

/// Scratch buffers of one worker.
struct Scratch {
  rays::Slicer slicer;
  std::vector<Met> met;
  std::vector<Found> found;
};

/// One measurement of one detector.
class Look {
 public:
  Look(world::World& world, const bodies::Space& space, world::DetectorRow row, const Aim& aim,
       std::uint64_t tick, Scratch& scratch)
      : world_(world),
        space_(space),
        model_(world.detectors.model[row]),
        detector_(*world.desc(model_).detector),
        aim_(aim),
        tick_(tick),
        scratch_(scratch),
        echoes_(world.detectors.echoes[row]) {}

  void measure(std::vector<Detection>& finds) {
    const scene::ModelDesc& desc = world_.desc(model_);
    const geom::Pose X_WB = geom::compose(world_.models.X_WM[model_], desc.X_MB);
    scratch_.found.clear();
    echoes_.assign(detector_.samples, {static_cast<float>(detector_.range_max), 0});
    scratch_.slicer.stand(space_, X_WB.xy(), X_WB.z + 0.5 * desc.size.z, detector_.range_max, kAnybody,
                          world_.models.root[model_]);
    const geom::Rotation heading = geom::Rotation::of(X_WB.a);
    for (std::uint32_t line = 0; line < aim_.ahead.size(); ++line) {
      const geom::Rotation& ahead = aim_.ahead[line];
      const std::vector<rays::Stretch>& stretches =
          scratch_.slicer.along(space_, heading * geom::Vec2{ahead.c, ahead.s}, detector_.range_max);
      for (const Aim::Layer& layer : aim_.layers) {
        meet(stretches, layer.slope);
        follow(layer.length, ahead, echoes_[line / detector_.rays]);
      }
    }
    tell(finds);
  }

 private:
  Rng draw(Purpose purpose, std::uint32_t part) const {
    return Rng(world_.seed(), tick_, {purpose, world_.serial(model_), part});
  }

  /// Lists the bodies that a line of this slope hits, nearest first, except one that it starts in.
  void meet(const std::vector<rays::Stretch>& stretches, double slope) {
    scratch_.met.clear();
    for (const rays::Stretch& stretch : stretches) {
      double from = stretch.from, to = stretch.to;
      if (slope == 0) {
        if (stretch.low > 0 || stretch.high < 0) continue;
      } else {
        const double a = stretch.low / slope, b = stretch.high / slope;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
      }
      if (from > 0 && from < to) scratch_.met.push_back({from, to, stretch.solid});
    }
    std::ranges::sort(scratch_.met, {}, [](const Met& met) { return std::tuple(met.from, met.solid); });
  }

  /// Evaluates a line; `length` is metres of line per metre on the floor.
  void follow(double length, const geom::Rotation& ahead, Echo& echo) {
    double lost = 0;  // dB
    std::uint32_t bodies = 0;
    for (const Met& met : scratch_.met) {
      const double range = met.from * length;
      if (range > detector_.range_max) return;
      const world::ModelRow model = space_.solids.model[met.solid];
      const double level = detector_.budget - lost - spread_loss(detector_, range);
      if (range >= detector_.range_min && level >= 0 && sees(model)) {
        if (note(model, range, level, bodies, ahead) && range < static_cast<double>(echo.range))
          echo = {static_cast<float>(range), static_cast<float>(level)};
      }
      if (!aim_.through.empty() && aim_.through.hold(world_, model)) continue;
      if (bodies++ == detector_.walls) return;
      lost += detector_.loss_per_body + detector_.loss_per_metre * (met.to - met.from) * length;
    }
  }

  bool sees(world::ModelRow model) const { return aim_.sees.empty() || aim_.sees.hold(world_, model); }

  /// Adds a detection. False if the thing is missed in this measurement (probability `miss`).
  bool note(world::ModelRow model, double range, double level, std::uint32_t bodies,
            const geom::Rotation& ahead) {
    const world::ModelRow root = world_.models.root[model];
    const world::ModelId target = world_.id(root);
    if (detector_.miss > 0 && draw(Purpose::kDetection, world_.serial(target)).uniform() < detector_.miss)
      return false;
    auto found = std::ranges::find(scratch_.found, root, &Found::root);
    if (found == scratch_.found.end()) {
      scratch_.found.push_back({{}, root});
      found = scratch_.found.end() - 1;
      found->told.range = 2 * range + 1;
    }
    found->cos += ahead.c;
    found->sin += ahead.s;
    if (range < found->told.range)
      found->told = {target, world_.models.fiducial_return[model], range, 0, level, bodies};
    return true;
  }

  double with_error(double range, Rng& rng) const {
    if (detector_.noise_proportional > 0) range += range * detector_.noise_proportional * rng.gaussian();
    if (detector_.noise_constant > 0) range += detector_.noise_constant * rng.gaussian();
    if (detector_.resolution > 0) range = detector_.resolution * std::round(range / detector_.resolution);
    return std::clamp(range, detector_.range_min, detector_.range_max);
  }

  /// Writes the detections, with noise.
  void tell(std::vector<Detection>& finds) const {
    finds.clear();
    for (const Found& found : scratch_.found) {
      Detection& told = finds.emplace_back(found.told);
      Rng rng = draw(Purpose::kDetection, world_.serial(told.target));
      rng.bits();  // the first number decided on `miss`
      told.range = with_error(told.range, rng);
      told.bearing = geom::atan2(found.sin, found.cos);
      if (detector_.noise_angular > 0)
        told.bearing = geom::normalize(told.bearing + detector_.noise_angular * rng.gaussian());
    }
    std::ranges::sort(finds, {}, &Detection::target);
    for (std::uint32_t beam = 0; beam < echoes_.size(); ++beam) {
      Echo& echo = echoes_[beam];
      if (static_cast<double>(echo.range) >= detector_.range_max) continue;
      Rng rng = draw(Purpose::kEcho, beam);
      echo.range = static_cast<float>(with_error(static_cast<double>(echo.range), rng));
    }
  }

  const world::World& world_;
  const bodies::Space& space_;
  world::ModelRow model_;
  const DetectorDesc& detector_;
  const Aim& aim_;
  std::uint64_t tick_;
  Scratch& scratch_;
  std::vector<Echo>& echoes_;
};

class DetectorSense final : public SensePhase {
 public:
  explicit DetectorSense(unsigned workers) : scratch_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.detectors.model, world.detectors.measured_tick};
  }

  void populate(const world::World& world, const bodies::Space&) override {
    aims_.clear();
    aims_.resize(world.scene().models.size());
    for (const world::ModelRow model : world.detectors.model) {
      std::optional<Aim>& aim = aims_[world.models.desc[model]];
      if (!aim) aim = aim_of(world, *world.desc(model).detector);
    }
  }

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override {
    workers.run(due.size(), 1, [&](std::size_t begin, std::size_t end) {
      Scratch& scratch = scratch_[workers.current()];
      for (std::size_t i = begin; i < end; ++i)
        Look(world, space, due[i], aim_for(world, due[i]), tick, scratch)
            .measure(world.detectors.finds[due[i]]);
    });
    std::uint64_t rays = 0;
    for (const world::DetectorRow row : due)
      rays += aim_for(world, row).ahead.size() * aim_for(world, row).layers.size();
    return rays;
  }

 private:
  const Aim& aim_for(const world::World& world, world::DetectorRow row) const {
    return *aims_[world.models.desc[world.detectors.model[row]]];
  }

  std::vector<std::optional<Aim>> aims_;  // by description of detectors (rows of SceneDesc::models)
  std::vector<Scratch> scratch_;          // (workers)
};

}  // namespace

std::unique_ptr<SensePhase> make_detector_sense(unsigned workers) {
  return std::make_unique<DetectorSense>(workers);
}

}  // namespace playhouse::senses
