#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/discovery/found_servers.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/base/fail.h"
#include "playhouse/wire/messages.h"
#include "playhouse_client/client.h"

namespace playhouse::app {
namespace {

constexpr client::Seconds kPatience{0.25};  // period of checks for the end

/// One message as a line: {"message":"laser.data.scan","index":0,"time":1.5,"data":{...}}
std::string line_of(const client::Device& device, std::uint8_t subtype, std::span<const std::byte> body,
                    double timestamp) {
  const wire::MessageDef* message = wire::find_message(device.interf(), wire::MessageType::kData, subtype);
  std::string line = fmt::format(R"({{"message":"{}","index":{},"time":{},"data":)",
                                 message == nullptr ? "unknown" : message->name, device.index(), timestamp);
  if (message == nullptr) {
    line += "null";
  } else {
    message->to_json(body, line);
  }
  return line + "}\n";
}

/// Ends after `count` messages, on a signal, or if standard output is closed.
Result<void> print_data(client::Client& client, client::Device& device, std::uint64_t count,
                        const Interrupt& interrupt) {
  std::uint64_t printed = 0;
  bool heard = true;
  device.on_data([&](std::uint8_t subtype, std::span<const std::byte> body, double timestamp) {
    if (!heard || (count > 0 && printed == count)) return;
    const std::string line = line_of(device, subtype, body, timestamp);
    heard = std::fwrite(line.data(), 1, line.size(), stdout) == line.size() && std::fflush(stdout) == 0;
    ++printed;
  });
  while (heard && interrupt.signal() == 0 && (count == 0 || printed < count)) {
    if (const Result<std::size_t> read = client.read(kPatience); !read && interrupt.signal() == 0) {
      device.on_data({});
      return read.error();
    }
  }
  device.on_data({});
  return {};
}

bool sends_data(std::uint16_t interf) {
  const wire::InterfaceDef* known = wire::find_interface(interf);
  return known != nullptr && std::ranges::any_of(known->messages, [](const wire::MessageDef& message) {
           return message.type == wire::MessageType::kData;
         });
}

}  // namespace

int watch(const WatchOptions& options) {
  const bool is_robot_alone = options.device.empty();
  const Result<DeviceArgument> wanted =
      is_robot_alone ? DeviceArgument{{}, options.server} : parse_wanted_device(options.device);
  if (!wanted) return fail(wanted.error(), kUsage);
  if (wanted->address && !sends_data(wanted->address->interf))
    return fail({"", "a device of this interface sends no data to watch"}, kUsage);
  const Result<NamedServer> server =
      is_robot_alone ? server_of_robot(options.server) : reach_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  Result<client::Client> client = client::Client::connect(
      server->address.host, server->address.port, {.mode = client::Mode::kPush, .token = options.token});
  if (!client) return fail(server->explain(client.error()));
  const Result<DeviceName> name = find_device(*client, *wanted, &sends_data);
  if (!name) return fail(name.error());
  Result<client::Device> device = client::Device::open(*client, name->interf, name->index);
  if (!device)
    return fail({device.error().where, device.error().text + "; playhouse devices lists what there is"});
  const Interrupt interrupt;  // output lines have to be completed from here on
  if (const Result<void> printed = print_data(*client, *device, options.count, interrupt); !printed) {
    return fail(printed.error());
  }
  return interrupt.exit_code(kDone);
}

}  // namespace playhouse::app
