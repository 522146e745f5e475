// What the planner's proxy makes of data that come without a list.
#include <gtest/gtest.h>

#include "libplayerc/playerc.h"

namespace {

TEST(Planner, TheNumberOfWaypointsComesWithTheDataAndTheirPlacesAreZerosBeforeTheyAreAskedFor) {
  playerc_planner_t *planner = playerc_planner_create(nullptr, 0);
  player_msghdr_t header = {};
  header.subtype = PLAYER_PLANNER_DATA_STATE;
  player_planner_data_t data = {};
  for (const uint32_t count : {3U, 1U, 5U}) {
    data.waypoints_count = count;
    planner->info.putmsg(planner, reinterpret_cast<char *>(&header), reinterpret_cast<char *>(&data));
    ASSERT_EQ(planner->waypoint_count, static_cast<int>(count));
    for (uint32_t i = 0; i < count; ++i) EXPECT_EQ(planner->waypoints[i][0], 0.0);
    planner->waypoints[0][1] = 7.0;
  }
  EXPECT_EQ(planner->waypoints[0][1], 7.0) << "what is known stays";
  data.waypoints_count = 0xFFFFFFFF;
  planner->info.putmsg(planner, reinterpret_cast<char *>(&header), reinterpret_cast<char *>(&data));
  EXPECT_EQ(planner->waypoint_count, 5) << "nobody has a way of so many";
  playerc_planner_destroy(planner);
}

}  // namespace
