/// Cameras of 320 x 240 pixels in a hall with 40 crates, a wall, which may be a mirror, and two people:
/// colours and depths of each, all of a tick at once. Says how many pairs of pictures a second.

#include <benchmark/benchmark.h>

#include "playhouse/render/renderer.h"
#include "playhouse/render/testing_meshes.h"

namespace playhouse::render {
namespace {

struct Hall {
  std::vector<Instance> instances;
  std::vector<Figure> figures;
};

struct Contents {
  bool people = false, mirror = false;  // as the wall
};

Hall hall(Renderer& renderer, Contents contents) {
  Hall made;
  const std::uint32_t crate = renderer.add_shape(testing::box({0.3, 0.3, 0.3}));
  mesh::Mesh of_wall = testing::box({0.1, 10, 1.2});
  if (contents.mirror) of_wall.materials[0] = {.metallic = 0.9f, .roughness = 0.05f};
  const std::uint32_t wall = renderer.add_shape(of_wall);
  for (int k = 0; k < 41; ++k) {
    Instance& instance = made.instances.emplace_back();
    instance.shape = k < 40 ? crate : wall;
    instance.p = k < 40 ? geom::Vec3{2 + 0.35 * k, 3.0 * (k % 5) - 6, 0.3} : geom::Vec3{12, 0, 1.2};
    instance.q = geom::orientation(0.7 * k, {});
    instance.tint = {0.1f * static_cast<float>(k % 9), 0.4f, 0.3f, 1};
    instance.segment = static_cast<std::uint32_t>(k + 1);
  }
  if (!contents.people) return made;
  for (const double x : {2.5, 5.0}) {
    Figure& figure = made.figures.emplace_back();
    figure.p = {x, 0.4 * x - 1.5, 0};
    figure.gait = {x, 0.7};
  }
  return made;
}

View view(Shows shows, int number) {
  View view;
  view.shows = shows;
  view.eye = {0, 0.2 * number, 0.6};
  view.q_WC = geom::orientation(0.1 * number, {0, 0.05});
  view.half_width = 0.7;
  view.half_height = 0.525;
  view.far = 20;
  view.width = 320;
  view.height = 240;
  return view;
}

void cameras(benchmark::State& state, Contents contents) {
  Result<std::unique_ptr<Renderer>> renderer = Renderer::make();
  if (!renderer) return state.SkipWithError(renderer.error().line().c_str());
  state.SetLabel((*renderer)->name());
  const Hall made = hall(**renderer, contents);
  std::vector<View> views;
  for (int k = 0; k < state.range(0); ++k)
    for (const Shows shows : {Shows::kColor, Shows::kDepth}) views.push_back(view(shows, k));
  Environment around;
  around.to_sun = {-0.4, -0.5, 0.768};
  std::vector<Picture> pictures;
  for (auto _ : state) (*renderer)->draw(around, {made.instances, made.figures, {}}, views, pictures);
  state.counters["img/s"] = benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                                               benchmark::Counter::kIsRate);
}

void color_and_depth(benchmark::State& state) {
  cameras(state, {});
}
void color_and_depth_with_people(benchmark::State& state) {
  cameras(state, {.people = true});
}
void color_and_depth_with_a_mirror(benchmark::State& state) {
  cameras(state, {.mirror = true});
}

BENCHMARK(color_and_depth)->Arg(1)->Arg(3)->Arg(8)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(color_and_depth_with_people)->Arg(1)->Arg(3)->Arg(8)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(color_and_depth_with_a_mirror)->Arg(1)->Arg(3)->Arg(8)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace playhouse::render
