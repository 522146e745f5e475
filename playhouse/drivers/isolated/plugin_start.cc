#include "playhouse/drivers/isolated/plugin_start.h"

#include <limits>
#include <utility>

namespace playhouse::drivers {
namespace {

void pack_devices(Packer& out, std::span<const PluginDevice> devices) {
  out.varint(devices.size());
  for (const PluginDevice& device : devices) {
    out.text(device.key);
    out.text(device.interf);
    out.u16(device.code);
    out.u16(device.index);
    out.u32(device.port);
  }
}

std::vector<PluginDevice> unpack_devices(Unpacker& in) {
  std::vector<PluginDevice> devices;
  for (std::uint64_t left = in.varint(); left > 0 && in.ok(); --left) {
    PluginDevice& device = devices.emplace_back();
    device.key = in.text();
    device.interf = in.text();
    device.code = in.u16();
    device.index = in.u16();
    device.port = in.u32();
  }
  return devices;
}

void pack_key(Packer& out, const Plugin::MessageKey& key) {
  out.u64(key.first);
  out.u8(key.second);
}

Plugin::MessageKey unpack_key(Unpacker& in) {
  const std::uint64_t device = in.u64();
  return {device, in.u8()};
}

void pack_keys(Packer& out, std::span<const Plugin::MessageKey> keys) {
  out.varint(keys.size());
  for (const Plugin::MessageKey& key : keys) pack_key(out, key);
}

std::vector<Plugin::MessageKey> unpack_some_keys(Unpacker& in, std::size_t most) {
  std::vector<Plugin::MessageKey> keys;
  for (std::uint64_t left = in.varint(); left > 0 && in.ok() && keys.size() <= most; --left)
    keys.push_back(unpack_key(in));
  return keys;
}

}  // namespace

Bytes pack(const PluginStart& start) {
  Bytes body;
  Packer out(body);
  out.text(start.library);
  pack_devices(out, start.provides);
  pack_devices(out, start.uses);
  return body;
}

std::optional<PluginStart> unpack_start(std::span<const std::byte> body) {
  Unpacker in(body);
  PluginStart start;
  start.library = in.text();
  start.provides = unpack_devices(in);
  start.uses = unpack_devices(in);
  return in.ok() && in.at_end() ? std::optional(std::move(start)) : std::nullopt;
}

Bytes pack(const RegisteredKeys& keys) {
  Bytes body;
  Packer out(body);
  pack_keys(out, keys.commands);
  pack_keys(out, keys.requests);
  pack_keys(out, keys.data);
  out.varint(keys.passed_on.size());
  for (const auto& [key, used] : keys.passed_on) {
    pack_key(out, key);
    out.u64(used);
  }
  out.f64(keys.period);
  return body;
}

std::optional<RegisteredKeys> unpack_keys(std::span<const std::byte> body, std::size_t devices) {
  // One more device than there are: which one that is wrong is told by who checks them.
  const std::size_t most = (devices + 1) * (std::numeric_limits<std::uint8_t>::max() + std::size_t{1});
  Unpacker in(body);
  RegisteredKeys keys;
  keys.commands = unpack_some_keys(in, most);
  keys.requests = unpack_some_keys(in, most);
  keys.data = unpack_some_keys(in, most);
  for (std::uint64_t left = in.varint(); left > 0 && in.ok() && keys.passed_on.size() <= most; --left) {
    const Plugin::MessageKey key = unpack_key(in);
    keys.passed_on.emplace_back(key, in.u64());
  }
  keys.period = in.f64();
  return in.ok() && in.at_end() ? std::optional(std::move(keys)) : std::nullopt;
}

Bytes pack(const FieldAsked& asked) {
  Bytes body;
  Packer out(body);
  out.text(asked.key);
  out.text(asked.otherwise);
  return body;
}

std::optional<FieldAsked> unpack_asked(std::span<const std::byte> body) {
  Unpacker in(body);
  FieldAsked asked{in.text(), {}};
  asked.otherwise = in.text();
  return in.ok() && in.at_end() ? std::optional(std::move(asked)) : std::nullopt;
}

}  // namespace playhouse::drivers
