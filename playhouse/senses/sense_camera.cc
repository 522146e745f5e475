/// CameraSense: the phase that takes images with cameras that are subscribed
/// and due. A pixel shows the first body, or the floor, that the ray through
/// its centre enters; a ray that starts inside a body sees what is behind it.
///
/// In: poses, bodies, colours of models; the pose and lens of each camera.
/// Out: its pixels; of a stereo camera that is read as one also those of the right lens, and the depths.
/// Cost: for each slice of the lens the walls along it and the bodies near it (slice.h), and for each of its
///   pixels a few operations per stretch of a body, four pixels at a time.
/// Source: slab test: the interval of a ray in an upright prism is the intersection of the stretch with the
///   interval of its heights.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "playhouse/rays/camera_image.h"
#include "playhouse/rays/lens.h"
#include "playhouse/rays/slice.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/scene/forms/daylight.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::senses {
namespace {

using scene::CameraDesc;
using scene::ImageKind;

constexpr double kNothing = 1e300;  // m, distance of a pixel without a hit
static_assert(rays::Lens::kPad >= simd::kFour);

/// Depth buffer of a slice: distance on the floor and number of the nearest thing, by pixel.
struct SeenInSlice {
  double* distance;  // m
  double* thing;     // whole number as double
};

/// Something drawn in a slice.
struct Thing {
  double from, to, low, high;  // see Stretch
  double number;
};

/// Draws a thing with a depth test, except nearer than the near plane
/// `least`. Vectors of four: also writes a pad of up to kFour - 1 pixels.
PLAYHOUSE_INLINE void show(const Thing& thing, const double* run, const double* least, std::size_t pixels,
                           const SeenInSlice& seen) {
  for (std::size_t i = 0; i < pixels; i += simd::kFour) {
    simd::Double4 per_rise, nearest, distance, number;
    simd::load(per_rise, run + i);
    simd::load(nearest, least + i);
    simd::load(distance, seen.distance + i);
    simd::load(number, seen.thing + i);
    const simd::Double4 a = thing.low * per_rise, b = thing.high * per_rise;
    const simd::Double4 first = a < b ? a : b, last = a < b ? b : a;
    const simd::Double4 enters = first > thing.from ? first : simd::Double4{} + thing.from;
    const simd::Double4 leaves = last < thing.to ? last : simd::Double4{} + thing.to;
    const auto shows = (enters < leaves) & (enters >= nearest) & (enters > 0) & (enters < distance);
    simd::store<simd::Double4>(seen.distance + i, shows ? enters : distance);
    simd::store<simd::Double4>(seen.thing + i, shows ? simd::Double4{} + thing.number : number);
  }
}

std::uint32_t rgb(const scene::Color& color) {
  return scene::rgba8(color) >> 8;
}

class CameraSense final : public SensePhase {
 public:
  explicit CameraSense(unsigned workers) : scratch_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.cameras.model, world.cameras.measured_tick};
  }
  void populate(const world::World&, const bodies::Space&) override {}

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override {
    workers.run(due.size(), 1, [&](std::size_t begin, std::size_t end) {
      Scratch& scratch = scratch_[workers.current()];
      for (std::size_t i = begin; i < end; ++i) look(world, space, due[i], tick, scratch);
    });
    std::uint64_t rays = 0;
    for (const world::CameraRow row : due)
      rays += world.cameras.pixels[row].size() + world.cameras.right_pixels[row].size();
    return rays;
  }

 private:
  /// Cached lens of a camera description, for the last tilt and zoom.
  struct Fitted {
    double tilt = 0, zoom = 0;  // rad
    rays::Lens lens;
  };
  /// Scratch buffers of one worker.
  struct Scratch {
    std::map<std::uint32_t, Fitted> lenses;  // by row of SceneDesc::models
    rays::Slicer slicer;
    std::vector<double> distance, thing;  // of the pixels of a slice
    std::vector<double> far, left_far;    // m of depth                                     (image)
    std::vector<std::uint32_t> sample;    // see Seen                                    (image)
  };

  static const rays::Lens& fit(const world::World& world, world::CameraRow row, Scratch& scratch) {
    const world::ModelRow model = world.cameras.model[row];
    const double tilt = world.cameras.tilt[row], zoom = world.cameras.zoom[row];
    Fitted& fitted = scratch.lenses[world.models.desc[model]];
    if (fitted.lens.place.empty() || fitted.tilt != tilt || fitted.zoom != zoom)
      fitted = {tilt, zoom, rays::make_lens(*world.desc(model).camera, tilt, zoom)};
    return fitted.lens;
  }

  static void look(world::World& world, const bodies::Space& space, world::CameraRow row, std::uint64_t tick,
                   Scratch& scratch) {
    trace(world, space, row, 0, scratch);
    rays::expose(world, row, tick, {scratch.far, scratch.sample});
    if (!rays::takes_pairs(world, row)) return rays::forget_pair(world, row);
    std::swap(scratch.far, scratch.left_far);
    trace(world, space, row, world.desc(world.cameras.model[row]).camera->baseline, scratch);
    rays::expose_pair(world, row, tick, {scratch.far, scratch.sample}, scratch.left_far);
  }

  /// What the pixels of a lens see that is so far to the right of the camera's place. [m]
  static void trace(const world::World& world, const bodies::Space& space, world::CameraRow row,
                    double to_the_right, Scratch& scratch) {
    const world::ModelRow model = world.cameras.model[row];
    const scene::ModelDesc& desc = world.desc(model);
    const CameraDesc& camera = *desc.camera;
    const rays::Lens& lens = fit(world, row, scratch);
    const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
    const geom::Rotation heading = geom::Rotation::of(X_WB.a + world.cameras.pan[row]);
    const double eye = X_WB.z + rays::lens_height(desc);
    const geom::Vec2 lens_place = X_WB.xy() + heading * geom::Vec2{0, -to_the_right};
    scratch.slicer.stand(space, lens_place, eye, std::ranges::max(lens.reach), bit(bodies::SeenBy::kImage),
                         world.models.root[model]);
    scratch.far.resize(lens.place.size());
    scratch.sample.resize(lens.place.size());
    for (std::size_t s = 0; s < lens.ahead.size(); ++s) {
      if (lens.first[s] == lens.first[s + 1]) continue;
      const geom::Vec2 d = heading * geom::Vec2{lens.ahead[s].c, lens.ahead[s].s};
      show_slice(world, space, scratch.slicer.along(space, d, lens.reach[s]), lens, s, camera, eye, scratch);
    }
  }

  /// Fills the pixels of a slice.
  static void show_slice(const world::World& world, const bodies::Space& space,
                         const std::vector<rays::Stretch>& stretches, const rays::Lens& lens,
                         std::size_t slice, const CameraDesc& camera, double eye, Scratch& scratch) {
    const std::size_t first = lens.first[slice], pixels = lens.first[slice + 1] - first;
    scratch.distance.assign(pixels + simd::kFour, kNothing);
    scratch.thing.assign(pixels + simd::kFour, 0);
    const SeenInSlice seen{scratch.distance.data(), scratch.thing.data()};
    const auto meet = [&](const Thing& thing) {
      simd::in_vectors<show>(thing, lens.run.data() + first, lens.least.data() + first, pixels, seen);
    };
    meet({0, kNothing, -kNothing, -eye, 0});
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const rays::Stretch& stretch = stretches[k];
      if (world.models.color[space.solids.model[stretch.solid]].a > 0)
        meet({stretch.from, stretch.to, stretch.low, stretch.high, static_cast<double>(k + 1)});
    }
    const bool of_models = camera.image == ImageKind::kSegmentation;
    const std::uint32_t sky = of_models ? 0 : rays::sky_color(world.scene()),
                        floor = of_models ? 0 : scene::kFloorColor;
    const auto sample_of = [&](world::ModelRow model) {
      return of_models ? rays::segment_of(world.models.id[model]) : rgb(world.models.color[model]);
    };
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::uint32_t at = lens.place[first + i];
      const double depth = seen.distance[i] * lens.depth[first + i];
      const bool shown = depth <= camera.range_max;
      const auto thing = static_cast<std::size_t>(seen.thing[i]);
      scratch.far[at] = shown ? depth : 0;
      scratch.sample[at] = !shown       ? sky
                           : thing == 0 ? floor
                                        : sample_of(space.solids.model[stretches[thing - 1].solid]);
    }
  }

  std::vector<Scratch> scratch_;  // (workers)
};

}  // namespace

std::unique_ptr<SensePhase> make_camera_sense(unsigned workers) {
  return std::make_unique<CameraSense>(workers);
}

}  // namespace playhouse::senses
