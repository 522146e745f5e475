#pragma once

/// Result<T>: a value, or an Error with text and position. For external faults (bad files, bad
/// packets, lost peers); bugs are PLAYHOUSE_ASSERTs. Shaped like std::expected, which C++20 lacks.

#include <string>
#include <utility>
#include <variant>

#include "playhouse/base/assert.h"

namespace playhouse {

/// An error. `where` is "file:line", a peer's address, or empty.
struct Error {
  std::string where;
  std::string text;

  /// One-line message: "where: text".
  std::string line() const { return where.empty() ? text : where + ": " + text; }
};

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    PLAYHOUSE_ASSERT(ok());
    return *std::get_if<0>(&state_);
  }
  /// By value, so that `for (x : *list())` does not iterate over a destroyed temporary.
  T value() && {
    PLAYHOUSE_ASSERT(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  const T& value() const& {
    PLAYHOUSE_ASSERT(ok());
    return *std::get_if<0>(&state_);
  }
  const Error& error() const {
    PLAYHOUSE_ASSERT(!ok());
    return *std::get_if<1>(&state_);
  }
  T& operator*() & { return value(); }
  T operator*() && { return std::move(*this).value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  bool ok() const { return ok_; }
  explicit operator bool() const { return ok_; }
  const Error& error() const {
    PLAYHOUSE_ASSERT(!ok_);
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace playhouse
