/// What is written is read back the same, and by Stage 4 as well.

#include "playhouse/scene/write_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/testing/reference.h"
#include "playhouse/mesh/testing_meshes.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/testing_same_scene.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::map<std::string, std::string> kFiles = {{"w/plan", "P1 3 3 1 0 0  1 1 0  0 0 1"},
                                                   {"w/below/plan", "P1 2 2 1 0 0 1"},
                                                   {"w/../other/plan", "P1 2 1 1 1"},
                                                   {"w/plan.obj", mesh::test_obj()}};

SceneDesc loaded(const std::string& text, const std::string& path = "w/t.world") {
  config::MemoryFiles files(kFiles);
  Result<SceneDesc> scene = load_world_text(text, path, files);
  EXPECT_TRUE(scene.ok()) << scene.error().line() << "\n" << text;
  return scene ? std::move(*scene) : SceneDesc{};
}

std::string written(const SceneDesc& scene, const std::string& path = "w/t.world") {
  const Result<std::string> text = write_world(scene, path);
  EXPECT_TRUE(text.ok()) << text.error().line();
  return text ? *text : "";
}

/// What a file says, written and read again, differs in.
std::string difference_of(const std::string& text) {
  const SceneDesc scene = loaded(text);
  const std::string again = written(scene);
  return difference(scene, loaded(again)) +
         (written(loaded(again)) == again ? "" : " (written otherwise then)");
}

// ---- what Stage 4 reads
// ------------------------------------------------------------------------------------------------------

/// A fault by the rules of Stage 4's files, which are narrower than ours: "" if there is none.
class StageRules {
 public:
  explicit StageRules(std::string_view text) : text_(text) {}

  std::string fault() {
    while (at_ < text_.size() && fault_.empty()) token();
    if (fault_.empty() && depth_ != 0) fault_ = "brackets";
    return fault_.empty() ? "" : fault_ + " before: " + std::string(text_.substr(at_, 40));
  }

 private:
  static constexpr std::size_t kBuffer = 255;

  void token() {
    const char c = text_[at_];
    if (c == '#') return run("comment", [](char d) { return d != '\n'; });
    if (c == '"') return string();
    if (std::isalpha(static_cast<unsigned char>(c)))
      return run("word", [](char d) {
        return std::isalnum(static_cast<unsigned char>(d)) ||
               std::string_view(".-_[]").find(d) != std::string_view::npos;
      });
    if (std::string_view("+-.0123456789").find(c) != std::string_view::npos) {
      run("number",
          [](char d) { return std::string_view("+-.0123456789").find(d) != std::string_view::npos; });
      if (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) fault_ = "an exponent";
      return;
    }
    if (c == '[' && in_tuple_) fault_ = "a tuple in a tuple";
    if (c == '\n' && in_tuple_) fault_ = "a tuple on two lines";
    if (c == '[') in_tuple_ = true;
    if (c == ']') in_tuple_ = false;
    if (c == '(') ++depth_;
    if (c == ')') --depth_;
    if (std::string_view(" \n[]()").find(c) == std::string_view::npos) fault_ = "an odd character";
    ++at_;
  }
  template <typename Is>
  void run(const char* what, const Is& is) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is(text_[at_])) ++at_;
    if (at_ - begin > kBuffer) fault_ = std::string("a long ") + what;
  }
  void string() {
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    if (end == std::string_view::npos || text_[end] != '"') fault_ = "a string without end";
    if (end - at_ > kBuffer) fault_ = "a long string";
    at_ = std::min(end, text_.size() - 1) + 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool in_tuple_ = false;
  std::string fault_;
};

// ---- files of people
// ------------------------------------------------------------------------------------------------------

void expect_read_back_the_same(const SceneDesc& scene, const std::string& path) {
  for (const std::string& to : {path + ".saved", std::string("/elsewhere/saved.world")}) {
    const std::string text = written(scene, to);
    config::DiskFiles files;
    const Result<SceneDesc> again = load_world_text(text, to, files);
    ASSERT_TRUE(again.ok()) << again.error().line();
    EXPECT_EQ(difference(scene, *again), "") << path;
    EXPECT_LE(again->models.size(), scene.models.size()) << path;
    EXPECT_LE(again->warnings.size(), scene.warnings.size()) << path;
    EXPECT_EQ(StageRules(text).fault(), "") << path;
    if (again->models.size() != scene.models.size()) continue;
    for (std::size_t row = 0; row < again->models.size(); ++row)
      EXPECT_EQ(again->models[row].prototype, scene.models[row].prototype) << path;
  }
}

/// Worlds in the folder and below it that load, each compared.
int compare_all(const std::filesystem::path& folder) {
  int compared = 0;
  // Through no link: a world written elsewhere names its files by where they are.
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::canonical(folder))) {
    if (entry.path().extension() != ".world") continue;
    const std::string path = entry.path().string();
    const Result<SceneDesc> scene = load_world(path);
    if (!scene) continue;
    expect_read_back_the_same(*scene, path);
    ++compared;
  }
  return compared;
}

TEST(WriteWorld, every_world_here_is_read_back_the_same) {
  EXPECT_GE(compare_all(PLAYHOUSE_SOURCE_DIR "/worlds"), 6);
}

TEST(WriteWorld, every_world_of_stage_is_read_back_the_same) {
  SKIP_WITHOUT_STAGE();
  EXPECT_GE(compare_all(stage_source() / "worlds"), 15);
}

// ---- words
// ------------------------------------------------------------------------------------------------------

/// Another value than the one that counts without the word.
std::string any_value(const Word& word) {
  if (word.type == "flag") return word.otherwise == "1" || word.name == "gui_move" ? "0" : "1";
  if (word.type == "integer" || word.type == "count") return "7";
  if (word.type == "number") return word.limits == "from 0 to 1" ? "0.375" : "212.375";
  if (word.type == "length" || word.type == "angle") return "0.37";
  if (word.name == "mesh" || word.name == "look") return "\"plan.obj\"";
  if (word.name == "ground") return "\"ice\"";          // a known material
  if (word.name == "rfid_tag") return "\"e200 01ff\"";  // hexadecimal bytes
  if (word.type == "text") return "\"plan\"";
  if (word.type == "texts") return "[\"name=a mass>1\" \"color=red\"]";  // conditions are
  if (word.type == "color") return "\"SteelBlue3\"";
  if (word.type == "colors") return "[\"red\" \"teal\" \"gray51\" \"DarkGreen\"]";
  if (word.type == "choice") {
    const std::size_t end = word.form.rfind('"'), begin = word.form.rfind('"', end - 1);
    return std::string(word.form.substr(begin, end - begin + 1));
  }
  if (word.type == "choices") {  // the last word of each
    std::string last;
    for (std::size_t end = word.form.find(')'); end != std::string_view::npos;
         end = word.form.find(')', end + 1)) {
      const std::size_t begin = word.form.rfind('"', end - 2);
      last += (last.empty() ? "" : " ") + std::string(word.form.substr(begin, end - begin));
    }
    return "[" + last + "]";
  }
  // As many numbers as the form has names, ascending.
  std::string numbers;
  const double step = word.limits == "from 0 to 1" ? 0.25 : 1.5;
  double number = word.limits.starts_with("from 1 ") ? 3 : 0.125;
  for (std::size_t at = 0; at != std::string_view::npos; at = word.form.find(' ', at + 1), number += step)
    numbers += (numbers.empty() ? "" : " ") + std::to_string(word.type == "rgba" ? number / 10 : number);
  return "[" + numbers + "]";
}

std::string file_with(const Kind& kind, const std::string& words) {
  if (kind.entity == EntityForm::kWorld) return words + "\nposition ( pose [1 2 3 4] )\n";
  const std::string entity = std::string(kind.name) + " ( " + words + " )\n";
  return kind.entity == EntityForm::kPart ? std::string(kind.inside) + " ( " + entity + " )" : entity;
}

/// So that no word of a kind is read and not written.
TEST(WriteWorld, every_word_of_every_kind_is_read_back_with_its_value) {
  int words = 0;
  for (const Kind& kind : kinds()) {
    if (kind.name == "block" || kind.entity == EntityForm::kTrait)
      continue;  // no words, or a test of its own
    std::string all;
    for (const std::span<const Word> some : {common_words(kind), kind.words}) {
      for (const Word& word : some) {
        if (word.use == Support::kOld || (word.use == Support::kSilent && word.type.empty())) continue;
        const bool is_of_mesh = word.name.starts_with("mesh") || word.name == "look";
        if (is_of_mesh && kind.name == "gripper") continue;  // has paddles
        if (word.name == "robot_types")
          continue;  // of defines, which written files don't keep (docs/robot-client.md)
        const bool is_counted = !word.counted_by.empty();
        const std::string count = is_counted ? std::string(word.counted_by) + " 2 " : "";
        const std::string mesh = word.name.starts_with("mesh_") ? "mesh \"plan.obj\" " : "";
        const std::string said = mesh + count + std::string(word.name) + " " + any_value(word);
        EXPECT_EQ(difference_of(file_with(kind, said)), "") << said;
        EXPECT_THAT(written(loaded(file_with(kind, said))),
                    HasSubstr(std::string(word.name) + (is_counted ? "[1] " : " ")))
            << kind.name << ": " << said;
        if (word.type != "rgba" && !is_of_mesh) all += said + " ";
        ++words;
      }
    }
    EXPECT_EQ(difference_of(file_with(kind, all)), "") << all;
    EXPECT_EQ(StageRules(written(loaded(file_with(kind, all)))).fault(), "");
  }
  EXPECT_GE(words, 100);
}

TEST(WriteWorld, words_that_this_build_does_not_read_are_kept) {
  const std::string text =
      written(loaded("threads 4\nwindow ( size [300 200] show_grid 0 )\n"
                     "position ( trail_interval \"0.5\" debug 1.0 laser_return 1 unheard_of 2 )"));
  EXPECT_THAT(text, HasSubstr("threads 4\n"));
  EXPECT_THAT(text, HasSubstr("window ( show_grid 0 size [300 200] )"));
  EXPECT_THAT(text, HasSubstr("debug 1 trail_interval \"0.5\" )"));
  EXPECT_THAT(text, Not(HasSubstr("unheard_of")));
  EXPECT_THAT(text, Not(HasSubstr("laser_return"))) << "Stage 4 does not read it either";
}

TEST(WriteWorld, numbers_are_as_short_as_they_can_be) {
  EXPECT_EQ(written(loaded(
                "position ( pose [0.1 -2.50 1e-7 280] velocity [0.3 0 0 -45.5] fiducial ( fov 33.3 ) )")),
            "position (\n  pose [0.1 -2.5 0.0000001 280]\n  velocity [0.3 0 0 -45.5]\n  fiducial ( fov 33.3 "
            ")\n)\n");
  EXPECT_EQ(written(loaded("model ( size [1 1 0.22] model ( pose [0 0 0.1 0] ) )")),
            "model (\n  size [1 1 0.22]\n  model ( pose [0 0 0.1 0] )\n)\n");
}

TEST(WriteWorld, files_keep_their_units) {
  for (const std::string units : {"", "unit_angle \"radians\"\n", "unit_length \"cm\"\n",
                                  "unit_length \"mm\"\nunit_angle \"radians\"\n"}) {
    const std::string text =
        units +
        "\nposition ( pose [0.7 57 35 2.1] wheelbase 3.3 ranger ( pose [1.3 -7 12 1.5708] "
        "sensor ( fov 0.1 range [0.3 77] noise [0.1 0.1 0.1] ) ) )";
    EXPECT_EQ(difference_of(text), "") << units;
    EXPECT_THAT(written(loaded(text)), StartsWith(units));
    EXPECT_THAT(written(loaded(text)), HasSubstr("pose [1.3 -7 12 1.5708]"));
  }
}

TEST(WriteWorld, colors_are_named_where_stage_knows_the_name) {
  const std::string text =
      written(loaded("model ( color \"dark slate grey\" )\nmodel ( color \"silver\" )\n"
                     "model ( color_rgba [0 1 0 1] )\nmodel ( color_rgba [0 1 0 0.5] )\n"
                     "blobfinder ( colors_count 2 colors [\"lime\" \"teal\"] )"));
  EXPECT_THAT(text, HasSubstr("color \"DarkSlateGray\""));
  EXPECT_THAT(text, HasSubstr("color_rgba [0.7529412 0.7529412 0.7529412 1]"));
  EXPECT_THAT(text, HasSubstr("color \"green\""));
  EXPECT_THAT(text, HasSubstr("color_rgba [0 1 0 0.5]"));
  EXPECT_THAT(text, HasSubstr("colors [\"green\" \"teal\"]"));
}

TEST(WriteWorld, texts_that_no_file_can_hold_are_written_as_something_like_them) {
  SceneDesc scene = loaded("model ( name \"a\" say \"b\" )");
  scene.trees[0].name = "\"x\"\ny";
  scene.models[0].say = "one\r\ntwo";
  const SceneDesc again = loaded(written(scene));
  EXPECT_EQ(again.trees[0].name, "'x' y");
  EXPECT_EQ(again.models[0].say, "one  two");
}

// ---- names
// ------------------------------------------------------------------------------------------------------

TEST(WriteWorld, names_are_said_where_the_model_would_have_another) {
  for (const char* text : {
           "position ( name \"position:0\" )\nposition ( )\nposition ( name \"x\" )\nposition ( )",
           "position ( name \"position:1\" )\nposition ( name \"a\" )",
           "model ( )\nmodel ( name \"model:7\" )\nmodel ( name \"/m\" )\nmodel ( name \"//m\" )\nmodel ( "
           "name \"/\" )",
           "model ( name \"a\" model ( name \"b\" model ( ) ) model ( name \"/c\" model ( name \"d\" ) ) )",
           "model ( name \"a\" model ( name \"/\" ) model ( name \"x/y\" ) model ( name \"/a./x\" ) )",
           "model ( name \"a\" model ( name \"model:1\" ) model ( name \"b.c\" ) model ( ) ranger ( ) )",
           "model ( name \"a\" )\nmodel ( name \"a.x\" model ( ) )\nposition ( name \"a\" )",
           "position ( name \"a\" ranger ( ) )\nposition ( name \"a\" ranger ( ) )\nposition ( name \"a\" "
           "ranger ( ) )",
           "model ( name \"a\" model ( name \"b\" ) )\nmodel ( name \"a.b\" )",
           "model ( name \"b\" )\nmodel ( model ( name \"/b\" ) )\nmodel ( model ( name \"/b\" model ( ) ) )",
       })
    EXPECT_EQ(difference_of(text), "") << text;
}

// ---- bodies
// ------------------------------------------------------------------------------------------------------

TEST(WriteWorld, bodies_are_as_the_file_says_them) {
  for (const char* text : {
           "model ( noblocks 1 )",
           "model ( boundary 1 size [3 2 1] )",
           "model ( size [0 1 1] )\nmodel ( size [0 0 1] )\nranger ( size [1 1 1] )\nfiducial ( boundary 1 )",
           "model ( block ( points 3 point[0] [0.1 0.7] point[1] [0.3 -1.3] point[2] [3.1 0.2] z [0.1 0.7] ) "
           ")",
           "model ( block ( points 2 point[0] [1 2] point[1] [3 5] z [0 1] ) )",
           "model ( block ( points 4 point[0] [1 2] point[1] [3 5] ) size [0.44 0.38 0.22] )",
           "model ( block ( points 3 point[1] [0 1] point[2] [1 0] z [0 1] ) block ( points 3 point[1] [0 7] "
           "point[2] [3 0] ) )",
           "unit_length \"cm\"\nmodel ( block ( points 3 point[1] [0 13] point[2] [7 0] z [-3 11] ) size [44 "
           "38 22] )",
           "model ( bitmap \"plan\" boundary 1 noblocks 1 size [7 7 1] )",
           "model ( bitmap \"plan\" block ( points 3 point[0] [0 0] point[1] [0 9] point[2] [5 5] z [0 2] ) "
           ")",
           "model ( stack_children 0 size [1 1 2] model ( pose [0 0 0.5 0] model ( ) ) )",
           "gripper ( size [1 2 3] paddle_size [0.3 0.2 0.1] paddle_state [\"closed\" \"down\"] )",
           "gripper ( boundary 1 )\ngripper ( noblocks 1 )\ngripper ( size [0 1 1] )",
       })
    EXPECT_EQ(difference_of(text), "") << text;
}

TEST(WriteWorld, bitmaps_are_named_from_the_folder_of_the_file_where_they_are_below_it) {
  const SceneDesc scene = loaded("model ( bitmap \"below/plan\" )\nmodel ( bitmap \"../other/plan\" )");
  const std::string here = std::filesystem::current_path().string();
  const std::string text = written(scene);
  EXPECT_THAT(text, HasSubstr("bitmap \"below/plan\""));
  EXPECT_THAT(text, HasSubstr("bitmap \"" + here + "/other/plan\""));
  EXPECT_THAT(written(scene, "saved.world"), HasSubstr("bitmap \"w/below/plan\""));
  for (const char* path : {"/elsewhere/saved.world", ""})
    EXPECT_THAT(written(scene, path), HasSubstr("bitmap \"" + here + "/w/below/plan\""));
}

TEST(WriteWorld, models_that_code_made_have_their_blocks) {
  SceneDesc scene;
  ModelDesc model;
  model.name = model.alias = model.prototype = "m";
  model.size = {2, 1, 1};
  scene.models.push_back(model);
  model.blocks = {{{{-1, -0.5}, {1, -0.5}, {0, 0.5}}, 0, 1}};
  scene.models.push_back(model);
  scene.models.back().name = "n";
  const SceneDesc again = expanded(loaded(written(scene)));
  ASSERT_EQ(again.models.size(), 2u);
  EXPECT_TRUE(again.models[0].blocks.empty());
  EXPECT_EQ(again.models[1].blocks, model.blocks);
}

// ---- macros
// ------------------------------------------------------------------------------------------------------

std::string swarm(int robots, const std::string& own = {}) {
  std::string text = "define robot position ( size [0.4 0.4 0.2]\n";
  for (int i = 0; i < 12; ++i) text += " ranger ( pose [0 0 0 " + std::to_string(30 * i) + "] sensor ( ) )\n";
  text += ")\n";
  for (int i = 0; i < robots; ++i)
    text +=
        "robot ( name \"r" + std::to_string(i) + "\" pose [" + std::to_string(i) + " 0 0 0] " + own + " )\n";
  return text;
}

TEST(WriteWorld, what_a_swarm_has_in_common_is_said_once) {
  const SceneDesc scene = loaded(swarm(1000, "color \"blue\""));
  const std::string text = written(scene);
  EXPECT_LT(text.size(), 40000u);
  EXPECT_THAT(text, HasSubstr("define robot position (\n  color \"blue\"\n"));
  EXPECT_THAT(text, HasSubstr("\nrobot ( name \"r7\" pose [7 0 0 0] )\n"));
  const SceneDesc again = loaded(text);
  EXPECT_EQ(difference(scene, again), "");
  EXPECT_EQ(again.models.size(), 13u);
  EXPECT_EQ(again.models[0].prototype, "robot");
}

TEST(WriteWorld, robots_of_one_macro_that_differ_are_of_one_macro_again) {
  const std::string text =
      "define robot position ( size [1 1 1] mass 3 ranger ( sensor ( ) ) )\n"
      "robot ( ctrl \"wander\" )\nrobot ( mass 4 )\nrobot ( ranger ( ) )\nrobot ( ctrl \"wander\" color "
      "\"blue\" )\n"
      "model ( name \"robot\" )\nmodel ( name \"wall\" model ( ) )\nmodel ( model ( ) )\nmodel ( model ( ) )";
  const SceneDesc scene = loaded(text), again = loaded(written(scene));
  EXPECT_EQ(difference(scene, again), "");
  ASSERT_EQ(again.models.size(), scene.models.size());
  for (std::size_t row = 0; row < scene.models.size(); ++row)
    EXPECT_EQ(again.models[row].prototype, scene.models[row].prototype);
  EXPECT_THAT(written(scene), HasSubstr("define robot position (\n  size [1 1 1]\n  ranger"));
  EXPECT_THAT(written(scene), HasSubstr("robot ( mass 4 )\n"));
}

TEST(WriteWorld, macros_hide_no_word_that_the_file_needs) {
  for (const char* text : {
           "define block model ( size [1 1 1] model ( ) )\nblock ( )\nblock ( name \"b\" )\n"
           "define sensor model ( )\nsensor ( pose [1 0 0 0] )\ndefine window position ( )\nwindow ( )",
           "define a_block model ( mass 3 )\na_block ( )\ndefine block model ( mass 4 )\nblock ( )",
           "position ( name \"0 <?>\" ranger ( ) )\nposition ( name \"b\" ranger ( ) )",
           "position ( name \"include\" ranger ( ) )\nposition ( name \"b\" ranger ( ) )",
       }) {
    EXPECT_EQ(difference_of(text), "") << text;
    EXPECT_EQ(StageRules(written(loaded(text))).fault(), "");
  }
}

TEST(WriteWorld, a_world_without_models_is_one_again) {
  SceneDesc scene = loaded("resolution 0.5\n");
  EXPECT_EQ(written(scene), "resolution 0.5\n\n");
  EXPECT_TRUE(loaded(written(scene)).models.empty());
}

TEST(WriteWorld, a_file_that_would_be_too_large_is_refused_with_a_line) {
  SceneDesc scene = loaded("model ( name \"a\" )");
  scene.models[0].say = std::string(limits::kFileBytes, 'x');
  const Result<std::string> text = write_world(scene, "w/t.world");
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.error().text, "the world is too large for a file of 67108864 bytes");
}

// ---- anything
// ------------------------------------------------------------------------------------------------------

std::string any_entity(int depth) {
  static const std::vector<std::string> kTypes = {"position", "ranger",  "model",        "fiducial",
                                                  "robot",    "gripper", "blinkenlight", "actuator"};
  static const std::vector<std::string> kWords = {
      "name \"a\"",
      "name \"b\"",
      "name \"/b\"",
      "name \"position:1\"",
      "name \"a.model:0\"",
      "name \"c.x\"",
      "pose [1 2 3 4]",
      "pose [0.1 -0.7 0.3 200.3]",
      "pose [1e-9 3 0 359.99]",
      "pose [-5.123456789012345 0 0 -180]",
      "origin [0.1 0 0.2 33.3]",
      "size [0.3 0.7 0.1]",
      "size [0 1 1]",
      "color \"random\"",
      "color_rgba [0.1 0.2 0.3 0.7]",
      "color \"teal\"",
      "fiducial_return 5",
      "say \"it's\"",
      "mass 0.1",
      "ctrl \"wander 3\"",
      "ctrl [\"a\" \"b\"]",
      "stack_children 0",
      "gui_move 0",
      "alwayson 1",
      "update_interval 33.3335",
      "ranger_return -1",
      "bitmap \"plan\"",
      "boundary 1",
      "noblocks 1",
      "watts 3",
      "period 333.3",
      "dutycycle 0.3",
      "type \"rotational\"",
      "axis [0.1 -0.7 2]",
      "min_position -0.3",
      "max_position 0.7",
      "start_position 0.31",
      "enabled 0",
      "friction 0.1",
      "velocity [0.1 0 0 7]",
      "drive \"car\"",
      "fov 77.7",
      "paddle_size [0.5 0.2 0.3]",
      "paddle_state [\"closed\" \"up\"]",
      "block ( points 3 point[1] [0 0.3] point[2] [0.7 0.1] z [0 0.3] )",
      "block ( points 2 point[1] [0.1 0.3] )",
      "velocity_bounds [-1 1 0 0 0 0 -33.3 44.4]",
      "localization_origin [0.1 0.2 0.3 123.4]"};
  std::string text = *rc::gen::elementOf(kTypes) + " (";
  const auto count = *rc::gen::inRange(0, 5);
  for (const std::string& word : *rc::gen::container<std::vector<std::string>>(
           static_cast<std::size_t>(count), rc::gen::elementOf(kWords)))
    text += " " + word;
  for (int inner = depth > 0 ? *rc::gen::inRange(0, 3) : 0; inner > 0; --inner)
    text += " " + any_entity(depth - 1);
  return text + " )\n";
}

RC_GTEST_PROP(WriteWorld, any_world_is_read_back_the_same, ()) {
  std::string text =
      *rc::gen::elementOf(std::vector<std::string>{"", "", "unit_angle \"radians\"\n", "interval_sim 250\n"});
  text +=
      "define robot position ( size [0.4 0.3 0.2] ranger ( pose [0.1 0 0.05 10] sensor ( fov 33.3 ) ) )\n";
  for (int count = *rc::gen::inRange(1, 8); count > 0; --count) text += any_entity(2);
  config::MemoryFiles files(kFiles);
  const Result<SceneDesc> scene = load_world_text(text, "w/t.world", files);
  RC_ASSERT(scene.ok());
  const Result<std::string> saved = write_world(*scene, "w/t.world");
  RC_ASSERT(saved.ok());
  const Result<SceneDesc> again = load_world_text(*saved, "w/t.world", files);
  RC_ASSERT(again.ok());
  RC_ASSERT(difference(*scene, *again) == "");
  RC_ASSERT(StageRules(*saved).fault() == "");
}

}  // namespace
}  // namespace playhouse::scene
