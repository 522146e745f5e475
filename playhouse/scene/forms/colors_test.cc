#include "playhouse/scene/forms/colors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace playhouse::scene {
namespace {

Color rgb(int r, int g, int b) {
  return {static_cast<float>(r) / 255.0f, static_cast<float>(g) / 255.0f, static_cast<float>(b) / 255.0f, 1};
}

TEST(Colors, names_have_their_x11_values_not_those_of_the_web) {
  EXPECT_EQ(color_by_name("green"), rgb(0, 255, 0));
  EXPECT_EQ(color_by_name("gray"), rgb(190, 190, 190));
  EXPECT_EQ(color_by_name("maroon"), rgb(176, 48, 96));
  EXPECT_EQ(color_by_name("purple"), rgb(160, 32, 240));
  EXPECT_EQ(color_by_name("NavyBlue"), rgb(0, 0, 128));
  EXPECT_EQ(color_by_name("light slate grey"), rgb(119, 136, 153));
  EXPECT_EQ(color_by_name("LightSlateGray"), rgb(119, 136, 153));
  EXPECT_EQ(color_by_name("SteelBlue3"), rgb(79, 148, 205));
  EXPECT_EQ(color_by_name("silver"), rgb(192, 192, 192));
}

TEST(Colors, gray_levels_round_as_x11_does) {
  EXPECT_EQ(color_by_name("gray0"), rgb(0, 0, 0));
  EXPECT_EQ(color_by_name("grey10"), rgb(26, 26, 26));
  EXPECT_EQ(color_by_name("gray50"), rgb(127, 127, 127));
  EXPECT_EQ(color_by_name("gray90"), rgb(229, 229, 229));
  EXPECT_EQ(color_by_name("gray100"), rgb(255, 255, 255));
  EXPECT_FALSE(color_by_name("gray101"));
}

TEST(Colors, channels_beyond_what_a_screen_has_keep_to_themselves) {
  EXPECT_EQ(rgba8({1, 0.5f, 0, 1}), 0xFF8000FFu);
  EXPECT_EQ(rgba8({2, -1, 300, 0}), 0xFF00FF00u);
  EXPECT_EQ(rgba8({std::nanf(""), HUGE_VALF, 0, 1}), 0x000000FFu);
}

TEST(Colors, are_called_by_the_shortest_name_that_x11_has_for_them) {
  EXPECT_EQ(color_name(rgb(0, 255, 0)), "green");
  EXPECT_EQ(color_name(rgb(0, 255, 255)), "cyan");
  EXPECT_EQ(color_name(rgb(47, 79, 79)), "DarkSlateGray");
  EXPECT_EQ(color_name(rgb(26, 26, 26)), "gray10");
  EXPECT_EQ(color_name(rgb(192, 192, 192)), "");
  EXPECT_EQ(color_name(rgb(192, 192, 192), true), "silver");
  EXPECT_EQ(color_name({1, 0, 0, 0.5f}), "");
  EXPECT_EQ(color_name({-1e9f, 1e9f, 0, 1}), "");
  int named = 0;
  for (int rgb_cube = 0; rgb_cube < 256 * 256; ++rgb_cube) {
    const Color color = rgb(rgb_cube >> 8, rgb_cube & 0xFF, 0);
    const std::string name = color_name(color, true);
    if (name.empty()) continue;
    EXPECT_EQ(color_by_name(name), color) << name;
    ++named;
  }
  EXPECT_GT(named, 20);
}

TEST(Colors, other_words_are_none) {
  for (const char* word : {"", "re", "redd", "gray-1", "zzz"}) EXPECT_FALSE(color_by_name(word)) << word;
  EXPECT_EQ(color_hint("ornage"), " (did you mean \"orange\"?)");
}

}  // namespace
}  // namespace playhouse::scene
