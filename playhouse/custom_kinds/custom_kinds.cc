#include "playhouse/custom_kinds/custom_kinds.h"

#include <map>
#include <memory>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/libraries/thrown_by.h"
#include "playhouse/world/custom_hooks.h"
#include "playhouse/world/custom_library.h"

namespace playhouse::custom_kinds {
namespace {

using world::CustomCode;
using world::CustomKind;

constexpr libraries::LibraryAbi kProvided{"custom model", "PLAYHOUSE_CUSTOM_KIND", "playhouse_custom",
                                          world::kCustomVersion, world::kCustomVersion};

using Opened = std::map<std::string, std::shared_ptr<libraries::SharedLibrary>>;

/// Null if libraries are only located.
Result<std::shared_ptr<libraries::SharedLibrary>> open(const std::string& name, const std::string& where,
                                                       const libraries::Libraries& libraries, Opened& opened,
                                                       std::vector<std::string>& warnings) {
  if (const auto at = opened.find(name); at != opened.end()) return at->second;
  const auto library = libraries::load({kProvided, name, where, {}}, libraries, warnings);
  if (!library) return library;
  if (*library) {
    const auto layout = reinterpret_cast<std::uint64_t (*)()>((*library)->symbol("playhouse_custom_layout"));
    if (!layout || layout() != world::layout())
      return Error{where, "custom model " + in_quotes(name) + ": " + escaped((*library)->file()) +
                              " is built with headers of another program; build it again with those of "
                              "this one"};
  }
  opened.emplace(name, *library);
  return library;
}

Result<CustomKind::Sizes> configure(CustomKind& kind, const std::vector<std::string>& arguments) {
  constexpr std::size_t kMost = limits::kCustomNumbers;
  CustomKind::Sizes sizes;
  std::string thrown;
  if (const char* why = libraries::thrown_by(thrown, [&] { sizes = kind.configure(arguments); }))
    return Error{{}, why};
  if (sizes.commands <= kMost && sizes.state <= kMost && sizes.readings <= kMost) return sizes;
  return Error{{}, "needs more than " + std::to_string(kMost) + " commands, state or readings"};
}

/// Null if libraries are only located.
Result<std::shared_ptr<const CustomCode>> make_code(const std::string& text, const std::string& where,
                                                    const libraries::Libraries& libraries, Opened& opened,
                                                    std::vector<std::string>& warnings) {
  std::vector<std::string> words = libraries::words_of(text);
  if (words.empty()) return Error{where, "a custom model needs a library \"NAME ARGUMENTS\""};
  const std::string name = std::move(words.front());
  words.erase(words.begin());
  const auto library = open(name, where, libraries, opened, warnings);
  if (!library) return library.error();
  if (!*library) return std::shared_ptr<const CustomCode>();
  Result<std::unique_ptr<CustomKind>> made = (*library)->make<CustomKind>();
  if (!made) return Error{where, "custom model " + in_quotes(name) + ": " + made.error().line()};
  const Result<CustomKind::Sizes> sizes = configure(**made, words);
  if (!sizes) return Error{where, "custom model " + in_quotes(name) + ": " + sizes.error().line()};
  auto code = std::make_shared<CustomCode>();
  // Keeps the library loaded until the last object is deleted.
  code->kind = {made->release(), [kept = *library](const CustomKind* kind) { delete kind; }};
  code->sizes = *sizes;
  return std::shared_ptr<const CustomCode>(std::move(code));
}

}  // namespace

Result<std::vector<std::string>> attach_custom_kinds(world::World& world,
                                                     const libraries::Libraries& libraries) {
  const scene::SceneDesc& scene = world.scene();
  std::vector<std::string> warnings;
  Opened opened;
  world.custom_codes.assign(scene.models.size(), nullptr);
  for (std::size_t row = 0; row < scene.models.size(); ++row) {
    const scene::ModelDesc& model = scene.models[row];
    if (model.kind != scene::ModelKind::kCustom) continue;
    auto code = make_code(model.custom->library, scene.at(model.where), libraries, opened, warnings);
    if (!code) return code.error();
    world.custom_codes[row] = std::move(*code);
  }
  for (const world::CustomRow row : world.customs.rows()) world::begin_custom(world, {row});
  return warnings;
}

}  // namespace playhouse::custom_kinds
