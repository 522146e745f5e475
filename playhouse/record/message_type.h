#pragma once

/// MessageSchema: parses a schema of encoding ros2msg, and flattens messages to table rows.
/// A message is a row; one with a list of messages is a row for each element. Values.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/record/cdr.h"

namespace playhouse::record {

/// Note of a field of model ids, in a schema: such a number has no value in a table.
inline constexpr std::string_view kNoModel = "id; 4294967295: no model";

/// Note of a list whose elements have several numbers, in a schema: their names follow, each after a space.
inline constexpr std::string_view kNumbersEach = " numbers each: ";
/// After the name of one that is a model's id, 4294967295 without a model.
inline constexpr std::string_view kModelPart = "(model)";

/// Limit on columns of a table; a list of numbers takes one for each element.
inline constexpr std::size_t kTableColumns = 1u << 18;
/// Limit on the letters of all paths of a type, nested messages included.
inline constexpr std::size_t kPathLetters = 1u << 24;
/// Limit on rows times fields of one message; a world of 100,000 robots has 2 million.
inline constexpr std::size_t kMessageValues = 1u << 22;

class MessageSchema {
 public:
  /// Fails on invalid schemas, on fields of undefined types, and on nested lists of messages.
  static Result<MessageSchema> parse(const std::string& text);

  /// Paths of the leaf fields: "transform.rotation.x".
  /// Timestamps are omitted: messages have a log time.
  const std::vector<std::string>& fields() const { return fields_; }
  /// Of all paths, those of nested messages included.
  std::size_t letters() const { return letters_; }
  /// Which fields are lists.
  const std::vector<bool>& lists() const { return lists_; }
  /// Name of a list's number: "hits.0.range", or "ranges.0" where an element is one number.
  std::string name_of(std::size_t field, std::size_t number) const;

  /// Values as text, by row and field; empty for a model that is absent (kNoModel). Fails on a message that
  /// does not match the type, or has more values than kMessageValues.
  using Rows = std::vector<std::vector<std::vector<std::string>>>;
  Result<Rows> rows(std::span<const std::byte> message) const;

 private:
  enum class FieldKind : std::uint8_t { kNumber, kText, kMessage, kTime };
  /// A number of an element of a list.
  struct ElementNumber {
    std::string name;
    bool model = false;
  };
  using Parts = std::vector<ElementNumber>;
  using SharedParts = std::shared_ptr<const Parts>;  // a message's, wherever it is within others
  struct MessageField {
    std::string name, type;
    FieldKind kind = FieldKind::kNumber;
    bool list = false;
    std::uint32_t count = 1;  // of a fixed-size array
    bool model = false;       // a model's id, or none
    SharedParts parts{};      // of an element
  };
  using Fields = std::vector<MessageField>;
  struct Walk;

  static SharedParts parts_of(std::string_view note);
  Result<void> add_line(std::string_view line, Fields& into);
  Result<void> number_fields(const std::string& type, const std::string& path, int depth, bool in_list);
  /// Number of columns of a type.
  std::size_t width_of(const std::string& type) const;
  bool read(const std::string& type, CdrReader& in, Walk& walk) const;

  std::map<std::string, Fields> types_;  // "" is the top-level type
  std::vector<std::string> fields_;
  std::vector<bool> lists_;
  std::vector<SharedParts> parts_;  // by field; null: an element is one number
  std::size_t messages_ = 0;        // nested messages, itself included
  std::size_t letters_ = 0;
};

}  // namespace playhouse::record
