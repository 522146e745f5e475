#pragma once

/// Caller: a server's client, as drivers see it, without a dependency on sessions. Io thread.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace playhouse::device {

/// What a client may do; the role of a guest decides (docs/guests.md).
struct Rights {
  bool reads = true;    // lists devices, opens them, asks for what they are
  bool drives = true;   // commands, and requests that change a device
  bool manages = true;  // the same to the world as a whole: pause, reset, poses, spawn and removal
};

/// Number of the drivers of this program, which are no clients of the server: all of them have one.
inline constexpr std::uint32_t kDrivers = 0;

class Caller {
 public:
  /// `name` is for the log: "127.0.0.1:40312"; `serial`: see there.
  explicit Caller(std::string name, std::uint32_t serial = kDrivers)
      : serial_(serial), name_(std::move(name)), holder_(name_) {}
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller() { leave(); }

  /// Its number in its server, never reused: for data to it alone (Publication::clients).
  std::uint32_t serial() const { return serial_; }
  const std::string& name() const { return name_; }
  const Rights& rights() const { return rights_; }
  /// Whose share of a run it takes what it brings from: who has several connections has one share.
  const std::string& holder() const { return holder_; }
  /// For the server.
  void set_rights(const Rights& rights) { rights_ = rights; }
  void set_holder(std::string holder) { holder_ = std::move(holder); }

  /// Adds a task to run when the client disconnects, before this object is destroyed.
  void when_gone(std::function<void()> task) { tasks_.push_back({nullptr, std::move(task)}); }
  /// The same, at most once per owner.
  void when_gone_once(const void* owner, std::function<void()> task) {
    if (std::ranges::find(tasks_, owner, &OwnedTask::owner) == tasks_.end())
      tasks_.push_back({owner, std::move(task)});
  }
  std::size_t task_count() const { return tasks_.size(); }

  /// Enables fast detection of a dead peer: the connection ends soon after the client's machine or
  /// cable fails, rather than after the system's default timeout (net::Connection::expect_alive).
  void expect_alive() const {
    if (expect_alive_) expect_alive_();
  }
  /// Sets the implementation. For the server.
  void expect_alive_by(std::function<void()> how) { expect_alive_ = std::move(how); }

  /// The client has disconnected: runs the tasks. For the server.
  void leave() {
    for (const OwnedTask& task : std::exchange(tasks_, {})) task.run();
  }

 private:
  struct OwnedTask {
    const void* owner;  // null: none
    std::function<void()> run;
  };

  const std::uint32_t serial_;
  std::string name_, holder_;
  Rights rights_;
  std::vector<OwnedTask> tasks_;
  std::function<void()> expect_alive_;
};

}  // namespace playhouse::device
