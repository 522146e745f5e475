#pragma once

/// Link: a learning program at the other end of a socket, which steps the world. It is the one member of a
/// world in lock-step; what it says is short, and the arrays are in shared memory (agents.h). docs/gym.md has
/// the messages.

#include <string>
#include <thread>

#include "playhouse/base/result.h"
#include "playhouse/drivers/gym/agents.h"
#include "playhouse/drivers/simulated/simulation.h"

namespace playhouse::drivers::gym {

class Link {
 public:
  /// `simulation` is in lock-step, waits for one, and outlives the link. The socket, a stream of the Unix
  /// domain, is closed with the link.
  Link(Simulation& simulation, int socket) : simulation_(simulation), socket_(socket), agents_(simulation) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link();

  /// Hands the memory over and listens. Before Simulation::run(), which ends when the other end goes. Fails
  /// on a world without agents, and where nobody is at the other end.
  Result<void> start();

 private:
  struct Request;
  void listen();
  bool receive(Request& request) const;
  void carry_out(const Request& request);
  void answer(const std::string& why_not) const;
  Result<void> send_memory() const;

  Simulation& simulation_;
  const int socket_;
  Agents agents_;
  std::string why_not_;  // the change of the step under way was not made; tick thread
  std::thread listener_;
};

}  // namespace playhouse::drivers::gym
