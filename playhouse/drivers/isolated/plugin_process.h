#pragma once

/// PluginProcess: a process with the code of one plug-in: this program once more, by isolated_main.h. It has three
/// descriptors of ours, its standard output, its standard error and kPluginSocket, and no other.

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::drivers {

/// The word on the command line of such a process, which is no command for users.
inline constexpr const char* kPluginProcessWord = "isolated-plugin";
inline constexpr int kPluginSocket = 3;

class PluginProcess {
 public:
  /// Starts `program`, which calls run_isolated_plugin(); `name` is for who lists processes. Fails with the system's
  /// reason.
  static Result<std::unique_ptr<PluginProcess>> start(const std::filesystem::path& program, std::string name);
  /// Kills it.
  ~PluginProcess();
  PluginProcess(const PluginProcess&) = delete;
  PluginProcess& operator=(const PluginProcess&) = delete;

  int socket() const { return socket_; }
  /// What it prints: the end of a pipe that never blocks.
  int output() const { return output_; }
  /// A descriptor that becomes readable when the process has ended.
  int ending() const { return ending_; }

  /// It ends at once, if it has not, and whatever is still said to it is lost. Any thread.
  void kill() const;
  /// It shall end by itself: it reads the end of what we say. Any thread.
  void hang_up() const;
  struct ProcessOutcome {
    bool is_good = false;  // it ended by itself, with exit code 0
    std::string text;      // "its process was ended by SIGSEGV"
  };
  /// Waits for its end, and ends what it has started and left in its group. Once.
  ProcessOutcome wait();

 private:
  PluginProcess() = default;
  bool wait_for(siginfo_t& ended, int options) const;
  Result<void> spawn(const std::filesystem::path& program, std::string name, int socket, int output);

  pid_t process_ = -1;
  int socket_ = -1, output_ = -1, ending_ = -1;
  bool was_waited_for_ = false;
};

}  // namespace playhouse::drivers
