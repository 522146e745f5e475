// The driver against a script that says what the original driver was told, and against the emulator.

#include "playhouse/drivers/garminnmea/garminnmea.h"

#include <gtest/gtest.h>

#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers {
namespace {

namespace gps = wire::gps;
using testing::FarEnd;
using testing::HardwareTest;

constexpr const char* kReceiverSection = R"(driver( name "garminnmea" port "/dev/gps" provides ["gps:1"] ))";
constexpr const char* kRmc = "$GPRMC,123519.25,A,4807.0380,N,01131.0000,E,022.4,084.4,230394,003.1,W*43\r\n";
constexpr const char* kGga = "$GPGGA,123519.25,4807.0380,N,01131.0000,E,1,08,0.9,545.4,M,46.9,M,,*6E\r\n";

class GarminNmeaScript : public HardwareTest {
 protected:
  void begin(const std::string& more = "") {
    std::string section = kReceiverSection;
    section.insert(section.size() - 1, more);
    ASSERT_EQ(build(section), "");
    client = client_of(gps::kCode, 1);
  }
  gps::Data fix_after(const std::string& text) {
    receiver.send(std::as_bytes(std::span(text)));
    return latest<gps::Data>(*client, gps::kCode, gps::kDataState, 0.5);
  }
  FarEnd receiver{network_, "/dev/gps", {.baud = 4800}};
  std::unique_ptr<server::TestClient> client;
};

TEST_F(GarminNmeaScript, a_fix_is_that_of_the_original_in_the_units_of_the_interface) {
  begin();
  EXPECT_EQ(access, 1);
  const auto fix = fix_after(std::string("$PGRME,15.0,M,45.0,M,25.0,M*1C\r\n") + kRmc + kGga);
  EXPECT_EQ(fix.time_sec, 764426119u);
  EXPECT_EQ(fix.time_usec, 250000u);
  EXPECT_EQ(fix.latitude, 481173000);
  EXPECT_EQ(fix.longitude, 115166667);
  EXPECT_EQ(fix.altitude, 592300) << "545.4 m above sea, which is 46.9 m above the ellipsoid";
  EXPECT_EQ(fix.quality, 1u);
  EXPECT_EQ(fix.num_sats, 8u);
  EXPECT_EQ(fix.hdop, 9u);
  EXPECT_NEAR(fix.speed, 11.523, 0.001);
  EXPECT_NEAR(fix.course, 84.4 * 3.14159265 / 180, 1e-6);
  EXPECT_NEAR(fix.utm_e, 687299.58, 0.01);
  EXPECT_NEAR(fix.utm_n, 5332401.25, 0.01);
  EXPECT_EQ(fix.err_horz, 15);
  EXPECT_EQ(fix.err_vert, 45);
}

TEST_F(GarminNmeaScript, it_takes_any_talker_and_jumps_and_leaves_out_what_is_damaged) {
  begin();
  EXPECT_EQ(fix_after("$GNGGA,123523,4907.0380,N,01131.0000,E,4,08,0.9,545.4,M,46.9,M,,*54\r\n").quality, 4u);
  EXPECT_EQ(
      fix_after("$GPGGA,123520,3348.4563,S,15110.9876,W,2,07,1.25,-12.3,M,20.1,M,3.2,0120*46\r\n").latitude,
      -338076050);
  EXPECT_EQ(fix_after("$GPGGA,123521,4807.0380,N,01131.0000,E,1,08,0.9,545.4,M,46.9,M,,*00\r\n").quality, 0u)
      << "nothing is published";
  const std::string half = kGga;
  EXPECT_EQ(fix_after(half.substr(0, 30)).quality, 0u);
  EXPECT_EQ(fix_after(half.substr(30)).quality, 1u);
}

TEST_F(GarminNmeaScript, without_a_fix_there_is_no_place) {
  begin();
  fix_after(std::string(kRmc) + kGga);
  const auto fix = fix_after("$GPGGA,123521,,,,,0,00,99.9,,M,,M,,*77\r\n");
  EXPECT_EQ(fix.time_sec, 764426121u);
  EXPECT_EQ(fix.latitude, 0);
  EXPECT_EQ(fix.quality, 0u);
  EXPECT_EQ(fix.hdop, 999u);
}

/// A GGA before midnight may come after the RMC of the next day, and the other way round.
TEST_F(GarminNmeaScript, days_change_at_midnight) {
  begin();
  const auto second = [this](const std::string& rmc, const std::string& gga) {
    return fix_after(
               nmea::sentence_of("GPRMC," + rmc + ",A,4807.0380,N,01131.0000,E,0,0," +
                                 (rmc[0] == '2' ? "310126" : "010226") + ",,") +
               nmea::sentence_of("GPGGA," + gga + ",4807.0380,N,01131.0000,E,1,08,0.9,545.4,M,46.9,M,,"))
        .time_sec;
  };
  constexpr std::uint32_t kFebruary = 1769904000;  // 2026-02-01
  EXPECT_EQ(second("235959", "235959"), kFebruary - 1);
  EXPECT_EQ(second("235959", "000000"), kFebruary);
  EXPECT_EQ(second("000000", "000000"), kFebruary);
  EXPECT_EQ(second("000000", "235959"), kFebruary - 1);
}

TEST_F(GarminNmeaScript, noise_and_silence_are_no_receiver) {
  begin();
  fix_after(kGga);
  for (int second = 0; second < 11; ++second) fix_after("$GPGGA,12$$*\r\n\xFF*00,,,");
  client->read();
  network_.run_for(6);
  EXPECT_EQ(server::outline(client->ask(server::open_request(gps::kCode, 1))), "ACK 3, NACK 3");
}

class GarminNmeaPair : public HardwareTest {
 protected:
  server::FakeDriver& source = add_device(gps::kCode);

  void begin(const std::string& more = "", const std::string& of_emulator = "") {
    std::string section = kReceiverSection;
    section.insert(section.size() - 1, more);
    ASSERT_EQ(build(R"(driver( name "garminnmea_emulator" port "/dev/gps" requires ["gps:0"])" + of_emulator +
                    ")\n" + section),
              "");
    client = client_of(gps::kCode, 1);
  }
  gps::Data heard(const gps::Data& told, double seconds = 2) {
    publish(gps::kCode, gps::kDataState, told);
    return latest<gps::Data>(*client, gps::kCode, gps::kDataState, seconds);
  }
  static gps::Data fix() {
    gps::Data fix;
    fix.time_sec = 1774269319;
    fix.time_usec = 123456;
    fix.latitude = -338076051;
    fix.longitude = 1511831267;
    fix.altitude = -12345;
    fix.speed = 1.5;
    fix.course = 4;
    fix.quality = 1;
    fix.num_sats = 9;
    fix.hdop = 11;
    fix.vdop = 17;
    fix.err_horz = 2.5;
    fix.err_vert = 4.25;
    return fix;
  }
  std::unique_ptr<server::TestClient> client;
};

TEST_F(GarminNmeaPair, times_and_places_are_exact) {
  begin();
  const auto read = heard(fix(), 3.5);
  EXPECT_EQ(read.time_sec, 1774269319u);
  EXPECT_EQ(read.time_usec, 123456u);
  EXPECT_EQ(read.latitude, -338076051);
  EXPECT_EQ(read.longitude, 1511831267);
  EXPECT_EQ(read.altitude, -12345);
  EXPECT_NEAR(read.speed, 1.5, 0.0003) << "a thousandth of a knot";
  EXPECT_NEAR(read.course, 4, 0.0001) << "a hundredth of a degree";
  EXPECT_EQ(read.quality, 1u);
  EXPECT_EQ(read.num_sats, 9u);
  EXPECT_EQ(read.hdop, 11u);
  EXPECT_EQ(read.vdop, 17u);
  EXPECT_EQ(read.err_horz, 2.5);
  EXPECT_EQ(read.err_vert, 4.25);
}

TEST_F(GarminNmeaPair, a_fix_that_is_lost_is_told) {
  begin(" baud 9600", R"( baud 9600 talker "GN" period 0.5)");
  EXPECT_EQ(heard(fix()).quality, 1u);
  gps::Data none;
  none.time_sec = 1774269320;
  none.num_sats = 2;
  const auto read = heard(none);
  EXPECT_EQ(read.quality, 0u);
  EXPECT_EQ(read.num_sats, 2u);
  EXPECT_EQ(read.time_sec, 1774269320u);
  EXPECT_EQ(read.latitude, 0);
}

TEST_F(GarminNmeaPair, before_the_first_fix_there_is_no_time) {
  begin();
  const auto read = latest<gps::Data>(*client, gps::kCode, gps::kDataState, 1.5);
  EXPECT_EQ(read.time_sec, 0u);
  EXPECT_EQ(read.quality, 0u);
  EXPECT_EQ(read.hdop, 999u) << "and yet something was published";
}

TEST_F(GarminNmeaPair, at_another_speed_there_is_no_sentence_and_a_line_that_was_pulled_is_waited_for) {
  begin(" reconnect 1");
  EXPECT_EQ(heard(fix()).quality, 1u);
  network_.serial().unplug("/dev/gps");
  EXPECT_EQ(heard(fix()).quality, 0u);
  network_.serial().plug("/dev/gps");
  network_.run_for(3);
  EXPECT_EQ(heard(fix()).quality, 1u);
}

TEST_F(GarminNmeaPair, a_receiver_at_another_speed_is_none) {
  begin("", " baud 9600");
  EXPECT_EQ(heard(fix(), 5).quality, 0u);
  network_.run_for(6);
  EXPECT_EQ(server::outline(client->ask(server::open_request(gps::kCode, 1))), "ACK 3, NACK 3");
}

/// The sum does not tell two equal faults in one sentence.
TEST_F(GarminNmeaPair, a_noisy_line_loses_sentences_and_gives_hardly_a_wrong_place) {
  begin();
  network_.serial().faults = {.loss = 0.001, .change = 0.001};
  int fixes = 0, wrong = 0;
  for (int second = 0; second < 200; ++second) {
    const auto read = heard(fix(), 1);
    if (read.quality == 0) continue;
    ++fixes;
    if (read.latitude != -338076051 || read.longitude != 1511831267) ++wrong;
  }
  EXPECT_GT(fixes, 120);
  EXPECT_LT(fixes, 200);
  EXPECT_LE(wrong, 1);
}

TEST_F(GarminNmeaPair, sections_with_faults_say_what_is_valid) {
  EXPECT_EQ(build(R"(driver( name "garminnmea" provides ["gps:1"] baud 5000 ))"),
            "test.cfg:1: baud is 4800, 9600, 19200, 38400, 57600, 115200 or 230400");
  EXPECT_EQ(build(R"(driver( name "garminnmea_emulator" port "/dev/gps" requires ["gps:0"] talker "gps" ))"),
            "test.cfg:1: talker is two letters such as GP or GN, not \"gps\"");
  ASSERT_EQ(build(kReceiverSection), "");
  client = client_of(gps::kCode, 1);
  EXPECT_EQ(access, 3) << "no such port";
}

}  // namespace
}  // namespace playhouse::drivers
