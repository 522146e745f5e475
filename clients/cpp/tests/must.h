#pragma once

/// For test programs: the first failure prints a line and exits.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "playhouse_client/client.h"

namespace playhouse::client {

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}

template <typename T>
T must(Result<T> result) {
  if (!result) fail(result.error().line());
  return std::move(*result);
}

inline void must(const Result<void>& result) {
  if (!result) fail(result.error().line());
}

}  // namespace playhouse::client
