#include "playhouse/bridge/simulated/joining.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <tuple>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/simulated/auto_devices.h"
#include "playhouse/bridge/simulated/joined_robots.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/wire/codec.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using testing::MemorySite;

constexpr const char* kLab = R"(
interval_sim 100
robot_types [ "cart" "scanner" "cube" ]
define scanner ranger( size [0.1 0.1 0.1] pose [0.1 0 0 0] sensor( samples 3 fov 180 ) )
define cart position( size [0.4 0.4 0.2] origin [0 0 0 0] )
define cube model( size [1 1 1] )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] )
position( name "own" pose [0 -3 0 0] size [0.4 0.4 0.2] color "green" )
)";

std::string wire_value(double x, double y, const std::vector<std::string>& texts) {
  const double place[3] = {x, y, 1.5};
  std::string value(sizeof place, '\0');
  std::memcpy(value.data(), place, sizeof place);
  for (const std::string& text : texts) value.append(text).push_back('\0');
  return value;
}

RobotRequest request(const std::string& type, double x, double y,
                     const std::vector<std::string>& texts = {}) {
  const Result<RobotRequest> parsed = parse_join_request(type, wire_value(x, y, texts));
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().text);
  return parsed ? *parsed : RobotRequest{};
}

class Joining : public ::testing::Test {
 protected:
  explicit Joining(const std::string& world = kLab) : site(world) {
    EXPECT_TRUE(site.site().open_world("lab.world"));
    robots = std::make_unique<AutoDevices>(site.site(), 6665);
    EXPECT_TRUE(robots->add_all());
  }
  run::Simulation& simulation() { return *simulation_of(site.site()); }
  const world::World& world() { return simulation().world(); }
  /// The name of what came, or why nothing did.
  std::string come(const RobotRequest& wanted) {
    std::string told;
    EXPECT_TRUE(simulation().requests().post([&](world::Journal& journal) {
      const std::size_t before = journal.world().models.size();
      const Result<Joined> joined = join(journal, wanted);
      told = joined ? joined->name : joined.error().text;
      if (joined) last = *joined;
      if (!joined) EXPECT_EQ(journal.world().models.size(), before) << "all of it, or nothing";
    }));
    site.run(1);
    return told;
  }
  std::string devices(const std::string& model) {
    return devices_below(world(), model_devices_of(site.site())->directory(), world().find(model), 6665);
  }

  MemorySite site;
  std::unique_ptr<AutoDevices> robots;
  Joined last;
};

TEST_F(Joining, nobody_comes_far_from_everything) {
  EXPECT_EQ(come(request("cart", 900e3, -2)),
            "900000.00 -2.00 is more than 1000 m from everything in the world");
  EXPECT_EQ(come(request("cart", 900, 0)), "cart");
}

/// Beside a long wall the nearest place of a square is straight across: half of both thicknesses away.
TEST_F(Joining, the_nearest_free_place_is_beside_what_is_in_the_way) {
  const std::uint32_t cart = world().scene().robot_types.at("cart");
  const geom::Pose free{0.7, 0.3, 0, 1};
  EXPECT_EQ(*free_place(world(), cart, free), free);
  for (const double x : {2.75, 2.9, 2.95, 3.05, 3.2}) {
    const Result<geom::Pose> place = free_place(world(), cart, {x, 1, 0, 0});
    ASSERT_TRUE(place) << x;
    const double least = 0.3 - std::fabs(x - 3), away = std::hypot(place->x - x, place->y - 1);
    EXPECT_EQ(place->x > 3, x > 3) << "the nearer side";
    EXPECT_GE(std::fabs(place->x - 3), 0.3) << x;
    EXPECT_GE(away, least) << x;
    EXPECT_LE(away, least + 0.05 + 1e-6) << x;
    EXPECT_TRUE(is_free(world(), cart, *place));
  }
  EXPECT_EQ(free_place(world(), cart, {-900e3, 0, 0, 0}).error().text,
            "-900000.00 0.00 is more than 1000 m from everything in the world");
}

class JoiningWhatIsFarFromItsOrigin : public Joining {
 protected:
  JoiningWhatIsFarFromItsOrigin()
      : Joining(
            "robot_types [ \"cart\" ] define cart position( size [0.4 0.4 0.2] origin [0 0 0 0] ) "
            "model( name \"ring\" pose [10 0 0 90] origin [50 0 0 0] size [1 2 1] ) "
            "model( name \"low\" pose [-5 0 0 0] origin [0 0 0 0] size [1 1 0.1] )") {}
};

/// The ring's body is at 10 50, turned, so 2 x 1; a cart beside it needs 1.2 and 0.7.
TEST_F(JoiningWhatIsFarFromItsOrigin, finds_the_body) {
  const std::uint32_t cart = world().scene().robot_types.at("cart");
  for (const auto& [dx, dy, free] :
       {std::tuple(0.0, 0.0, false), std::tuple(1.19, 0.0, false), std::tuple(1.21, 0.0, true),
        std::tuple(-1.19, 0.0, false), std::tuple(0.0, 0.69, false), std::tuple(0.0, 0.71, true),
        std::tuple(0.0, -0.69, false), std::tuple(0.0, -50.0, true)})
    EXPECT_EQ(is_free(world(), cart, {10 + dx, 50 + dy, 0, 0}), free) << dx << " " << dy;
  EXPECT_FALSE(is_free(world(), cart, {-5.69, 0, 0, 0}));
  EXPECT_TRUE(is_free(world(), cart, {-5.71, 0, 0, 0}));
}

class JoiningASolidWorld : public Joining {
 protected:
  JoiningASolidWorld()
      : Joining(
            "robot_types [ \"cart\" ] define cart position( size [0.4 0.4 0.2] ) "
            "model( name \"rock\" size [4.2 4.2 1] )") {}
};

TEST_F(JoiningASolidWorld, refuses_who_has_no_place) {
  const std::uint32_t cart = world().scene().robot_types.at("cart");
  EXPECT_EQ(free_place(world(), cart, {0, 0, 0, 0}).error().text,
            "there is no free place within 2 m of 0.00 0.00");
  EXPECT_TRUE(free_place(world(), cart, {0.5, 0, 0, 0})) << "1.8 m away";
}

TEST_F(Joining, types_stand_nowhere_until_a_robot_of_them_joins) {
  EXPECT_EQ(world().models.size(), 2u);
  EXPECT_EQ(come(request("cart", 0, 0)), "cart");
  EXPECT_EQ(come(request("cart", 1, 0)), "cart~2");
  EXPECT_EQ(come(request("cart", 2, 0, {"bob", "red"})), "bob");
  EXPECT_EQ(world().models.size(), 5u);
  EXPECT_EQ(world().models.color[world().find("bob")], *scene::color_by_name("red"));
  EXPECT_DOUBLE_EQ(world().models.X_WM[world().find("bob")].a, 1.5);
}

/// The first cart of the world has a scanner of its own.
class JoiningBesideOthers : public Joining {
 protected:
  JoiningBesideOthers() : Joining(std::string(kLab) + "cart( name \"r0\" pose [0 3 0 0] scanner( ) )\n") {}
};

TEST_F(JoiningBesideOthers, a_type_is_its_define_without_what_a_robot_of_the_world_adds) {
  EXPECT_EQ(come(request("cart", 0, 0, {"bob"})), "bob");
  EXPECT_EQ(devices("bob"), "position2d:2 position3d:2 speech:2 speech_recognition:2");
}

TEST_F(Joining, sensors_are_parts_of_the_robot_and_of_its_devices) {
  EXPECT_EQ(come(request("cart", 0, 0, {"bob", "", "scanner", "scanner 0.2 0 3"})), "bob");
  EXPECT_EQ(devices("bob"),
            "position2d:1 position3d:1 speech:1 speech_recognition:1 ranger:0 laser:1 ranger:1 laser:2");
  const world::ModelRow first = world().find("bob-scanner"), second = world().find("bob-scanner~2");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(world().models.X_PM[first].x, 0.1);
  EXPECT_EQ(world().models.X_PM[first].z, 0.2);
  EXPECT_EQ(world().models.X_PM[second].x, 0.2);
  EXPECT_EQ(world().models.X_PM[second].a, 3);
  EXPECT_EQ(model_devices_of(site.site())->directory().size(), 12u) << "each device once";
}

TEST_F(Joining, a_model_that_is_there_can_be_the_type) {
  EXPECT_EQ(come(request("own", 0, 0)), "own~2");
  EXPECT_EQ(world().models.color[world().find("own~2")], *scene::color_by_name("green"));
}

TEST_F(Joining, what_cannot_be_is_told_and_nothing_comes) {
  EXPECT_EQ(come(request("carrt", 0, 0)),
            "the world has no type of robot \"carrt\" (did you mean \"cart\"?)");
  EXPECT_EQ(come(request("lamp", 0, 0)), "the world has no type of robot \"lamp\"; there are cart, own");
  EXPECT_EQ(come(request("scanner", 0, 0)), "\"scanner\" is not a robot: it is a ranger");
  EXPECT_EQ(come(request("cart", 0, 0, {"", "", "cart"})), "\"cart\" is not a sensor: it is a position");
  EXPECT_EQ(come(request("cart", 0, 0, {"", "", "scaner"})),
            "the world has no type of sensor \"scaner\" (did you mean \"scanner\"?)");
  EXPECT_EQ(come(request("cart", 0, 0, {"own"})), "there is a model \"own\" already");
  EXPECT_EQ(come(request("cart", 0, 0, {"", "rred"})), "there is no color \"rred\" (did you mean \"red\"?)");
  EXPECT_EQ(come(request("cart", 0.1, -3.1)), "the place at 0.10 -3.10 is occupied");
  EXPECT_EQ(come(request("cart", 2.8, 4)), "the place at 2.80 4.00 is occupied");
}

TEST(JoinRequests, are_read_with_care) {
  const auto fault = [](const std::string& value) {
    const Result<RobotRequest> read = parse_join_request("cart", value);
    return read ? "" : read.error().text;
  };
  EXPECT_EQ(fault("short"), "x, y and heading are needed, as three float64");
  EXPECT_EQ(fault(wire_value(1e300, 0, {})), "invalid pose: not finite, or too far away");
  EXPECT_EQ(fault(wire_value(0, 0, {"two\nlines"})), "invalid name: a line of up to 1024 bytes is valid");
  EXPECT_EQ(fault(wire_value(0, 0, {"", "", "scanner 1 2"})),
            "\"scanner 1 2\": a sensor is a type, or a type with x, y and heading");
  EXPECT_EQ(fault(wire_value(0, 0, {"", "", ""})),
            "\"\": a sensor is a type, or a type with x, y and heading");
  EXPECT_EQ(fault(wire_value(0, 0, std::vector<std::string>(80, "scanner"))),
            "a robot brings 64 sensors at most");
}

TEST_F(Joining, leaving_takes_the_sensors_along_and_nothing_else) {
  come(request("cart", 0, 0, {"bob", "", "scanner"}));
  const Joined bob = last;
  come(request("cart", 1, 0, {"eve", "", "scanner"}));
  ASSERT_TRUE(
      simulation().requests().post([&](world::Journal& journal) { leave(journal, std::span(&bob, 1)); }));
  site.run(1);
  EXPECT_FALSE(world().find("bob"));
  EXPECT_FALSE(world().find("bob-scanner"));
  EXPECT_TRUE(world().find("eve-scanner"));
  ASSERT_TRUE(
      simulation().requests().post([&](world::Journal& journal) { leave(journal, std::span(&bob, 1)); }));
  site.run(1);
  EXPECT_EQ(world().models.size(), 4u);
}

wire::simulation::PropertyReq property(const std::string& type, std::string value) {
  return {wire::c_string(type), wire::c_string("robot"), 0, std::move(value)};
}

TEST_F(Joining, robots_leave_with_the_client_that_brought_them) {
  JoinedRobots joined(simulation());
  testing::OutputRecorder answers;
  {
    device::Caller student("10.0.0.1:1"), other("10.0.0.2:1");
    int expected = 0;
    student.expect_alive_by([&] { ++expected; });
    joined.join(property("cart", wire_value(0, 0, {"bob", "", "scanner"})), &student, {answers, 1});
    joined.join(property("cart", wire_value(1, 0, {"ann"})), &student, {answers, 2});
    joined.join(property("cart", wire_value(2, 0, {"eve"})), &other, {answers, 3});
    EXPECT_EQ(expected, 1);
    site.run(1);
    for (const std::uint64_t ticket : {1, 2, 3}) EXPECT_TRUE(answers.answers[ticket].ack);
    joined.join(property("cart", wire_value(-1, 0, {"late"})), &student, {answers, 4});
    student.leave();  // before the last one has come
    site.run(1);
    EXPECT_FALSE(world().find("bob"));
    EXPECT_FALSE(world().find("bob-scanner"));
    EXPECT_FALSE(world().find("ann"));
    EXPECT_FALSE(world().find("late"));
    EXPECT_TRUE(world().find("eve"));
  }
  site.run(1);
  EXPECT_FALSE(world().find("eve"));
}

TEST_F(Joining, the_sensors_of_a_robot_go_with_it_whoever_takes_it_out) {
  JoinedRobots joined(simulation());
  testing::OutputRecorder answers;
  device::Caller student("10.0.0.1:1");
  joined.join(property("cart", wire_value(0, 0, {"bob", "", "scanner", "scanner 0.2 0 3"})), &student,
              {answers, 1});
  joined.join(property("cart", wire_value(1, 0, {"eve", "", "scanner"})), &student, {answers, 2});
  site.run(1);
  ASSERT_TRUE(world().find("bob-scanner~2"));
  const world::ModelId bob = world().id(world().find("bob"));
  ASSERT_TRUE(
      simulation().requests().post([bob](world::Journal& journal) { ASSERT_TRUE(journal.despawn(bob)); }));
  site.run(2);
  for (const char* const name : {"bob", "bob-scanner", "bob-scanner~2"}) EXPECT_FALSE(world().find(name));
  EXPECT_TRUE(world().find("eve-scanner"));
}

TEST_F(Joining, robots_and_their_sensors_are_of_the_share_of_the_client) {
  JoinedRobots joined(simulation());
  testing::OutputRecorder answers;
  device::Caller student("10.0.0.1:1"), same("10.0.0.1:2"), other("10.0.0.2:1");
  for (device::Caller* each : {&student, &same}) each->set_holder("blue-chair-7");
  // As if it had brought what is here already so often that two models are left of its share.
  for (std::size_t k = 2; k < limits::kBroughtByOneModels; ++k)
    simulation().shares()->add(world(), "blue-chair-7", world().id(world().find("own")));
  joined.join(property("cart", wire_value(0, 0, {"bob", "", "scanner"})), &student, {answers, 1});
  joined.join(property("cart", wire_value(1, 0, {"ann"})), &same, {answers, 2});
  joined.join(property("cart", wire_value(2, 0, {"eve"})), &other, {answers, 3});
  site.run(1);
  EXPECT_TRUE(answers.answers[1].ack);
  EXPECT_FALSE(answers.answers[2].ack);
  EXPECT_EQ(wire::text(wire::decode<wire::simulation::PropertyReq>(answers.answers[2].body)->value),
            "your share of the run is full: you brought 4096 models with 1 sensors and 3 beams");
  EXPECT_TRUE(answers.answers[3].ack);
  student.leave();
  site.run(1);
  joined.join(property("cart", wire_value(1, 0, {"ann"})), &same, {answers, 4});
  site.run(1);
  EXPECT_TRUE(answers.answers[4].ack) << "what went is not counted";
}

TEST_F(Joining, who_is_no_client_and_who_asks_for_what_is_not_gets_a_reason) {
  JoinedRobots joined(simulation());
  testing::OutputRecorder answers;
  const auto reason = [&](std::uint64_t ticket) {
    EXPECT_FALSE(answers.answers[ticket].ack);
    const auto body = wire::decode<wire::simulation::PropertyReq>(answers.answers[ticket].body);
    return body ? std::string(wire::text(body->value)) : body.error().text;
  };
  device::Caller student("10.0.0.1:1");
  joined.join(property("cart", wire_value(0, 0, {})), nullptr, {answers, 1});
  joined.join(property("cart", "x"), &student, {answers, 2});
  joined.join(property("crt", wire_value(0, 0, {})), &student, {answers, 3});
  site.run(1);
  EXPECT_EQ(reason(1), "clients alone bring robots");
  EXPECT_EQ(reason(2), "x, y and heading are needed, as three float64");
  EXPECT_EQ(reason(3), "the world has no type of robot \"crt\" (did you mean \"cart\"?)");
}

}  // namespace
}  // namespace playhouse::drivers
