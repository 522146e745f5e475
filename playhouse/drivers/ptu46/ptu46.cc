#include "playhouse/drivers/ptu46/ptu46.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers {

namespace ptz = wire::ptz;

namespace {

constexpr double kPtuCycle = 0.1;                          // s between two rounds of questions
constexpr double kWakeSeconds = 0.1, kSetUpSeconds = 0.2;  // s until what the unit says then is dropped
constexpr double kPtuPatience = 1, kResetPatience = 30;    // s for a reply
constexpr int kMostLostReplies = 3;

constexpr DeviceText kPtu46Provides[] = {{"ptz"}};

HardwareOptions ptu46_options(SectionFields& fields) {
  const int baud = fields.integer({"baud", "Of the unit, as it is set.", "baud"}, 9600, 600, 115200);
  return read_hardware_options(
      fields,
      read_line_place(
          fields, {"port", "Serial port of the unit, or a TCP port that passes its bytes on: tcp:lab:8101."},
          "/dev/ttyR1", {.baud = baud}),
      false);
}

}  // namespace

Ptu46::Ptu46(std::string name, Site& site, const HardwareOptions& options)
    : HardwareDriver(std::move(name), site, options) {
  on_command<ptz::Cmd>(kMount, ptz::kCmdState, [this](const ptz::Cmd& wanted) { look(wanted); });
  on_request<ptz::ReqControlMode>(kMount, ptz::kReqControlMode,
                                  [this](const ptz::ReqControlMode& asked) -> AnswerBody {
                                    if (asked.mode > ptz::kPositionControl) return std::nullopt;
                                    has_speeds_ = asked.mode == ptz::kVelocityControl;
                                    wanted_.reset();
                                    return done();
                                  });
  on_question(kMount, ptz::kReqGeom, []() -> AnswerBody { return wire::encode(ptz::Geom{}); });
  on_question(kMount, ptz::kReqStatus, []() -> AnswerBody { return wire::encode(ptz::ReqStatus{}); });
}

// --- start-up

void Ptu46::say(const std::string& text) {
  send(std::as_bytes(std::span(text)));
}

void Ptu46::began() {
  say(" ");
  wait_ = after(kWakeSeconds, [this] { wake(); });
}

/// Terse replies, no echo, independent axes, at once. The replies are not read: an echo may be between them.
void Ptu46::wake() {
  line().drop_input();
  say("ft ed ci i ");
  mode_ = false;
  wait_ = after(kSetUpSeconds, [this] {
    line().drop_input();
    reader_.clear();
    ask_limits();
  });
}

void Ptu46::ask_limits() {
  errands_.clear();
  const auto ask = [this](const char* letters, double& value) {
    errands_.push_back({ptu::encode_command(letters), &value, kPtuPatience});
  };
  pan_ = tilt_ = {};
  ask("tr", tilt_.resolution);
  ask("pr", pan_.resolution);
  ask("pn", pan_.least);
  ask("px", pan_.most);
  ask("tn", tilt_.least);
  ask("tx", tilt_.most);
  ask("pl", pan_.slowest);
  ask("pu", pan_.fastest);
  ask("tl", tilt_.slowest);
  ask("tu", tilt_.fastest);
  then_ = [this] { check_limits(); };
  send_next();
}

void Ptu46::check_limits() {
  const auto is_known = [](const PtuAxis& axis) {
    return axis.resolution > 0 && axis.least < axis.most && axis.fastest > 0;
  };
  if (is_known(pan_) && is_known(tilt_)) return run();
  if (std::exchange(has_reset_, true))
    return give_up("the unit does not know its limits, also after a reset");
  inform("the unit does not know its limits: it is reset");
  errands_.push_back({ptu::encode_command(" r"), nullptr, kResetPatience});
  then_ = [this] { ask_limits(); };
  send_next();
}

void Ptu46::run() {
  runs_ = true;
  then_ = [this] { publish_direction(); };
  cycle();
}

void Ptu46::forgot() {
  reader_.clear();
  errands_.clear();
  then_ = nullptr;
  is_out_ = runs_ = has_reset_ = has_speeds_ = false;
  mode_.reset();
  wanted_.reset();
  lost_ = 0;
  wait_.reset();
  patience_.reset();
}

void Ptu46::ending() {
  if (runs_ && mode_ == true) say("h ");
}

// --- one command at a time

/// What is asked next, in a cycle, follows the newest command.
void Ptu46::cycle() {
  wait_ = after(kPtuCycle, [this] { cycle(); });
  if (!errands_.empty()) return;
  if (mode_ != has_speeds_) change_mode();
  if (wanted_) obey(*std::exchange(wanted_, std::nullopt));
  errands_.push_back({ptu::encode_command("pp"), &pan_.position, kPtuPatience});
  errands_.push_back({ptu::encode_command("tp"), &tilt_.position, kPtuPatience});
  errands_.push_back({ptu::encode_command("ps"), &pan_.speed, kPtuPatience});
  errands_.push_back({ptu::encode_command("ts"), &tilt_.speed, kPtuPatience});
  send_next();
}

void Ptu46::send_next() {
  if (is_out_ || errands_.empty()) return;
  is_out_ = true;
  say(errands_.front().command);
  patience_ = after(errands_.front().patience, [this] {
    if (++lost_ == kMostLostReplies) return give_up("the unit does not answer");
    is_out_ = false;
    reader_.clear();
    line().drop_input();
    send_next();
  });
}

void Ptu46::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<ptu::PtuReply> reply = reader_.next()) take(*reply);
}

/// A reply without the number that was asked for is that of another command.
void Ptu46::take(const ptu::PtuReply& reply) {
  if (!is_out_) return;
  const PtuErrand& errand = errands_.front();
  if (reply.is_good && (errand.value != nullptr) != reply.value.has_value()) return;
  if (reply.is_good && errand.value != nullptr) *errand.value = *reply.value;
  errands_.pop_front();
  is_out_ = false;
  lost_ = 0;
  patience_.reset();
  if (!errands_.empty()) return send_next();
  if (const auto then = then_) then();
}

void Ptu46::publish_direction() {
  const auto speed = [this](const PtuAxis& axis) {
    return mode_ == true ? static_cast<float>(ptu::radians_of(axis.speed, axis.resolution)) : 0.0F;
  };
  publish(kMount, ptz::kDataState,
          ptz::Data{.pan = static_cast<float>(ptu::radians_of(pan_.position, pan_.resolution)),
                    .tilt = static_cast<float>(ptu::radians_of(tilt_.position, tilt_.resolution)),
                    .zoom = 0,
                    .panspeed = speed(pan_),
                    .tiltspeed = speed(tilt_)});
}

// --- what clients command

void Ptu46::look(const ptz::Cmd& wanted) {
  if (!std::isfinite(wanted.pan) || !std::isfinite(wanted.tilt) || !std::isfinite(wanted.panspeed) ||
      !std::isfinite(wanted.tiltspeed))
    return;
  wanted_ = wanted;
  if (runs_ && errands_.empty()) cycle();
}

void Ptu46::tell(const char* letters, std::optional<long> number) {
  errands_.push_back({ptu::encode_command(letters, number), nullptr, kPtuPatience});
}

/// What turns at a speed stands before it gets directions.
void Ptu46::change_mode() {
  if (!has_speeds_) tell("h");
  tell(has_speeds_ ? "cv" : "ci");
  mode_ = has_speeds_;
}

/// In position mode a speed of 0 leaves that of the unit.
void Ptu46::obey(const ptz::Cmd& wanted) {
  const long pan_speed = speed_within(pan_, static_cast<double>(wanted.panspeed));
  const long tilt_speed = speed_within(tilt_, static_cast<double>(wanted.tiltspeed));
  if (has_speeds_ || pan_speed != 0) tell("ps", has_speeds_ ? pan_speed : std::abs(pan_speed));
  if (has_speeds_ || tilt_speed != 0) tell("ts", has_speeds_ ? tilt_speed : std::abs(tilt_speed));
  if (has_speeds_) return;
  tell("pp", counts_within(pan_, static_cast<double>(wanted.pan)));
  tell("tp", counts_within(tilt_, static_cast<double>(wanted.tilt)));
}

long Ptu46::counts_within(const PtuAxis& axis, double radians) const {
  return std::lround(std::clamp(ptu::counts_of(radians, axis.resolution), axis.least, axis.most));
}

/// A speed that is not 0 is one that the axis can have.
long Ptu46::speed_within(const PtuAxis& axis, double radians) const {
  const double counts = ptu::counts_of(radians, axis.resolution), size = std::fabs(counts);
  if (size < 1) return 0;
  return std::lround(std::copysign(std::min(std::max(size, axis.slowest), axis.fastest), counts));
}

constinit const DriverDefinition kPtu46Driver{
    .name = "ptu46",
    .doc = "Directed Perception's pan-tilt units, PTU-46 and D46.",
    .provides = kPtu46Provides,
    .read_options = reading<ptu46_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<Ptu46>(section, site, ptu46_options, kPtu46Provides);
    },
};

}  // namespace playhouse::drivers
