#pragma once

/// PluginFrame: what the program and a plug-in in a process of its own tell each other, over a pair of sockets. Both ends
/// are the same executable, so a frame has no version, and the byte order of the machine.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"

namespace playhouse::drivers {

enum class PluginFrameKind : std::uint8_t {
  // To the plug-in. Each of these is a call, which it answers with kReturned.
  kConfigure,  // body: see pack(PluginStart); flag: its time is a world's
  kOpen,       // flag: likewise
  kClose,
  kStep,
  kCommand,  // device, subtype, body
  kRequest,  // likewise, and number: of the reply
  kDatum,    // likewise, and time
  kHeard,    // number: of the question; flag: ACK; body
  // The answer to kAskTime and kAskField: time, or another number; body.
  kTold,
  // Of the plug-in.
  kRegistered,  // within kConfigure; body: see pack(Plugin::Registered)
  kReturned,    // flag: it threw; body: what
  kAskTime,
  kAskField,  // within kConfigure; subtype: FieldQuestion; number: element; time and body: see pack(FieldAsked)
  kPublish,       // device, subtype, time, body
  kCommandOther,  // device, subtype, body
  kAskOther,      // likewise, and number: of the question
  kReply,         // number, flag: ACK; body
  kSay,           // flag: a warning; body: text
};

struct PluginFrame {
  PluginFrameKind kind = PluginFrameKind::kReturned;
  bool flag = false;
  std::uint8_t subtype = 0;
  std::uint32_t device = 0;  // number in the file's list
  std::uint64_t number = 0;
  double time = 0;
  Bytes body = {};
};

Bytes bytes_of_text(std::string_view text);
std::string_view text_of(const Bytes& body);

/// Writes frames whole and in order. Any thread.
class FrameOutput {
 public:
  explicit FrameOutput(int socket) : socket_(socket) {}
  using FrameMark = std::uint64_t;  // bytes up to the end of a frame
  /// Writes what there is room for; flush() writes the rest. Never blocks.
  FrameMark offer(const PluginFrame& frame);
  void flush();
  /// Whether the other end, if there is one, has to read before all is written, or all up to `mark`.
  bool is_waiting() const;
  bool is_waiting(FrameMark mark) const;
  /// Blocks until it is written. False: there is no other end.
  bool send(const PluginFrame& frame);

 private:
  std::size_t write(std::span<const std::byte> first, std::span<const std::byte> second);

  const int socket_;
  mutable std::mutex mutex_;  // guards what follows
  std::deque<Bytes> waiting_;
  std::size_t at_ = 0;  // from there on the first of them is not written
  FrameMark offered_ = 0, written_ = 0;
  bool is_over_ = false;  // there is no other end
};

/// Reads them. One thread.
class FrameInput {
 public:
  explicit FrameInput(int socket) : socket_(socket) {}
  enum class ReadOutcome : std::uint8_t { kSome, kNothing, kEnd };
  /// Reads what has come.
  ReadOutcome read(bool waits);
  /// The next frame; none until more is read. Fails on what is no frame.
  Result<std::optional<PluginFrame>> take();

 private:
  const int socket_;
  Bytes bytes_;  // from `at_` on: not taken
  std::size_t at_ = 0;
};

}  // namespace playhouse::drivers
