#pragma once

/// HardwareLine: how a driver reaches its hardware: a serial port, or a TCP port that passes its bytes on. Io thread.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

/// Where the hardware is.
struct LinePlace {
  std::string path = {};       // of a serial port; empty: TCP
  std::string host = {};       // of TCP
  std::uint16_t tcp_port = 0;  //
  net::SerialSettings serial = {};

  /// "/dev/ttyS0" or "lab:8101"
  std::string name() const;
};

/// Reads the place of a section's field: "/dev/ttyS0", or "tcp:HOST:PORT". A value that is neither is a fault of `fields`.
LinePlace read_line_place(SectionFields& fields, const OptionText& option, const std::string& otherwise,
                          const net::SerialSettings& serial);

class LineEvents {
 public:
  virtual ~LineEvents() = default;
  /// Bytes may be sent, and come.
  virtual void line_opened() = 0;
  /// `bytes` is valid during the call.
  virtual void line_received(std::span<const std::byte> bytes) = 0;
  /// Nothing comes any more, or it could not be opened; "... WHY". It is closed.
  virtual void line_lost(const std::string& why) = 0;
};

class HardwareLine final : private net::SerialEvents, private net::ConnectionEvents {
 public:
  /// `network` and `events` must outlive it.
  HardwareLine(net::Network& network, LinePlace place, LineEvents& events);
  HardwareLine(const HardwareLine&) = delete;
  HardwareLine& operator=(const HardwareLine&) = delete;
  ~HardwareLine() override;

  /// Serial ports are open on return, or fail; TCP connects, and fails by line_lost().
  Result<void> open();
  /// What was sent is passed on; no events follow.
  void close();
  bool is_open() const { return serial_ != nullptr || connection_ != nullptr; }
  /// What would exceed limits::kSerialBytes of waiting bytes is lost as a whole.
  void send(std::span<const std::byte> bytes);
  /// Of a serial port; no effect on TCP.
  Result<void> set(const net::SerialSettings& settings);
  void drop_input();
  const std::string& name() const { return name_; }

 private:
  void received(std::span<const std::byte> bytes) override;
  void ended(const std::string& why) override;
  void drained() override {}
  void lost() override {}  // closed() follows
  void closed(const std::string& why) override;
  void connected(Result<std::unique_ptr<net::Connection>> connection);
  void end(const std::string& why);

  net::Network& network_;
  const LinePlace place_;
  const std::string name_;
  LineEvents& events_;
  std::unique_ptr<net::SerialLine> serial_;
  std::unique_ptr<net::Attempt> attempt_;
  std::unique_ptr<net::Connection> connection_;
};

}  // namespace playhouse::drivers
