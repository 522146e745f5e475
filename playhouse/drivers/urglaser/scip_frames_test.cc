// Bytes as hosts of SCIP said them, and as they took them from a scanner.

#include "playhouse/drivers/urglaser/scip_frames.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "playhouse/base/rng.h"

namespace playhouse::drivers::scip {
namespace {

RawBytes bytes_of(std::string_view text) {
  RawBytes bytes;
  put_text(bytes, text);
  return bytes;
}
std::string text_of(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
  return text;
}

TEST(ScipFrames, checksums_and_numbers_are_those_of_the_maker) {
  EXPECT_EQ(check_of("00"), 'P');
  EXPECT_EQ(check_of("99"), 'b');
  EXPECT_EQ(check_of("0E"), 'e');
  EXPECT_EQ(named_line("DMAX", "5600", true), "DMAX:5600;_");
  EXPECT_EQ(named_line("VEND", "Hokuyo Automatic Co.,Ltd.", true), "VEND:Hokuyo Automatic Co.,Ltd.;[");
  EXPECT_EQ(encode_number(1234, 2), "CB");
  EXPECT_EQ(encode_number(5432, 3), "1Dh");
  EXPECT_EQ(encode_number(16000000, 4), "m2@0");
  EXPECT_EQ(decode_number("1Dh"), 5432);
  EXPECT_EQ(decode_number("m2@0"), 16000000);
  EXPECT_FALSE(decode_number("1\x7fh"));
  EXPECT_FALSE(decode_number("1 h"));
  EXPECT_EQ((ScipRequest{44, 725, 1, 0, 2}.line("MD")), "MD0044072501002");
  EXPECT_EQ((ScipRequest{0, 768, 1}.line("GD")), "GD0000076801");
}

/// The scan of the capture: 1000 mm and the number of the step.
TEST(ScipFrames, a_scan_of_the_capture_has_its_lines) {
  std::string data;
  for (int step = 44; step <= 725; ++step) data += encode_number(1000 + step, 3);
  std::vector<std::string> lines = data_lines(encode_number(0xA0, 4), true);
  EXPECT_EQ(lines.at(0), "002PR") << "its time";
  for (const std::string& line : data_lines(data, true)) lines.push_back(line);
  const RawBytes bytes = encode_reply("MD0044072501001", "99", lines, true);
  EXPECT_EQ(bytes.size(), 2137u);
  const std::string text = text_of(bytes);
  EXPECT_TRUE(text.starts_with("MD0044072501001\n99b\n002PR\n0@D0@E0@F0@G0@")) << text.substr(0, 60);
  EXPECT_TRUE(text.ends_with("0Jma\n\n"));

  ScipReplies replies;
  replies.add(bytes);
  const auto reply = replies.next();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, "99");
  EXPECT_EQ(joined_data(std::span(reply->lines).subspan(1)), data);
}

TEST(ScipFrames, what_a_model_tells_is_read) {
  const ScipModel& urg = scip_models().front();
  const RawBytes bytes = encode_reply("PP", "00", parameter_lines(urg), true);
  EXPECT_EQ(bytes.size(), 128u) << "as of the capture";
  EXPECT_TRUE(text_of(bytes).ends_with("SCAN:600;e\n\n"));
  ScipReplies replies;
  replies.add(bytes);
  auto lines = replies.next()->lines;
  const auto model = read_parameters(lines);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->most, 5600);
  EXPECT_EQ(model->front, 384);
  EXPECT_NEAR(model->angle_of(725), 341 * 360 / 1024.0 * 3.14159265 / 180, 1e-6);
  lines[2] = "DMAX:5601;_";
  EXPECT_FALSE(read_parameters(lines)) << "a wrong checksum";
  lines[2] = named_line("DMAX", "-1", true);
  EXPECT_FALSE(read_parameters(lines));
}

TEST(ScipFrames, answers_with_damage_are_left_out) {
  ScipReplies replies;
  replies.add(bytes_of("QT\n00Q\n\nQT\n0"));
  EXPECT_FALSE(replies.next());
  replies.add(bytes_of("0P\n\n\n\nV\n0\nVEND:x\n\n"));
  EXPECT_EQ(replies.next()->status, "00");
  const auto old = replies.next();
  EXPECT_EQ(old->status, "0");
  EXPECT_EQ(old->lines.size(), 1u);
  EXPECT_FALSE(joined_data(std::vector<std::string>{"0@D0@x"}));
}

TEST(ScipFrames, lines_end_with_either_sign_and_are_short) {
  ScipLines lines;
  lines.add(bytes_of("QT\rPP\n\nSCIP2.0\n"));
  lines.add(RawBytes(1));
  EXPECT_EQ(lines.next(), "QT");
  EXPECT_EQ(lines.next(), "PP");
  EXPECT_EQ(lines.next(), "SCIP2.0");
  EXPECT_FALSE(lines.next());
  lines.add(bytes_of(std::string(1000, 'x') + "\nVV\n"));
  EXPECT_EQ(lines.next(), "VV");
}

TEST(ScipFrames, any_bytes_are_read_without_harm) {
  Rng rng(5);
  ScipReplies replies;
  ScipLines lines;
  for (int k = 0; k < 20000; ++k) {
    constexpr char kLikely[] = {'\n', '0', 'P', ';', ':'};
    std::string text;
    for (int each = 0; each < 6; ++each)
      text += rng.bits() % 2 == 0 ? kLikely[rng.bits() % 5] : static_cast<char>(rng.bits());
    replies.add(bytes_of(text));
    lines.add(bytes_of(text));
    while (const auto reply = replies.next()) {
      static_cast<void>(read_parameters(reply->lines));
      static_cast<void>(joined_data(reply->lines));
    }
    while (lines.next()) {
    }
  }
}

}  // namespace
}  // namespace playhouse::drivers::scip
