#pragma once

/// Caller: a client of the server as drivers see it, which know no sessions. Io thread.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace playhouse::device {

class Caller {
 public:
  /// `name` is for log lines: "127.0.0.1:40312".
  explicit Caller(std::string name) : name_(std::move(name)) {}
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller() { leave(); }

  const std::string& name() const { return name_; }

  /// Runs once the client has gone, before this object has.
  void when_gone(std::function<void()> task) { tasks_.push_back({nullptr, std::move(task)}); }
  /// The same, unless there is one of this owner already.
  void when_gone_once(const void* owner, std::function<void()> task) {
    if (std::ranges::find(tasks_, owner, &Task::owner) == tasks_.end())
      tasks_.push_back({owner, std::move(task)});
  }
  std::size_t task_count() const { return tasks_.size(); }

  /// From now on its connection ends soon after the client's machine or cable fails, and not after as long as
  /// the system likes to wait (net::Connection::expect_alive).
  void expect_alive() const {
    if (expect_alive_) expect_alive_();
  }
  /// How that is done. For the server.
  void expect_alive_by(std::function<void()> how) { expect_alive_ = std::move(how); }

  /// The client has gone. For the server.
  void leave() {
    for (const Task& task : std::exchange(tasks_, {})) task.run();
  }

 private:
  struct Task {
    const void* owner;  // null: none
    std::function<void()> run;
  };

  std::string name_;
  std::vector<Task> tasks_;
  std::function<void()> expect_alive_;
};

}  // namespace playhouse::device
