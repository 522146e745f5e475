#pragma once

/// ChromiumRenderer: pictures by the page in a Chromium without a window. Nothing listens anywhere: the
/// page's files, the world and the pictures go through the browser's DevTools pipes, so that the page has
/// exactly the ticks that it is to draw, and nobody else can open it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/app/browser.h"
#include "playhouse/app/devtools.h"
#include "playhouse/app/renderer.h"
#include "playhouse/app/sensor_shapes.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/web_server/mesh_files.h"

namespace playhouse::app {

/// Where Chromium is, looked for in PATH under the names that it has; none: it is not there.
std::optional<std::string> find_chromium();
/// Those names, for a person.
std::string chromium_names();

class ChromiumRenderer final : public Renderer {
 public:
  /// Pictures of the world by this program, which starts when it is needed first, with what is `seen`.
  /// Signals that `interrupt` notes end every wait. The world's scene, `seen` and `interrupt` outlive it.
  ChromiumRenderer(std::string program, const world::World& world, const SensorShapes& seen,
                   const Interrupt& interrupt);

  double memory() const override { return 20; }
  Result<void> see(const world::World& world) override;
  Result<Picture> draw(const world::World& world, const View& view) override;

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

  // What the page holds of the world, and what it is told.
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
