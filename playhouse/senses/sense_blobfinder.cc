/// BlobfinderSense: the phase that finds blobs of a colour in the images of blobfinders that are subscribed
/// and due. An image is one row of columns, a ray each, that hits bodies at any height, as in Stage.
///
/// In: poses, bodies, colours of models; fov, pan, image, range, colours of each camera.
/// Out: blobs, from right to left.
/// Cost: a ray for each column of the image.
/// Source: Stage: columns at equal angles; rows as if every body were kHeight high and centred at the height
///   of the lens.

#include <algorithm>
#include <cmath>

#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {
namespace {

constexpr double kHeight = 0.6;  // m

/// Tolerance for equal colours, components in 0 .. 1.
constexpr float kSameColor = 1e-5f;

bool same(const scene::Color& a, const scene::Color& b) {
  return std::fabs(a.r - b.r) < kSameColor && std::fabs(a.g - b.g) < kSameColor &&
         std::fabs(a.b - b.b) < kSameColor;
}

/// The colours of interest of a blobfinder; none: any.
std::span<const scene::Color> wanted(const scene::BlobfinderDesc& camera) {
  const std::size_t all = camera.colors.size();
  return std::span(camera.colors)
      .first(camera.colors_count > 0 ? std::min<std::size_t>(camera.colors_count, all) : all);
}

/// Sets the first and last row of a blob by its range.
void add_rows(const scene::BlobfinderDesc& camera, world::Blob& blob) {
  const double half = geom::atan2(0.5 * kHeight, blob.range) / (camera.fov / camera.height);  // px
  const double middle = std::floor(0.5 * camera.height), off = std::floor(half);
  blob.top = static_cast<std::uint32_t>(std::clamp(middle - off, 0.0, camera.height));
  blob.bottom = static_cast<std::uint32_t>(std::clamp(middle + off, 0.0, camera.height));
}

class BlobfinderSense final : public SensePhase {
 public:
  SensorTable table(world::World& world) const override {
    return {world.blobfinders.model, world.blobfinders.measured_tick};
  }
  void populate(const world::World&, const bodies::Space&) override {}

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t, world::Workers& workers) override {
    workers.run(due.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) look(world, space, due[i]);
    });
    std::uint64_t rays = 0;
    for (const world::BlobfinderRow row : due)
      rays += columns(*world.desc(world.blobfinders.model[row]).blobfinder);
    return rays;
  }

 private:
  static std::uint32_t columns(const scene::BlobfinderDesc& camera) {
    return static_cast<std::uint32_t>(camera.width);
  }

  static void look(world::World& world, const bodies::Space& space, world::BlobfinderRow row) {
    const world::ModelRow model = world.blobfinders.model[row];
    const scene::ModelDesc& desc = world.desc(model);
    const scene::BlobfinderDesc& camera = *desc.blobfinder;
    const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
    const std::uint32_t count = columns(camera);
    const world::ModelRow root = world.models.root[model];
    const double step = count > 1 ? camera.fov / (count - 1) : 0;
    const double rightmost = X_WB.a + camera.pan - (count > 1 ? 0.5 * camera.fov : 0);
    std::vector<world::Blob>& blobs = world.blobfinders.blobs[row];
    blobs.clear();
    Run run;
    // From the right to the left, as blobs are listed.
    for (std::uint32_t k = 0; k < count; ++k) {
      const geom::Rotation ahead = geom::Rotation::of(rightmost + k * step);
      const bodies::Hit hit = cast(
          space,
          {X_WB.xy(), {ahead.c, ahead.s}, -1e300, 1e300, camera.range, bit(bodies::SeenBy::kImage), root});
      const bool seen = hit.solid.valid();
      const scene::Color color = seen ? world.models.color[space.solids.model[hit.solid]] : scene::Color{};
      if (run.columns > 0 && !(seen && same(color, run.color))) finish(camera, count, run, blobs);
      if (!seen) continue;
      if (run.columns == 0) run = {color, k, 0, 0};
      run.range += hit.range;
      ++run.columns;
    }
    if (run.columns > 0) finish(camera, count, run, blobs);
  }

  /// Consecutive columns of one colour, from the right.
  struct Run {
    scene::Color color;
    std::uint32_t first = 0, columns = 0;
    double range = 0;  // m, sum over columns
  };

  static void finish(const scene::BlobfinderDesc& camera, std::uint32_t count, Run& run,
                     std::vector<world::Blob>& blobs) {
    const std::span<const scene::Color> colors = wanted(camera);
    const auto channel =
        std::ranges::find_if(colors, [&](const scene::Color& color) { return same(color, run.color); });
    if (colors.empty() || channel != colors.end()) {
      world::Blob blob;
      blob.color = run.color;
      blob.channel = static_cast<std::uint32_t>(channel - colors.begin());
      blob.right = count - 1 - run.first;
      blob.left = blob.right + 1 - run.columns;
      blob.range = run.range / run.columns;
      add_rows(camera, blob);
      blobs.push_back(blob);
    }
    run = {};
  }
};

}  // namespace

std::unique_ptr<SensePhase> make_blobfinder_sense(unsigned) {
  return std::make_unique<BlobfinderSense>();
}

}  // namespace playhouse::senses
