#include "playhouse/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "playhouse/base/finding.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/config/cfg.h"
#include "playhouse/config/text/syntax.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string summary(const SceneDesc& scene) {
  std::vector<std::size_t> trees(scene.models.size());  // by row of the root
  for (const TreeDesc& tree : scene.trees) ++trees[tree.top];
  std::map<std::string, std::size_t> types;
  std::size_t models = 0, beams = 0;
  for (std::size_t row = 0, top = 0; row < scene.models.size(); ++row) {
    const ModelDesc& model = scene.models[row];
    if (model.parent < 0) top = row;
    models += trees[top];
    types[model.type] += trees[top];
    for (const RangerSensorDesc& sensor : model.sensors) beams += trees[top] * sensor.samples * sensor.rings;
  }
  std::string line = escaped(scene.path) + ": " + counted(models, "model");
  for (const auto& [type, count] : types) line += ", " + std::to_string(count) + " " + type;
  return line + ", " + counted(beams, "beam");
}

/// A line for each mesh as a body, by which a file in another unit is seen.
std::vector<std::string> sizes_of_meshes(const SceneDesc& scene) {
  std::set<const mesh::Mesh*> told;
  std::vector<std::string> lines;
  for (const ModelDesc& model : scene.models) {
    if (!model.mesh || !told.insert(model.mesh.get()).second) continue;
    const geom::Vec3 extent = model.mesh->high - model.mesh->low;
    lines.push_back(fmt::format("{}: a mesh of {:.4g} x {:.4g} x {:.4g} m", escaped(model.body.mesh),
                                extent.x, extent.y, extent.z));
  }
  return lines;
}

void append(CheckReport& report, const std::vector<std::string>& warnings) {
  report.has_warnings |= !warnings.empty();
  for (const std::string& warning : warnings) report.lines.push_back(finding("warning", placed(warning)));
}

void fail(CheckReport& report, const Error& error, const std::vector<Error>& others = {}) {
  report.ok = false;
  report.lines.push_back(finding("error", error));
  for (const Error& other : others) report.lines.push_back(finding("error", other));
}

void report_world(const std::string& path, config::NamedBy by, CheckReport& report) {
  std::vector<Error> others;
  const Result<SceneDesc> scene = load_world(path, by, &others);
  if (!scene) return fail(report, scene.error(), others);
  append(report, scene->warnings);
  std::ranges::move(sizes_of_meshes(*scene), std::back_inserter(report.lines));
  report.lines.push_back(summary(*scene));
}

void check_configuration(const std::string& path, CheckReport& report) {
  std::vector<Error> others;
  const Result<config::CfgFile> cfg = config::load_cfg(path, 6665, &others, is_model_type);
  if (!cfg) return fail(report, cfg.error(), others);
  append(report, cfg->warnings);
  std::size_t devices = 0;
  for (const config::CfgSection& driver : cfg->drivers) {
    devices += driver.count("provides");
    if (!driver.has("worldfile")) continue;
    const bool was_ok = report.ok;
    report_world(driver.filename("worldfile", ""), config::NamedBy::kFile, report);
    if (was_ok && !report.ok) fail(report, {driver.at("worldfile"), "this world does not load"});
  }
  report.lines.push_back(escaped(path) + ": " + counted(cfg->drivers.size(), "driver") + ", " +
                         counted(devices, "device"));
}

void check_include(const std::string& path, CheckReport& report) {
  config::DiskFiles files;
  Result<std::string> text = config::DiskFiles(config::NamedBy::kPerson).read(path);
  if (!text) return fail(report, {escaped(path), text.error().text});
  const Result<config::Document> document =
      config::parse_document(config::Format::kWorld, path, std::move(*text), files);
  if (!document) return fail(report, document.error());
  std::size_t macros = 0;
  for (const config::Statement& statement : document->statements) macros += statement.base.empty() ? 0 : 1;
  report.lines.push_back(escaped(path) + ": " + counted(macros, "macro"));
}

}  // namespace

CheckReport check_file(const std::string& path) {
  CheckReport report{.ok = true};
  if (path.ends_with(".cfg")) {
    check_configuration(path, report);
  } else if (path.ends_with(".inc")) {
    check_include(path, report);
  } else {
    report_world(path, config::NamedBy::kPerson, report);
  }
  return report;
}

}  // namespace playhouse::scene
