// Bytes as the original driver sent them and took them from a camera.

#include "playhouse/drivers/sonyevid30/visca_frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers::visca {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;

const CameraModel& d30() {
  return *find_camera("d30");
}
const CameraModel& d100() {
  return *find_camera("d100");
}

TEST(ViscaFrames, moves_are_those_of_the_original_without_its_rounding) {
  EXPECT_EQ(to_hex(encode_move(0x18, 0x14, units_of(d30(), 0.5236, -9 * 3.14159265 / 180))),
            "81 01 06 02 18 14 0f 0e 0f 08 0f 0f 09 04 ff");
  EXPECT_EQ(units_of(d30(), 0.5236, -0.1745), (PanTilt{-264, -120}))
      << "which the original cuts to 9 degrees";
  EXPECT_EQ(units_of(d100(), 0.5236, 0.5), (PanTilt{-432, 360})) << "no further than it reaches";
  EXPECT_EQ(units_of(d30(), 9, -9), (PanTilt{-880, -300}));
  EXPECT_EQ(units_of(d30(), NAN, 0).tilt, 0);
  EXPECT_EQ(to_hex(encode_zoom(0x2D1)), "81 01 04 47 00 02 0d 01 ff");
}

TEST(ViscaFrames, drives_are_those_of_the_original) {
  const double pan = 0.3 * 180 / 3.14159265, tilt = 0.1 * 180 / 3.14159265;
  EXPECT_EQ(to_hex(encode_drive(-pan_code_of(d30(), pan), tilt_code_of(d30(), tilt))),
            "81 01 06 01 05 02 01 01 ff");
  EXPECT_EQ(to_hex(encode_drive(-pan_code_of(d100(), pan), tilt_code_of(d100(), tilt))),
            "81 01 06 01 0b 06 01 01 ff");
  EXPECT_EQ(to_hex(encode_drive(3, -4)), "81 01 06 01 03 04 02 02 ff");
  EXPECT_EQ(to_hex(encode_drive(0, 0)), "81 01 06 01 01 01 03 03 ff")
      << "no speed of 0, which cameras refuse";
}

TEST(ViscaFrames, speeds_are_those_of_the_tables) {
  EXPECT_NEAR(pan_speed_of(d30(), 0x18), 80, 1e-9);
  EXPECT_NEAR(pan_speed_of(d30(), -1), -3.33, 0.01);
  EXPECT_NEAR(tilt_speed_of(d30(), 0x14), 50, 1e-9);
  EXPECT_NEAR(pan_speed_of(d100(), 0x18), 300, 1e-9);
  EXPECT_NEAR(tilt_speed_of(d100(), 0x14), 125, 1e-9);
  EXPECT_NEAR(pan_speed_of(d100(), 1), 2, 1e-9);
  for (const CameraModel& model : camera_models())
    for (int code = -model.tilt_speeds; code <= model.tilt_speeds; ++code) {
      EXPECT_EQ(pan_code_of(model, pan_speed_of(model, code)), code) << model.name;
      EXPECT_EQ(tilt_code_of(model, tilt_speed_of(model, code)), code) << model.name;
    }
}

TEST(ViscaFrames, directions_and_views_come_back) {
  for (const CameraModel& model : camera_models()) {
    const ViewRange range{1.0, 0.1};
    for (int units = model.least.tilt; units <= model.most.tilt; ++units) {
      const PanTilt back = units_of(model, pan_of(model, units), tilt_of(model, units));
      ASSERT_EQ(back, (PanTilt{units, units})) << model.name;
    }
    for (int zoom = 0; zoom <= model.most_zoom; zoom += 7)
      ASSERT_EQ(zoom_units(model, range, view_of(model, range, zoom)), zoom) << model.name;
    EXPECT_EQ(zoom_units(model, range, 1), 0);
    EXPECT_EQ(zoom_units(model, range, 0.1), model.most_zoom);
    EXPECT_EQ(find_camera(model.code), &model);
  }
}

TEST(ViscaFrames, frames_are_found_and_others_left_out) {
  ViscaReader reader;
  reader.add(from_hex("90 41 ff 90 50 0f 0e 0f 08 0f 0f 09 04 ff ff 90 ff"));
  EXPECT_EQ(to_hex(*reader.next()), "90 41");
  const RawBytes answer = *reader.next();
  EXPECT_EQ(number_at(answer, 2), -264);
  EXPECT_EQ(number_at(answer, 6), -108);
  EXPECT_EQ(number_at(answer, 7), std::nullopt) << "cut";
  EXPECT_EQ(reader.next(), std::nullopt);
  reader.add(RawBytes(1000, std::byte{0x81}));
  reader.add(from_hex("ff 90 42 ff"));
  EXPECT_EQ(to_hex(*reader.next()), "90 42");
  EXPECT_EQ(number_at(from_hex("00 10 00 00"), 0), std::nullopt) << "a byte is no nibble";
}

}  // namespace
}  // namespace playhouse::drivers::visca
