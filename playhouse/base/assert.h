#pragma once

/// PLAYHOUSE_ASSERT stops the program on a bug of ours, in every build. Never for bytes or files from outside.

namespace playhouse {

[[noreturn]] void assert_failed(const char* condition, const char* file, int line);

}  // namespace playhouse

#define PLAYHOUSE_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::playhouse::assert_failed(#condition, __FILE__, __LINE__))
