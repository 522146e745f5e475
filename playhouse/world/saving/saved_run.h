#pragma once

/// A saved run: all that is needed to continue a run, as one file:
/// the files of its scene, its engine, its seed and its state.
/// docs/saved-runs.md draws the layout.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::world {

struct SavedRun {
  config::SourceFiles sources;
  std::string engine;  // World::engine
  std::uint64_t seed = 1;
  std::vector<std::byte> state;  // state.h
  std::string build = {};        // that wrote it (base/version.h); of this program in encode()
};

std::vector<std::byte> encode(const SavedRun& run);
/// The complete file: a header with the number of the format, the build and the hash of the body, then the body.
std::vector<std::byte> with_head(std::span<const std::byte> body);

/// Fails on bytes that are no saved run, of another format, truncated or corrupt; errors name no file.
Result<SavedRun> decode_saved_run(std::span<const std::byte> bytes);

}  // namespace playhouse::world
