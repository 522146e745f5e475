#pragma once

/// Disk: room for recordings, and whether their program still lives. FailingDisk: a recording on it.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "playhouse/record/record_thread.h"

namespace playhouse::house {

struct Disk {
  std::optional<std::size_t> room;  // bytes of records; none: enough
  bool killed = false;              // the program writes nothing any more
};

class FailingDisk final : public record::RecordSink {
 public:
  /// The disk must outlive it.
  FailingDisk(std::unique_ptr<record::RecordSink> file, const Disk& disk)
      : file_(std::move(file)), disk_(disk) {}
  void add(std::span<const std::byte> records) override {
    taken_ += records.size();
    file_->add(records);
  }
  std::size_t waiting() const override { return file_->waiting(); }
  Result<void> flush() override { return works() ? file_->flush() : full(); }
  Result<void> attach(const record::Attachment& attachment) override { return file_->attach(attachment); }
  Result<void> finish() override { return works() ? file_->finish() : full(); }

 private:
  bool works() const { return !disk_.killed && (!disk_.room || taken_ <= *disk_.room); }
  static Error full() { return {"the simulated disk", "is full"}; }

  std::unique_ptr<record::RecordSink> file_;
  const Disk& disk_;
  std::size_t taken_ = 0;
};

}  // namespace playhouse::house
