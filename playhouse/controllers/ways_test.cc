#include "playhouse/controllers/ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "playhouse/scene/world_loader.h"

namespace playhouse::controllers {
namespace {

/// A wall 8 m long between the left and the right, with a way round at its upper end.
constexpr const char* kWall = R"(
  model( name "wall" pose [0 -1 0 0] size [0.2 8 1] )
  model( name "paint" pose [-2 0 0 0] size [1 1 0.01] obstacle_return 0 ranger_return -1 )
  model( name "bridge" pose [-2 2 0.5 0] size [1 1 1] )
)";

struct Floor {
  explicit Floor(const std::string& text) {
    config::MemoryFiles none({});
    auto loaded = scene::load_world_text(text, "test.world", none);
    EXPECT_TRUE(loaded) << loaded.error().line();
    scene = std::move(*loaded);
    world.emplace(scene, 1);
  }
  scene::SceneDesc scene;
  std::optional<world::World> world;
};

/// Follows the way in steps of 0.1 m. The places on it, or none if it does not end within the reach.
std::vector<geom::Vec2> walk(const Ways& ways, geom::Vec2 from, geom::Vec2 to, double reach) {
  std::vector<geom::Vec2> places{from};
  for (int step = 0; step < 1000; ++step) {
    const geom::Vec2 at = places.back(), left = to - at;
    if (geom::dot(left, left) < reach * reach) return places;
    const std::optional<geom::Vec2> next = ways.next(at);
    if (!next) return {};
    const geom::Vec2 way = *next - at;
    places.push_back(at + std::min(1.0, 0.1 / std::sqrt(geom::dot(way, way))) * way);
  }
  return {};
}

TEST(Ways, lead_round_what_stands_in_between_and_keep_off_it) {
  const Floor floor(kWall);
  const geom::Vec2 place{4, -2};
  const Ways ways(*floor.world, place, 1, 0.3, 0.22);
  const std::vector<geom::Vec2> places = walk(ways, {-4, -2}, place, 1);
  ASSERT_FALSE(places.empty());
  for (const geom::Vec2 p : places) {
    EXPECT_FALSE(std::fabs(p.x) < 0.25 && p.y < 3.1 && p.y > -5.1) << p.x << ", " << p.y;
  }
}

TEST(Ways, that_others_take_the_other_way_are_left_to_them_where_there_is_another) {
  const Floor floor(R"(
    model( name "pillar" pose [0 0 0 0] size [4 4 1] )
    model( name "north" pose [0 6 0 0] size [16 0.2 1] )
    model( name "south" pose [0 -6 0 0] size [16 0.2 1] )
  )");
  const geom::Vec2 west{-6, 0.5}, east{6, 0.5};
  const Ways there(*floor.world, east, 0.5, 0.3, 0.22);
  const auto middle = [](const std::vector<geom::Vec2>& route) {
    return std::ranges::min(route, {}, [](geom::Vec2 p) { return std::fabs(p.x); }).y;
  };
  const std::vector<geom::Vec2> route = there.route(west);
  ASSERT_FALSE(route.empty());
  EXPECT_GT(middle(route), 2) << "the shorter one";
  EXPECT_GT(middle(Ways(*floor.world, west, 0.5, 0.3, 0.22).route(east)), 2);
  EXPECT_LT(middle(Ways(*floor.world, west, 0.5, 0.3, 0.22, route).route(east)), -2);
}

TEST(Ways, lead_nowhere_from_a_room_without_a_door) {
  const Floor floor(R"(
    model( pose [0 2 0 0] size [4.2 0.2 1] ) model( pose [0 -2 0 0] size [4.2 0.2 1] )
    model( pose [2 0 0 0] size [0.2 4.2 1] ) model( pose [-2 0 0 0] size [0.2 4.2 1] )
  )");
  const Ways ways(*floor.world, {6, 0}, 0.5, 0.3, 0.22);
  EXPECT_FALSE(ways.next({0, 0}).has_value());
  EXPECT_TRUE(ways.route({0, 0}).empty());
  EXPECT_TRUE(ways.next({-6, 0}).has_value());
}

TEST(Ways, of_any_place_are_answered) {
  const Floor floor(kWall);
  const Ways ways(*floor.world, {4, -2}, 1, 0.3, 0.22);
  for (const double far : {1e9, -1e9}) EXPECT_FALSE(ways.next({far, far}) && ways.next({far, far})->x > 100);
}

}  // namespace
}  // namespace playhouse::controllers
