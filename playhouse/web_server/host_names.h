#pragma once

/// HostNames: the names under which browsers may call this program, and which pages may control it. Whoever
/// owns another name can make it point at us once their page is in somebody's browser (DNS rebinding).

#include <string>
#include <string_view>
#include <vector>

namespace playhouse::web_server {

class HostNames {
 public:
  /// `machine` is what the machine calls itself (empty: the system is asked); `further` are those that we
  /// were told.
  HostNames(std::string machine, std::vector<std::string> further);

  const std::string& machine() const { return machine_; }

  /// Whether an authority, "name" or "name:port", is ours: localhost, an address, the machine's own name or a
  /// further one.
  bool has(std::string_view authority) const;

  /// Whether a page from `origin` may watch and control the program that its browser calls `host`: it came
  /// from here, the same name and port. Another port is another program, whoever's that is. In front of a
  /// further name there may be a proxy that speaks TLS.
  bool may_control(std::string_view origin, const std::string& host) const;

 private:
  bool is_further(std::string_view name) const;

  std::string machine_;
  std::vector<std::string> further_;
};

}  // namespace playhouse::web_server
