#include "playhouse/server/out_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::server {

void OutQueue::add(Frame frame) {
  const QueueAction action = rules_.action_for(frame);
  if (action == QueueAction::kIgnore) return;
  if (frame.is_answer()) {
    add_answer(std::move(frame), action);
  } else {
    add_data(std::move(frame), action);
  }
}

void OutQueue::add_data(Frame frame, QueueAction action) {
  const std::size_t size = frame.bytes->size();
  const std::uint64_t kind = frame.kind();
  bool counted = true;  // against the limit of messages
  if (action == QueueAction::kReplace) {
    counted = false;
    if (const auto old = newest_.find(kind); old != newest_.end()) remove_data(old->second);
  }
  while (!data_.empty() && ((counted && data_.size() >= limits::kSessionQueueMessages) ||
                            data_bytes_ + size > limits::kSessionQueueBytes)) {
    remove_data(data_.begin());
    ++dropped_;
    ++unreported_drops_;
  }
  data_bytes_ += size;
  data_.push_back({next_number_++, std::move(frame)});
  newest_[kind] = std::prev(data_.end());
}

void OutQueue::add_answer(Frame frame, QueueAction action) {
  if (action == QueueAction::kReplace) {
    const auto old = std::find_if(answers_.rbegin(), answers_.rend(),
                                  [&](const Entry& entry) { return entry.frame.kind() == frame.kind(); });
    if (old != answers_.rend()) {
      answer_bytes_ -= old->frame.bytes->size();
      answers_.erase(std::next(old).base());
    }
  }
  answer_bytes_ += frame.bytes->size();
  answers_.push_back({next_number_++, std::move(frame)});
}

void OutQueue::request_data(Frame answer) {
  answer_bytes_ += answer.bytes->size();
  answers_.push_front({0, std::move(answer)});
  data_requested_ = true;
  data_delivered_ = false;
}

void OutQueue::forget(std::uint16_t interf, std::uint16_t index) {
  for (Place place = data_.begin(); place != data_.end();) {
    const Place next = std::next(place);
    if (place->frame.interf == interf && place->frame.index == index) remove_data(place);
    place = next;
  }
}

void OutQueue::remove_data(Place place) {
  data_bytes_ -= place->frame.bytes->size();
  if (const auto newest = newest_.find(place->frame.kind());
      newest != newest_.end() && newest->second == place) {
    newest_.erase(newest);
  }
  data_.erase(place);
}

void OutQueue::take(std::vector<net::SharedBytes>& out, std::size_t max_bytes, double now) {
  std::size_t size = 0;
  while (size < max_bytes) {
    Frame frame;
    if (round_is_over()) {
      frame = finish_round(now);
    } else if (may_send()) {
      frame = pop();
    } else {
      return;
    }
    size += frame.bytes->size();
    out.push_back(std::move(frame.bytes));
  }
}

// An answer never waits for a round: it goes out with the data before it.
bool OutQueue::may_send() const {
  if (!answers_.empty()) return true;
  return !data_.empty() && (mode_ == DeliveryMode::kPush || data_requested_);
}

// The round holds what waited when its first data went out, so that it ends even if data comes faster than it
// goes.
bool OutQueue::round_is_over() const {
  if (mode_ != DeliveryMode::kPull || !data_requested_ || !data_delivered_) return false;
  const bool answer_left = !answers_.empty() && answers_.front().number <= round_end_;
  const bool data_left = !data_.empty() && data_.front().number <= round_end_;
  return !answer_left && !data_left;
}

Frame OutQueue::pop() {
  const bool answer = data_.empty() || (!answers_.empty() && answers_.front().number < data_.front().number);
  if (answer) {
    Frame frame = std::move(answers_.front().frame);
    answers_.pop_front();
    answer_bytes_ -= frame.bytes->size();
    return frame;
  }
  if (data_requested_ && !std::exchange(data_delivered_, true)) round_end_ = next_number_ - 1;
  Frame frame = data_.front().frame;
  remove_data(data_.begin());
  return frame;
}

Frame OutQueue::finish_round(double now) {
  data_requested_ = data_delivered_ = false;
  wire::Header header;
  header.interf = wire::player::kCode;
  header.type = wire::MessageType::kSynch;
  header.timestamp = now;
  const std::uint32_t lost = std::exchange(unreported_drops_, 0);
  if (lost == 0) {
    header.subtype = wire::player::kSynchOk;
    return make_frame(header, {});
  }
  header.subtype = wire::player::kSynchOverflow;
  return make_frame(header, wire::encode(wire::Uint32{lost}));
}

}  // namespace playhouse::server
