#pragma once

/// Link: the socket of a learning program that steps the world. The
/// only member of a world in lock-step; messages are small, arrays are
/// in shared memory (agents.h). docs/gym.md specifies the messages.

#include <string>
#include <thread>

#include "playhouse/base/result.h"
#include "playhouse/bridge/gym/agents.h"
#include "playhouse/run/simulation.h"

namespace playhouse::drivers::gym {

class Link {
 public:
  /// `simulation` must be in lock-step with one member, and must outlive
  /// the link. The socket, a Unix domain stream, is closed with the link.
  Link(run::Simulation& simulation, int socket)
      : simulation_(simulation), socket_(socket), agents_(simulation) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link();

  /// Sends the memory's descriptor and starts listening. Before Simulation::run(), which
  /// returns when the peer disconnects. Fails on a world without agents, or without a peer.
  Result<void> start();

 private:
  struct Request;
  void listen();
  bool receive(Request& request) const;
  void carry_out(const Request& request);
  void answer(const std::string& why_not) const;
  Result<void> send_memory() const;

  run::Simulation& simulation_;
  const int socket_;
  Agents agents_;
  std::string why_not_;  // error of the change in the current step; tick thread
  std::thread listener_;
};

}  // namespace playhouse::drivers::gym
