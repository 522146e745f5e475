// Sentences that the original driver was told, and those of the maker's tables.

#include "playhouse/drivers/garminnmea/nmea_sentences.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/base/rng.h"

namespace playhouse::drivers::nmea {
namespace {

RawBytes bytes_of(std::string_view text) {
  RawBytes bytes;
  put_text(bytes, text);
  return bytes;
}
NmeaFields fields_of(std::string_view text) {
  SentenceReader reader;
  reader.add(bytes_of(text));
  return reader.next().value_or(NmeaFields{});
}

TEST(NmeaSentences, sums_are_those_of_the_makers) {
  EXPECT_EQ(sentence_of("GPVTG,054.7,T,034.4,M,005.5,N,010.2,K"),
            "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n");
  EXPECT_EQ(sentence_of("GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"),
            "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n");
}

TEST(NmeaSentences, a_fix_is_what_the_original_took_it_for) {
  const auto gga =
      read_gga(fields_of("$GPGGA,123519.25,4807.0380,N,01131.0000,E,1,08,0.9,545.4,M,46.9,M,,*6E\r\n"));
  ASSERT_TRUE(gga);
  EXPECT_EQ(gga->time, ((12 * 60 + 35) * 60 + 19) * 1'000'000LL + 250'000);
  EXPECT_EQ(gga->place, (NmeaPlace{481173000, 115166667}));
  EXPECT_EQ(gga->quality, 1);
  EXPECT_EQ(gga->satellites, 8);
  EXPECT_EQ(gga->hdop, 0.9);
  EXPECT_EQ(gga->altitude, 545.4);
  EXPECT_EQ(gga->geoid, 46.9);
  const auto south =
      read_gga(fields_of("$GPGGA,123520,3348.4563,S,15110.9876,W,2,07,1.25,-12.3,M,20.1,M,3.2,0120*46\r\n"));
  EXPECT_EQ(south->place, (NmeaPlace{-338076050, -1511831267}));
  EXPECT_EQ(south->altitude, -12.3);
  const auto none = read_gga(fields_of("$GPGGA,123521,,,,,0,00,99.9,,M,,M,,*77\r\n"));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->place);
  EXPECT_EQ(none->quality, 0);
}

TEST(NmeaSentences, times_speeds_and_errors_are_read) {
  const auto rmc =
      read_rmc(fields_of("$GPRMC,123519.25,A,4807.0380,N,01131.0000,E,022.4,084.4,230394,003.1,W*43\r\n"));
  ASSERT_TRUE(rmc);
  EXPECT_EQ(*rmc->date / 1'000'000 + 45319, 764426119) << "in 1994; the original has 2094";
  EXPECT_TRUE(rmc->is_valid);
  EXPECT_NEAR(*rmc->speed, 11.523, 0.001);
  EXPECT_EQ(rmc->course, 84.4);
  const auto zda = read_zda(fields_of("$GPZDA,123519.00,23,03,2026,00,00*6F\r\n"));
  EXPECT_EQ(zda->date / kDay, 20535);
  const auto gst = read_gst(fields_of("$GPGST,123524,1.1,2.2,3.3,4.4,5.5,6.6,7.7*7A\r\n"));
  EXPECT_NEAR(*gst->horizontal, 8.591, 0.001) << "of 5.5 and 6.6 m";
  EXPECT_EQ(gst->vertical, 7.7);
  EXPECT_EQ(read_pgrme(fields_of("$PGRME,15.0,M,45.0,M,25.0,M*1C\r\n"))->vertical, 45);
  EXPECT_EQ(read_gsa(fields_of("$GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1*39\r\n"))->vertical, 2.1);
}

TEST(NmeaSentences, types_are_known_whoever_talks) {
  EXPECT_EQ(type_of({"GNGGA"}), "GGA");
  EXPECT_EQ(type_of({"PGRME"}), "PGRME");
  EXPECT_EQ(type_of({"GP"}), "");
  EXPECT_EQ(type_of({""}), "");
}

TEST(NmeaSentences, without_their_sum_or_with_a_wrong_one_they_are_none) {
  EXPECT_TRUE(fields_of("$GPGGA,123521,4807.0380,N,01131.0000,E,1,08,0.9,545.4,M,46.9,M,,*00\r\n").empty());
  EXPECT_TRUE(fields_of("$GPGGA,123522,4807.0380,N,01131.0000,E,5,08,0.9,545.4,M,46.9,M,,\r\n").empty());
  EXPECT_TRUE(fields_of("$*\r\n").empty());
  EXPECT_TRUE(fields_of("$\r\n").empty());
  EXPECT_FALSE(fields_of("$GPGGA,12$PGRME,15.0,M,45.0,M,25.0,M*1C\r\n").empty()) << "the second one is whole";
  EXPECT_FALSE(fields_of("$PGRME,15.0,M,45.0,M,25.0,M*1c\n").empty());
}

TEST(NmeaSentences, fields_that_are_none_of_their_kind_make_none) {
  const auto reads = [](const std::string& text) {
    return read_gga(fields_of(sentence_of(text))).has_value();
  };
  EXPECT_TRUE(reads("GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"));
  EXPECT_TRUE(reads("GPGGA,,,,,,0,00,99.9,,,,,,"));
  EXPECT_TRUE(reads("GPGGA"));
  for (const char* const text :
       {"GPGGA,126019,4807.038,N,01131.000,E,1,08", "GPGGA,123519,4860.000,N,01131.000,E,1,08",
        "GPGGA,123519,9007.038,N,01131.000,E,1,08", "GPGGA,123519,4807.038,X,01131.000,E,1,08",
        "GPGGA,123519,4807.038,N,18100.000,E,1,08", "GPGGA,123519,4a07.038,N,01131.000,E,1,08",
        "GPGGA,123519,4807.038,N,01131.000,E,1,-8", "GPGGA,123519,4807.038,N,01131.000,E,nan,08",
        "GPGGA,123519,48,N,01131.000,E,1,08", "GPGGA,12,4807.038,N,01131.000,E,1,08"})
    EXPECT_FALSE(reads(text)) << text;
}

TEST(NmeaSentences, places_and_times_come_back_exactly) {
  Rng rng(7);
  for (int round = 0; round < 4000; ++round) {
    const Gga told{.time = static_cast<DayTime>(rng.bits() % static_cast<std::uint64_t>(kDay)),
                   .place = NmeaPlace{static_cast<std::int32_t>(rng.bits() % 1800000001) - 900000000,
                                      static_cast<std::int32_t>(
                                          static_cast<std::int64_t>(rng.bits() % 3600000001) - 1800000000)},
                   .quality = 1,
                   .satellites = 8,
                   .hdop = 0.9,
                   .altitude = static_cast<double>(rng.bits() % 8000000) / 1000,
                   .geoid = 0};
    const std::string text = encode_gga("GP", told);
    ASSERT_LE(text.size(), 86u) << text;
    const auto read = read_gga(fields_of(text));
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read->time, told.time) << text;
    EXPECT_EQ(read->place, told.place) << text;
    EXPECT_NEAR(*read->altitude, *told.altitude, 1e-9) << text;
  }
}

TEST(NmeaSentences, what_is_sent_is_as_long_as_the_standard_allows) {
  const DayTime time = 45319LL * 1'000'000 + 250'000;
  const Gga gga{.time = time,
                .place = NmeaPlace{481173000, 115166667},
                .quality = 1,
                .satellites = 8,
                .hdop = 0.9,
                .altitude = 545.4,
                .geoid = 0};
  EXPECT_EQ(encode_gga("GP", gga),
            sentence_of("GPGGA,123519.25,4807.038000,N,01131.000002,E,1,08,0.9,545.400,M,0.0,M,,"));
  EXPECT_LE(encode_gga("GP", gga).size(), 82u);
  const Rmc rmc{time, 20535 * kDay, true, NmeaPlace{-338076050, -1511831267}, 11.523, 84.4};
  EXPECT_EQ(encode_rmc("GN", rmc),
            sentence_of("GNRMC,123519.25,A,3348.456300,S,15110.987602,W,22.399,84.40,230326,,,A"));
  EXPECT_EQ(encode_rmc("GP", {}), sentence_of("GPRMC,,V,,,,,,,,,,N"));
  EXPECT_EQ(encode_gga("GP", {.quality = 0, .satellites = 0, .hdop = 99.9}),
            "$GPGGA,,,,,,0,00,99.9,,,,,,*71\r\n")
      << "as receivers without a fix have it";
}

}  // namespace
}  // namespace playhouse::drivers::nmea
