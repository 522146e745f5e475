#pragma once

/// IsolatedPlugin: a plug-in whose code runs in a process of its own, for a PluginShell that takes it for any other:
/// a hook is a call of that process, which comes back, throws what the plug-in threw, or throws how the process ended.
/// What the process says in between is carried out by a thread that reads it. It may say anything: the program leaves
/// out what is no valid message, and what breaks the rules of the exchange ends the process.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>

#include "playhouse/drivers/isolated/plugin_frame.h"
#include "playhouse/drivers/isolated/plugin_process.h"
#include "playhouse/drivers/plugin/plugin.h"

namespace playhouse::drivers {

class IsolatedPlugin final : public Plugin {
 public:
  struct IsolatedOptions {
    std::filesystem::path program;    // of PluginProcess::start()
    std::filesystem::path library;    // which the process loads
    std::string name;                 // for lines of the log
    std::function<bool()> has_world;  // whether time is a world's
  };
  static Result<std::unique_ptr<IsolatedPlugin>> start(IsolatedOptions options);
  ~IsolatedPlugin() override;

  /// Called once with how the process ended, unless it was to: on a thread of its own. After configure().
  using ProcessEnded = std::function<void(const std::string& why)>;
  void watch(ProcessEnded ended);

  // Any thread.

  /// Ends the process at once: calls throw `why`.
  void kill(const std::string& why);
  /// No more calls: the process ends by itself, and is killed at `until` otherwise. Returns when it has ended.
  void end(std::chrono::steady_clock::time_point until);

  // Plugin

  void configure(const PluginSection& section) override;
  void open() override;
  void close() override { call({.kind = PluginFrameKind::kClose}); }
  void step() override { call({.kind = PluginFrameKind::kStep}); }

 private:
  using Lock = std::unique_lock<std::mutex>;
  using TakenFrame = Result<void>;  // or which rule was broken

  IsolatedPlugin(IsolatedOptions options, std::unique_ptr<PluginProcess> process);
  void call(const PluginFrame& frame);
  void begin();
  void return_from_call(const Lock&);
  void call_request(MessageKey key, std::span<const std::byte> body, PluginReply reply);

  void read();
  bool read_some(int milliseconds);
  bool take_frames();
  void tell_lines();
  void tell_line();
  void has_ended();

  TakenFrame take(PluginFrame& frame);
  TakenFrame tell(const PluginFrame& answer);
  TakenFrame take_registered(const PluginFrame& frame);
  TakenFrame take_returned(const PluginFrame& frame);
  TakenFrame tell_field(const PluginFrame& frame);
  TakenFrame take_question(const PluginFrame& frame);
  TakenFrame take_reply(PluginFrame& frame);

  const IsolatedOptions options_;
  const std::unique_ptr<PluginProcess> process_;
  FrameOutput out_;
  const std::shared_ptr<std::atomic<std::size_t>> questions_;  // see OpenQuestion

  // Of the thread that reads, which is that of configure() before watch().
  FrameInput in_;
  bool has_output_ = true;
  std::string line_;                        // which is not whole
  const PluginSection* section_ = nullptr;  // within configure()
  std::size_t asked_of_section_ = 0;        // bytes
  bool is_registered_ = false;
  FrameOutput::FrameMark last_told_ = 0;

  ProcessEnded ended_;
  std::thread reader_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  bool is_called_ = false;  // one call at a time
  bool has_returned_ = false, is_ending_ = false, is_over_ = false;
  std::optional<std::string> thrown_;
  std::string why_;  // it was killed, or is over
  std::map<std::uint64_t, PluginReply> replies_;
  std::uint64_t next_reply_ = 0;
};

}  // namespace playhouse::drivers
