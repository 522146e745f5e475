#include "model_list.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "playhouse/base/in_quotes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/messages.h"
#include "session.h"

namespace playhouse::client {

namespace simulation = wire::simulation;

namespace {

constexpr std::size_t kMostModels = 1u << 22;  // sanity limit on untrusted input

/// Splits off the text before the next separator; the separator is consumed.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}

/// Unescapes a name: \\, \t and \n stand for backslash, tab and newline.
std::string unescaped(std::string_view field) {
  std::string name;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] != '\\' || i + 1 == field.size()) {
      name += field[i];
      continue;
    }
    const char letter = field[++i];
    name += letter == 't' ? '\t' : letter == 'n' ? '\n' : letter;
  }
  return name;
}

template <typename Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  return fault == std::errc() && end == text.data() + text.size();
}

/// Parses "6665:position2d:12". None if malformed, or if this library does not know the interface.
std::optional<DeviceAddress> parse_device(std::string_view text) {
  DeviceAddress address;
  const std::string_view port = take(text, ':');
  const wire::InterfaceDef* interf = wire::find_interface(take(text, ':'));
  if (interf == nullptr || !parse_number(port, address.port) || !parse_number(text, address.index))
    return std::nullopt;
  address.interf = interf->code;
  return address;
}

Error malformed(std::string_view line) {
  return Error{"", "the list of models has an invalid line: " + in_quotes(line)};
}

}  // namespace

Result<void> read_model_list(std::string_view text, std::vector<Model>& models) {
  std::map<std::string, std::size_t, std::less<>> rows;  // parents precede children
  for (std::size_t row = 0; row < models.size(); ++row) rows[models[row].name] = row;
  while (!text.empty()) {
    const std::string_view line = take(text, '\n');
    std::array<std::string_view, 5> fields;
    std::string_view rest = line;
    for (std::string_view& field : fields) field = take(rest, '\t');
    std::size_t index = 0;
    if (static_cast<std::size_t>(std::ranges::count(line, '\t')) + 1 != fields.size()) return malformed(line);
    if (!parse_number(fields[0], index) || index != models.size()) return malformed(line);
    Model model{unescaped(fields[1]), unescaped(fields[2]), std::nullopt, {}};
    if (!fields[3].empty()) {
      const auto parent = rows.find(unescaped(fields[3]));
      if (parent == rows.end()) return malformed(line);
      model.parent = parent->second;
    }
    while (!fields[4].empty()) {
      if (const auto device = parse_device(take(fields[4], ' '))) model.devices.push_back(*device);
    }
    rows[model.name] = models.size();
    models.push_back(std::move(model));
  }
  return {};
}

Result<std::optional<std::vector<Model>>> ask_models(Session& session, std::uint16_t simulation_index) {
  std::vector<Model> models;
  simulation::PropertyReq question{wire::c_string(""), wire::c_string("models"), 0, ""};
  do {
    const auto answer = session.ask(simulation::kCode, simulation_index, simulation::kReqGetProperty,
                                    wire::encode(question), deadline_after(session.timeout()));
    if (!answer) return answer.error();
    if (!*answer) return std::optional<std::vector<Model>>();
    const auto decoded = wire::decode<simulation::PropertyReq>(**answer);
    if (!decoded) return Error{"", "the list of models does not decode: " + decoded.error().text};
    const simulation::PropertyReq& told = *decoded;
    if (const auto read = read_model_list(told.value, models); !read) return read.error();
    if (told.index != 0 &&
        (told.index != models.size() || told.index <= question.index || models.size() > kMostModels))
      return Error{"", "the list of models does not go on where it ended"};
    question.index = told.index;
  } while (question.index != 0);
  return std::optional(std::move(models));
}

std::size_t top_of(const std::vector<Model>& models, std::size_t row) {
  while (models[row].parent) row = *models[row].parent;
  return row;
}

}  // namespace playhouse::client
