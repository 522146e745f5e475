#pragma once

/// The real server with devices that a test adds, lets publish and retires, for tests of the client
/// libraries.

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse {

class RetiringServer {
 public:
  RetiringServer() {
    const Result<std::uint16_t> opened = server_.listen(0);
    PLAYHOUSE_ASSERT(opened.ok());
    port_ = *opened;
    driver_.answers[wire::position2d::kReqGetGeom] = wire::encode(wire::position2d::Geom{});
    io_ = std::thread([this] { loop_.run(); });
  }
  ~RetiringServer() {
    loop_.stop();
    io_.join();
  }

  std::uint16_t port() const { return port_; }
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  /// Devices of interface position2d, by their indices; each call returns when it is done.
  void add(std::uint16_t index) {
    on_io([&] { devices_[index] = *server_.add_device({port_, wire::position2d::kCode, index}, driver_); });
  }
  void retire(std::uint16_t index) {
    on_io([&] { server_.retire_device(devices_.at(index)); });
  }
  void publish(std::uint16_t index, double x) {
    wire::position2d::Data state;
    state.pos.px = x;
    std::vector<device::Publication> batch;
    batch.push_back({devices_.at(index), wire::position2d::kDataState, x, wire::encode(state)});
    server_.publish(std::move(batch));
    on_io([] {});
  }
  std::size_t commands() {
    std::size_t count = 0;
    on_io([&] { count = driver_.commands.size(); });
    return count;
  }

 private:
  void on_io(const std::function<void()>& task) {
    std::promise<void> done;
    loop_.post([&] {
      task();
      done.set_value();
    });
    done.get_future().wait();
  }

  net::IoLoop loop_;
  server::FakeDriver driver_{"wheels"};
  server::Server server_{loop_};
  std::uint16_t port_ = 0;
  std::map<std::uint16_t, device::DeviceId> devices_;
  std::thread io_;
};

}  // namespace playhouse
