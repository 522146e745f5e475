#include "playhouse/app/pictures/picture_of_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "playhouse/app/pictures/client_drawings.h"
#include "playhouse/app/pictures/prisms.h"
#include "playhouse/app/pictures/shape.h"
#include "playhouse/base/limits.h"
#include "playhouse/geom/convex_hull.h"
#include "playhouse/geom/orientation.h"

namespace playhouse::app {
namespace {

using geom::Vec2;

constexpr int kRowsOfPixel = 4;     // level lines along which the cover of a pixel is measured
constexpr double kMargin = 0.03;    // of the longer side
constexpr double kStanding = 0.02;  // rad; what is tilted less is drawn upright
constexpr double kEmpty = 10;       // m, side of a picture without bodies
constexpr std::uint8_t kFloor[] = {236, 239, 244};  // so that white bodies are seen
constexpr scene::Color kNose{0, 0, 0, 0.55f};

/// Shapes of prisms at their models' poses, and of noses.
class Bodies {
 public:
  explicit Bodies(const world::World& world) : world_(world) {}

  /// In model order.
  std::vector<FilledShape> shapes() {
    std::vector<FilledShape> shapes;
    for (const world::ModelRow row : world_.models.rows()) add(row, shapes);
    return shapes;
  }

 private:
  void add(world::ModelRow row, std::vector<FilledShape>& shapes) {
    const std::uint32_t desc = world_.models.desc[row];
    const auto [entry, is_new] = prisms_.try_emplace(desc);
    if (is_new) entry->second = prisms_of(world_.scene().models[desc]);
    for (const Extrusion& prism : entry->second)
      shapes.push_back(placed(prism, row, world_.models.color[row]));
    if (world_.models.kind[row] == scene::ModelKind::kPosition && !entry->second.empty())
      shapes.push_back(placed(nose_of(world_.scene().models[desc]), row, kNose));
  }

  /// A triangle on the front half of the top of the body.
  static Extrusion nose_of(const scene::ModelDesc& desc) {
    const double x = desc.size.x / 2, y = desc.size.y / 2, top = desc.X_MB.z + desc.size.z;
    Extrusion nose{{{{0.9 * x, 0}, {0.3 * x, 0.5 * y}, {0.3 * x, -0.5 * y}}}, top, top};
    for (Vec2& p : nose.loops.front()) p = geom::transform(desc.X_MB, p);
    return nose;
  }

  FilledShape placed(const Extrusion& prism, world::ModelRow row, const scene::Color& color) const {
    const geom::SpatialPose X = world::pose_in_world(world_.models, world::ModelRow{row});
    const bool stands = std::hypot(X.tilt.x, X.tilt.y) < kStanding;
    return stands ? upright(prism, X.X, color) : tilted(prism, X, color);
  }

  static FilledShape upright(const Extrusion& prism, const geom::Pose& X_WM, const scene::Color& color) {
    const geom::Rotation turn = geom::Rotation::of(X_WM.a);
    FilledShape shape{prism.loops, X_WM.z + prism.z_max, color, false};
    for (std::vector<Vec2>& loop : shape.loops)
      for (Vec2& p : loop) p = X_WM.xy() + turn * p;
    return shape;
  }

  /// Projection of a tilted prism: that of its convex hull.
  static FilledShape tilted(const Extrusion& prism, const geom::SpatialPose& X_WM,
                            const scene::Color& color) {
    const geom::Quaternion q = geom::orientation(X_WM.X.a, X_WM.tilt);
    double top = -1e300;
    std::vector<Vec2> points;
    for (const std::vector<Vec2>& loop : prism.loops)
      for (const Vec2& p : loop)
        for (const double z : {prism.z_min, prism.z_max}) {
          const geom::Vec3 turned = q * geom::Vec3{p.x, p.y, z};
          points.push_back(X_WM.X.xy() + Vec2{turned.x, turned.y});
          top = std::max(top, X_WM.X.z + turned.z);
        }
    std::vector<Vec2> hull = geom::convex_hull(std::move(points));
    if (hull.size() < 3) return {{}, top, color, false};
    return {{std::move(hull)}, top, color, false};
  }

  const world::World& world_;
  std::map<std::uint32_t, std::vector<Extrusion>> prisms_;  // by description
};

/// Painter's algorithm.
class Painter {
 public:
  explicit Painter(const Viewport& view) : view_(view) {
    picture_ = {view.width, view.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    picture_.rgb.reserve(3 * pixels);
    for (std::size_t k = 0; k < pixels; ++k)
      picture_.rgb.insert(picture_.rgb.end(), std::begin(kFloor), std::end(kFloor));
  }

  void paint(const FilledShape& shape) {
    std::vector<std::vector<Vec2>> loops = shape.loops;
    for (std::vector<Vec2>& loop : loops)
      for (Vec2& p : loop) p = in_picture(p);
    const std::vector<geom::Outline> outlines(loops.begin(), loops.end());
    const std::vector<geom::Trapezoid> parts =
        shape.each ? inside_of_each(outlines) : geom::trapezoids(outlines);
    if (parts.empty()) return;
    const std::pair<int, int> rows = rows_of(parts);
    const int low = rows.first, high = rows.second;
    cover_.assign(static_cast<std::size_t>(std::max(0, high - low)) * width(), 0);
    for (const geom::Trapezoid& part : parts)
      geom::each_line(
          part, low * kRowsOfPixel, high * kRowsOfPixel, [&](int line, double left, double right) {
            add_cover(cover_.data() + static_cast<std::size_t>(line / kRowsOfPixel - low) * width(), left,
                      right);
          });
    for (std::size_t k = 0; k < cover_.size(); ++k)
      if (cover_[k] > 0) mix(static_cast<std::size_t>(low) * width() + k, shape.color, cover_[k]);
  }

  images::RgbImage take() { return std::move(picture_); }

 private:
  std::size_t width() const { return static_cast<std::size_t>(view_.width); }

  static std::vector<geom::Trapezoid> inside_of_each(const std::vector<geom::Outline>& outlines) {
    std::vector<geom::Trapezoid> parts;
    for (const geom::Outline& outline : outlines) {
      const std::vector<geom::Trapezoid> inside = geom::trapezoids({&outline, 1});
      parts.insert(parts.end(), inside.begin(), inside.end());
    }
    return parts;
  }

  /// x in pixels, y in scan lines, kRowsOfPixel per pixel, from the upper left corner.
  Vec2 in_picture(Vec2 p) const {
    return {(p.x - view_.left) * view_.pixels_per_metre,
            (view_.top - p.y) * view_.pixels_per_metre * kRowsOfPixel};
  }

  /// Pixel rows that the parts touch, clipped to the picture.
  std::pair<int, int> rows_of(const std::vector<geom::Trapezoid>& parts) const {
    double low = 1e300, high = -1e300;
    for (const geom::Trapezoid& part : parts) {
      low = std::min(low, part.y_low);
      high = std::max(high, part.y_high);
    }
    const auto row = [this](double y) {
      return static_cast<int>(std::clamp(y / kRowsOfPixel, 0.0, static_cast<double>(view_.height)));
    };
    return {row(low), std::min(row(high) + 1, view_.height)};
  }

  void add_cover(float* row, double left, double right) const {
    left = std::clamp(left, 0.0, static_cast<double>(view_.width));
    right = std::clamp(right, 0.0, static_cast<double>(view_.width));
    for (int x = static_cast<int>(left); x < right; ++x)
      row[x] += static_cast<float>(std::min(right, x + 1.0) - std::max(left, static_cast<double>(x))) /
                kRowsOfPixel;
  }

  void mix(std::size_t pixel, const scene::Color& color, float cover) {
    const float share = std::min(cover, 1.0f) * color.a;
    const float channels[] = {color.r, color.g, color.b};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& out = picture_.rgb[3 * pixel + k];
      const float mixed = static_cast<float>(out) + share * (255 * channels[k] - static_cast<float>(out));
      out = static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0f, 255.0f)));
    }
  }

  Viewport view_;
  images::RgbImage picture_;
  std::vector<float> cover_;  // coverage of a row's pixels by a shape, 0 to 1
};

}  // namespace

Result<Viewport> view_of(const world::World& world, int width) {
  geom::Box box;
  for (const FilledShape& shape : Bodies(world).shapes())
    for (const std::vector<Vec2>& loop : shape.loops)
      for (const Vec2 p : loop) box.add(p);
  if (box.empty()) box = {-kEmpty / 2, -kEmpty / 2, kEmpty / 2, kEmpty / 2};
  box = box.grown(kMargin * std::max(box.x_max - box.x_min, box.y_max - box.y_min));
  const double across = box.x_max - box.x_min, up = box.y_max - box.y_min;
  const double height = std::max(1.0, std::round(width * up / across));
  if (width * height > static_cast<double>(limits::kPicturePixels))
    return Error{
        "", fmt::format("would be {} x {:.0f} pixels, and a picture has at most {}: choose a smaller --width",
                        width, height, limits::kPicturePixels)};
  return Viewport{width, static_cast<int>(height), box.x_min, box.y_max, width / across, {}};
}

/// Sorted by top height; ties: bodies first, in model order.
images::RgbImage picture_of(const world::World& world, const Viewport& view, const SensorShapes& seen) {
  std::vector<FilledShape> shapes = Bodies(world).shapes();
  add_client_drawings(shapes, world, view.line_width());
  seen.add_to(shapes, world, view.line_width());
  std::ranges::stable_sort(shapes, {}, &FilledShape::z_max);
  Painter painter(view);
  for (const FilledShape& shape : shapes) painter.paint(shape);
  return painter.take();
}

}  // namespace playhouse::app
