#include "playhouse/bridge/simulated/directory.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

/// "position2d:0".
std::string name_within_port(device::Address address) {
  const wire::InterfaceDef* interf = wire::find_interface(address.interf);
  PLAYHOUSE_ASSERT(interf != nullptr);
  return fmt::format("{}:{}", interf->name, address.index);
}

/// Escapes a name, so that tabs and line ends are unambiguous separators.
std::string escaped_field(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == '\\') {
      text += "\\\\";
    } else if (c == '\t') {
      text += "\\t";
    } else if (c == '\n') {
      text += "\\n";
    } else {
      text += c;
    }
  }
  return text;
}

std::string line_of(const world::World& world, const Directory& directory, world::ModelRow row) {
  const world::ModelRow parent = world.models.parent[row];
  std::string line =
      fmt::format("{}\t{}\t{}\t{}\t", world.id(row).value, escaped_field(world.name(row)),
                  escaped_field(world.desc(row).type), parent ? escaped_field(world.name(parent)) : "");
  const char* separator = "";
  for (const device::Address& address : directory.devices_of(world.id(row))) {
    fmt::format_to(std::back_inserter(line), "{}{}:{}", separator, address.robot, name_within_port(address));
    separator = " ";
  }
  return line += '\n';
}

/// The first row with this id or a later one.
std::size_t first_row_from(const world::World& world, world::ModelId id) {
  const auto& ids = world.models.id;
  return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
}

}  // namespace

void Directory::add(world::ModelId model, device::Address address) {
  if (!model) return;
  devices_[model].push_back(address);
  models_[address] = model;
}

void Directory::remove(device::Address address) {
  const auto found = models_.find(address);
  if (found == models_.end()) return;
  const auto of_model = devices_.find(found->second);
  std::erase(of_model->second, address);
  if (of_model->second.empty()) devices_.erase(of_model);
  models_.erase(found);
}

std::vector<device::Address> Directory::devices() const {
  std::vector<device::Address> all;
  for (const auto& [address, model] : models_) all.push_back(address);
  return all;
}

std::span<const device::Address> Directory::devices_of(world::ModelId model) const {
  const auto found = devices_.find(model);
  return found == devices_.end() ? std::span<const device::Address>() : found->second;
}

world::ModelId Directory::model_of(device::Address address) const {
  const auto found = models_.find(address);
  return found == models_.end() ? world::ModelId{} : found->second;
}

std::vector<std::string> device_names(const Directory& directory, world::ModelId model, std::uint32_t port) {
  std::vector<std::string> names;
  for (const device::Address& address : directory.devices_of(model)) {
    const std::string name = name_within_port(address);
    names.push_back(address.robot == port ? name : fmt::format("{}:{}", address.robot, name));
  }
  return names;
}

std::string devices_below(const world::World& world, const Directory& directory, world::ModelRow model,
                          std::uint32_t port) {
  std::string text;
  const auto add = [&text](const std::string& more) {
    if (!text.empty() && !more.empty()) text += ' ';
    text += more;
  };
  for (const std::string& name : device_names(directory, world.id(model), port)) add(name);
  for (const world::ModelRow child : world.children(model))
    add(devices_below(world, directory, {child}, port));
  return text;
}

ModelList list_models(const world::World& world, const Directory& directory, std::uint32_t first) {
  ModelList list;
  const std::size_t count = world.models.size();
  const std::size_t begin = first_row_from(world, {first});
  for (std::size_t row = begin; row < count; ++row) {
    const std::string line = line_of(world, directory, {static_cast<std::uint32_t>(row)});
    const bool full = row - begin >= limits::kListedModels ||
                      (row > begin && list.text.size() + line.size() > limits::kModelListBytes);
    if (full) {
      list.next = world.models.id[world.models.rows()[row]].value;
      break;
    }
    list.text += line;
  }
  return list;
}

}  // namespace playhouse::drivers
