#include "playhouse/wire/codec.h"

namespace playhouse::wire {

std::string c_string(std::string_view text) {
  std::string raw(text);
  raw.push_back('\0');
  return raw;
}

std::string_view text(std::string_view raw) {
  return raw.substr(0, raw.find('\0'));
}

}  // namespace playhouse::wire
