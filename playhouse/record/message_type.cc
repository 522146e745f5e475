#include "playhouse/record/message_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "playhouse/base/in_quotes.h"

namespace playhouse::record {
namespace {

constexpr int kDepth = 16;                       // nesting of messages
constexpr std::uint32_t kFixedCount = 1u << 16;  // limit on fixed-size arrays
constexpr std::size_t kPartLetters = 64, kMostParts = 64;
constexpr std::string_view kNoId = "4294967295";
constexpr std::string_view kTime = "builtin_interfaces/Time";

constexpr std::array<std::string_view, 13> kNumbers{"bool",   "byte",    "char",   "int8",   "uint8",
                                                    "int16",  "uint16",  "int32",  "uint32", "int64",
                                                    "uint64", "float32", "float64"};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

/// Short form: "pkg/msg/Name" -> "pkg/Name".
std::string short_name(std::string_view type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string_view::npos
             ? std::string(type)
             : std::string(type.substr(0, at)) + "/" + std::string(type.substr(at + 5));
}

std::string number_text(const std::string& type, CdrReader& in) {
  if (type == "float64") return fmt::format("{}", in.number<double>());
  if (type == "float32") return fmt::format("{}", in.number<float>());
  if (type == "int64") return fmt::format("{}", in.number<std::int64_t>());
  if (type == "uint64") return fmt::format("{}", in.number<std::uint64_t>());
  if (type == "int32") return fmt::format("{}", in.number<std::int32_t>());
  if (type == "uint32") return fmt::format("{}", in.number<std::uint32_t>());
  if (type == "int16") return fmt::format("{}", in.number<std::int16_t>());
  if (type == "uint16") return fmt::format("{}", in.number<std::uint16_t>());
  if (type == "int8") return fmt::format("{}", int{in.number<std::int8_t>()});
  return fmt::format("{}", unsigned{in.number<std::uint8_t>()});
}

}  // namespace

/// Rows under construction: fields outside the list of messages are copied into each row.
struct MessageSchema::Walk {
  std::vector<std::vector<std::string>> outside;  // by field
  std::vector<std::vector<std::string>>* to = nullptr;
  Rows rows;
  bool has_list = false;
  bool is_too_large = false;
  std::size_t field = 0;  // next field
};

/// Null without names, and for names too many or too long.
MessageSchema::SharedParts MessageSchema::parts_of(std::string_view note) {
  const std::size_t at = note.find(kNumbersEach);
  if (at == std::string_view::npos) return nullptr;
  std::string_view names = note.substr(at + kNumbersEach.size());
  names = trimmed(names.substr(0, names.find(';')));
  Parts parts;
  while (!names.empty()) {
    std::string_view name = names.substr(0, names.find(' '));
    names = trimmed(names.substr(name.size()));
    const bool model = name.ends_with(kModelPart);
    if (model) name.remove_suffix(kModelPart.size());
    if (name.size() > kPartLetters || parts.size() == kMostParts) return nullptr;
    parts.push_back({std::string(name), model});
  }
  return parts.empty() ? nullptr : std::make_shared<const Parts>(std::move(parts));
}

std::string MessageSchema::name_of(std::size_t field, std::size_t number) const {
  if (parts_[field] == nullptr) return fmt::format("{}.{}", fields_[field], number);
  const Parts& parts = *parts_[field];
  return fmt::format("{}.{}.{}", fields_[field], number / parts.size(), parts[number % parts.size()].name);
}

Result<void> MessageSchema::add_line(std::string_view line, Fields& into) {
  const std::size_t note = std::min(line.find('#'), line.size());
  const bool model = line.substr(note).find(kNoModel) != std::string_view::npos;
  SharedParts parts = parts_of(line.substr(note));
  line = trimmed(line.substr(0, note));
  if (line.empty()) return {};
  const std::size_t space = line.find_first_of(" \t");
  if (space == std::string_view::npos)
    return Error{{}, "has a schema with an invalid line: " + in_quotes(line)};
  std::string_view type = line.substr(0, space);
  std::string_view name = trimmed(line.substr(space));
  if (name.find('=') != std::string_view::npos) return {};  // a constant
  name = name.substr(0, name.find_first_of(" \t"));         // what follows is a default
  MessageField field;
  field.name = name;
  if (const std::size_t bracket = type.find('['); bracket != std::string_view::npos) {
    const std::string_view count = type.substr(bracket + 1, type.size() - bracket - 2);
    field.list = count.empty() || count.starts_with("<=");
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), field.count);
    if (!field.list &&
        (error != std::errc() || end != count.data() + count.size() || field.count > kFixedCount))
      return Error{{},
                   fmt::format("has a schema with an invalid array size: {}; up to {} is valid",
                               in_quotes(line), kFixedCount)};
    type = type.substr(0, bracket);
  }
  type = type.substr(0, type.find("<="));
  field.type = short_name(type);
  field.kind = field.type == kTime                                   ? FieldKind::kTime
               : type == "string"                                    ? FieldKind::kText
               : std::ranges::find(kNumbers, type) != kNumbers.end() ? FieldKind::kNumber
                                                                     : FieldKind::kMessage;
  field.model = model && field.type == "uint32";
  if (field.list && field.kind == FieldKind::kNumber) field.parts = std::move(parts);
  into.push_back(std::move(field));
  return {};
}

Result<MessageSchema> MessageSchema::parse(const std::string& text) {
  MessageSchema type;
  std::string name;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    if (line.starts_with("MSG:")) {
      name = short_name(trimmed(line.substr(4)));
      type.types_.try_emplace(name);  // even without fields
      continue;
    }
    if (line.starts_with("===")) continue;
    if (const Result<void> added = type.add_line(line, type.types_[name]); !added) return added.error();
  }
  type.types_.try_emplace("");
  if (const Result<void> numbered = type.number_fields("", "", 0, false); !numbered) return numbered.error();
  return type;
}

Result<void> MessageSchema::number_fields(const std::string& type, const std::string& path, int depth,
                                          bool in_list) {
  const auto found = types_.find(type);
  if (found == types_.end()) return Error{{}, "has a schema that lacks type " + in_quotes(type)};
  if (++messages_ > kTableColumns) return Error{{}, "has a schema with too many messages in each other"};
  if (depth > kDepth) return Error{{}, "has a schema of messages too deep in each other"};
  bool has_list = false;
  for (const MessageField& field : found->second) {
    if (field.kind == FieldKind::kTime) continue;
    if (fields_.size() >= kTableColumns) return Error{{}, "has a schema with too many fields"};
    letters_ += path.size() + field.name.size();
    if (letters_ > kPathLetters) return Error{{}, "has a schema with names that are too long in each other"};
    if (field.kind != FieldKind::kMessage) {
      fields_.push_back(path + field.name);
      lists_.push_back(field.list || field.count != 1);
      parts_.push_back(field.parts);
      continue;
    }
    if (field.list && (in_list || depth > 0 || has_list))
      return Error{{}, "has a schema with lists of messages in each other, or two"};
    if (!field.list && field.count != 1) return Error{{}, "has a schema with an array of messages"};
    has_list = has_list || field.list;
    const Result<void> inner =
        number_fields(field.type, path + field.name + ".", depth + 1, in_list || field.list);
    if (!inner) return inner;
  }
  return {};
}

std::size_t MessageSchema::width_of(const std::string& type) const {
  std::size_t width = 0;
  for (const MessageField& field : types_.at(type))
    if (field.kind != FieldKind::kTime) width += field.kind == FieldKind::kMessage ? width_of(field.type) : 1;
  return width;
}

bool MessageSchema::read(const std::string& type, CdrReader& in, Walk& walk) const {
  for (const MessageField& field : types_.at(type)) {
    if (!in.ok()) return false;
    if (field.kind == FieldKind::kMessage && !field.list) {
      if (!read(field.type, in, walk)) return false;
      continue;
    }
    const std::uint32_t count = field.list ? in.number<std::uint32_t>() : field.count;
    if (!in.ok() || (field.list && count > in.left())) return false;
    if (field.kind == FieldKind::kMessage) {
      walk.has_list = true;
      if (count > kMessageValues / (fields_.size() + messages_)) walk.is_too_large = true;
      if (walk.is_too_large) return false;
      const std::size_t first = walk.field;
      for (std::uint32_t i = 0; i < count; ++i) {
        walk.rows.emplace_back(fields_.size());
        walk.to = &walk.rows.back();
        walk.field = first;
        if (!read(field.type, in, walk)) return false;
      }
      walk.to = &walk.outside;
      walk.field = first + width_of(field.type);
      continue;
    }
    if (field.kind == FieldKind::kTime) {
      for (std::uint32_t i = 0; i < count && in.ok(); ++i) in.time();
      continue;
    }
    std::vector<std::string>& values = (*walk.to)[walk.field++];
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
      values.push_back(field.kind == FieldKind::kText ? in.text() : number_text(field.type, in));
      const bool model = field.parts ? (*field.parts)[i % field.parts->size()].model : field.model;
      if (model && values.back() == kNoId) values.back().clear();
    }
  }
  return in.ok();
}

Result<MessageSchema::Rows> MessageSchema::rows(std::span<const std::byte> message) const {
  CdrReader in(message);
  Walk walk;
  walk.outside.resize(fields_.size());
  walk.to = &walk.outside;
  const bool good = read("", in, walk);
  if (good && walk.has_list) {
    std::size_t repeated = 0;  // values copied into each row
    for (const std::vector<std::string>& values : walk.outside) repeated += values.size();
    walk.is_too_large = repeated > 0 && walk.rows.size() > kMessageValues / repeated;
  }
  if (walk.is_too_large) return Error{{}, "has a message of too many values"};
  if (!good) return Error{{}, "has a message that does not match its schema"};
  if (!walk.has_list) return Rows{std::move(walk.outside)};
  for (auto& row : walk.rows)
    for (std::size_t field = 0; field < fields_.size(); ++field)
      if (row[field].empty()) row[field] = walk.outside[field];
  return std::move(walk.rows);
}

}  // namespace playhouse::record
