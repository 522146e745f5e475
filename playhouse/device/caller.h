#pragma once

/// Caller: a client of the server as drivers see it, which know no sessions. Io thread.

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
  void when_gone(std::function<void()> task) { tasks_.push_back(std::move(task)); }

  /// The client has gone. For the server.
  void leave() {
    for (const std::function<void()>& task : std::exchange(tasks_, {})) task();
  }

 private:
  std::string name_;
  std::vector<std::function<void()>> tasks_;
};

}  // namespace playhouse::device
