#include "playhouse/record/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <system_error>

#include "playhouse/base/in_quotes.h"
#include "playhouse/record/device_recording.h"
#include "playhouse/record/message_type.h"
#include "playhouse/record/messages.h"

namespace playhouse::record {
namespace {

/// Write buffers: of a table, and of all of them while each has at least the smallest one.
constexpr std::size_t kBufferBytes = 1u << 16, kLeastBufferBytes = 1u << 12, kAllBufferBytes = 1u << 26;

using SharedType = std::shared_ptr<const MessageSchema>;  // of all channels of a schema

constexpr const char* kTooManyFields = "the recording has too many fields";

/// What a type takes of the limit on fields: one for each, and for the letters of their names.
std::size_t fields_of(const MessageSchema& type) {
  constexpr std::size_t kLettersEach = 64;
  return type.fields().size() + type.letters() / kLettersEach;
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

/// File name of a topic: "/r0/ranger_0/scan" is r0.ranger_0.scan.csv.
std::string file_of(const std::string& topic) {
  std::string name = topic.starts_with('/') ? topic.substr(1) : topic;
  for (char& letter : name)
    if (letter == '/')
      letter = '.';
    else if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '_' && letter != '-')
      letter = '_';
  return name.substr(0, 200) + ".csv";
}

/// True if the four fields from here are a quaternion.
bool is_turn(const std::vector<std::string>& fields, std::size_t first) {
  const bool is_first = fields[first].ends_with("rotation.x") || fields[first].ends_with("orientation.x");
  if (!is_first) return false;
  const std::string path = fields[first].substr(0, fields[first].size() - 1);
  return fields[first + 1] == path + "y" && fields[first + 2] == path + "z" &&
         fields[first + 3] == path + "w";
}

/// The yaw of a quaternion x, y, z, w, as geom::RollPitchYaw has it. [rad]
double heading_of(std::span<const std::vector<std::string>> parts) {
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < q.size(); ++i)
    q[i] = parts[i].empty() ? 0 : std::strtod(parts[i].front().c_str(), nullptr);
  const auto [x, y, z, w] = q;
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

class Table {
 public:
  Table(SharedType type, std::string path)
      : type_(std::move(type)), path_(std::move(path)), widths_(type_->fields().size()) {
    const std::vector<std::string>& fields = type_->fields();
    for (std::size_t i = 0; i + 3 < fields.size(); ++i)
      if (is_turn(fields, i)) turns_.push_back(i);
  }

  /// First pass: measures the lengths of lists.
  Result<void> measure(const MessageRecord& message) {
    const Result<MessageSchema::Rows> rows = type_->rows(message.body);
    if (!rows) return rows.error();
    for (const auto& row : *rows)
      for (std::size_t field = 0; field < row.size(); ++field)
        widths_[field] = std::max(widths_[field], row[field].size());
    return {};
  }

  Result<void> begin() {
    std::string line = "time";
    std::size_t columns = 1;
    for (std::size_t field = 0; field < widths_.size(); ++field) {
      const std::string& name = type_->fields()[field];
      columns += widths_[field];
      if (columns > kTableColumns) return Error{escaped(path_), "cannot be written: it has too many columns"};
      if (!type_->lists()[field]) line += "," + cell(name);
      for (std::size_t i = 0; type_->lists()[field] && i < widths_[field]; ++i)
        line += "," + cell(type_->name_of(field, i));
    }
    for (const std::size_t turn : turns_) {
      const std::string& x = type_->fields()[turn];
      line += "," + cell(x.substr(0, x.size() - 1) + "heading");
    }
    text_ = std::move(line) + "\n";
    return write("wb");
  }

  /// Writes once there is as much as the buffer takes.
  Result<void> add(const MessageRecord& message, std::size_t buffer_bytes) {
    const Result<MessageSchema::Rows> rows = type_->rows(message.body);
    if (!rows) return rows.error();
    for (const auto& row : *rows) {
      text_ += fmt::format("{}", static_cast<double>(message.publish_time) / 1e9);
      for (std::size_t field = 0; field < row.size(); ++field) {
        const std::size_t width = type_->lists()[field] ? widths_[field] : 1;
        for (std::size_t i = 0; i < width; ++i)
          text_ += i < row[field].size() ? "," + cell(row[field][i]) : ",";
      }
      for (const std::size_t turn : turns_)
        text_ += fmt::format(",{}", heading_of(std::span(row).subspan(turn, 4)));
      text_ += "\n";
      ++rows_;
      if (text_.size() >= buffer_bytes)
        if (const Result<void> written = write("ab"); !written) return written;
    }
    return {};
  }

  Result<void> end() { return write("ab"); }
  std::uint64_t rows() const { return rows_; }

 private:
  Result<void> write(const char* mode) {
    std::FILE* const file = std::fopen(path_.c_str(), mode);
    bool written = file != nullptr && std::fwrite(text_.data(), 1, text_.size(), file) == text_.size();
    int code = errno;
    if (file != nullptr && std::fclose(file) != 0 && written) {
      written = false;
      code = errno;
    }
    if (!written) return Error{escaped(path_), "cannot be written: " + std::generic_category().message(code)};
    text_.clear();
    // A long row, or the first one, is no reason to keep as much for each table.
    if (text_.capacity() > 2 * kBufferBytes) text_.shrink_to_fit();
    return {};
  }

  const SharedType type_;
  const std::string path_;
  std::vector<std::size_t> widths_;  // by field
  std::vector<std::size_t> turns_;   // first fields of quaternions
  std::string text_;
  std::uint64_t rows_ = 0;
};

class Export {
 public:
  Export(const ByteSource& source, std::string folder, std::size_t most_fields)
      : source_(source), folder_(std::move(folder)), most_fields_(most_fields) {}

  Result<CsvTables> run() {
    if (const Result<void> measured =
            read([](Table& table, const MessageRecord& message) { return table.measure(message); });
        !measured)
      return measured.error();
    if (tables_.empty() && is_of_devices_)
      return only_of_devices("no tables, which are made of messages of ROS 2");
    std::error_code fault;
    std::filesystem::create_directories(folder_, fault);
    if (fault) return Error{escaped(folder_), "cannot be made: " + fault.message()};
    for (auto& [channel, table] : tables_)
      if (const Result<void> begun = table.begin(); !begun) return begun.error();
    const std::size_t buffer_bytes = std::clamp(kAllBufferBytes / std::max<std::size_t>(tables_.size(), 1),
                                                kLeastBufferBytes, kBufferBytes);
    if (const Result<void> added = read(
            [=](Table& table, const MessageRecord& message) { return table.add(message, buffer_bytes); });
        !added)
      return added.error();
    for (auto& [channel, table] : tables_) {
      if (const Result<void> ended = table.end(); !ended) return ended.error();
      done_.rows += table.rows();
    }
    done_.tables = tables_.size();
    return done_;
  }

 private:
  template <typename Take>
  Result<void> read(const Take& take) {
    McapReader reader(source_);
    const auto end =
        reader.read({.message = [&](const Channel& channel, const MessageRecord& message) -> Result<void> {
                       Table* const table = table_of(channel, reader);
                       return table == nullptr ? Result<void>() : take(*table, message);
                     },
                     .attachment = {}});
    if (!end) return end.error();
    done_.cut = *end == McapReader::FileEnd::kCut;
    is_of_devices_ = is_of_devices(reader);
    return {};
  }

  /// Null if the channel has no table.
  Table* table_of(const Channel& channel, const McapReader& reader) {
    if (const auto found = tables_.find(channel.id); found != tables_.end()) return &found->second;
    if (!seen_.insert(channel.id).second) return nullptr;
    const auto schema = reader.schemas().find(channel.schema);
    const bool is_known = schema != reader.schemas().end() && schema->second.encoding == kSchemaEncoding &&
                          channel.encoding == kMessageEncoding;
    if (!is_known) return leave_out(channel, "its messages are not those of ROS 2");
    for (const char* const bytes : {kState, kChange, kImage, kPointCloud})
      if (schema->second.name == bytes) return nullptr;
    const Result<SharedType>& type = type_of(schema->second);
    if (!type) return leave_out(channel, type.error().text);
    if (fields_ += fields_of(**type); fields_ > most_fields_) return leave_out(channel, kTooManyFields);
    // Another topic may have the name with the number, too.
    std::string file = file_of(channel.topic);
    while (!files_.insert(file).second)
      file = fmt::format("{}.{}.csv", file.substr(0, file.size() - 4), channel.id);
    return &tables_.emplace(channel.id, Table(*type, folder_ + "/" + file)).first->second;
  }

  /// Parsed once for all channels of the schema.
  const Result<SharedType>& type_of(const Schema& schema) {
    const auto found = types_.find(schema.id);
    return found != types_.end() ? found->second : types_.emplace(schema.id, parsed(schema)).first->second;
  }

  Result<SharedType> parsed(const Schema& schema) {
    if (fields_ > most_fields_) return Error{{}, kTooManyFields};
    Result<MessageSchema> type = MessageSchema::parse(schema.text);
    if (!type) return type.error();
    if (fields_ += fields_of(*type); fields_ > most_fields_) return Error{{}, kTooManyFields};
    return SharedType(std::make_shared<const MessageSchema>(std::move(*type)));
  }

  Table* leave_out(const Channel& channel, const std::string& why) {
    done_.left_out.push_back(fmt::format("channel {}: {}", in_quotes(channel.topic), why));
    return nullptr;
  }

  const ByteSource& source_;
  const std::string folder_;
  const std::size_t most_fields_;
  std::size_t fields_ = 0;                             // of all tables and types
  std::map<std::uint16_t, Result<SharedType>> types_;  // by schema
  std::map<std::uint16_t, Table> tables_;
  std::set<std::uint16_t> seen_;
  std::set<std::string> files_;
  bool is_of_devices_ = false;
  CsvTables done_;
};

}  // namespace

Result<CsvTables> write_csv(const ByteSource& source, const std::string& folder, std::size_t most_fields) {
  return Export(source, folder, most_fields).run();
}

}  // namespace playhouse::record
