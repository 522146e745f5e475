#pragma once

/// The simulator's model list: request and parser.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse_client/model.h"

namespace playhouse::client {

class Session;

/// Parses one answer and appends its models. `text` is untrusted.
Result<void> read_model_list(std::string_view text, std::vector<Model>& models);

/// Requests all models from an open simulation device; none if it refuses.
Result<std::optional<std::vector<Model>>> ask_models(Session& session, std::uint16_t simulation);

/// Row of the top-level ancestor of model `row` (itself if it is at the top).
std::size_t top_of(const std::vector<Model>& models, std::size_t row);

}  // namespace playhouse::client
