#pragma once

/// PropertyBag: a driver's named settings, which clients read and change by the property requests that every
/// interface has (GET and SET of INT, DBL, STR and BOOL). Any thread.

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"

namespace playhouse::device {

using PropertyValue = std::variant<std::int32_t, double, std::string, bool>;

enum class PropertyAccess : std::uint8_t { kReadWrite, kReadOnly };

class PropertyBag {
 public:
  /// Adds a property; its type is that of the value, for good. Asserts that the key is new.
  void declare(std::string key, PropertyValue value, PropertyAccess access = PropertyAccess::kReadWrite);

  /// Nothing if there is no such property.
  std::optional<PropertyValue> get(const std::string& key) const;
  /// For the driver, which may change read-only properties too. Fails on an unknown key and on another type.
  Result<void> set(const std::string& key, PropertyValue value);

  /// True for the eight property requests.
  static bool is_property_request(const Message& message);
  /// Answers one of them: GET gives the value, SET an empty ACK; an unknown key, another type, a read-only
  /// property or a body that does not decode gives NACK.
  void request(const Message& message, Replier replier);

 private:
  struct Property {
    PropertyValue value;
    PropertyAccess access;
  };
  /// For a client: false on an unknown key, another type or a read-only property.
  bool change(const std::string& key, PropertyValue value);
  template <typename Request, typename T>
  void serve_get(const Message& message, Replier& replier) const;
  template <typename Request, typename T>
  void serve_set(const Message& message, Replier& replier);

  mutable std::mutex mutex_;
  std::map<std::string, Property> properties_;
};

}  // namespace playhouse::device
