#pragma once

/// HostNames: allowed values of the Host header, and origins that may control the program.
/// Protects against DNS rebinding: a page loaded from a foreign name that resolves to our address.

#include <string>
#include <string_view>
#include <vector>

namespace playhouse::web_server {

class HostNames {
 public:
  /// `machine` is the machine's host name (empty: ask
  /// the system); `further` are configured names.
  HostNames(std::string machine, std::vector<std::string> further);

  const std::string& machine() const { return machine_; }

  /// True for an authority, "name" or "name:port", that is ours:
  /// localhost, an IP address, the machine's name or a further one.
  bool has(std::string_view authority) const;

  /// Same-origin check: whether a page from `origin` may control the program
  /// reached as `host`: same name and port, and https if we speak TLS. Another port may be another program.
  /// For further names the scheme may be https anyhow: a TLS proxy in front of us.
  bool may_control(std::string_view origin, const std::string& host, bool encrypted) const;

 private:
  bool is_further(std::string_view name) const;

  std::string machine_;
  std::vector<std::string> further_;
};

}  // namespace playhouse::web_server
