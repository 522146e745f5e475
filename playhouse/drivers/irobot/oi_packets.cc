#include "playhouse/drivers/irobot/oi_packets.h"

#include <algorithm>
#include <numbers>

namespace playhouse::drivers::irobot {
namespace {

constexpr std::uint8_t kFirstPacket = kBumpsAndDrops;
constexpr std::uint8_t kLastOfSci = kCapacity, kLastOfCreate = kWantedLeft, kLastOf500 = 58;
constexpr std::byte kStreamMark{19};

/// What a packet holds: two bytes, with a sign or not, or one up to a value.
struct PacketForm {
  int least = 0, most = 0;
};
constexpr PacketForm kWord{0, 0xFFFF}, kSignedWord{-0x8000, 0x7FFF}, kByte{0, 0xFF}, kSignedByte{-0x80, 0x7F},
    kYesNo{0, 1};
constexpr PacketForm kForms[] = {
    {0, 31},     kYesNo,      kYesNo,      kYesNo,
    kYesNo,      kYesNo,      kYesNo,      {0, 31},  // 7 to 14
    kByte,       kByte,       kByte,       kByte,
    kSignedWord, kSignedWord, {0, 5},      kWord,  // 15 to 22
    kSignedWord, kSignedByte, kWord,       kWord,
    kWord,       kWord,       kWord,       kWord,  // 23 to 30
    kWord,       kByte,       kWord,       kByte,
    kByte,       kByte,       kByte,       kByte,  // 31 to 38
    kSignedWord, kSignedWord, kSignedWord, kSignedWord,
    kWord,       kWord,       kByte,       kWord,  // 39 to 46
    kWord,       kWord,       kWord,       kWord,
    kWord,       kByte,       kByte,       kSignedWord,  // 47 to 54
    kSignedWord, kSignedWord, kSignedWord, kByte,        // 55 to 58
};

const PacketForm& form_of(std::size_t number) {
  return kForms[number - kFirstPacket];
}
bool is_word(const PacketForm& form) {
  return form.most > 0xFF;
}

struct PacketGroup {
  std::uint8_t number;
  PacketRange packets;
};
constexpr PacketGroup kGroups[] = {
    {0, {7, 26}}, {1, {7, 16}},   {2, {17, 20}},   {3, {21, 26}},   {4, {27, 34}},   {5, {35, 42}},
    {6, {7, 42}}, {100, {7, 58}}, {101, {43, 58}}, {106, {46, 51}}, {107, {54, 58}},
};

std::uint8_t last_packet(RobotGeneration generation) {
  if (generation == RobotGeneration::kSci) return kLastOfSci;
  return generation == RobotGeneration::k500 ? kLastOf500 : kLastOfCreate;
}

double radians_of_unit(RobotGeneration generation) {
  // The SCI tells the half difference of the ways of both wheels, in mm.
  return generation == RobotGeneration::kSci ? 0.001 / half_axle(generation) : std::numbers::pi / 180;
}

}  // namespace

std::optional<PacketRange> packets_of(RobotGeneration generation, std::uint8_t number) {
  PacketRange packets{number, number};
  if (const auto group = std::ranges::find(kGroups, number, &PacketGroup::number); group != std::end(kGroups))
    packets = group->packets;
  else if (number < kFirstPacket || generation == RobotGeneration::kSci)
    return std::nullopt;
  return packets.last > last_packet(generation) ? std::nullopt : std::optional(packets);
}

std::size_t bytes_of(const PacketRange& packets) {
  std::size_t bytes = 0;
  for (std::size_t number = packets.first; number <= packets.last; ++number)
    bytes += is_word(form_of(number)) ? 2 : 1;
  return bytes;
}

void put_packets(RawBytes& bytes, const PacketRange& packets, const OiSensors& sensors) {
  for (std::size_t number = packets.first; number <= packets.last; ++number) {
    const PacketForm& form = form_of(number);
    const int value = std::clamp(sensors[number], form.least, form.most);
    if (is_word(form))
      put_16_be(bytes, value);
    else
      put_u8(bytes, value);
  }
}

std::optional<OiSensors> read_early_group(std::span<const std::byte> answer) {
  if (answer.size() != kEarlyBytes) return std::nullopt;
  OiSensors sensors{};
  std::size_t at = 0;
  for (std::size_t number = kFirstPacket; number <= kCapacity; ++number) {
    const PacketForm& form = form_of(number);
    int& value = sensors[number];
    if (is_word(form))
      value = form.least < 0 ? s16_be(answer, at) : u16_be(answer, at);
    else
      value = form.least < 0 ? static_cast<std::int8_t>(u8(answer, at)) : u8(answer, at);
    if (value > form.most) return std::nullopt;
    at += is_word(form) ? 2 : 1;
  }
  return sensors;
}

RawBytes stream_frame(std::span<const std::byte> content) {
  RawBytes frame{kStreamMark};
  put_u8(frame, static_cast<int>(content.size()));
  frame.insert(frame.end(), content.begin(), content.end());
  int sum = 0;
  for (std::size_t at = 1; at < frame.size(); ++at) sum += u8(frame, at);
  put_u8(frame, -sum & 0xFF);
  return frame;
}

double radians_of(RobotGeneration generation, double angle) {
  return angle * radians_of_unit(generation);
}

double angle_of(RobotGeneration generation, double radians) {
  return radians / radians_of_unit(generation);
}

}  // namespace playhouse::drivers::irobot
