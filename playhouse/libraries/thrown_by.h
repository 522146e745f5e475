#pragma once

/// What code of a library throws, as one line.

#include <exception>
#include <string>

#include "playhouse/base/in_quotes.h"

namespace playhouse::libraries {

/// Calls `what`; the message of an exception, or nullptr. Valid as long as `text`.
template <typename Call>
const char* thrown_by(std::string& text, const Call& what) {
  try {
    what();
    return nullptr;
  } catch (const std::exception& error) {
    text = escaped(error.what());
  } catch (...) {
    text = "threw something that is not a std::exception";
  }
  return text.c_str();
}

}  // namespace playhouse::libraries
