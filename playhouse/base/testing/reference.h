#pragma once

/// The original programs, for tests that compare with them. Recordings are in this tree. Stage's own world
/// files are not, for they are under the GPL: tests that need them are skipped where nobody has put them;
/// where they are, a missing or unreadable file is a failure.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace playhouse {

/// Sessions of Player and traces of Stage; tests/reference/README.md describes them.
inline std::filesystem::path reference() {
  return std::filesystem::path(PLAYHOUSE_SOURCE_DIR) / "tests/reference";
}

/// The source of Stage 4.3, of which tests read worlds/, tests/ and examples/: the folder that
/// PLAYHOUSE_STAGE names, else the copy beside the checkout; as in tests/compat/test_recorded_sessions.py.
/// Empty: neither is.
inline std::filesystem::path stage_source() {
  if (const char* const named = std::getenv("PLAYHOUSE_STAGE"); named && *named) return named;
  const auto beside = std::filesystem::path(PLAYHOUSE_SOURCE_DIR).parent_path() / "shared/stage";
  return std::filesystem::exists(beside) ? beside / "worlds-data" : std::filesystem::path();
}

}  // namespace playhouse

#define SKIP_WITHOUT_STAGE()                                                              \
  if (::playhouse::stage_source().empty())                                                \
  GTEST_SKIP() << "needs Stage's own worlds: git clone https://github.com/rtv/Stage "     \
                  "(281ed731 is 4.3.0), and PLAYHOUSE_STAGE=the folder"
