#pragma once

/// Renderer: pictures of meshes and people as cameras take them, without a screen. It knows nothing of
/// worlds: shapes are added once, and every call of draw() says what is where and who looks.
///
/// In: shapes, instances and figures in W, lamps, a sun, a sky, fog; views.
/// Out: pictures: colours, distances along the way that a view looks, numbers that instances have.
/// Cost: for each view, its visible instances as one draw for each kind of surface; pictures of colours draw
/// what
///   throws shadows once more. One read of each page of pictures.
/// Source: shadow maps after Williams, 1978, with percentage-closer filtering after Reeves et al., 1987; the
/// rest in
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

/// Light from what a screen is told, both from 0 to 1.
float linear(float srgb);

/// What is about all bodies. The floor is the plane z = 0.
struct Surroundings {
  geom::Vec3 to_sun = {0, 0, 1};  // unit
  float sun = 0.72f;              // light of the sun; a white face towards it is so bright
  float ambient = 0.42f;          // and by the light from everywhere
  float white_lux = 20;           // of lamps that make a white face as bright as 1
  Rgb sky = {0.35f, 0.55f, 0.81f}, floor = {0.69f, 0.69f, 0.65f};
  Rgb fog = {0.6f, 0.63f, 0.66f};
  double visibility = 0;  // m, at which fog leaves 5 % of a contrast; 0: there is no fog
  double seconds = 0;     // by which smoke drifts
};

struct Instance {
  std::uint32_t shape = 0;
  geom::Vec3 p;  // m, in W
  geom::Quaternion q;
  std::array<float, 4> tint = {1, 1, 1, 1};  // times the colours of its shape; below 1 one sees through it
  std::uint32_t segment = 0;                 // what pictures of segments have there
  std::uint32_t group = kNoGroup;            // see View::hides
  float glow = 0;                            // light that it gives off itself, times its colours
};

/// What shines from a point, without shadows. Of those of a scene each view has the kMostLamps that are
/// brightest where its eye is.
struct Lamp {
  geom::Vec3 p;                  // m, in W
  Rgb light = {1, 1, 1};         // cd, along `way`
  geom::Vec3 way = {0, 0, -1};   // unit, in W
  float inner = -1, outer = -1;  // cosines of the angles from `way` up to which a spot shines fully, and at
                                 // all; -1: every way
};
inline constexpr std::size_t kMostLamps = 16;

/// A person.
struct Figure {
  geom::Vec3 p;          // m, in W, of the ground under it
  double heading = 0;    // rad
  double height = 1.75;  // m
  Gait gait;
  std::array<float, 3> clothes = {1, 1, 1};  // linear
  std::uint32_t segment = 0, group = kNoGroup;
};

/// A cloud in a box, which pictures of colours alone show.
struct Smoke {
  geom::Vec3 p;  // m, its middle in W
  geom::Quaternion q;
  geom::Vec3 half;                              // m
  std::array<float, 4> tint = {1, 1, 1, 0.8f};  // a: how much it hides at most
  std::uint32_t group = kNoGroup;
};

struct Scene {
  std::span<const Instance> instances = {};
  std::span<const Figure> figures = {};
  std::span<const Smoke> smokes = {};
  std::span<const Lamp> lamps = {};
};

/// Pixels row by row from the top.
struct Picture {
  std::vector<std::uint32_t> sample;  // 0xRRGGBB, or segments; 0: none
  std::vector<double> depth;  // m along the way the view looks, of pictures of depth alone; 0: nothing
};

class Renderer {
 public:
  /// Fails with one line where there is no OpenGL 4.5.
  static Result<std::unique_ptr<Renderer>> make();
  ~Renderer();

  /// Who renders.
  const std::string& name() const;
  /// Its number, for instances. Surfaces without corners are left out; images larger than the card takes are
  /// not shown.
  std::uint32_t add_shape(const mesh::Mesh& mesh);
  /// The pictures of views, which keep their memory from call to call.
  void draw(const Surroundings& surroundings, const Scene& scene, std::span<const View> views,
            std::vector<Picture>& pictures);

 private:
  class Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::render
