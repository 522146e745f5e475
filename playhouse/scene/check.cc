#include "playhouse/scene/check.h"

#include <map>

#include "playhouse/scene/cfg.h"
#include "playhouse/scene/syntax.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string summary(const SceneDesc& scene) {
  std::map<std::string, std::size_t> types;
  std::size_t beams = 0;
  for (const ModelDesc& model : scene.models) {
    ++types[model.type];
    for (const RangerSensorDesc& sensor : model.sensors) beams += sensor.samples;
  }
  std::string line = scene.path + ": " + counted(scene.models.size(), "model");
  for (const auto& [type, count] : types) line += ", " + std::to_string(count) + " " + type;
  return line + ", " + counted(beams, "beam");
}

void append(CheckReport& report, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) report.lines.push_back("warning: " + warning);
}

void fail(CheckReport& report, const Error& error) {
  report.ok = false;
  report.lines.push_back("error: " + error.line());
}

void report_world(const Result<SceneDesc>& scene, CheckReport& report) {
  if (!scene) return fail(report, scene.error());
  append(report, scene->warnings);
  report.lines.push_back(summary(*scene));
}

void check_configuration(const std::string& path, CheckReport& report) {
  const Result<CfgFile> cfg = load_cfg(path);
  if (!cfg) return fail(report, cfg.error());
  append(report, cfg->warnings);
  std::size_t devices = 0;
  for (const CfgSection& driver : cfg->drivers) {
    devices += driver.count("provides");
    if (!driver.has("worldfile")) continue;
    const Result<SceneDesc> scene = load_world(driver.filename("worldfile", ""));
    if (!scene) report.lines.push_back("error: " + driver.at("worldfile") + ": this world does not load");
    report_world(scene, report);
  }
  report.lines.push_back(path + ": " + counted(cfg->drivers.size(), "driver") + ", " +
                         counted(devices, "device"));
}

void check_include(const std::string& path, CheckReport& report) {
  DiskFiles files;
  Result<std::string> text = files.read(path);
  if (!text) return fail(report, {path, text.error().text});
  const Result<Document> document = parse_document(Format::kWorld, path, std::move(*text), files);
  if (!document) return fail(report, document.error());
  std::size_t macros = 0;
  for (const Statement& statement : document->statements) macros += statement.base.empty() ? 0 : 1;
  report.lines.push_back(path + ": " + counted(macros, "macro"));
}

}  // namespace

CheckReport check_file(const std::string& path) {
  CheckReport report{true, {}};
  if (path.ends_with(".cfg")) {
    check_configuration(path, report);
  } else if (path.ends_with(".inc")) {
    check_include(path, report);
  } else {
    report_world(load_world(path), report);
  }
  return report;
}

}  // namespace playhouse::scene
