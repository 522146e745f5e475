#pragma once

/// Announcer: tells the local network by DNS-SD which ports of this machine are Player servers, as long as it
/// exists, through the machine's Avahi daemon. Where there is none, or it goes away, they are announced once there is
/// one (again). A name that another server has gets a number. A thread of its own talks to the daemon.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace playhouse::discovery {

struct AnnouncedServer {
  std::uint16_t port = 0;
  std::vector<std::string> texts;  // texts.h
};

/// Of the protocol family that servers are bound to.
enum class AnnouncedFamily : std::uint8_t { kIpv4, kAny };

class Announcer {
 public:
  Announcer(std::vector<AnnouncedServer> servers, AnnouncedFamily family);
  ~Announcer();
  Announcer(const Announcer&) = delete;
  Announcer& operator=(const Announcer&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::discovery
