#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/replicate/layout.h"
#include "playhouse/world/control.h"

namespace playhouse::replicate {

/// Sun, sky and fog as rendered by the world's cameras, as JSON; "null" if they render none.
std::string light_text(const world::World& world);

/// Whether a text names the Player devices of models: pages show them, observers do not.
enum class TellDevices : std::uint8_t { kNo, kYes };

/// The scene as the JSON text that every viewer gets first: light, shapes,
/// prototypes, and the models of a layout with their start state (exactly
/// `layout.start`, the first baseline). docs/viewer-protocol.md specifies it.
std::string scene_text(const scene::SceneDesc& scene, std::string_view light, const Prototypes& prototypes,
                       const Layout& layout, TellDevices devices = TellDevices::kYes);

/// The update that takes a viewer from one population to another: removed models, and models that are new or
/// have another parent, with their start state. Both layouts are of one run. Empty if there is no difference.
std::string changes_text(const Layout& from, const Layout& to, TellDevices devices = TellDevices::kYes);

/// The instants to which a viewer can rewind, or why there are none.
std::string history_text(const world::Timeline& timeline);

/// A world file for a viewer to download under this name.
std::string world_file_text(std::string_view name, std::string_view text);

/// Merge of two layouts by id: calls gone(row of `from`), stays(row of `from`, row
/// of `to`) and came(row of `to`); a model with a new parent is gone and came.
template <typename Gone, typename Stays, typename Came>
void compare(const Layout& from, const Layout& to, Gone gone, Stays stays, Came came) {
  const auto parent_id = [](const Layout& layout, world::ModelRow row) {
    const world::ModelRow parent = layout.parent[row];
    return parent ? layout.id[parent] : world::ModelId{};
  };
  const world::ModelRow from_end = from.id.next(), to_end = to.id.next();
  for (world::ModelRow a{0}, b{0}; a < from_end || b < to_end;) {
    if (b == to_end || (a < from_end && from.id[a] < to.id[b])) {
      gone(a);
      ++a;
    } else if (a == from_end || to.id[b] < from.id[a]) {
      came(b);
      ++b;
    } else {
      if (parent_id(from, a) == parent_id(to, b)) {
        stays(a, b);
      } else {
        gone(a);
        came(b);
      }
      ++a, ++b;
    }
  }
}

}  // namespace playhouse::replicate
