// Texts of errors, and memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fake_server.h"
extern "C" {
#include "fail.h"
#include "memory.h"
#include "text.h"
}

namespace playhouse_c {
namespace {

TEST(Errors, AreOneLineAndCutOffWhereTheyDoNotFit) {
  ph_error error;
  EXPECT_EQ(ph_fail(&error, PH_WIRE_ERROR, "%s", std::string(2000, 'x').c_str()), PH_WIRE_ERROR);
  EXPECT_EQ(std::string(error.text), std::string(PH_ERROR_BYTES - 4, 'x') + "...");
  ph_fail(&error, PH_MISUSED, "a\nb\r%d", 1);
  EXPECT_STREQ(error.text, "a b 1");
  ph_fail(&error, PH_MISUSED, "c: %s", error.text);
  EXPECT_STREQ(error.text, "c: a b 1");
  EXPECT_EQ(ph_fail(nullptr, PH_NO_DATA, "nobody sees this"), PH_NO_DATA);
}

std::string number(double value) {
  char text[PH_NUMBER_BYTES];
  return ph_number_text(value, text);
}

TEST(Errors, NumbersHaveTheFewestDigits) {
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(number(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(number(-3.0), "-3");
  EXPECT_EQ(number(NAN), "nan");
  EXPECT_EQ(number(-NAN), "nan");
  EXPECT_EQ(number(-INFINITY), "-inf");
}

std::string near(const std::string &word, std::vector<const char *> known) {
  char text[PH_NEAR_BYTES];
  return ph_did_you_mean(word.c_str(), known.data(), known.size(), text);
}

TEST(Errors, ANearWordIsSuggested) {
  EXPECT_EQ(near("lazer", {"laser", "ranger"}), " (did you mean \"laser\"?)");
  EXPECT_EQ(near("gust", {"guest", "r0", "guard"}), " (did you mean \"guest\"?)");
  EXPECT_EQ(near("xyzzy", {"laser", "ranger"}), "");
  EXPECT_EQ(near("", {"", "a"}), "");
  EXPECT_EQ(near(std::string(500, 'a'), {"a"}), "");
}

TEST(Memory, AnArenaGivesZeroedMemoryOfAnySize) {
  ph_arena arena = {nullptr};
  for (std::size_t size = 1; size < 300000; size = size * 3 + 1) {
    auto *bytes = static_cast<std::uint8_t *>(ph_arena_take(&arena, size, 1));
    ASSERT_NE(bytes, nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes) % alignof(std::max_align_t), 0U);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(bytes[i], 0);
    std::fill(bytes, bytes + size, std::uint8_t{1});
  }
  EXPECT_EQ(ph_arena_take(&arena, SIZE_MAX / 2, 16), nullptr);
  ph_arena_free(&arena);
  ph_arena_free(&arena);
}

}  // namespace
}  // namespace playhouse_c
