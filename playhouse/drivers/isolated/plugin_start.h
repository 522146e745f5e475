#pragma once

/// What the program and the process of a plug-in tell each other before the server runs, as bodies of frames.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/drivers/isolated/plugin_frame.h"
#include "playhouse/drivers/plugin/plugin.h"

namespace playhouse::drivers {

/// Of kConfigure.
struct PluginStart {
  std::string library;  // path
  std::vector<PluginDevice> provides, uses;
};
Bytes pack(const PluginStart& start);
std::optional<PluginStart> unpack_start(std::span<const std::byte> body);

/// Of kRegistered: what a plug-in takes, without its hooks.
struct RegisteredKeys {
  std::vector<Plugin::MessageKey> commands, requests, data;
  std::vector<std::pair<Plugin::MessageKey, std::uint64_t>> passed_on;  // requests; numbers of `requires`
  double period = 0;                                                    // s
};
Bytes pack(const RegisteredKeys& keys);
/// None if they are more than messages of so many devices can be.
std::optional<RegisteredKeys> unpack_keys(std::span<const std::byte> body, std::size_t devices);

/// Functions of PluginSection, as subtypes of kAskField.
enum class FieldQuestion : std::uint8_t {
  kHas,
  kCount,
  kNumber,
  kLength,
  kAngle,
  kInteger,
  kFlag,
  kText,
  kFilename
};

/// Of kAskField.
struct FieldAsked {
  std::string key, otherwise;
};
Bytes pack(const FieldAsked& asked);
std::optional<FieldAsked> unpack_asked(std::span<const std::byte> body);

}  // namespace playhouse::drivers
