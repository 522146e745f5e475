#include "playhouse/web_server/speech_log.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/replicate/json_text.h"

namespace playhouse::web_server {

void SpeechLog::note(const replicate::Snapshot& snapshot) {
  while (!lines_.empty() && lines_.back().tick > snapshot.tick) {
    bytes_ -= lines_.back().json.size();
    lines_.pop_back();
    text_.reset();
  }
  if (layout_ == snapshot.layout && said_ == snapshot.said) return;
  layout_ = snapshot.layout;
  said_ = snapshot.said;
  std::map<world::ModelId, std::string> now;
  for (const replicate::Said& said : snapshot.says) {
    const world::ModelId id = layout_->id[said.model];
    const auto before = says_.find(id);
    if (before == says_.end() || before->second != said.text)
      add(snapshot.tick, fmt::format(R"({{"tick":{},"model":{},"name":{},"text":{}}})", snapshot.tick,
                                     id.value, replicate::quoted(said.name), replicate::quoted(said.text)));
    now.emplace(id, said.text);
  }
  says_ = std::move(now);
}

void SpeechLog::add(std::uint64_t tick, std::string json) {
  text_.reset();
  bytes_ += json.size();
  lines_.push_back({tick, std::move(json)});
  while (lines_.size() > kLinesMost || bytes_ > kBytesMost) {
    bytes_ -= lines_.front().json.size();
    lines_.pop_front();
  }
}

std::shared_ptr<const std::string> SpeechLog::text() {
  if (!text_ && !lines_.empty()) {
    const std::string lines = replicate::list(lines_, [](const SpeechLine& line) { return line.json; });
    text_ = std::make_shared<const std::string>(fmt::format("{{\"said\":{}}}\n", lines));
  }
  return text_;
}

}  // namespace playhouse::web_server
