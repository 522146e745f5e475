#pragma once

/// Player configuration files (.cfg) -> driver sections whose fields are read by name,
/// in SI units. Format: docs/configuration.md. Independent of drivers and interfaces.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/device_address.h"
#include "playhouse/config/text/expand.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::config {

struct CfgDocument;  // shared by the sections of a file

/// A field `plugin`, which names a shared library.
struct PluginField {
  std::string name;
  std::string where;   // "file:line"
  std::string folder;  // of the configuration file; "": the current one
};

/// One `driver ( ... )` section. Accessors return `otherwise` for an absent
/// field and record which keys were asked for. The first malformed field is
/// kept as fault(), so that a driver reads everything it needs and checks once.
class CfgSection {
 public:
  std::string name() const { return text("name", ""); }
  /// "file:line" of the section, or of one of its fields.
  std::string at() const;
  std::string at(std::string_view key) const;
  bool has(std::string_view key) const;
  /// Number of elements of a field; 0 if absent, 1 for a scalar.
  std::size_t count(std::string_view key) const;

  double number(std::string_view key, double otherwise, std::size_t element = 0) const;
  /// Metres, or metres per second.
  double length(std::string_view key, double otherwise, std::size_t element = 0) const;
  /// Radians, or radians per second.
  double angle(std::string_view key, double otherwise, std::size_t element = 0) const;
  int integer(std::string_view key, int otherwise, std::size_t element = 0) const;
  /// yes, true, a number other than 0; no, false, 0.
  bool flag(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key, std::string_view otherwise, std::size_t element = 0) const;
  std::vector<std::string> texts(std::string_view key) const;
  /// A path, relative to the folder of the configuration file.
  std::string filename(std::string_view key, std::string_view otherwise) const;
  /// None if it has no field `plugin`.
  std::optional<PluginField> plugin() const;
  /// The addresses of `provides`, `requires` or another field of that form.
  std::vector<DeviceAddress> addresses(std::string_view key) const;

  /// Suffix for an error about a missing `key`: "; file:line: "modle" is unknown (did you
  /// mean "model"?)" if the section has an unread field with a similar name, else "".
  std::string slip_for(std::string_view key) const;

  /// Keys that were asked for, whether the section has them or not.
  const std::set<std::string, std::less<>>& asked() const { return asked_; }
  /// The first malformed field, "file:line: what".
  Result<void> fault() const;
  /// One warning per unread field, with the nearest key that was read.
  std::vector<std::string> unread() const;

 private:
  friend class CfgLoader;
  CfgSection(std::shared_ptr<const CfgDocument> file, const ExpandedSection& instance);

  const Field* ask(std::string_view key) const;
  void fail(const Field& field, std::string text) const;
  double scaled(std::string_view key, double otherwise, std::size_t element, double factor) const;

  std::shared_ptr<const CfgDocument>
      file_;  // shared by the sections of one file, which live as long as any of its drivers
  SourceLine where_;
  FieldSet fields_;
  mutable std::set<std::string, std::less<>> asked_;
  mutable std::optional<Error> fault_;
};

struct CfgFile {
  std::string path;
  std::vector<std::string> files;     // all files read
  std::vector<CfgSection> drivers;    // in file order
  std::vector<PluginField> plugins;   // outside all sections, likewise
  std::vector<std::string> warnings;  // "file:line: text", of the file itself
};

/// True of the type of a section that is a model of a world file.
using IsModel = bool (*)(std::string_view type);

/// Loads a configuration file. Fails with one error, "file:line: what": bad syntax,
/// a driver without `name` or `provides`, a malformed address, or two drivers that
/// provide the same address. `port` is the default port of addresses. `others`, if
/// given, gets further errors, up to limits::kWarningsOfAKind in total. `is_model`, if given, tells the sections
/// of a world file, so that one in place of a configuration is named as such.
Result<CfgFile> load_cfg(const std::string& path, std::uint16_t port = 6665,
                         std::vector<Error>* others = nullptr, IsModel is_model = nullptr);

/// The same for a text that was read from `path`; includes are read from `files`.
Result<CfgFile> load_cfg_text(std::string text, const std::string& path, FileReader& files,
                              std::uint16_t port = 6665, std::vector<Error>* others = nullptr,
                              IsModel is_model = nullptr);

}  // namespace playhouse::config
