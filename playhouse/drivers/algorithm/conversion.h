#pragma once

/// Answers of a device that are those of another one, converted: for algorithms that show a device as something else.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {

/// Asks a device that the shell uses, and answers with what it says, a From, converted; NACK, if it says none.
template <typename From, typename Convert>
void answer_converted(Shell& shell, std::size_t used, std::uint8_t subtype,
                      std::span<const std::byte> question, device::Replier replier, Convert convert) {
  const auto shared =
      std::make_shared<device::Replier>(std::move(replier));  // a std::function must be copyable
  shell.client().ask(used, subtype, question, [shared, convert](const AnswerBody& body) {
    if (const std::optional<From> value = decoded<From>(body)) shared->ack(wire::encode(convert(*value)));
  });
}

/// Answers `subtype` of the first device with what the used one answers to `of_used`, converted.
template <typename From, typename Convert>
void convert_answers(Shell& shell, std::size_t used, std::uint8_t subtype, std::uint8_t of_used,
                     Convert convert) {
  shell.on_request(subtype,
                   [&shell, used, of_used, convert](const device::Message&, device::Replier replier) {
                     answer_converted<From>(shell, used, of_used, {}, std::move(replier), convert);
                   });
}

/// The same of a request with a body, which is that of the used device: the body is passed on.
template <typename From, typename Convert>
void convert_setting(Shell& shell, std::size_t used, std::uint8_t subtype, Convert convert) {
  shell.on_request(subtype, [&shell, used, convert](const device::Message& message, device::Replier replier) {
    answer_converted<From>(shell, used, message.subtype, message.body, std::move(replier), convert);
  });
}

/// Changes a Config of the used device: asks for it by `get`, and sets it changed by `set`. `answer` makes the answer
/// of what is in effect then.
template <typename Config, typename Change, typename Answer>
void change_configuration(Shell& shell, std::size_t used, std::uint8_t get, std::uint8_t set,
                          device::Replier replier, Change change, Answer answer) {
  const auto shared = std::make_shared<device::Replier>(std::move(replier));
  shell.client().ask(used, get, {}, [&shell, used, set, shared, change, answer](const AnswerBody& body) {
    std::optional<Config> config = decoded<Config>(body);
    if (!config) return;
    change(*config);
    shell.client().ask(used, set, wire::encode(*config), [shared, answer](const AnswerBody& now) {
      if (const std::optional<Config> valid = decoded<Config>(now)) shared->ack(wire::encode(answer(*valid)));
    });
  });
}

}  // namespace playhouse::drivers
