// Robots by name, from a server of a few lines that lists its models.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "fake_server.h"
extern "C" {
#include "models.h"
}

namespace playhouse_c {
namespace {

using ::testing::ElementsAre;

const std::vector<std::string> kHouse = {
    "0\tr0\tposition\t\tPORT:position2d:0",
    "1\tr0.ranger:0\tranger\tr0\tPORT:ranger:0 PORT:sonar:0",
    "2\twall\tmodel\t\t",
    "3\tguest\tposition\t\tPORT:position2d:12",
    "4\tguest.ranger:0\tranger\tguest\tPORT:ranger:20 PORT:laser:12",
    "5\tguest.arm\tmodel\tguest\t",
    "6\tguest.arm.eye\tfiducial\tguest.arm\tPORT:fiducial:3",
    "7\tguest.ranger:1\tranger\tguest\tPORT:ranger:21 PORT:laser:30",
    "8\tnext\tposition\t\t9999:position2d:0",
};

/// Lines with the port of the server in place of PORT.
std::string lines(const std::vector<std::string> &of, std::size_t from, std::size_t to, int port) {
  std::string text;
  for (std::size_t i = from; i < to && i < of.size(); ++i) {
    std::string line = of[i];
    for (std::size_t at; (at = line.find("PORT")) != std::string::npos;)
      line.replace(at, 4, std::to_string(port));
    text += line + "\n";
  }
  return text;
}

void answer_page(Peer &peer, const Received &message, std::uint32_t following, const std::string &page) {
  const ph_simulation_property_req told = {
      "", 1, "models", 7, following, page.data(), static_cast<std::uint32_t>(page.size())};
  peer.answer(message, body(ph_simulation_property_req_type, told));
}

std::uint32_t asked_index(const Received &message) {
  ph_simulation_property_req asked{};
  ph_arena arena = {nullptr};
  EXPECT_EQ(
      ph_simulation_property_req_decode(&asked, message.body.data(), message.body.size(), &arena, nullptr),
      PH_OK);
  EXPECT_STREQ(asked.prop, "models");
  ph_arena_free(&arena);
  return asked.index;
}

/// All of kHouse, three models at a time.
bool house(Peer &peer, const Received &message) {
  if (message.header.interface_code != PH_SIMULATION_CODE) {
    peer.answer(message, {}, PH_KIND_NACK);
    return true;
  }
  const std::uint32_t index = asked_index(message);
  answer_page(peer, message, index + 3 < kHouse.size() ? index + 3 : 0,
              lines(kHouse, index, index + 3, peer.port()));
  return true;
}

ph_robot *robot_of(const Client &client, const char *name) {
  ph_error error = {PH_OK, ""};
  ph_robot *robot = ph_client_robot(client.get(), name, &error);
  EXPECT_NE(robot, nullptr) << error.text;
  return robot;
}

std::vector<std::string> devices_of(const ph_robot *robot) {
  std::size_t count = 0;
  const ph_address *devices = ph_robot_devices(robot, &count);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.emplace_back(devices[i].name);
  return names;
}

// --- lines

class Lines : public ::testing::Test {
 protected:
  ~Lines() override { ph_models_free(&models_); }
  ph_status parse(std::string text, ph_error *error) { return ph_models_parse(&models_, text.data(), error); }
  ph_models models_ = {};
};

TEST_F(Lines, ALineIsAModelWithItsDevices) {
  EXPECT_WORKS(parse("4\ta\\tb\\\\n\\n\tranger\tr 0\t6665:ranger:1 1:laser:2\n", &error));
  ASSERT_EQ(models_.count, 1U);
  const ph_model &model = models_.items[0];
  EXPECT_STREQ(model.name, "a\tb\\n\n");
  EXPECT_STREQ(model.type, "ranger");
  EXPECT_STREQ(model.parent, "r 0");
  EXPECT_EQ(model.id, 4U);
  ASSERT_EQ(model.device_count, 2U);
  EXPECT_EQ(model.devices[0].port, 6665);
  EXPECT_STREQ(model.devices[1].name, "laser:2");
  EXPECT_STREQ(model.devices[1].interface_name, "laser");
  EXPECT_EQ(model.devices[1].index, 2);
  EXPECT_STREQ(model.devices[1].model, model.name);
}

TEST_F(Lines, LinesThatMakeNoSenseAreAnError) {
  for (const char *line : {"x\n", "x\ta\tb\tc\t\n", "0\ta\tb\tc\td\te\n", "0\ta\tb\tc\tlaser:0\n",
                           "0\ta\tb\tc\t1:laser:\n", "0\ta\tb\tc\t65536:laser:0\n", "0\ta\tb\tc\t:\n",
                           "99999999999999999999\ta\tb\tc\t\n", "\ta\tb\tc\t\n"}) {
    EXPECT_FAILS(parse(line, &error), PH_WIRE_ERROR, "list of models");
  }
}

TEST_F(Lines, WhatAModelCarriesIsFoundAtAnyDepth) {
  EXPECT_WORKS(parse(lines(kHouse, 0, 8, 1), &error));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < models_.count; ++i) {
    if (ph_models_within(&models_, i, 3)) names.emplace_back(models_.items[i].name);
  }
  EXPECT_THAT(names, ElementsAre("guest", "guest.ranger:0", "guest.arm", "guest.arm.eye", "guest.ranger:1"));
}

TEST_F(Lines, NamesAreFoundAmongManyAndOfEqualOnesTheLast) {
  std::string text;
  for (int i = 0; i < 5000; ++i) {
    const std::string name = "r" + std::to_string(i % 2500);
    text += std::to_string(i) + "\t" + name + "\tposition\t" +
            (i % 2 == 1 ? "r" + std::to_string(i % 2500 - 1) : "") + "\t\n";
  }
  EXPECT_WORKS(parse(text, &error));
  ASSERT_EQ(models_.count, 5000U);
  for (std::size_t i = 0; i < 2500; ++i) {
    ASSERT_EQ(ph_models_find(&models_, ("r" + std::to_string(i)).c_str()), 2500 + i);
  }
  EXPECT_EQ(ph_models_find(&models_, "r2500"), 5000U);
  EXPECT_EQ(models_.parents[4999], 4998U);
  EXPECT_EQ(models_.parents[1], 0U);
  EXPECT_EQ(models_.parents[4998], 4998U) << "a top-level model";
}

// --- robots

TEST(Robots, ARobotHasTheDevicesOfAllItCarries) {
  FakeServer server(script(house));
  const Client client = connected(server.address());
  ph_robot *guest = robot_of(client, "guest");
  EXPECT_THAT(devices_of(guest),
              ElementsAre("position2d:12", "ranger:20", "laser:12", "fiducial:3", "ranger:21", "laser:30"));
  EXPECT_STREQ(ph_robot_name(guest), "guest");
  EXPECT_STREQ(ph_robot_type(guest), "position");
  ph_laser *laser = ph_robot_laser(guest, 0, nullptr);
  ASSERT_NE(laser, nullptr);
  EXPECT_STREQ(ph_device_name(ph_laser_device(laser)), "laser:12");
  EXPECT_EQ(ph_robot_laser(guest, 0, nullptr), laser) << "opened once";
  ph_ranger *second = ph_robot_ranger(guest, 1, nullptr);
  ASSERT_NE(second, nullptr);
  EXPECT_STREQ(ph_device_name(ph_ranger_device(second)), "ranger:21");
  EXPECT_EQ(ph_robot_count(guest, "ranger"), 2U);
  EXPECT_EQ(ph_robot_count(guest, "sonar"), 0U);
}

TEST(Robots, TheyAreTheModelsAtTheTopWithDevicesHere) {
  FakeServer server(script(house));
  const Client client = connected(server.address());
  ph_robot *const *robots = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_client_robots(client.get(), &robots, &count, &error));
  ASSERT_EQ(count, 2U);
  EXPECT_STREQ(ph_robot_name(robots[0]), "r0");
  EXPECT_STREQ(ph_robot_name(robots[1]), "guest");
  EXPECT_EQ(robots[1], robot_of(client, "guest"));
}

TEST(Robots, TheLastOfEqualNamesIsMeant) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    answer_page(
        peer, message, 0,
        "0\tr\tposition\t\t1:position2d:0\n1\tr.l\tranger\tr\t1:laser:0\n2\tr\tposition\t\t1:position2d:1\n");
    return true;
  }));
  const Client client = connected(server.address());
  EXPECT_THAT(devices_of(robot_of(client, "r")), ElementsAre("position2d:1"));
}

TEST(Robots, DevicesAreListedWithTheirModels) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    if (message.header.interface_code == PH_SIMULATION_CODE) {
      answer_page(peer, message, 0, lines(kHouse, 0, kHouse.size(), peer.port()));
    } else if (message.header.subtype == PH_PLAYER_REQ_DEVLIST->subtype) {
      const std::uint32_t port = peer.port();
      const ph_common_devaddr at[] = {{0, port, 31, 0},
                                      {0, port, 4, 12},
                                      {0, port, PH_RANGER_CODE, 20},
                                      {0, port, 6, 77},
                                      {0, port, 999, 1}};
      peer.answer(message, body(ph_player_device_devlist_type, ph_player_device_devlist{at, 5}));
    } else {
      peer.answer(message, {}, PH_KIND_NACK);
    }
    return true;
  }));
  const Client client = connected(server.address());
  const ph_device_entry *entries = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_client_devices(client.get(), &entries, &count, &error));
  std::vector<std::string> told;
  for (std::size_t i = 0; i < count; ++i) {
    told.push_back(std::string(entries[i].name) + " " + entries[i].model + " " + entries[i].robot +
                   entries[i].driver);
  }
  EXPECT_THAT(told, ElementsAre("simulation:0  ", "position2d:12 guest guest",
                                "ranger:20 guest.ranger:0 guest", "laser:77  ", "999:1  "));
  ASSERT_EQ(count, 5U);
  EXPECT_STREQ(entries[4].interface_name, "999");
}

/// The devices that were opened (+) and closed (-), simulation aside.
std::vector<std::string> opened(const std::vector<Received> &received) {
  std::vector<std::string> found;
  for (const Received &message : received) {
    if (message.header.interface_code != 1 || message.header.subtype != PH_PLAYER_REQ_DEV->subtype) continue;
    const int code = message.body.at(11), index = message.body.at(15), access = message.body.at(19);
    if (code == PH_SIMULATION_CODE) continue;
    found.push_back((access == PH_PLAYER_CLOSE_MODE ? "-" : "+") + std::to_string(code) + ":" +
                    std::to_string(index));
  }
  return found;
}

TEST(Robots, DevicesAreOpenedOnceAndTheModelsAskedForOnce) {
  FakeServer server(script(house));
  {
    const Client client = connected(server.address());
    for (int i = 0; i < 3; ++i) {
      EXPECT_WORKS(ph_position2d_stop(ph_robot_position2d(robot_of(client, "guest"), 0, nullptr), &error));
    }
    ph_robot_laser(robot_of(client, "guest"), 0, nullptr);
    ph_robot_laser(robot_of(client, "guest"), 1, nullptr);
    robot_of(client, "r0");
  }
  EXPECT_THAT(opened(server.finish()), ElementsAre("+4:12", "+6:12", "+6:30", "-6:30", "-6:12", "-4:12"));
  int asked = 0;
  for (const Received &message : server.finish())
    asked += message.header.interface_code == PH_SIMULATION_CODE;
  EXPECT_EQ(asked, 3);
}

TEST(Robots, OneThatCameLaterIsFoundAndTheOthersStayTheSame) {
  int asked = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    const std::string first = "0\tr0\tposition\t\t1:position2d:0\n",
                      second = "1\tr1\tposition\t\t1:position2d:1\n";
    answer_page(peer, message, 0, ++asked == 1 ? first : first + second);
    return true;
  }));
  const Client client = connected(server.address());
  ph_robot *first = robot_of(client, "r0");
  EXPECT_THAT(devices_of(robot_of(client, "r1")), ElementsAre("position2d:1"));
  EXPECT_EQ(robot_of(client, "r0"), first);
  const ph_model *models = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_client_models(client.get(), &models, &count, &error));
  ASSERT_EQ(count, 2U);
  EXPECT_STREQ(models[1].name, "r1");
}

TEST(Robots, ClosingOneStopsItAndItOpensAgainAndItsDevicesMayBeFreed) {
  FakeServer server(script(house));
  {
    const Client client = connected(server.address());
    ph_robot *guest = robot_of(client, "guest");
    ph_position2d *base = ph_robot_position2d(guest, 0, nullptr);
    EXPECT_WORKS(ph_position2d_drive(base, 0.1, 0, 0, &error));
    EXPECT_WORKS(ph_robot_close(guest, &error));
    EXPECT_FALSE(ph_device_is_open(ph_position2d_device(base)));
    ph_position2d *again = ph_robot_position2d(guest, 0, nullptr);
    ASSERT_NE(again, nullptr);
    ph_position2d_free(again);
    ph_position2d_free(base);
    EXPECT_WORKS(ph_robot_close(guest, &error));
    ASSERT_NE(ph_robot_position2d(guest, 0, nullptr), nullptr);
  }
  EXPECT_THAT(opened(server.finish()), ElementsAre("+4:12", "-4:12", "+4:12", "-4:12", "+4:12", "-4:12"));
}

TEST(Robots, ANameThatIsNotThereGetsTheNearestOne) {
  FakeServer server(script(house));
  const Client client = connected(server.address());
  EXPECT_REFUSES(ph_client_robot(client.get(), "gest", &error), PH_REQUEST_REFUSED,
                 "there is no robot \"gest\" at " + server.address() + " (did you mean \"guest\"?)");
  ph_error error = {PH_OK, ""};
  EXPECT_EQ(ph_client_robot(client.get(), "xyzzy", &error), nullptr);
  EXPECT_EQ(std::string(error.text), "there is no robot \"xyzzy\" at " + server.address());
}

TEST(Robots, ADeviceThatOneLacksIsToldWithWhatItHas) {
  FakeServer server(script(house));
  const Client client = connected(server.address());
  EXPECT_REFUSES(ph_robot_laser(robot_of(client, "r0"), 0, &error), PH_REQUEST_REFUSED,
                 "robot \"r0\" has no laser (it has position2d:0, ranger:0, sonar:0)");
  EXPECT_REFUSES(ph_robot_device(robot_of(client, "r0"), "sonar", 1, &error), PH_REQUEST_REFUSED,
                 "robot \"r0\" has no sonar number 1 (it has ");
  EXPECT_REFUSES(ph_robot_laser(robot_of(client, "wall"), 0, &error), PH_REQUEST_REFUSED,
                 "robot \"wall\" has no laser (it has no devices)");
  EXPECT_REFUSES(
      ph_robot_position2d(robot_of(client, "next"), 0, &error), PH_REQUEST_REFUSED,
      "at port " + std::to_string(server.port()) + ", but position2d:0 at port 9999: connect there");
}

TEST(Robots, AServerThatDoesNotListModelsIsTold) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message, {}, PH_KIND_NACK);
    return true;
  }));
  const Client client = connected(server.address());
  ph_robot *const *robots = nullptr;
  std::size_t count = 0;
  const char *told = "this server does not tell the names of models; open devices by number";
  EXPECT_FAILS(ph_client_robots(client.get(), &robots, &count, &error), PH_REQUEST_REFUSED, told);
  EXPECT_REFUSES(ph_client_robot(client.get(), "r0", &error), PH_REQUEST_REFUSED, told);
}

TEST(Robots, AListThatGoesRoundInCirclesIsAnError) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    answer_page(peer, message, 1, "0\tr0\tposition\t\t\n");
    return true;
  }));
  const Client client = connected(server.address());
  const ph_model *models = nullptr;
  std::size_t count = 0;
  EXPECT_FAILS(ph_client_models(client.get(), &models, &count, &error), PH_WIRE_ERROR,
               "goes on at 1 after 1");
}

}  // namespace
}  // namespace playhouse_c
