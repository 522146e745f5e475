#pragma once

/// SpeechLog: what models have said, for pages that come later: the last lines that
/// the snapshots held, at most kLinesMost, and kBytesMost of JSON. Thread: web.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>

#include "playhouse/replicate/snapshot.h"

namespace playhouse::web_server {

class SpeechLog {
 public:
  static constexpr std::size_t kLinesMost = 50;
  static constexpr std::size_t kBytesMost = 32768;  // of any line far less: limits::kSayBytes

  /// Adds a line for each text that the snapshot before did not have;
  /// drops those of later ticks: the run has gone back.
  void note(const replicate::Snapshot& snapshot);

  /// All lines as the text that a page gets (docs/viewer-protocol.md); null: there are none.
  std::shared_ptr<const std::string> text();

 private:
  struct SpeechLine {
    std::uint64_t tick = 0;
    std::string json;
  };

  void add(std::uint64_t tick, std::string json);

  std::deque<SpeechLine> lines_;  // by tick
  std::size_t bytes_ = 0;         // of `lines_`
  std::shared_ptr<const std::string> text_;
  // Of the last snapshot.
  std::shared_ptr<const replicate::Layout> layout_;
  std::uint64_t said_ = 0;
  std::map<world::ModelId, std::string> says_;
};

}  // namespace playhouse::web_server
