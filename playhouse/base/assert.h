#pragma once

/// PLAYHOUSE_ASSERT aborts on a bug of ours, in every build. Never use it on bytes or files from outside.

namespace playhouse {

[[noreturn]] void assert_failed(const char* condition, const char* file, int line);

}  // namespace playhouse

#define PLAYHOUSE_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::playhouse::assert_failed(#condition, __FILE__, __LINE__))
