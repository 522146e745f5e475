#include "playhouse/net/io_loop.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/asio_loop.h"

namespace playhouse::net {
namespace {

constexpr double kLongestWait = 1e9;  // s; more is for ever, and too much for the clock

class AsioTimer final : public Timer {
 public:
  AsioTimer(asio::io_context& context, double seconds, Network::Task task)
      : timer_(context, std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                            std::chrono::duration<double>(std::min(seconds, kLongestWait)))) {
    timer_.async_wait([task = std::move(task), live = std::weak_ptr<int>(live_)](const auto& error) {
      if (!error && !live.expired()) task();
    });
  }

 private:
  // An expired timer cannot be cancelled: its task checks whether the owner is alive.
  std::shared_ptr<int> live_ = std::make_shared<int>(0);
  asio::steady_timer timer_;
};

void wait_for_signal(IoLoop::Impl& impl) {
  impl.signals->async_wait([&impl](const error_code& error, int signal) {
    if (error) return;
    impl.signal_task(signal);
    wait_for_signal(impl);
  });
}

}  // namespace

IoLoop::Impl::Lingering::iterator IoLoop::Impl::linger(std::function<void()> end) {
  if (lingering.size() >= limits::kLingering) end_first();
  return lingering.insert(lingering.end(), std::move(end));
}

void IoLoop::Impl::leave(Lingering::iterator place) {
  lingering.erase(place);
  if (finishing && lingering.empty()) context.stop();
}

void IoLoop::Impl::end_lingering() {
  while (!lingering.empty()) end_first();
}

// Copied, because the call erases the entry.
void IoLoop::Impl::end_first() {
  const std::function<void()> end = lingering.front();
  end();
}

std::unique_ptr<Attempt> Network::connect_tls(const std::string& host, std::uint16_t port,
                                              std::shared_ptr<TlsTrust>, Connected connected) {
  return connect(host, port, std::move(connected));
}

Result<std::unique_ptr<SerialLine>> Network::open_serial(const std::string& path, const SerialSettings&) {
  return Error{path, "there are no serial ports here"};
}

Result<std::unique_ptr<SerialLine>> Network::open_terminal(const std::string& link, const SerialSettings&) {
  return Error{link, "there are no pseudo-terminals here"};
}

IoLoop::IoLoop() : impl_(std::make_unique<Impl>()) {}
IoLoop::~IoLoop() = default;

void IoLoop::run() {
  impl_->context.restart();
  impl_->finishing = false;
  const auto work = asio::make_work_guard(impl_->context);
  impl_->context.run();
}

void IoLoop::poll() {
  impl_->context.restart();
  impl_->context.poll();
}

void IoLoop::stop() {
  // Posted, so that stop() before run() is effective.
  asio::post(impl_->context, [context = &impl_->context] { context->stop(); });
}

void IoLoop::finish() {
  post([impl = impl_.get()] {
    impl->finishing = true;
    if (impl->lingering.empty()) impl->context.stop();
  });
}

std::size_t IoLoop::lingering() const {
  return impl_->lingering.size();
}

void IoLoop::use_tls(std::shared_ptr<TlsIdentity> identity) {
  impl_->tls = std::move(identity);
}

void IoLoop::on_signal(std::initializer_list<int> signals, std::function<void(int)> task) {
  PLAYHOUSE_ASSERT(!impl_->signals);
  impl_->signals.emplace(impl_->context);
  for (const int signal : signals) impl_->signals->add(signal);
  impl_->signal_task = std::move(task);
  wait_for_signal(*impl_);
}

void IoLoop::post(Task task) {
  asio::post(impl_->context, std::move(task));
}

double IoLoop::now() const {
  return monotonic_seconds();
}

std::unique_ptr<Timer> IoLoop::after(double seconds, Task task) {
  return std::make_unique<AsioTimer>(impl_->context, seconds, std::move(task));
}

}  // namespace playhouse::net
