#include "playhouse/replicate/command.h"

#include <fmt/format.h>

#include <boost/json.hpp>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/command_members.h"

namespace playhouse::replicate {

namespace json = boost::json;

Result<Command> parse_command(std::string_view text) {
  if (text.size() > limits::kViewerCommandBytes)
    return Error{"", fmt::format("a command of more than {} bytes", limits::kViewerCommandBytes)};
  json::parse_options options;
  options.max_depth = 2;
  json::error_code error;
  const json::value value = json::parse(text, error, {}, options);
  if (error) return Error{"", "not JSON: " + error.message()};
  if (!value.is_object()) return Error{"", "a command is a JSON object"};
  Members in(value.get_object());
  return in.finish(read_command(in));
}

}  // namespace playhouse::replicate
