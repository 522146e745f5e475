#pragma once

/// ChromiumRenderer: renders pictures by the page in a headless Chromium. No port
/// is opened: page files, world and pictures go through DevTools pipes, so that
/// the page gets exactly the ticks to draw, and no other process can connect.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/app/pictures/browser.h"
#include "playhouse/app/pictures/devtools.h"
#include "playhouse/app/pictures/renderer.h"
#include "playhouse/app/pictures/sensor_shapes.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/web_server/mesh_files.h"

namespace playhouse::app {

/// Path of Chromium, searched in PATH under its known names; none if not found.
std::optional<std::string> find_chromium();
/// Those names, for messages.
std::string chromium_names();

class ChromiumRenderer final : public WorldRenderer {
 public:
  /// Renders the world with the sensor data in `seen`; `program` is started on first use. Signals
  /// noted by `interrupt` end every wait. The world's scene, `seen` and `interrupt` must outlive it.
  ChromiumRenderer(std::string program, const world::World& world, const SensorShapes& seen,
                   const Interrupt& interrupt);

  double memory() const override { return 20; }
  Result<void> see(const world::World& world) override;
  Result<scene::RgbImage> draw(const world::World& world, const Viewport& view) override;

 private:
  Result<void> start();
  Result<void> open_page();
  void answer_request(const boost::json::object& about);
  Result<void> run(const std::string& script);

  const std::string program_;
  const SensorShapes& seen_;
  Browser browser_;
  DevTools tools_;
  bool started_ = false, loaded_ = false;

  // Replication state of the page.
  replicate::Prototypes prototypes_;
  web_server::MeshFiles mesh_files_;
  std::shared_ptr<const replicate::Layout> layout_;
  std::string scene_;  // the text of layout_
  replicate::Viewer viewer_;
  replicate::ChangesTexts changes_texts_;
  replicate::Snapshot snapshot_;
  std::vector<std::byte> packet_;
  std::uint32_t frames_ = 0;
};

}  // namespace playhouse::app
