#include "playhouse/scene/vocabulary.h"

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {
namespace {

constexpr ModelType kTypes[] = {
    {"model", ModelKind::kPlain, true, true, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
    {"position", ModelKind::kPosition, true, true, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
    {"ranger", ModelKind::kRanger, true, false, {0.15, 0.15, 0.2}, {0, 0, 0.5f, 1}},
    {"fiducial", ModelKind::kFiducial, true, false, {0, 0, 0}, {1, 0, 0, 1}},
    {"actuator", ModelKind::kPlain, false, true, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
    {"blinkenlight", ModelKind::kPlain, false, true, {0.02, 0.02, 0.02}, {0, 1, 0, 1}},
    {"blobfinder", ModelKind::kPlain, false, false, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
    {"bumper", ModelKind::kPlain, false, true, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
    {"camera", ModelKind::kPlain, false, true, {0.1, 0.07, 0.05}, {0, 0, 0, 1}},
    {"gripper", ModelKind::kPlain, false, true, {0.2, 0.3, 0.2}, {0.3f, 0.3f, 0.3f, 1}},
    {"lightindicator", ModelKind::kPlain, false, true, {0.4, 0.4, 1.0}, {1, 0, 0, 1}},
};

/// Types of Stage 1 to 3 and what Stage 4 has instead.
struct OldType {
  std::string_view name, instead;
};
constexpr OldType kOldTypes[] = {
    {"laser", "write ranger( sensor( range [0 8] fov 180 samples 180 ) )"},
    {"sonar", "write ranger( sensor( pose [x y z heading] range [0 5] fov 15 ) ... )"},
    {"ptz", "a camera has pantilt [pan tilt]"},
    {"map", "write model( bitmap \"file.png\" size [x y z] boundary 1 ), or the floorplan macro of map.inc"},
    {"environment", "write model( bitmap \"file.png\" size [x y z] boundary 1 )"},
    {"box", "write model( size [x y z] )"},
    {"puck", "write: define puck model( size [0.08 0.08 0.1] gripper_return 1 )"},
    {"charger", "write model( joules -1 give_watts 1000 )"},
    {"power", "joules and watts are properties of any model"},
    {"powerpack", "joules and watts are properties of any model"},
    {"wifi", "Stage 4 has no radio"},
    {"audio", "Stage 4 has no audio; any model has say \"text\""},
    {"speech", "any model has say \"text\""},
    {"player", "leave it out; devices are named in the configuration file"},
    {"driver", "this is a configuration file, for playhouse serve"},
    {"truth", "leave it out; every model's pose is known by its name"},
};

enum class Use {
  kRead,    // read by this build
  kSilent,  // known to Stage 4, of no consequence for the simulation
  kLater,   // known to Stage 4, not simulated by this build
  kOld,     // ignored by Stage 4 too; older versions knew it
};

/// The words of one vocabulary that share a use, separated by blanks; `type` limits them to one model type.
struct Words {
  Vocabulary vocabulary;
  std::string_view type;
  Use use;
  std::string_view words;
};

constexpr Words kWords[] = {
    {Vocabulary::kWorld, "", Use::kRead,
     "name interval_sim resolution quit_time unit_length unit_angle speedup paused"},
    {Vocabulary::kWorld, "", Use::kSilent, "show_clock show_clock_interval threads confirm_on_quit test"},
    {Vocabulary::kWorld, "", Use::kOld,
     "size interval_real gui_interval gui_menu_interval gui_disable threadpool truth_server map_resolution"},
    {Vocabulary::kWindow, "", Use::kRead, "center rotate scale show_data follow_model"},
    {Vocabulary::kWindow, "", Use::kSilent,
     "size pcam_loc pcam_angle pcam_on interval screenshots screenshot_skip show_blocks show_flags "
     "show_clock "
     "show_follow show_footprints show_grid show_status show_trailarrows show_trailrise show_trailfast "
     "show_trailblur show_occupancy show_voxels show_boundingboxes show_ranger_transducers "
     "show_ranger_ranges "
     "show_ranger_strikes show_ranger_fov show_fiducial show_fiducial_fov show_gripper_data show_blinken "
     "show_camera show_bumper_hits show_position_coords show_position_waypoints ranger_vis blobfinder_vis "
     "raster_vis custom_vis energy_dissipation energy_input energy_stored"},
    {Vocabulary::kWindow, "", Use::kOld, "fill_polygons polygons grid rangerdata laserdata show_tree"},
    {Vocabulary::kModel, "", Use::kRead,
     "pose size origin name color color_rgba bitmap noblocks boundary obstacle_return ranger_return "
     "fiducial_return fiducial_key gripper_return mass update_interval alwayson stack_children ctrl say "
     "gui_move trail_length"},
    {Vocabulary::kModel, "", Use::kSilent,
     "blob_return friction map_resolution gui_grid gui_nose gui_outline trail_interval event_queue debug"},
    {Vocabulary::kModel, "", Use::kLater,
     "watts joules kjoules joules_capacity kjoules_capacity give_watts take_watts"},
    {Vocabulary::kModel, "", Use::kOld,
     "laser_return sonar_return gui_movemask gui_boundary gui_geometry shape reversed scale port "
     "block_return "
     "polygons interval_real"},
    {Vocabulary::kModel, "position", Use::kRead,
     "drive velocity velocity_bounds acceleration_bounds wheelbase localization localization_origin "
     "odom_error"},
    {Vocabulary::kModel, "position", Use::kOld, "odom power steer"},
    {Vocabulary::kModel, "ranger", Use::kOld,
     "range_max range_min view ssize spose scount sview srange samples fov laser_sample_skip"},
    {Vocabulary::kModel, "fiducial", Use::kRead, "range_min range_max range_max_id fov ignore_zloc"},
    {Vocabulary::kModel, "blobfinder", Use::kSilent, "colors_count colors image range fov pan"},
    {Vocabulary::kModel, "blobfinder", Use::kOld, "channel_count channels channels_count range_max ptz"},
    {Vocabulary::kModel, "bumper", Use::kSilent, "bcount bpose blength"},
    {Vocabulary::kModel, "gripper", Use::kSilent, "paddle_size paddle_state autosnatch"},
    {Vocabulary::kModel, "camera", Use::kSilent, "resolution range fov pantilt"},
    {Vocabulary::kModel, "actuator", Use::kSilent,
     "type axis min_position max_position max_speed start_position"},
    {Vocabulary::kModel, "blinkenlight", Use::kSilent, "period dutycycle enabled"},
    {Vocabulary::kBlock, "", Use::kRead, "points point z"},
    {Vocabulary::kBlock, "", Use::kOld, "height filled color"},
    {Vocabulary::kSensor, "", Use::kRead, "pose size range fov samples noise color color_rgba"},
    {Vocabulary::kSensor, "", Use::kOld, "range_max range_min view ranger_return obstacle_return alwayson"},
};

/// What to write instead of an old property.
struct OldProperty {
  Vocabulary vocabulary;
  std::string_view word, instead;
};
constexpr OldProperty kOldProperties[] = {
    {Vocabulary::kModel, "laser_return", "Stage 4 has ranger_return"},
    {Vocabulary::kModel, "sonar_return", "Stage 4 has ranger_return"},
    {Vocabulary::kModel, "range_max", "it belongs into a sensor( range [min max] )"},
    {Vocabulary::kModel, "range_min", "it belongs into a sensor( range [min max] )"},
    {Vocabulary::kModel, "samples", "it belongs into a sensor( ... )"},
    {Vocabulary::kModel, "fov", "it belongs into a sensor( ... )"},
    {Vocabulary::kModel, "view", "write sensor( range [min max] fov degrees )"},
    {Vocabulary::kModel, "spose", "write one sensor( pose [x y z heading] ) each"},
    {Vocabulary::kModel, "ssize", "write sensor( size [x y z] )"},
    {Vocabulary::kModel, "sview", "write sensor( range [min max] fov degrees )"},
    {Vocabulary::kModel, "scount", "the sensor( ) entities are counted"},
    {Vocabulary::kModel, "odom", "write localization \"odom\""},
    {Vocabulary::kSensor, "range_max", "write range [min max]"},
    {Vocabulary::kSensor, "range_min", "write range [min max]"},
    {Vocabulary::kSensor, "view", "write range [min max] fov degrees"},
};

/// Calls `visit(word)` for each word of a line, until it returns true.
template <typename Visit>
bool any_word(std::string_view words, Visit visit) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (visit(words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

bool applies(const Words& words, Vocabulary vocabulary, std::string_view type) {
  return words.vocabulary == vocabulary && (words.type.empty() || words.type == type);
}

const Words* find_word(Vocabulary vocabulary, std::string_view type, std::string_view word) {
  for (const Words& words : kWords) {
    if (!applies(words, vocabulary, type)) continue;
    if (any_word(words.words, [word](std::string_view w) { return w == word; })) return &words;
  }
  return nullptr;
}

std::string hint(Vocabulary vocabulary, std::string_view type, std::string_view word) {
  std::vector<std::string_view> candidates = {"include"};
  if (vocabulary == Vocabulary::kWorld) candidates.push_back("define");
  for (const Words& words : kWords) {
    if (!applies(words, vocabulary, type) || words.use == Use::kOld) continue;
    any_word(words.words, [&candidates](std::string_view w) {
      candidates.push_back(w);
      return false;
    });
  }
  return did_you_mean(word, candidates);
}

std::string instead_of(Vocabulary vocabulary, std::string_view word) {
  for (const OldProperty& old : kOldProperties) {
    if (old.vocabulary == vocabulary && old.word == word) return ": " + std::string(old.instead);
  }
  return {};
}

std::string_view owner(Vocabulary vocabulary, std::string_view type) {
  switch (vocabulary) {
    case Vocabulary::kWorld:
      return "the world";
    case Vocabulary::kWindow:
      return "window";
    case Vocabulary::kBlock:
      return "block";
    case Vocabulary::kSensor:
      return "sensor";
    case Vocabulary::kModel:
      break;
  }
  return type;
}

}  // namespace

const ModelType* find_model_type(std::string_view name) {
  const auto found = std::find_if(std::begin(kTypes), std::end(kTypes),
                                  [name](const ModelType& type) { return type.name == name; });
  return found == std::end(kTypes) ? nullptr : found;
}

std::string unknown_type(std::string_view name, std::span<const std::string_view> macros) {
  const std::string text = "unknown model type " + in_quotes(name);
  for (const OldType& old : kOldTypes) {
    if (old.name == name) return text + " (Stage 4 has none: " + std::string(old.instead) + ")";
  }
  std::vector<std::string_view> candidates;
  for (const ModelType& type : kTypes) candidates.push_back(type.name);
  for (const std::string_view word : {"window", "block", "sensor"}) candidates.push_back(word);
  candidates.insert(candidates.end(), macros.begin(), macros.end());
  return text + did_you_mean(name, candidates);
}

void VocabularyCheck::check(Vocabulary vocabulary, std::string_view type, const Properties& properties) {
  LoadState& state = properties.state();
  for (const Field* field : properties.fields().all()) {
    if (!checked_.insert(field).second) continue;  // a macro's field is seen once per instance
    const std::string_view word = without_index(field->key);
    const Words* known = find_word(vocabulary, type, word);
    if (known && known->use != Use::kLater && known->use != Use::kOld) continue;
    if (known && !words_.insert(word).second) continue;
    const std::string subject = in_quotes(word);
    const std::string whose = " of " + std::string(owner(vocabulary, type));
    if (!known) {
      state.warnings.add(Warning::kUnknownWord, field->where, "unknown property " + subject + whose,
                         [&] { return hint(vocabulary, type, word); });
    } else if (known->use == Use::kLater) {
      state.warnings.add(Warning::kNoEffect, field->where,
                         subject + " is not simulated yet and has no effect");
    } else {
      state.warnings.add(Warning::kNoEffect, field->where,
                         subject + whose + " has no effect" + instead_of(vocabulary, word));
    }
  }
}

}  // namespace playhouse::scene
