// Opens the gate of yard.world and drives up to the screen: the count rate rises.
//
//     build/watch 127.0.0.1:6665

#include <cstdio>
#include <vector>

#include "playhouse_client/robot.h"

using playhouse::Result;
using namespace playhouse::client;

namespace {

/// Waits for the next measurement.
Result<void> next_data(Client& client, Device& device) {
  while (!device.take_fresh()) {
    if (const auto read = client.read(); !read) return read.error();
  }
  return {};
}

Result<void> open_gate(Client& client, Aio& bar) {
  if (const auto told = bar.set(0, 1); !told) return told;
  for (;;) {
    if (const auto came = next_data(client, bar.device()); !came) return came;
    if (bar.voltages().at(0) > 1.39) break;  // rad
  }
  std::printf("the gate is open\n");
  return {};
}

Result<void> drive_past(Client& client, Aio& counter, Position2d& base) {
  if (const auto driven = base.drive(0.5, 0); !driven) return driven;
  for (;;) {
    if (const auto came = next_data(client, counter.device()); !came) return came;
    const auto state = base.state();
    if (!state) continue;
    const std::vector<double> readings = counter.voltages();
    std::printf("%5.2f m ahead: %3.0f counts, %4.0f in all\n", state->pose.x, readings.at(0), readings.at(1));
    if (state->pose.x > 2.5) return base.stop();
  }
}

Result<void> watch(const char* address) {
  Result<Client> client = Client::connect(address);
  if (!client) return client.error();
  const Result<Robot> rover = client->robot("rover"), gate = client->robot("gate");
  if (!rover) return rover.error();
  if (!gate) return gate.error();
  Result<Aio> counter = rover->aio(), bar = gate->aio();
  if (!counter) return counter.error();
  if (!bar) return bar.error();
  Result<Position2d> base = rover->position2d();
  if (!base) return base.error();
  if (const auto opened = open_gate(*client, *bar); !opened) return opened;
  return drive_past(*client, *counter, *base);
}

}  // namespace

int main(int argc, char** argv) {
  const Result<void> done = watch(argc > 1 ? argv[1] : "127.0.0.1:6665");
  if (done) return 0;
  std::fprintf(stderr, "%s\n", done.error().line().c_str());
  return 1;
}
