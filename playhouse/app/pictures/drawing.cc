#include "playhouse/app/pictures/drawing.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/pictures/chromium_renderer.h"
#include "playhouse/app/pictures/own_renderer.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

constexpr const char* kByChromium = "Chromium";
constexpr const char* kByUs = "Playhouse";

}  // namespace

Drawing::Drawing(std::string command, const std::string& wanted)
    : command_(std::move(command)),
      chromium_alone_(wanted == kChromium),
      chromium_(wanted == kPlayhouse ? std::nullopt : find_chromium()),
      why_ours_(wanted.empty() && !chromium_ ? "there is no Chromium in PATH" : "") {}

Result<void> Drawing::possible() const {
  if (!chromium_alone_ || chromium_) return {};
  return Error{
      "--renderer chromium",
      fmt::format("there is no {} in PATH; --renderer playhouse draws without it", chromium_names())};
}

int Drawing::run(DrawnRun& drawn, const Interrupt& interrupt, const Draw& draw) {
  if (chromium_) {
    log::say(fmt::format("{}: Chromium draws ({})", command_, escaped(*chromium_)));
    ChromiumRenderer chromium(*chromium_, drawn.world(), drawn.seen(), interrupt);
    const Result<int> code = draw(chromium);
    if (code) return done(*code, kByChromium);
    if (interrupt.signal() != 0) return interrupt.exit_code(kFailed);
    if (chromium_alone_)
      return fail({"", fmt::format("Chromium {}; --renderer playhouse draws without it", code.error().text)});
    log::warn("{}: Chromium {}; Playhouse draws", command_, code.error().text);
  } else if (!why_ours_.empty()) {
    log::say(fmt::format("{}: Playhouse draws: {}", command_, why_ours_));
  }
  OwnRenderer own(drawn.seen());
  const Result<int> code = draw(own);
  if (code) return done(*code, kByUs);
  return interrupt.signal() != 0 ? interrupt.exit_code(kFailed)
                                 : fail({"", fmt::format("Playhouse {}", code.error().text)});
}

int Drawing::done(int code, const char* by) const {
  if (code != kDone) return code;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start_;
  log::say(fmt::format("{}: drawn by {} in {:.1f} s", command_, by, took.count()));
  return code;
}

}  // namespace playhouse::app
