#include "playhouse/drivers/urglaser/scip_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numbers>
#include <utility>

namespace playhouse::drivers::scip {
namespace {

constexpr std::size_t kLongestLine = 128, kLongestReply = 32768, kDataOfLine = 64;
constexpr char kZero = '0';
constexpr int kMask = (1 << kScipBits) - 1;

constexpr ScipModel kModels[] = {
    {.name = "URG-04LX"},
    {.name = "UTM-30LX",
     .least = 23,
     .most = 60000,
     .resolution = 1440,
     .first = 0,
     .last = 1080,
     .front = 540,
     .end = 1080,
     .speed = 2400,
     .no_echo = 1,
     .too_near = 2,
     .elsewhere = 5},
    {.name = "UST-10LX",
     .least = 20,
     .most = 30000,
     .resolution = 1440,
     .first = 0,
     .last = 1080,
     .front = 540,
     .end = 1080,
     .speed = 2400,
     .no_echo = 1,
     .too_near = 2,
     .elsewhere = 5},
    {.name = "UST-20LX",
     .least = 20,
     .most = 60000,
     .resolution = 1440,
     .first = 0,
     .last = 1080,
     .front = 540,
     .end = 1080,
     .speed = 2400,
     .no_echo = 1,
     .too_near = 2,
     .elsewhere = 5},
    {.name = "UXM-30LX-EW",
     .least = 23,
     .most = 60000,
     .resolution = 1440,
     .first = 0,
     .last = 760,
     .front = 380,
     .end = 760,
     .speed = 1200,
     .no_echo = 1,
     .too_near = 2,
     .elsewhere = 5},
};

void add_text(std::string& text, std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
}

bool is_checked(std::string_view line) {
  return line.size() > 1 && check_of(line.substr(0, line.size() - 1)) == line.back();
}

}  // namespace

char check_of(std::string_view line) {
  int sum = 0;
  for (const char each : line) sum += static_cast<unsigned char>(each);
  return static_cast<char>(kZero + (sum & kMask));
}

std::string encode_number(int number, int characters) {
  std::string text;
  for (int at = characters - 1; at >= 0; --at)
    text += static_cast<char>(kZero + (number >> (kScipBits * at) & kMask));
  return text;
}

std::optional<int> decode_number(std::string_view text) {
  int number = 0;
  for (const char each : text) {
    const int bits = static_cast<unsigned char>(each) - kZero;
    if (bits < 0 || bits > kMask) return std::nullopt;
    number = number << kScipBits | bits;
  }
  return number;
}

void ScipLines::add(std::span<const std::byte> bytes) {
  add_text(text_, bytes);
}

std::optional<std::string> ScipLines::next() {
  while (true) {
    const std::size_t end = text_.find_first_of("\n\r");
    if (end == std::string::npos) {
      if (text_.size() > kLongestLine) text_.clear();
      return std::nullopt;
    }
    std::string line = text_.substr(0, end);
    text_.erase(0, end + 1);
    std::erase(line, '\0');  // an original sends one behind SCIP2.0
    if (!line.empty() && line.size() <= kLongestLine) return line;
  }
}

void ScipReplies::add(std::span<const std::byte> bytes) {
  add_text(text_, bytes);
}

std::optional<ScipReply> ScipReplies::next() {
  while (true) {
    text_.erase(0, text_.find_first_not_of('\n'));
    const std::size_t end = text_.find("\n\n");
    if (end == std::string::npos) {
      if (text_.size() > kLongestReply) text_.clear();
      return std::nullopt;
    }
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= end;) {
      const std::size_t next = std::min(text_.find('\n', at), end);
      lines.push_back(text_.substr(at, next - at));
      at = next + 1;
    }
    text_.erase(0, end + 2);
    if (lines.size() < 2) continue;
    ScipReply reply{std::move(lines[0]), std::move(lines[1]), {}};
    constexpr std::size_t kCheckedStatus = 3;
    if (reply.status.size() == kCheckedStatus && is_checked(reply.status))
      reply.status.pop_back();
    else if (reply.status.size() != 1)
      continue;
    reply.lines.assign(std::make_move_iterator(lines.begin() + 2), std::make_move_iterator(lines.end()));
    return reply;
  }
}

RawBytes encode_reply(std::string_view echo, std::string_view status, const std::vector<std::string>& lines,
                      bool has_checks) {
  RawBytes bytes;
  put_text(bytes, echo);
  put_text(bytes, "\n");
  put_text(bytes, status);
  if (has_checks) put_u8(bytes, check_of(status));
  put_text(bytes, "\n");
  for (const std::string& line : lines) {
    put_text(bytes, line);
    put_text(bytes, "\n");
  }
  put_text(bytes, "\n");
  return bytes;
}

std::string named_line(std::string_view name, std::string_view value, bool has_check) {
  std::string line = fmt::format("{}:{}", name, value);
  if (has_check) line += {';', check_of(line)};
  return line;
}

std::vector<std::string> data_lines(std::string_view data, bool has_checks) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < data.size(); at += kDataOfLine) {
    lines.emplace_back(data.substr(at, kDataOfLine));
    if (has_checks) lines.back() += check_of(lines.back());
  }
  return lines;
}

std::optional<std::string> joined_data(std::span<const std::string> lines) {
  std::string data;
  for (const std::string& line : lines) {
    if (!is_checked(line)) return std::nullopt;
    data.append(line, 0, line.size() - 1);
  }
  return data;
}

std::optional<std::string> value_named(std::string_view name, std::span<const std::string> lines) {
  for (const std::string& line : lines) {
    const std::size_t end = line.rfind(';');
    if (end == std::string::npos || end + 2 != line.size() || !line.starts_with(name)) continue;
    if (line[name.size()] != ':' || check_of(std::string_view(line).substr(0, end)) != line.back()) continue;
    return line.substr(name.size() + 1, end - name.size() - 1);
  }
  return std::nullopt;
}

std::optional<int> number_named(std::string_view name, std::span<const std::string> lines) {
  const std::optional<std::string> text = value_named(name, lines);
  int number = 0;
  if (!text) return std::nullopt;
  const auto read = std::from_chars(text->data(), text->data() + text->size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  return number;
}

double ScipModel::step() const {
  return 2 * std::numbers::pi / resolution;
}

std::span<const ScipModel> scip_models() {
  return kModels;
}

std::vector<std::string> parameter_lines(const ScipModel& model) {
  const auto line = [](std::string_view name, int value) {
    return named_line(name, fmt::format("{}", value), true);
  };
  return {named_line("MODL", fmt::format("{}(Hokuyo Automatic Co.,Ltd.)", model.name), true),
          line("DMIN", model.least),
          line("DMAX", model.most),
          line("ARES", model.resolution),
          line("AMIN", model.first),
          line("AMAX", model.last),
          line("AFRT", model.front),
          line("SCAN", model.speed)};
}

std::optional<ScipModel> read_parameters(std::span<const std::string> lines) {
  constexpr int kMostStep = 9999, kMostResolution = 100000, kMostRange = 262143;
  ScipModel model;
  const auto read = [&lines](std::string_view name, int& to, int least, int most) {
    const std::optional<int> value = number_named(name, lines);
    if (!value || *value < least || *value > most) return false;
    to = *value;
    return true;
  };
  if (!read("DMIN", model.least, 0, kMostRange) || !read("DMAX", model.most, 1, kMostRange) ||
      !read("ARES", model.resolution, 1, kMostResolution) || !read("AMIN", model.first, 0, kMostStep) ||
      !read("AMAX", model.last, model.first, kMostStep) || !read("AFRT", model.front, 0, kMostStep) ||
      !read("SCAN", model.speed, 1, kMostResolution))
    return std::nullopt;
  return model;
}

std::string ScipRequest::line(std::string_view code) const {
  std::string text = fmt::format("{}{:04}{:04}{:02}", code, first, last, cluster);
  if (code.starts_with('M')) text += fmt::format("{:01}{:02}", skipped, count);
  return text;
}

}  // namespace playhouse::drivers::scip
