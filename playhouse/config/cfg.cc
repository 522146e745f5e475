#include "playhouse/config/cfg.h"

#include <cmath>
#include <map>
#include <tuple>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/config/shipped_worlds.h"
#include "playhouse/config/warnings.h"

namespace playhouse::config {

struct CfgDocument {
  Document document;
  Units units;
  std::string folder;
};

CfgSection::CfgSection(std::shared_ptr<const CfgDocument> file, const ExpandedSection& instance)
    : file_(std::move(file)), where_(instance.where), fields_(instance.parts) {}

std::string CfgSection::at() const {
  return file_->document.sources.at(where_);
}

std::string CfgSection::at(std::string_view key) const {
  const Field* field = fields_.find(key);
  return field ? file_->document.sources.at(field->where) : at();
}

bool CfgSection::has(std::string_view key) const {
  return ask(key) != nullptr;
}

std::size_t CfgSection::count(std::string_view key) const {
  const Field* field = ask(key);
  return field ? field->values.size() : 0;
}

const Field* CfgSection::ask(std::string_view key) const {
  if (!asked_.contains(key)) asked_.emplace(key);
  return fields_.find(key);
}

void CfgSection::fail(const Field& field, std::string text) const {
  if (!fault_) fault_ = file_->document.error(field.where, std::move(text));
}

Result<void> CfgSection::fault() const {
  return fault_ ? Result<void>(*fault_) : Result<void>();
}

double CfgSection::scaled(std::string_view key, double otherwise, std::size_t element, double factor) const {
  const Field* field = ask(key);
  if (!field || element >= field->values.size()) return otherwise;
  const Value& value = field->values[element];
  const std::optional<double> number =
      value.kind == ValueKind::kBool ? std::nullopt : parse_number(value.text);
  if (number) return *number * factor;
  fail(*field, in_quotes(key) + " needs a number, found " + in_quotes(value.text));
  return otherwise;
}

double CfgSection::number(std::string_view key, double otherwise, std::size_t element) const {
  return scaled(key, otherwise, element, 1);
}

double CfgSection::length(std::string_view key, double otherwise, std::size_t element) const {
  return scaled(key, otherwise, element, file_->units.length);
}

double CfgSection::angle(std::string_view key, double otherwise, std::size_t element) const {
  return scaled(key, otherwise, element, file_->units.angle);
}

int CfgSection::integer(std::string_view key, int otherwise, std::size_t element) const {
  const double value = number(key, otherwise, element);
  if (std::abs(value) <= 2147483647.0) return static_cast<int>(value);
  fail(*ask(key), in_quotes(key) + " needs a smaller number");
  return otherwise;
}

bool CfgSection::flag(std::string_view key, bool otherwise) const {
  const Field* field = ask(key);
  if (!field || field->values.empty()) return otherwise;
  const std::string_view text = field->values.front().text;
  if (text == "yes" || text == "true") return true;
  if (text == "no" || text == "false") return false;
  if (const auto number = parse_number(text)) return *number != 0;
  static constexpr std::string_view kWords[] = {"yes", "no", "true", "false"};
  fail(*field, in_quotes(key) + " is yes or no, found " + in_quotes(text) + did_you_mean(text, kWords));
  return otherwise;
}

std::string CfgSection::text(std::string_view key, std::string_view otherwise, std::size_t element) const {
  const Field* field = ask(key);
  return std::string(field && element < field->values.size() ? field->values[element].text : otherwise);
}

std::vector<std::string> CfgSection::texts(std::string_view key) const {
  std::vector<std::string> texts;
  if (const Field* field = ask(key)) {
    for (const Value& value : field->values) texts.emplace_back(value.text);
  }
  return texts;
}

std::string CfgSection::filename(std::string_view key, std::string_view otherwise) const {
  const std::string name = text(key, otherwise);
  return name.empty() ? name : resolve(file_->folder, name);
}

std::optional<PluginField> CfgSection::plugin() const {
  if (!has("plugin")) return std::nullopt;
  return PluginField{text("plugin", ""), at("plugin"), file_->folder};
}

std::vector<DeviceAddress> CfgSection::addresses(std::string_view key) const {
  std::vector<DeviceAddress> addresses;
  const Field* field = ask(key);
  if (!field) return addresses;
  for (const Value& value : field->values) {
    Result<DeviceAddress> address = parse_device_address(value.text);
    if (address) {
      addresses.push_back(std::move(*address));
    } else {
      fail(*field, address.error().text);
    }
  }
  return addresses;
}

std::string CfgSection::slip_for(std::string_view key) const {
  const std::string_view keys[] = {key};
  for (const Field* field : fields_.all()) {
    if (asked_.contains(field->key)) continue;
    if (const std::string hint = did_you_mean(field->key, keys); !hint.empty())
      return "; " + at(field->key) + ": " + in_quotes(field->key) + " is unknown" + hint;
  }
  return {};
}

std::vector<std::string> CfgSection::unread() const {
  std::vector<std::string_view> asked(asked_.begin(), asked_.end());
  asked.push_back("include");
  const std::string tail = " is not used by driver " + in_quotes(name());
  Warnings warnings(file_->document.sources);
  for (const Field* field : fields_.all()) {
    if (asked_.contains(field->key)) continue;
    warnings.add(Warning::kUnknownWord, field->where, in_quotes(field->key) + tail,
                 [&] { return did_you_mean(field->key, asked); });
  }
  return warnings.take();
}

/// Converts a parsed file to driver sections, with all checks that are independent of drivers.
class CfgLoader {
 public:
  CfgLoader(std::shared_ptr<CfgDocument> file, std::uint16_t port, IsModel is_model)
      : file_(std::move(file)),
        document_(file_->document),
        macros_(document_),
        warnings_(document_.sources),
        port_(port),
        is_model_(is_model) {}

  Result<CfgFile> load();
  /// Errors after the one returned by load().
  std::vector<Error> take_others() { return std::move(others_); }

 private:
  void read_file();
  void add(const Error& fault);
  /// Adds an unknown word that may be the cause of an error.
  void add_slip();
  Error nothing_to_serve();
  Result<void> read_globals();
  Result<void> add_section(const Section& section);
  Result<void> add_driver(const ExpandedSection& instance);
  Result<void> check_interface(const ExpandedSection& instance);
  Result<void> check_unique(const CfgSection& driver);

  std::shared_ptr<CfgDocument> file_;
  const Document& document_;
  Macros macros_;
  Warnings warnings_;
  std::optional<Error> error_;  // the first error
  std::vector<Error> others_;   // further ones
  bool has_models_ = false;     // like a world file
  std::size_t fields_ = 0;      // of all sections
  std::uint16_t port_;
  IsModel is_model_;
  CfgFile cfg_;
  std::map<std::tuple<std::string, std::uint16_t, std::string, std::uint16_t>, std::string>
      provided_;  // to its source line
};

Result<CfgFile> CfgLoader::load() {
  cfg_.files = document_.sources.file_names();
  cfg_.path = cfg_.files.front();
  file_->folder = folder_of(cfg_.path);
  read_file();
  if (error_) {
    add_slip();
    return *error_;
  }
  if (cfg_.drivers.empty()) return nothing_to_serve();
  cfg_.warnings = warnings_.take();
  return std::move(cfg_);
}

void CfgLoader::add(const Error& fault) {
  if (!error_) {
    error_ = fault;
  } else {
    others_.push_back(fault);
  }
}

void CfgLoader::add_slip() {
  if (std::optional<Error> slip = warnings_.slip()) others_.push_back(std::move(*slip));
}

Error CfgLoader::nothing_to_serve() {
  const std::string path = escaped(cfg_.path);
  if (has_models_)
    return Error{path, "is a world file, not a configuration: playhouse run " + path + " serves its robots"};
  add_slip();
  const SourceLine where =
      document_.statements.empty() ? SourceLine{0, 1} : document_.statements.front().section.where;
  return document_.error(where, "the file has no driver ( ... ) section, so there is nothing to serve");
}

void CfgLoader::read_file() {
  if (const auto globals = read_globals(); !globals) return add(globals.error());
  for (const Statement& statement : document_.statements) {
    if (!statement.base.empty()) {
      if (!macros_.define(statement)) {
        warnings_.add(Warning::kMacro, statement.section.where,
                      "macro " + in_quotes(statement.section.name) +
                          " is defined already; the first definition counts");
      }
      continue;
    }
    if (const auto added = add_section(statement.section); !added) add(added.error());
    if (error_ && (others_.size() + 1 >= limits::kWarningsOfAKind || fields_ > limits::kEntities)) return;
  }
}

Result<void> CfgLoader::read_globals() {
  static constexpr std::string_view kWords[] = {"unit_length", "unit_angle", "plugin",
                                                "test",        "include",    "define"};
  for (const Field& field : document_.fields) {
    if (field.key == "unit_length" || field.key == "unit_angle") continue;
    if (field.key == "plugin") {
      for (const Value& value : field.values)
        cfg_.plugins.push_back({std::string(value.text), document_.sources.at(field.where), file_->folder});
    } else if (field.key == "test") {
      warnings_.add(Warning::kNoEffect, field.where,
                    in_quotes(field.key) + " has no effect: use playhouse check");
    } else {
      warnings_.add(Warning::kUnknownWord, field.where,
                    "unknown field " + in_quotes(field.key) + " outside all sections",
                    [&field] { return did_you_mean(field.key, kWords); });
    }
  }
  const Result<Units> units = read_units(document_, FieldSet(std::span<const Field>(document_.fields)));
  if (!units) return units.error();
  file_->units = *units;
  return {};
}

Result<void> CfgLoader::add_section(const Section& section) {
  const Result<ExpandedSection> instance = macros_.instance(section);
  if (!instance) return instance.error();
  for (const Section* part : instance->parts) fields_ += part->fields.size();
  if (fields_ > limits::kEntities) {
    return document_.error(section.where, "the file holds more than " + std::to_string(limits::kEntities) +
                                              " fields, those of its macros included");
  }
  if (instance->type == "driver") return add_driver(*instance);
  if (instance->type == "interface") return check_interface(*instance);
  has_models_ = has_models_ || (is_model_ && is_model_(instance->type));
  warnings_.add(Warning::kUnknownWord, section.where, "section " + in_quotes(section.name) + " has no effect",
                [&] {
                  std::vector<std::string_view> words = macros_.names();
                  words.insert(words.end(), {"driver", "interface"});
                  return did_you_mean(section.name, words);
                });
  return {};
}

Result<void> CfgLoader::add_driver(const ExpandedSection& instance) {
  CfgSection driver(file_, instance);
  if (driver.name().empty())
    return document_.error(instance.where,
                           "a driver needs a name, as in: name \"stage\"" + driver.slip_for("name"));
  driver.ask("plugin");  // of a driver that is built in it names the former library, which is fine
  if (driver.count("provides") == 0 && driver.count("requires") == 0) {
    return document_.error(instance.where,
                           "driver " + in_quotes(driver.name()) +
                               " needs the devices it provides, as in: provides [ \"position2d:0\" ]" +
                               driver.slip_for("provides"));
  }
  for (const Section* part : instance.parts) {
    for (const Section& inner : part->sections) {
      warnings_.add(Warning::kNoEffect, inner.where,
                    "section " + in_quotes(inner.name) + " inside a driver has no effect");
    }
  }
  if (const auto unique = check_unique(driver); !unique) return unique;
  driver.addresses("requires");
  driver.flag("alwayson", false);
  if (const auto fault = driver.fault(); !fault) return fault;
  cfg_.drivers.push_back(std::move(driver));
  return {};
}

Result<void> CfgLoader::check_unique(const CfgSection& driver) {
  for (const DeviceAddress& address : driver.addresses("provides")) {
    const std::string host = address.host == "localhost" ? "" : address.host;
    const auto [taken, fresh] = provided_.try_emplace(
        {host, address.port.value_or(port_), address.interf, address.index}, driver.at("provides"));
    if (!fresh) {
      return Error{driver.at("provides"),
                   "device " + in_quotes(address.text()) + " is provided at " + taken->second + " already"};
    }
  }
  return {};
}

Result<void> CfgLoader::check_interface(const ExpandedSection& instance) {
  const CfgSection section(file_, instance);
  for (const std::string_view key : {"name", "code", "plugin"}) {
    if (section.has(key)) continue;
    return document_.error(instance.where, "an interface needs " + std::string(key) + section.slip_for(key));
  }
  const int code = section.integer("code", 0);
  if (const auto fault = section.fault(); !fault) return fault;
  if (code < 0 || code > 65535) return Error{section.at("code"), "\"code\" must be from 0 to 65535"};
  warnings_.add(
      Warning::kNoEffect, instance.where,
      "interface " + in_quotes(section.name()) + " has no effect: interfaces cannot be added by plug-ins");
  return {};
}

Result<CfgFile> load_cfg_text(std::string text, const std::string& path, FileReader& files,
                              std::uint16_t port, std::vector<Error>* others, IsModel is_model) {
  Result<Document> document = parse_document(Format::kConfiguration, path, std::move(text), files);
  if (!document) return document.error();
  auto file = std::make_shared<CfgDocument>(CfgDocument{std::move(*document), {}, {}});
  CfgLoader loader(std::move(file), port, is_model);
  Result<CfgFile> cfg = loader.load();
  if (others) *others = loader.take_others();
  return cfg;
}

Result<CfgFile> load_cfg(const std::string& path, std::uint16_t port, std::vector<Error>* others,
                         IsModel is_model) {
  DiskFiles files;
  Result<std::string> text = DiskFiles(NamedBy::kPerson).read(path);
  if (!text) return Error{escaped(path), text.error().text + did_you_mean_shipped(path)};
  return load_cfg_text(std::move(*text), path, files, port, others, is_model);
}

}  // namespace playhouse::config
