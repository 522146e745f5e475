#pragma once

/// The reference material beside the checkout (../shared): files and
/// recordings of the original programs. Tests that need it are skipped if all
/// of it is absent; if it is there, a missing or unreadable file is a failure.

#include <gtest/gtest.h>

#include <filesystem>

namespace playhouse {

inline std::filesystem::path reference() {
  return std::filesystem::path(PLAYHOUSE_SOURCE_DIR).parent_path() / "shared";
}

}  // namespace playhouse

#define SKIP_WITHOUT_REFERENCE()                          \
  if (!std::filesystem::exists(::playhouse::reference())) \
  GTEST_SKIP() << "no reference material at " << ::playhouse::reference()
