#pragma once

/// FailingDisk: a disk that is full after so many bytes.

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "playhouse/record/record_thread.h"

namespace playhouse::house {

class FailingDisk final : public record::RecordSink {
 public:
  FailingDisk(std::unique_ptr<record::RecordSink> file, std::size_t room)
      : file_(std::move(file)), room_(room) {}
  void add(std::span<const std::byte> records) override {
    taken_ += records.size();
    file_->add(records);
  }
  std::size_t waiting() const override { return file_->waiting(); }
  Result<void> flush() override { return has_room() ? file_->flush() : full(); }
  Result<void> attach(const record::Attachment& attachment) override { return file_->attach(attachment); }
  Result<void> finish() override { return has_room() ? file_->finish() : full(); }

 private:
  bool has_room() const { return taken_ <= room_; }
  static Error full() { return {"the simulated disk", "is full"}; }

  std::unique_ptr<record::RecordSink> file_;
  const std::size_t room_;
  std::size_t taken_ = 0;
};

}  // namespace playhouse::house
