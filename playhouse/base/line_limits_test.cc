#include "playhouse/base/line_limits.h"

#include <gtest/gtest.h>

namespace playhouse {
namespace {

constexpr int kWarning = 3, kError = 4;
constexpr auto kBurst = static_cast<std::size_t>(LineLimits::kLines);

/// Texts of what comes out, as one string per line.
std::vector<std::string> texts(const std::vector<LineLimits::Line>& lines) {
  std::vector<std::string> result;
  for (const LineLimits::Line& line : lines) result.push_back(line.text);
  return result;
}

/// So many lines of one kind at one moment; returns how many come out.
std::size_t flood(LineLimits& limits, std::size_t lines, double now, int level = kWarning) {
  std::size_t written = 0;
  for (std::size_t i = 0; i < lines; ++i) {
    written += limits.pass("{}: refused", {level, "1.2.3.4: refused"}, now).size();
  }
  return written;
}

TEST(LineLimits, lets_a_burst_of_a_kind_pass_and_then_a_line_a_second) {
  LineLimits limits;
  EXPECT_EQ(flood(limits, 10 * kBurst, 0), kBurst);
  EXPECT_EQ(flood(limits, 1000, 0.5), 0u);
  EXPECT_EQ(flood(limits, 1000, 2.1), static_cast<std::size_t>(2 * LineLimits::kLinesPerSecond));
}

TEST(LineLimits, has_room_for_a_burst_again_after_a_while_and_no_more) {
  LineLimits limits;
  flood(limits, kBurst, 0);
  EXPECT_EQ(flood(limits, 10 * kBurst, 1e6), kBurst);
}

TEST(LineLimits, holds_back_no_other_kind_and_no_other_level) {
  LineLimits limits;
  flood(limits, 10 * kBurst, 0);
  EXPECT_EQ(texts(limits.pass("{}: closed", {kWarning, "5.6.7.8: closed"}, 0)),
            std::vector<std::string>{"5.6.7.8: closed"});
  EXPECT_EQ(flood(limits, 1, 0, kError), 1u);
}

TEST(LineLimits, tells_how_many_it_held_back_with_the_next_line_of_any_kind) {
  LineLimits limits;
  flood(limits, kBurst + 70, 1);
  const double later = 1 + LineLimits::kSecondsUntilTold;
  EXPECT_EQ(texts(limits.pass("other", {kWarning, "other"}, later)),
            (std::vector<std::string>{"70 more lines in the last 10 s like: 1.2.3.4: refused", "other"}));
  EXPECT_TRUE(limits.summaries(later).empty()) << "logged once";
}

TEST(LineLimits, tells_at_the_end_what_was_not_told) {
  LineLimits limits;
  flood(limits, kBurst + 7, 1);
  EXPECT_EQ(texts(limits.summaries(3)),
            std::vector<std::string>{"7 more lines in the last 2 s like: 1.2.3.4: refused"});
}

TEST(LineLimits, every_line_of_a_flood_is_written_or_counted) {
  LineLimits limits;
  std::size_t written = 0, counted = 0;
  const auto look = [&](const std::vector<LineLimits::Line>& lines) {
    for (const LineLimits::Line& line : lines) {
      if (line.text == "x")
        ++written;
      else
        counted += std::stoul(line.text);
    }
  };
  constexpr std::size_t kLines = 600000;  // a thousand a second for ten minutes
  for (std::size_t i = 0; i < kLines; ++i)
    look(limits.pass("x", {kWarning, "x"}, static_cast<double>(i) / 1000));
  look(limits.summaries(600));
  EXPECT_EQ(written + counted, kLines);
  EXPECT_LE(written, kBurst + 600);
}

}  // namespace
}  // namespace playhouse
