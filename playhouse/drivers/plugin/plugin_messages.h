#pragma once

/// What a plug-in says to the program, checked: code of others may say anything.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>
#include <span>
#include <string>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

/// "" if it is a valid message of or to number `device` of these.
std::string fault_of_message(std::span<const PluginDevice> devices, wire::MessageType type,
                             std::size_t device, std::uint8_t subtype, std::span<const std::byte> body);

/// Lines that were told, so that each is told once. Any thread.
class ToldLines {
 public:
  /// False if it was told, or too many others were.
  bool add(const std::string& line);

 private:
  std::mutex mutex_;  // guards what follows
  std::set<std::string> lines_;
};

}  // namespace playhouse::drivers
