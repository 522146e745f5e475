#pragma once

/// MessageType: what a schema of encoding ros2msg says of its messages, and their values as flat rows: for
/// tables. A message is a row; one that has a list of messages is a row for each of those. Values.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/record/cdr.h"

namespace playhouse::record {

/// Columns of a table, at most; a list of numbers has one for each.
inline constexpr std::size_t kTableColumns = 1u << 18;
/// Rows of one message times its fields, at most; a world of 100,000 robots has 2 million.
inline constexpr std::size_t kMessageValues = 1u << 22;

class MessageType {
 public:
  /// Fails on what is no such text, on fields of types that it lacks, and on lists of messages within others.
  static Result<MessageType> parse(const std::string& text);

  /// Fields that are no message, by their path: "transform.rotation.x". Times are left out: a recording's
  /// messages have one of their own.
  const std::vector<std::string>& fields() const { return fields_; }
  /// Which of them are lists.
  const std::vector<bool>& lists() const { return lists_; }

  /// By row and field, the values as text. Fails on a message that is none of the type, and on one with more
  /// rows than kMessageValues allows.
  using Rows = std::vector<std::vector<std::vector<std::string>>>;
  Result<Rows> rows(std::span<const std::byte> message) const;

 private:
  enum class Kind : std::uint8_t { kNumber, kText, kMessage, kTime };
  struct Field {
    std::string name, type;
    Kind kind = Kind::kNumber;
    bool list = false;
    std::uint32_t count = 1;  // of what is no list
  };
  using Fields = std::vector<Field>;
  struct Walk;

  Result<void> add_line(std::string_view line, Fields& into);
  Result<void> number_fields(const std::string& type, const std::string& path, int depth, bool in_list);
  /// Columns that a message of the type has.
  std::size_t width_of(const std::string& type) const;
  bool read(const std::string& type, CdrReader& in, Walk& walk) const;

  std::map<std::string, Fields> types_;  // "" is the message's own
  std::vector<std::string> fields_;
  std::vector<bool> lists_;
  std::size_t messages_ = 0;  // in it, itself included
};

}  // namespace playhouse::record
