#include "playhouse/drivers/ptu46/ptu_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers::ptu {
namespace {

constexpr std::size_t kLongestReply = 200, kLongestCommand = 60;

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Of a whole text; none if it is no number.
std::optional<double> whole_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  constexpr double kMost = 1e8;
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !(std::fabs(value) < kMost))
    return std::nullopt;
  return value;
}

/// Of a limit, without a blank before its letter as a refusal has one.
void leave_out_events(std::string& line) {
  for (const std::string_view event : {"!P", "!T"})
    for (std::size_t at = line.find(event); at != std::string::npos; at = line.find(event))
      line.erase(at, event.size());
}

PtuReply read_reply(std::string_view line) {
  PtuReply reply{line.starts_with('*'), {}};
  const std::size_t last = line.find_last_not_of(" \t");
  const std::string_view text = line.substr(0, last + 1);
  const std::size_t blank = text.find_last_of(" *");
  if (reply.is_good && blank != std::string_view::npos) reply.value = whole_number(text.substr(blank + 1));
  return reply;
}

}  // namespace

void PtuReplyReader::add(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) text_.push_back(static_cast<char>(byte));
}

/// What a unit with an echo repeats before its reply is left out.
std::optional<PtuReply> PtuReplyReader::next() {
  while (true) {
    const std::size_t end = text_.find_first_of("\r\n");
    if (end == std::string::npos) {
      if (text_.size() > kLongestReply) text_.clear();
      return std::nullopt;
    }
    std::string line = text_.substr(0, end);
    text_.erase(0, end + 1);
    leave_out_events(line);
    const std::size_t begin = line.find_first_of("*!");
    if (begin != std::string::npos) return read_reply(std::string_view(line).substr(begin));
  }
}

void PtuCommandReader::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<PtuCommand> PtuCommandReader::next() {
  const auto is_end = [](std::byte byte) {
    return byte == std::byte{' '} || byte == std::byte{'\r'} || byte == std::byte{'\n'};
  };
  bytes_.erase(bytes_.begin(), std::ranges::find_if_not(bytes_, is_end));
  if (bytes_.empty()) return std::nullopt;
  if (u8(bytes_, 0) >= kFirstOpcode) return next_binary();
  const auto end = std::ranges::find_if(bytes_, is_end);
  if (end == bytes_.end()) {
    if (bytes_.size() > kLongestCommand) bytes_.clear();
    return std::nullopt;
  }
  PtuCommand command;
  for (auto at = bytes_.begin(); at <= end; ++at) command.text.push_back(static_cast<char>(*at));
  bytes_.erase(bytes_.begin(), end + 1);
  if (command.text.size() > kLongestCommand) return PtuCommand{};
  const std::string_view text = std::string_view(command.text).substr(0, command.text.size() - 1);
  const auto letters = static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin());
  for (const char letter : text.substr(0, letters))
    command.letters.push_back(static_cast<char>(letter & ~0x20));
  command.number = whole_number(text.substr(letters));
  if (letters < text.size() && !command.number) command.letters.clear();
  return command;
}

std::optional<PtuCommand> PtuCommandReader::next_binary() {
  PtuCommand command;
  command.opcode = u8(bytes_, 0);
  const std::size_t count = data_of(command.opcode);
  if (bytes_.size() <= count) return std::nullopt;
  const auto begin = bytes_.begin() + 1, end = begin + static_cast<std::ptrdiff_t>(count);
  command.data.assign(begin, end);
  bytes_.erase(bytes_.begin(), end);
  return command;
}

std::size_t data_of(std::uint8_t opcode) {
  if (opcode <= 142) return 2;
  if (opcode >= 197 && opcode <= 200) return 1;
  return opcode == 201 || opcode == 202 ? 4 : 0;
}

std::string encode_command(std::string_view letters, std::optional<long> number) {
  return std::string(letters) + (number ? std::to_string(*number) : "") + " ";
}

double radians_of(double counts, double resolution) {
  return geom::radians(counts * resolution / kArcSeconds);
}

double counts_of(double radians, double resolution) {
  return geom::degrees(radians) * kArcSeconds / resolution;
}

}  // namespace playhouse::drivers::ptu
