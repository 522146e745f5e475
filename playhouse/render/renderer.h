#pragma once

/// Renderer: headless rendering of meshes and people for cameras. Independent
/// of worlds: shapes are added once; every draw() gets instances and views.
///
/// In: shapes, instances and figures in W, lamps, sun, sky, fog; views.
/// Out: pictures: colour, depth along the optical axis, or segment numbers of instances.
/// Cost: per view, its visible instances as one draw call per surface;
///   colour pictures draw shadow casters a second time, and all of it again for each flat mirror
///   that they show, kMostMirrors at most (mirrors.h). One read-back per page.
/// Source: shadow maps after Williams, 1978, with percentage-closer filtering after Reeves et al., 1987;
///   others in
///   shaders.h and view.h.
/// Thread: any, one at a time.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/render/humanoid.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

using Rgb = std::array<float, 3>;  // linear

/// sRGB component to linear, both from 0 to 1.
float linear(float srgb);

/// Environment of all bodies. The floor is the plane z = 0.
struct Environment {
  geom::Vec3 to_sun = {0, 0, 1};  // unit
  float sun = 0.72f;              // radiance of a white face towards the sun
  float ambient = 0.42f;          // ambient light, in the same unit
  float white_lux = 20;           // illuminance by lamps that makes a white face as bright as 1
  Rgb sky = {0.35f, 0.55f, 0.81f}, floor = {0.69f, 0.69f, 0.65f};
  Rgb fog = {0.6f, 0.63f, 0.66f};
  double visibility = 0;  // m, where fog reduces contrast to 5 %; 0: no fog
  double seconds = 0;     // time for drifting smoke
};

struct Instance {
  std::uint32_t shape = 0;
  geom::Vec3 p;  // m, in W
  geom::Quaternion q;
  std::array<float, 4> tint = {1, 1, 1, 1};  // factor on the shape's colours; alpha below 1: transparent
  std::uint32_t segment = 0;                 // its number in segmentation pictures
  std::uint32_t group = kNoGroup;            // see View::hides
  float glow = 0;                            // factor on its colours, emitted
};

/// A point or spot light, without shadows. Each view uses
/// the kMostLamps of a scene that are brightest at its eye.
struct Lamp {
  geom::Vec3 p;                  // m, in W
  Rgb light = {1, 1, 1};         // cd, along `way`
  geom::Vec3 way = {0, 0, -1};   // unit, in W
  float inner = -1, outer = -1;  // spot: cosines of the cone angles of full and of no
                                 // light; -1: a point light
};
inline constexpr std::size_t kMostLamps = 16;

/// A person.
struct Figure {
  geom::Vec3 p;          // m, in W, of its feet
  double heading = 0;    // rad
  double height = 1.75;  // m
  Gait gait;
  std::array<float, 3> clothes = {1, 1, 1};  // linear
  std::uint32_t segment = 0, group = kNoGroup;
};

/// A box of smoke, drawn in colour pictures only.
struct Smoke {
  geom::Vec3 p;  // m, centre in W
  geom::Quaternion q;
  geom::Vec3 half;                              // m
  std::array<float, 4> tint = {1, 1, 1, 0.8f};  // a: maximum opacity
  std::uint32_t group = kNoGroup;
};

struct Scene {
  std::span<const Instance> instances = {};
  std::span<const Figure> figures = {};
  std::span<const Smoke> smokes = {};
  std::span<const Lamp> lamps = {};
};

/// Pixels in rows from the top.
struct Picture {
  std::vector<std::uint32_t> sample;  // 0xRRGGBB, or segment numbers; 0: none
  std::vector<double> depth;  // m along the optical axis, for pictures of depth only; 0: the ray hit nothing
};

class Renderer {
 public:
  /// Fails with a one-line reason without OpenGL 4.5.
  static Result<std::unique_ptr<Renderer>> make();
  ~Renderer();

  /// Name of the renderer.
  const std::string& name() const;
  /// Returns the shape's number, for instances. Empty surfaces are
  /// skipped; textures larger than the GPU supports are ignored.
  std::uint32_t add_shape(const mesh::Mesh& mesh);
  /// Renders all views. Buffers of `pictures` are reused.
  void draw(const Environment& surroundings, const Scene& scene, std::span<const View> views,
            std::vector<Picture>& pictures);

 private:
  class Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::render
