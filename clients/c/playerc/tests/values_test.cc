// The messages by their old names: the same bytes as by ours, and copies that share nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "libplayerc/playerc.h"
#include "playhouse/c/wire.h"
extern "C" {
#include "player_types.h"
}

namespace {

using testing::HasSubstr;

/** What a value of zeros is on the wire. */
std::string zeros(const ph_struct_type &type) {
  const std::vector<char> value(type.size);
  ph_buffer out = {};
  EXPECT_EQ(ph_encode(&type, value.data(), &out, nullptr), PH_OK) << type.name;
  std::string bytes(reinterpret_cast<const char *>(out.bytes), out.size);
  ph_buffer_free(&out);
  return bytes;
}

TEST(Types, EveryMessageHasTheSameBytesByItsOldNameAndByOurs) {
  for (const ph_message_type &old : player_messages) {
    const ph_message_type *ours = ph_find_message(old.interface_code, old.kind, old.subtype);
    ASSERT_NE(ours, nullptr) << old.name;
    EXPECT_STREQ(old.name, ours->name);
    ASSERT_EQ(old.payload == nullptr, ours->payload == nullptr) << old.name;
    if (old.payload == nullptr) continue;
    EXPECT_EQ(old.payload->min_bytes, ours->payload->min_bytes) << old.name;
    EXPECT_EQ(zeros(*old.payload), zeros(*ours->payload)) << old.name;
  }
}

TEST(Types, AListWithinAStructHasItsCountAndItsLimit) {
  player_log_set_filename_t name = {4, "log"};
  ph_buffer out = {};
  ASSERT_EQ(ph_encode(&player_log_set_filename_t_type, &name, &out, nullptr), PH_OK);
  EXPECT_EQ(std::string(reinterpret_cast<const char *>(out.bytes), out.size),
            std::string("\0\0\0\4\0\0\0\4log\0", 12));
  player_log_set_filename_t back = {};
  ph_arena arena = {};
  ASSERT_EQ(ph_decode(&player_log_set_filename_t_type, &back, out.bytes, out.size, &arena, nullptr), PH_OK);
  EXPECT_EQ(back.filename_count, 4U);
  EXPECT_STREQ(back.filename, "log");
  ph_error error;
  name.filename_count = 257;
  EXPECT_EQ(ph_encode(&player_log_set_filename_t_type, &name, &out, &error), PH_WIRE_ERROR);
  const std::string longer = std::string("\0\0\1\1\0\0\1\1", 8) + std::string(260, 'x');
  EXPECT_EQ(ph_decode(&player_log_set_filename_t_type, &back, longer.data(), longer.size(), &arena, &error),
            PH_WIRE_ERROR);
  EXPECT_THAT(error.text, HasSubstr("over its limit of 256"));
  ph_arena_free(&arena);
  ph_buffer_free(&out);
}

TEST(Values, ACopyHasListsOfItsOwnAtEveryDepth) {
  char names[2][6] = {"left", "right"};
  player_audio_mixer_channel_detail_t details[2] = {{5, names[0], 1}, {6, names[1], 2}};
  const player_audio_mixer_channel_list_detail_t mixer = {2, details, 1, 0};
  player_audio_mixer_channel_list_detail_t *copy = player_audio_mixer_channel_list_detail_t_clone(&mixer);
  ASSERT_NE(copy, nullptr);
  std::memset(names, 'x', sizeof names);
  details[0].caps = 9;
  EXPECT_EQ(copy->details_count, 2U);
  EXPECT_STREQ(copy->details[0].name, "left");
  EXPECT_STREQ(copy->details[1].name, "right");
  EXPECT_EQ(copy->details[0].caps, 1);
  player_audio_mixer_channel_list_detail_t_cleanup(copy);
  EXPECT_EQ(copy->details, nullptr);
  EXPECT_EQ(copy->details_count, 0U);
  player_audio_mixer_channel_list_detail_t_free(copy);
  player_audio_mixer_channel_list_detail_t_free(nullptr);
}

TEST(Values, AnEmptyListStaysEmpty) {
  const player_laser_data_t none = {};
  player_laser_data_t copy;
  EXPECT_EQ(player_laser_data_t_copy(&copy, &none), sizeof copy);
  EXPECT_EQ(copy.ranges, nullptr);
  player_laser_data_t_cleanup(&copy);
}

TEST(Names, OfInterfacesAndOfKindsOfMessages) {
  EXPECT_STREQ(interf_to_str(PLAYER_POSITION2D_CODE), "position2d");
  EXPECT_STREQ(interf_to_str(999), "unknown");
  EXPECT_EQ(str_to_interf("laser"), PLAYER_LASER_CODE);
  EXPECT_EQ(str_to_interf("lasser"), 0xFFFF);
  EXPECT_EQ(lookup_interface_name(0, 999), nullptr);
  EXPECT_STREQ(msgtype_to_str(PLAYER_MSGTYPE_REQ), "request");
  EXPECT_STREQ(msgtype_to_str(77), "unknown");
}

}  // namespace
