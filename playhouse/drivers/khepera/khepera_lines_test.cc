// Lines as the original driver sent and took them.

#include "playhouse/drivers/khepera/khepera_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace playhouse::drivers::khepera {
namespace {

std::optional<KheperaLine> line_of(std::string_view text) {
  KheperaReader reader;
  reader.add(std::as_bytes(std::span(text)));
  return reader.next();
}
std::vector<std::int64_t> numbers_of(std::string_view text) {
  return line_of(text).value_or(KheperaLine{}).numbers;
}

TEST(KheperaLines, are_those_of_the_original) {
  EXPECT_EQ(encode_line('E'), "E\n");
  EXPECT_EQ(encode_line('D', {-470, 480}), "D,-470,480\n");
  EXPECT_EQ(encode_answer('e', {0, 0}), "e,0,0\r\n");
  EXPECT_EQ(line_of("n,60,70,80,90,100,110,120,1023\r\n")->letter, 'n');
  EXPECT_EQ(numbers_of("n,60,70,80,90,100,110,120,1023\r\n"),
            (std::vector<std::int64_t>{60, 70, 80, 90, 100, 110, 120, 1023}));
  EXPECT_EQ(numbers_of("D,-475,475\n"), (std::vector<std::int64_t>{-475, 475}));
  EXPECT_EQ(line_of("d\r\n")->letter, 'd');
}

TEST(KheperaLines, end_with_any_end_and_what_is_none_has_no_letter) {
  EXPECT_EQ(line_of("H\r")->letter, 'H');
  EXPECT_EQ(line_of("\r\n\n\rE\r\n")->letter, 'E');
  EXPECT_EQ(line_of("H,12"), std::nullopt) << "not whole";
  EXPECT_EQ(line_of("h,1,x\n")->letter, 0);
  EXPECT_EQ(line_of("h1,2\n")->letter, 0);
  EXPECT_EQ(line_of("h,99999999999,2\n")->letter, 0);
  EXPECT_EQ(line_of("ROM of minirobot KHEPERA\r\n")->letter, 0);
  EXPECT_EQ(line_of("h," + std::string(5000, '1') + "\n")->letter, 0);
  KheperaReader reader;
  const std::string noise(100000, 'x');
  reader.add(std::as_bytes(std::span(noise)));
  EXPECT_EQ(reader.next(), std::nullopt);
  reader.add(std::as_bytes(std::span(std::string_view("\nE\n"))));
  EXPECT_EQ(reader.next()->letter, 'E');
}

TEST(KheperaLines, light_is_that_of_white_paper) {
  EXPECT_EQ(light_at(0), 1023);
  EXPECT_EQ(light_at(0.010), 1000);
  EXPECT_EQ(light_at(0.025), 362);
  EXPECT_EQ(light_at(0.1), 80);
  EXPECT_EQ(light_at(0.2), 0);
  EXPECT_EQ(light_at(NAN), 0);
  EXPECT_NEAR(range_of(450), 0.02, 1e-9);
  EXPECT_NEAR(range_of(0), 0.1, 1e-9);
  for (double range = 0.008; range < 0.1; range += 0.001)
    EXPECT_NEAR(range_of(light_at(range)), range, 0.0011) << range;
}

}  // namespace
}  // namespace playhouse::drivers::khepera
