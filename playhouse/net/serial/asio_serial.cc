// Serial lines of this machine.

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/asio_loop.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/serial/terminal_file.h"

namespace playhouse::net {
namespace {

using Stream = asio::posix::stream_descriptor;

/// The descriptor and its queue. Shared by the line and pending operations, which may outlive it.
class SerialStream : public std::enable_shared_from_this<SerialStream> {
 public:
  SerialStream(IoLoop::Impl& loop, int descriptor, std::string name)
      : loop_(loop), stream_(loop.context, descriptor), name_(std::move(name)) {
    error_code ignored;
    stream_.non_blocking(true, ignored);
  }

  /// Calls `overrun` when the line is full, as its other end reads too slowly or is not open.
  void on_overrun(std::function<void()> overrun) { overrun_ = std::move(overrun); }

  void start(SerialEvents& events) {
    events_ = &events;
    wait_for_bytes();
  }

  void send(std::span<const std::byte> bytes) {
    if (waiting_.size() + bytes.size() > limits::kSerialBytes && !make_room(bytes.size())) return;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    if (!writes_) write();
  }

  void close() {
    events_ = nullptr;
    error_code ignored;
    stream_.close(ignored);
  }

  int descriptor() { return stream_.native_handle(); }
  const std::string& name() const { return name_; }

 private:
  void wait_for_bytes() {
    stream_.async_wait(Stream::wait_read, [self = shared_from_this()](const error_code& error) {
      if (!error && self->events_ != nullptr) self->read();
    });
  }

  void read() {
    error_code error;
    const std::size_t count = stream_.read_some(asio::buffer(loop_.read_buffer), error);
    if (count > 0) events_->received(std::span(loop_.read_buffer).first(count));
    if (events_ == nullptr) return;  // closed by the owner
    if (error && error != asio::error::would_block && error != asio::error::interrupted)
      return std::exchange(events_, nullptr)->ended(error == asio::error::eof ? "is gone" : error.message());
    wait_for_bytes();
  }

  void write() {
    error_code error;
    const std::size_t count = stream_.write_some(asio::buffer(waiting_), error);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    if (error && error != asio::error::would_block && error != asio::error::interrupted) waiting_.clear();
    if (waiting_.empty()) return;
    if (overrun_) overrun_();
    writes_ = true;
    stream_.async_wait(Stream::wait_write, [self = shared_from_this()](const error_code& failed) {
      self->writes_ = false;
      if (!failed && self->events_ != nullptr) self->write();
    });
  }

  /// Of what nobody reads the oldest is dropped, and so is what is newest of a line that has no time for it: false.
  bool make_room(std::size_t bytes) {
    if (!overrun_ || bytes > limits::kSerialBytes) return false;
    const std::size_t excess = waiting_.size() + bytes - limits::kSerialBytes;
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(excess));
    return true;
  }

  IoLoop::Impl& loop_;
  Stream stream_;
  const std::string name_;
  std::function<void()> overrun_;
  SerialEvents* events_ = nullptr;
  std::vector<std::byte> waiting_;
  bool writes_ = false;  // as soon as the line takes more
};

class AsioSerialPort final : public SerialLine {
 public:
  AsioSerialPort(std::shared_ptr<SerialStream> stream, const SerialSettings& settings)
      : stream_(std::move(stream)), settings_(settings) {}
  ~AsioSerialPort() override { stream_->close(); }

  void start(SerialEvents& events) override { stream_->start(events); }
  void send(std::span<const std::byte> bytes) override { stream_->send(bytes); }
  Result<void> set(const SerialSettings& settings) override {
    const Result<void> set = set_terminal(stream_->descriptor(), name(), settings);
    if (set) settings_ = settings;
    return set;
  }
  SerialSettings settings() const override { return settings_; }
  void drop_input() override { tcflush(stream_->descriptor(), TCIFLUSH); }
  const std::string& name() const override { return stream_->name(); }

 private:
  std::shared_ptr<SerialStream> stream_;
  SerialSettings settings_;
};

class AsioTerminal final : public SerialLine {
 public:
  AsioTerminal(std::shared_ptr<SerialStream> stream, PseudoTerminal terminal)
      : stream_(std::move(stream)), terminal_(std::move(terminal)) {
    // Nobody has it open, or whoever has is too slow: newer bytes are better than older ones.
    stream_->on_overrun([other = terminal_.other] { tcflush(other, TCIFLUSH); });
  }
  ~AsioTerminal() override {
    stream_->close();
    ::close(terminal_.other);
    terminal_.remove();
  }

  void start(SerialEvents& events) override { stream_->start(events); }
  void send(std::span<const std::byte> bytes) override { stream_->send(bytes); }
  Result<void> set(const SerialSettings& settings) override {
    return set_terminal(terminal_.other, name(), settings);
  }
  SerialSettings settings() const override { return settings_of_terminal(terminal_.other); }
  void drop_input() override { tcflush(stream_->descriptor(), TCIFLUSH); }
  const std::string& name() const override { return stream_->name(); }

 private:
  std::shared_ptr<SerialStream> stream_;
  PseudoTerminal terminal_;
};

}  // namespace

Result<std::unique_ptr<SerialLine>> IoLoop::open_serial(const std::string& path,
                                                        const SerialSettings& settings) {
  const Result<int> descriptor = open_serial_port(path, settings);
  if (!descriptor) return descriptor.error();
  return std::unique_ptr<SerialLine>(
      std::make_unique<AsioSerialPort>(std::make_shared<SerialStream>(impl(), *descriptor, path), settings));
}

Result<std::unique_ptr<SerialLine>> IoLoop::open_terminal(const std::string& link,
                                                          const SerialSettings& settings) {
  Result<PseudoTerminal> terminal = open_pseudo_terminal(link, settings);
  if (!terminal) return terminal.error();
  auto stream = std::make_shared<SerialStream>(impl(), terminal->descriptor, link);
  return std::unique_ptr<SerialLine>(std::make_unique<AsioTerminal>(std::move(stream), std::move(*terminal)));
}

}  // namespace playhouse::net
