#include "playhouse/scene/world_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "playhouse/base/finding.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/scene/forms/charge.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/testing_expanded.h"

namespace playhouse::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Files = std::map<std::string, std::string>;

Result<SceneDesc> load(const std::string& text, Files others = {}, const WorldLimits& limits = {}) {
  config::MemoryFiles files(std::move(others));
  Result<SceneDesc> scene = load_world_text(text, "w/t.world", files, limits);
  if (scene) *scene = expanded(std::move(*scene));
  return scene;
}

SceneDesc loaded(const std::string& text, Files others = {}) {
  Result<SceneDesc> scene = load(text, std::move(others));
  EXPECT_TRUE(scene.ok()) << scene.error().line();
  return scene ? std::move(*scene) : SceneDesc{};
}

/// The only model of a world.
ModelDesc model_of(const std::string& text, Files others = {}) {
  SceneDesc scene = loaded(text, std::move(others));
  EXPECT_EQ(scene.models.size(), 1u) << text;
  return scene.models.empty() ? ModelDesc{} : std::move(scene.models[0]);
}

std::string error_of(const std::string& text, Files others = {}) {
  const Result<SceneDesc> scene = load(text, std::move(others));
  return scene ? "no error" : scene.error().line();
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::vector<std::string> names_of(const SceneDesc& scene) {
  std::vector<std::string> names;
  for (const ModelDesc& model : scene.models) names.push_back(model.name);
  return names;
}

/// x_min, x_max, y_min, y_max of points.
std::array<double, 4> extent(const std::vector<geom::Vec2>& points) {
  geom::Box box;
  for (const geom::Vec2 p : points) box.add(p);
  return {box.x_min, box.x_max, box.y_min, box.y_max};
}

double signed_area(const std::vector<geom::Vec2>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

// ---- text
// -------------------------------------------------------------------------------------------------------

TEST(WorldText, several_properties_may_share_a_line_and_comments_hold_any_byte) {
  const SceneDesc scene = loaded(
      "\xEF\xBB\xBF# \xff\xfe \"( [\r\nmodel( name \"a\" size [1 1 1]color \"red\" pose [1 2 3 4 9] "
      ")\r\rmodel\n # x\n\n"
      "(\tname \"b\")");
  EXPECT_THAT(names_of(scene), ElementsAre("a", "b"));
  EXPECT_EQ(scene.models[1].where.line, 4u);
}

TEST(WorldText, numbers_may_have_exponents_and_text_may_stand_for_numbers) {
  EXPECT_DOUBLE_EQ(model_of("model( mass 1.5e-3 )").mass, 0.0015);
  EXPECT_DOUBLE_EQ(model_of("model( mass \"+.5\" )").mass, 0.5);
  EXPECT_DOUBLE_EQ(model_of("model( mass 0.12345678901234567 )").mass, 0.12345678901234567);
}

TEST(WorldText, an_include_works_at_top_level_inside_an_entity_and_on_a_last_line_without_its_end) {
  const SceneDesc scene = loaded("model( include \"size.inc\" # rest\n )\ninclude \"more.inc\"",
                                 {{"w/size.inc", "size [1 2 3]"},
                                  {"w/more.inc", "include \"deep/more.inc\""},
                                  {"w/deep/more.inc", "model( name \"in\" )"}});
  EXPECT_EQ(scene.models[0].size, (geom::Size{1, 2, 3}));
  EXPECT_EQ(scene.models[1].name, "in");
  EXPECT_EQ(scene.at(scene.models[1].where), "w/deep/more.inc:1");
  EXPECT_THAT(scene.files, ElementsAre("w/t.world", "w/size.inc", "w/more.inc", "w/deep/more.inc"));
}

TEST(WorldText, an_include_beside_the_including_file_is_found_too) {
  EXPECT_EQ(model_of("include \"deep/a.inc\"",
                     {{"w/deep/a.inc", "include \"b.inc\""}, {"w/deep/b.inc", "model( name \"b\" )"}})
                .name,
            "b");
}

TEST(WorldText, faults_are_one_line_with_the_place) {
  EXPECT_EQ(error_of("model(\n pose [1, 2] )"),
            "w/t.world:2: unexpected character ',' (values are separated by spaces)");
  EXPECT_EQ(error_of("model(\n pose[1 2 3 4] )"), "w/t.world:2: \"pose[1\" needs a space before its \"[\"");
  EXPECT_EQ(error_of("model( name robot1 )"),
            "w/t.world:1: \"name\" needs a value, found the word \"robot1\" (text takes double quotes)");
  EXPECT_EQ(error_of("model( name\n\"x\" )"), "w/t.world:1: the value of \"name\" must be on the same line");
  EXPECT_EQ(error_of("model( pose [1 2\n3 4] )"),
            "w/t.world:1: the tuple of \"pose\" must end with \"]\" on the same line");
  EXPECT_EQ(error_of("model( pose [1 2"), "w/t.world:1: the tuple of \"pose\" lacks its \"]\"");
  EXPECT_EQ(error_of("\n\nmodel( player (\n)"), "w/t.world:3: \"model\" lacks its closing \")\"");
  EXPECT_EQ(error_of("model( ))"), "w/t.world:1: \")\" without its \"(\"");
  EXPECT_EQ(error_of("model( player\n)"), "w/t.world:1: \"player\" needs a value or \"(\"");
  EXPECT_EQ(error_of("\xef\xbb\xbf<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">"),
            "w/t.world:1: this is a world of Gazebo (SDF), not a world file of Player/Stage");
  EXPECT_EQ(error_of("#VRML_SIM R2021b utf8\nWorldInfo {\n}"),
            "w/t.world:1: this is a world of Webots, not a world file of Player/Stage");
  EXPECT_EQ(error_of("<html>"), "w/t.world:1: this is XML, not a world file of Player/Stage");
  EXPECT_THAT(error_of("version https://git-lfs.github.com/spec/v1\noid"), HasSubstr("`git lfs pull`"));
  EXPECT_EQ(error_of("model( ( ) )"), "w/t.world:1: expected a name or \")\", found \"(\"");
  EXPECT_EQ(error_of("model( name \"x )\n"), "w/t.world:1: string without its closing quote on this line");
  EXPECT_THAT(error_of("define x (\n)"),
              HasSubstr("w/t.world:1: define \"x\" needs the type it is based on"));
  EXPECT_THAT(error_of("define\n"), HasSubstr("define needs the name of the macro"));
  EXPECT_THAT(error_of("model( define x model ( ) )"), HasSubstr("outside all sections only"));
  EXPECT_THAT(error_of("include x.inc"), HasSubstr("include needs a file name in quotes"));
  EXPECT_EQ(error_of("\ninclude \"x.inc\""),
            "w/t.world:2: included file \"w/x.inc\" cannot be opened: no such file");
  EXPECT_EQ(error_of("model \x01"), "w/t.world:1: unexpected character 0x01");
}

/// Every line that a world gives: its warnings, and the error if there is one.
std::vector<std::string> lines_of(const std::string& text, Files others = {}) {
  const Result<SceneDesc> scene = load(text, std::move(others));
  return scene ? scene->warnings : std::vector{scene.error().line()};
}

/// All findings of a world that does not load, as they are told.
std::vector<std::string> findings_of(const std::string& text) {
  config::MemoryFiles files({});
  std::vector<Error> others;
  const Result<SceneDesc> scene = load_world_text(text, "w/t.world", files, {}, &others);
  EXPECT_FALSE(scene);
  if (scene) return scene->warnings;
  std::vector<std::string> lines{finding("error", scene.error())};
  for (const Error& other : others) lines.push_back(finding("error", other));
  return lines;
}

TEST(WorldText, an_unknown_type_of_a_macro_is_told_once_where_the_macro_is_defined) {
  EXPECT_THAT(findings_of("define x modle( size [1 1 1] )\nx( )\nx( )\ndefine y x( )\ny( )"),
              ElementsAre("w/t.world:1: error: unknown model type \"modle\" (did you mean \"model\"?)"));
}

TEST(WorldText, a_word_in_capitals_has_a_nearest_one) {
  EXPECT_THAT(
      findings_of("POSITION( )"),
      ElementsAre("w/t.world:1: error: unknown model type \"POSITION\" (did you mean \"position\"?)"));
}

TEST(WorldText, a_text_where_a_number_is_wanted_is_one_finding) {
  EXPECT_THAT(findings_of("interval_sim \"fast\""),
              ElementsAre("w/t.world:1: error: \"interval_sim\" needs a number, found \"fast\""));
}

TEST(WorldText, what_does_nothing_is_told) {
  const std::string block = "model( block( points 3 point[0] [0 0] point[1] [1 0] point[2] [1 1] z [0 1] ";
  const struct {
    std::string text, told;
  } cases[] = {
      {block + "point[3] [0 1] ) )", "\"point[3]\" has no effect: \"points\" is 3"},
      {block + "point [0 1] ) )", "\"point\" has no effect without a number: point[0], point[1] ..."},
      {"model( bitmap \"\" )", "\"bitmap\" names no file and has no effect"},
      {"model( color_rgba [255 0 0 1] )", "\"color_rgba\" takes values from 0 to 1; others are cut to that"},
      {"fiducial( range_min 5 range_max 2 )",
       "\"range_min\" is above \"range_max\": the fiducial sees nothing"},
  };
  for (const auto& one : cases)
    EXPECT_THAT(loaded(one.text).warnings, ElementsAre("w/t.world:1: " + one.told)) << one.text;
  EXPECT_EQ(model_of("model( color_rgba [255 0 0 1] )").color, (Color{1, 0, 0, 1}));
}

TEST(WorldText, the_id_of_a_tag_is_bytes) {
  EXPECT_EQ(loaded("model( rfid_tag \"E200 3412\" rfid_type 4 )").models[0].rfid_tag, "E200 3412");
  EXPECT_EQ(
      error_of("\nmodel( rfid_tag \"E20\" )"),
      "w/t.world:2: \"rfid_tag\" must be 1 to 62 bytes as pairs of hexadecimal digits, as \"E200 3412\", "
      "found \"E20\"");
  EXPECT_THAT(error_of("model( rfid_tag \"box 7\" )"), HasSubstr("\"rfid_tag\" must be 1 to 62 bytes"));
}

TEST(WorldText, a_ground_is_a_known_material_and_a_misspelt_material_is_told) {
  EXPECT_EQ(error_of("\nground \"icy\""),
            "w/t.world:2: \"ground\" \"icy\" is not a known material (did you mean \"ice\"?)");
  EXPECT_THAT(error_of("ground \"\""), HasSubstr("\"ground\" \"\" is not a known material"));
  EXPECT_THAT(loaded("ground \"carpet\" model( material \"velvet\" ) model( material \"smoke\" )").warnings,
              ElementsAre());
  EXPECT_THAT(
      loaded("model( material \"concret\" )").warnings,
      ElementsAre("w/t.world:1: \"material\" \"concret\" is a property for detectors only, not a known "
                  "material (did you mean \"concrete\"?)"));
  EXPECT_EQ(error_of("model( restitution 1.5 )"),
            "w/t.world:1: \"restitution\" must be from 0 to 1, found \"1.5\"");
}

TEST(WorldText, a_slip_in_a_keyword_is_told_also_when_an_error_follows_from_it) {
  EXPECT_THAT(findings_of("inclde \"map.inc\"\nfloorplan( name \"x\" )"),
              ElementsAre("w/t.world:2: error: unknown model type \"floorplan\"",
                          "w/t.world:1: warning: unknown property \"inclde\" of the world (did you mean "
                          "\"include\"?)"));
  EXPECT_THAT(
      findings_of("window( scal 10 )\nposition( pose [1 2] )"),
      ElementsAre("w/t.world:2: error: \"pose\" needs 4 values [x y z heading], found 2",
                  "w/t.world:1: warning: unknown property \"scal\" of window (did you mean \"scale\"?)"));
  EXPECT_EQ(error_of("defnie foo position ( )"),
            "w/t.world:1: \"defnie\" needs a value, found the word \"foo\" (did you mean \"define\"?)");
  EXPECT_THAT(
      loaded("inlcude \"map.inc\"\nmodel( includ \"more.inc\" )").warnings,
      ElementsAre(HasSubstr("(did you mean \"include\"?)"), HasSubstr("(did you mean \"include\"?)")));
  EXPECT_THAT(
      findings_of("model(\nblock( ponits 4 point[0] [0 0] ) )"),
      ElementsAre(HasSubstr("a block needs \"points\""),
                  "w/t.world:2: warning: unknown property \"ponits\" of block (did you mean \"points\"?)"));
  EXPECT_THAT(error_of("unit_length \"metre\""), HasSubstr("found \"metre\" (did you mean \"m\"?)"));
  EXPECT_THAT(error_of("unit_angle \"rad\""), HasSubstr("found \"rad\" (did you mean \"radians\"?)"));
  EXPECT_THAT(error_of("unit_length \"feet\""), testing::EndsWith("found \"feet\""));
}

TEST(WorldText, names_of_any_length_and_bytes_are_one_short_line) {
  const std::string escape = "\"\x1b[2J\x01" + std::string(100'000, 'x') + "\"";
  const std::string word = "a" + std::string(100'000, 'x');
  for (const std::string& text : std::initializer_list<std::string>{
           "model( name " + escape + " ) model( name " + escape + " )",
           "model( color " + escape + " )",
           "model( pose [" + escape + " 0 0 0] )",
           "model( bitmap " + escape + " )",
           "model( size [1 1 1] " + escape + " )",
           "position( drive " + escape + " )",
           "include " + escape,
           "include \"e\x1b.inc\"",
           "unit_length " + escape,
           "window( follow_model " + escape + " )",
           word + "( )",
           word + " [0",
           word + " oops",
           "model( " + word + " 1 )",
           "define " + word,
           "define " + word + " model oops",
           "define " + word + " " + word + " ( )\n" + word + "( )",
           "define " + word + " model ( )\ndefine " + word + " model ( )",
           word + "( )\ndefine " + word + " model ( )",
       }) {
    const std::vector<std::string> lines = lines_of(text, {{"w/e\x1b.inc", "oops"}});
    ASSERT_EQ(lines.size(), 1u) << text.substr(0, 40);
    EXPECT_LE(lines[0].size(), 600u) << text.substr(0, 40);
    EXPECT_EQ(std::ranges::count_if(lines[0], [](unsigned char c) { return c < ' '; }), 0)
        << text.substr(0, 40) << " gives " << lines[0];
    EXPECT_THAT(lines[0], HasSubstr("w/")) << text.substr(0, 40);
  }
}

TEST(WorldText, a_path_of_another_machine_is_an_error_that_says_where_the_name_alone_is_found) {
  for (const std::string text : {"include \"/opt/stage/x.inc\"", "model( bitmap \"/opt/stage/x.inc\" )",
                                 "model( mesh \"/opt/stage/x.inc\" )"})
    EXPECT_THAT(
        error_of(text, {{"w/x.inc", ""}}),
        HasSubstr("\"/opt/stage/x.inc\" cannot be opened: no such file; \"x.inc\" alone is found in w/"));
}

TEST(WorldText, an_include_cycle_is_reported_not_followed) {
  EXPECT_EQ(
      error_of("include \"a.inc\"", {{"w/a.inc", "\ninclude \"b.inc\""}, {"w/b.inc", "include \"a.inc\""}}),
      "w/b.inc:1: file \"w/a.inc\" includes itself");
  Files chain;
  for (int i = 0; i < 40; ++i) {
    chain["w/" + std::to_string(i)] = "include \"" + std::to_string(i + 1) + "\"";
  }
  EXPECT_THAT(error_of("include \"0\"", chain), HasSubstr("more than 32 files include each other"));
}

TEST(WorldText, a_few_lines_cannot_include_without_bound) {
  Files doubling{{"w/20", ""}};
  for (int i = 0; i < 20; ++i) {
    const std::string next = "include \"" + std::to_string(i + 1) + "\"\n";
    doubling["w/" + std::to_string(i)] = next + next;
  }
  EXPECT_THAT(error_of("include \"0\"", doubling), HasSubstr("more than 65536 files are included"));
  const std::string big = "#" + std::string(limits::kFileBytes * 3 / 8, '-') + "\n";
  EXPECT_THAT(
      error_of(repeated("include \"big\"\n", 3), {{"w/big", big}}),
      testing::AllOf(HasSubstr("w/t.world:3: "), HasSubstr("more than 64 MiB of text with all includes")));
}

// ---- macros
// -----------------------------------------------------------------------------------------------------

TEST(WorldMacros, an_instance_replaces_properties_and_adds_children_after_the_macros) {
  const SceneDesc scene = loaded(
      "define base position ( size [1 1 1] color \"red\" model( name \"first\" ) )\n"
      "define robot base ( color \"blue\" model( name \"second\" ) )\n"
      "robot ( name \"r\" name \"s\" color \"lime green\" model( name \"third\" ) )");
  EXPECT_THAT(names_of(scene), ElementsAre("s", "s.first", "s.second", "s.third"));
  EXPECT_EQ(scene.models[0].type, "position");
  EXPECT_EQ(scene.models[0].size, (geom::Size{1, 1, 1}));
  EXPECT_EQ(scene.models[0].color, (Color{50 / 255.0f, 205 / 255.0f, 50 / 255.0f, 1}));
}

TEST(WorldMacros, the_first_definition_of_a_name_counts) {
  const SceneDesc scene = loaded("define a model ( mass 1 )\ndefine a model ( mass 2 )\na( )");
  EXPECT_EQ(scene.models[0].mass, 1);
  EXPECT_THAT(scene.warnings,
              ElementsAre("w/t.world:2: macro \"a\" is defined at w/t.world:1 already; the first "
                          "definition counts"));
}

TEST(WorldMacros, a_file_that_is_included_twice_defines_its_own_once) {
  const SceneDesc scene =
      loaded("include \"r.inc\"\ninclude \"r.inc\"\nr( )", {{"w/r.inc", "define r model ( mass 3 )"}});
  EXPECT_EQ(scene.models[0].mass, 3);
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
}

TEST(WorldMacros, a_macro_shadows_a_type_from_its_definition_on_also_inside_other_macros) {
  const SceneDesc scene = loaded(
      "define robot position ( block( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] ) )\n"
      "robot( )\ndefine block model ( size [0.5 0.5 0.5] )\nblock( pose [4 0 0 0] )\nrobot( )");
  EXPECT_THAT(names_of(scene), ElementsAre("position:0", "model:1", "position:1", "position:1.model:0"));
  EXPECT_EQ(scene.models[0].blocks.at(0).points.size(), 3u);
}

TEST(WorldMacros, one_may_be_based_on_a_sensor) {
  const SceneDesc scene =
      loaded("define s sensor ( fov 20 samples 3 )\nranger( s( ) s( samples 5 ) )\nranger( )");
  ASSERT_EQ(scene.models[0].sensors.size(), 2u);
  EXPECT_EQ(scene.models[0].sensors[0].samples, 3u);
  EXPECT_EQ(scene.models[0].sensors[1].samples, 5u);
  EXPECT_TRUE(scene.models[1].sensors.empty());
}

TEST(World, whole_numbers_and_flags_are_truncated_with_a_warning_each) {
  const std::string text =
      "define s sensor( samples 2.7 )\nposition( obstacle_return 0.9\nfiducial_return 3.5 alwayson 1.5\n"
      "ranger( s( ) s( ) sensor( samples 180.0 ) ) )\nposition( fiducial_return -0.5 )";
  const SceneDesc scene = loaded(text);
  EXPECT_THAT(scene.warnings,
              testing::UnorderedElementsAre(
                  "w/t.world:1: \"samples\" takes a whole number: 2.7 is read as 2",
                  "w/t.world:2: \"obstacle_return\" takes a whole number: 0.9 is read as 0",
                  "w/t.world:3: \"fiducial_return\" takes a whole number: 3.5 is read as 3",
                  "w/t.world:3: \"alwayson\" takes a whole number: 1.5 is read as 1",
                  "w/t.world:5: \"fiducial_return\" takes a whole number: -0.5 is read as 0"));
  EXPECT_FALSE(scene.models[0].obstacle_return);
  EXPECT_EQ(scene.models[1].sensors[0].samples, 2u);
  EXPECT_EQ(scene.models[1].sensors[2].samples, 180u);
}

TEST(World, the_fov_of_a_sensor_has_a_limit_and_overlaps_above_a_turn) {
  const auto with = [](const std::string& words) { return "ranger(\nsensor( samples 5 " + words + " ) )"; };
  EXPECT_EQ(error_of(with("fov 1e5")), "w/t.world:2: \"fov\" must be from 0 to 36000, found \"1e5\"");
  EXPECT_THAT(loaded(with("fov 361")).warnings,
              ElementsAre("w/t.world:2: \"fov\" is above 360 degrees: beams overlap"));
  EXPECT_THAT(loaded(with("fov 360")).warnings, IsEmpty());
}

TEST(WorldMacros, wrong_use_is_one_clear_error) {
  EXPECT_EQ(error_of("robot( )\ndefine robot position ( )"),
            "w/t.world:1: macro \"robot\" is used before its definition at w/t.world:2");
  EXPECT_THAT(error_of("define model model ( )\nmodel( )"),
              HasSubstr("w/t.world:2: macro \"model\" is based on itself"));
  EXPECT_EQ(error_of("define a model ( a( ) )\na( )"), "w/t.world:1: macro \"a\" holds itself");
  EXPECT_EQ(error_of("define a model ( b( ) )\ndefine b model (\nc( ) )\ndefine c a ( )\na( )"),
            "w/t.world:1: macro \"b\" holds itself, by way of \"c\"");
  EXPECT_EQ(error_of("define a model (\nb( ) )\ndefine b model ( a( ) )\na( )"),
            "w/t.world:2: macro \"b\" holds itself, by way of \"a\"");
  EXPECT_THAT(error_of(repeated("model(", 70) + repeated(")", 70)), HasSubstr("nested more than 64 deep"));
  EXPECT_EQ(error_of("define robot position ( )\nrobo( )"),
            "w/t.world:2: unknown model type \"robo\" (did you mean \"robot\"?)");
}

TEST(WorldMacros, a_few_lines_cannot_expand_without_bound) {
  std::string text;
  for (int i = 40; i > 0; --i) {
    const std::string next = i == 40 ? "model" : "m" + std::to_string(i + 1);
    text += "define m" + std::to_string(i) + " model ( " + next + "( ) " + next + "( ) )\n";
  }
  const auto scene = load(text + "m1( )", {}, {.models = 1000});
  ASSERT_FALSE(scene.ok());
  EXPECT_THAT(scene.error().line(), HasSubstr("more than 1000 models"));
  std::string wide = "define m model ( ";
  for (int i = 0; i < 100; ++i) wide += "mass 1 ";
  const auto fields = load(wide + ")\nm( m( ) m( ) m( ) )", {}, {.fields = 350});
  ASSERT_FALSE(fields.ok());
  EXPECT_THAT(fields.error().line(), HasSubstr("more than 350 properties"));
}

TEST(WorldMacros, a_few_lines_cannot_make_texts_and_sensors_without_bound) {
  const auto fault = [](const std::string& text, const WorldLimits& limits) {
    const Result<SceneDesc> scene = load(text, {}, limits);
    return scene ? "none" : scene.error().line();
  };
  const std::string talk = "define t model( say \"0123456789\" )\nt( ) t( )\n";
  EXPECT_EQ(fault(talk, {.text_bytes = 60}), "none");
  EXPECT_EQ(fault(talk + "t( )", {.text_bytes = 60}),
            "w/t.world:3: the world holds more than 60 bytes of names and texts");
  const std::string sonars = "define r ranger( sensor( ) sensor( ) )\nr( ) r( )\n";
  EXPECT_EQ(fault(sonars, {.sensors = 4}), "none");
  EXPECT_EQ(fault(sonars + "r( )", {.sensors = 4}), "w/t.world:3: the world holds more than 4 sensors");
}

TEST(WorldMacros, a_few_lines_cannot_make_bodies_beams_and_pixels_without_bound) {
  const WorldLimits limits{.corners = 100, .beams = 1000};
  const auto fault = [&limits](const std::string& text) {
    const Result<SceneDesc> scene = load(text, {{"w/plan", "P1 4 4 1010 0101 1010 0101"}}, limits);
    return scene ? "none" : scene.error().line();
  };
  const std::string triangle = "block( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] )";
  EXPECT_EQ(fault("define t model( " + triangle + triangle + ")\nt( ) t( ) t( ) t( )"), "none");
  EXPECT_EQ(fault("define t model( " + triangle + triangle + ")\n" + repeated("t( )\n", 17)),
            "w/t.world:1: the world holds more than 100 corners of bodies");
  EXPECT_EQ(fault("define m model( bitmap \"plan\" )\nm( ) m( ) m( )\n m( )"),
            "w/t.world:1: the world holds more than 100 corners of bodies");
  EXPECT_EQ(fault("define r ranger( sensor( samples 300 ) )\nr( ) r( ) r( )"), "none");
  EXPECT_EQ(fault("detector( samples 10 rays 10 layers 10 )"), "none");
  EXPECT_EQ(fault("detector( samples 10 rays 11 layers 10 )"),
            "w/t.world:1: the world holds more than 1000 beams of rangers, lines of detectors and pixels of "
            "cameras");
  EXPECT_EQ(fault("define r ranger( sensor( samples 300 ) )\nr( ) r( ) r( )\nr( )"),
            "w/t.world:1: the world holds more than 1000 beams of rangers, lines of detectors and pixels of "
            "cameras");
}

// ---- names
// ------------------------------------------------------------------------------------------------------

TEST(WorldNames, default_names_count_siblings_of_a_type_and_the_ground_is_model_0) {
  const SceneDesc scene = loaded(
      "define robot position ( )\nmodel( ) robot( ranger( ) model( ) ranger( ) ) position( ) robot( name "
      "\"a\" model( ) )");
  EXPECT_THAT(names_of(scene),
              ElementsAre("model:1", "position:0", "position:0.ranger:0", "position:0.model:0",
                          "position:0.ranger:1", "position:1", "a", "a.model:0"));
  EXPECT_EQ(scene.models[6].alias, "position:2");
  EXPECT_EQ(scene.models[7].alias, "a.model:0");
}

TEST(WorldNames, a_name_is_below_its_parents_unless_it_starts_with_a_slash) {
  const SceneDesc scene = loaded("model( name \"a\" model( name \"b\" ) model( name \"/c\" ) )");
  EXPECT_THAT(names_of(scene), ElementsAre("a", "a.b", "c"));
  EXPECT_EQ(scene.models[1].alias, "a.model:0");
  EXPECT_EQ(scene.models[2].alias, "a.model:1");
}

TEST(WorldNames, the_last_model_of_a_name_has_it_and_the_others_fall_back) {
  const SceneDesc scene =
      loaded("model( name \"a\" model( ) )\nmodel( name \"a\" model( ) )\nmodel( name \"a\" )");
  EXPECT_THAT(names_of(scene), ElementsAre("model:1", "model:1.model:0", "model:2", "model:2.model:0", "a"));
  EXPECT_EQ(scene.models[1].alias, "model:1.model:0");
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("w/t.world:2: the name \"a\" was given at w/t.world:1"),
                                          HasSubstr("w/t.world:3: the name \"a\" was given at w/t.world:2")));
}

// ---- units, colours, frames
// -------------------------------------------------------------------------------------

TEST(WorldUnits, lengths_and_angles_are_scaled_where_they_are_lengths_and_angles) {
  const SceneDesc scene = loaded(
      "model( pose [100 0 0 3] size [50 60 80] mass 5 )\nunit_length \"cm\"\nunit_angle \"radians\"\n"
      "position( velocity_bounds [-50 50 0 0 0 0 -1 1] odom_error [0.1 0.2 0 0.3] )\nresolution 0.05");
  EXPECT_EQ(scene.models[0].X_PM, (geom::Pose{1, 0, 0, 3}));
  EXPECT_EQ(scene.models[0].size, (geom::Size{0.5, 0.6, 0.8}));
  EXPECT_EQ(scene.models[0].mass, 5);
  EXPECT_EQ(scene.models[1].position->velocity_bounds[0].min, -0.5);
  EXPECT_EQ(scene.models[1].position->velocity_bounds[3].max, 1);
  EXPECT_EQ(*scene.models[1].position->odom_error, (geom::Twist{0.1, 0.2, 0, 0.3}))
      << "fractions have no unit";
  EXPECT_EQ(scene.resolution, 0.05) << "never scaled";
}

TEST(WorldUnits, headings_are_wrapped) {
  EXPECT_NEAR(model_of("model( pose [0 0 0 450] )").X_PM.a, geom::kPi / 2, 1e-15);
}

TEST(WorldColors, names_beat_rgba_and_unknown_names_are_red_with_a_warning) {
  EXPECT_EQ(model_of("model( color_rgba [0.1 0.2 0.3 0.4] )").color, (Color{0.1f, 0.2f, 0.3f, 0.4f}));
  EXPECT_EQ(model_of("model( color \"gray50\" color_rgba [0.1 0.2 0.3 0.4] )").color,
            (Color{127 / 255.0f, 127 / 255.0f, 127 / 255.0f, 1}));
  EXPECT_EQ(model_of("model( color \"grey\" )").color, (Color{190 / 255.0f, 190 / 255.0f, 190 / 255.0f, 1}));
  const SceneDesc scene = loaded("model( color \"bleu\" )");
  EXPECT_EQ(scene.models[0].color, (Color{1, 0, 0, 1}));
  EXPECT_THAT(scene.warnings,
              ElementsAre("w/t.world:1: unknown color \"bleu\", red is used (did you mean \"blue\"?)"));
}

TEST(WorldColors, random_colors_differ_between_models_and_repeat_between_loads) {
  const std::string text = "model( color \"random\" ) model( color \"random\" )";
  const SceneDesc a = loaded(text), b = loaded(text);
  EXPECT_EQ(a.models[0].color, b.models[0].color);
  EXPECT_EQ(a.models[1].color, b.models[1].color);
  EXPECT_FALSE(a.models[0].color == a.models[1].color);
  EXPECT_EQ(a.models[0].color.a, 1);
}

TEST(WorldFrames, children_stand_on_a_parent_that_stacks) {
  const SceneDesc scene = loaded(
      "model( size [1 1 2] model( pose [0 0 -0.5 0] size [1 1 3] model( ) ) )\n"
      "model( size [1 1 2] stack_children 0 model( pose [0 0 -0.5 0] ) )");
  EXPECT_EQ(scene.models[1].X_PM.z, 1.5);
  EXPECT_EQ(scene.models[2].X_PM.z, 3);
  EXPECT_EQ(scene.models[4].X_PM.z, -0.5);
  EXPECT_EQ(scene.models[2].parent, 1);
}

// ---- bodies
// -----------------------------------------------------------------------------------------------------

constexpr const char* kTriangle = "points 3 point[0] [0 0] point[1] [0 1] point[2] [1 0] ";

TEST(WorldBodies, a_default_body_is_a_box_of_the_size) {
  const ModelDesc model = model_of("model( )");
  ASSERT_EQ(model.blocks.size(), 1u);
  EXPECT_EQ(extent(model.blocks[0].points), (std::array<double, 4>{-0.2, 0.2, -0.2, 0.2}));
  EXPECT_EQ(model.blocks[0].z_max, 1);
  EXPECT_TRUE(model_of("model( noblocks 1 )").blocks.empty());
  EXPECT_TRUE(model_of("ranger( )").blocks.empty());
  EXPECT_TRUE(model_of("fiducial( )").blocks.empty());
}

TEST(WorldBodies, of_a_gripper_is_a_base_and_two_paddles_that_move_unless_blocks_say_otherwise) {
  const auto expect = [](const Block& block, std::array<double, 4> sides, double z_min, double z_max) {
    const std::array<double, 4> found = extent(block.points);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], sides[i], 1e-12) << i;
    EXPECT_NEAR(block.z_min, z_min, 1e-12);
    EXPECT_NEAR(block.z_max, z_max, 1e-12);
  };
  const ModelDesc open = model_of("gripper( paddle_size [0.5 0.1 0.4] )");
  ASSERT_EQ(open.blocks.size(), 3u);
  EXPECT_EQ(open.moving_blocks, 2u);
  expect(open.blocks[0], {-0.1, 0, -0.15, 0.15}, 0, 0.2);
  expect(open.blocks[1], {0, 0.1, 0.12, 0.15}, 0, 0.08);
  expect(open.blocks[2], {0, 0.1, -0.15, -0.12}, 0, 0.08);
  const ModelDesc closed =
      model_of("gripper( size [1 1 1] paddle_size [0.5 0.1 0.4] paddle_state [ \"closed\" \"up\" ] )");
  expect(closed.blocks[1], {0, 0.5, 0, 0.1}, 0.6, 1);
  expect(closed.blocks[2], {0, 0.5, -0.1, 0}, 0.6, 1);
  EXPECT_EQ(model_of("gripper( paddle_size [1 0.1 0.1] )").blocks.size(), 2u) << "no base";
  EXPECT_EQ(model_of("gripper( paddle_size [0.5 0 0.1] )").blocks.size(), 1u) << "no paddles";
  const ModelDesc blocks = model_of(std::string("gripper( block( ") + kTriangle + "z [0 1] ) )");
  EXPECT_EQ(blocks.blocks.size(), 1u);
  EXPECT_EQ(blocks.moving_blocks, 0u);
  EXPECT_TRUE(model_of("gripper( noblocks 1 )").blocks.empty());
}

TEST(WorldBodies, all_blocks_together_are_stretched_to_the_size) {
  const ModelDesc model = model_of(
      "model( size [2 4 6]\n block( points 4 point[0] [10 10] point[1] [10 20] point[2] [20 20] point[3] [20 "
      "10] z [1 2] )\n"
      "block( points 3 point[0] [20 20] point[1] [30 20] point[2] [30 50] z [2 4] ) )");
  ASSERT_EQ(model.blocks.size(), 2u);
  EXPECT_EQ(extent(model.blocks[0].points), (std::array<double, 4>{-1, 0, -2, -1}));
  EXPECT_EQ(extent(model.blocks[1].points), (std::array<double, 4>{0, 1, -1, 2}));
  EXPECT_EQ(model.blocks[0].z_min, 1.5);
  EXPECT_EQ(model.blocks[0].z_max, 3);
  EXPECT_EQ(model.blocks[1].z_min, 3);
  EXPECT_EQ(model.blocks[1].z_max, 6);
}

TEST(WorldBodies, a_block_that_floats_stays_above_the_floor) {
  const auto heights = [](const std::string& size, const std::string& blocks) {
    std::vector<double> heights;
    for (const Block& block : model_of("model( size " + size + blocks + " )").blocks) {
      heights.push_back(block.z_min);
      heights.push_back(block.z_max);
    }
    return heights;
  };
  const auto block = [](const std::string& z) {
    return std::string(" block( ") + kTriangle + "z " + z + " )";
  };
  EXPECT_THAT(heights("[1 2 1]", block("[0.5 1]")), ElementsAre(0.5, 1));
  EXPECT_THAT(heights("[1 2 3]", block("[0.5 1]")), ElementsAre(1.5, 3));
  EXPECT_THAT(heights("[1 2 2]", block("[2 3]") + block("[3 4]")), ElementsAre(1, 1.5, 1.5, 2));
  EXPECT_THAT(heights("[1 2 1]", block("[0 0.5]") + block("[1 2]")), ElementsAre(0, 0.25, 0.5, 1));
  EXPECT_THAT(heights("[1 2 1]", block("[-0.5 0.5]")), ElementsAre(-0.5, 0.5)) << "0 is the floor";
}

TEST(WorldBodies, polygons_are_turned_counter_clockwise) {
  const ModelDesc model = model_of(std::string("model( block( ") + kTriangle + ") )");
  EXPECT_GT(signed_area(model.blocks.at(0).points), 0);
}

TEST(WorldBodies, a_block_without_height_is_as_high_as_the_model_with_a_warning) {
  const SceneDesc scene = loaded(std::string("model( size [1 1 3]\nblock( ") + kTriangle + ")\nblock( " +
                                 kTriangle + "z [1 1] )\nblock( " + kTriangle + "z [0.5 1] ) )");
  const ModelDesc& model = scene.models[0];
  for (const int k : {0, 1}) {
    EXPECT_EQ(model.blocks.at(k).z_min, 0);
    EXPECT_EQ(model.blocks.at(k).z_max, 3);
  }
  EXPECT_EQ(model.blocks.at(2).z_min, 1.5);
  EXPECT_EQ(model.blocks.at(2).z_max, 3);
  EXPECT_THAT(scene.warnings,
              ElementsAre("w/t.world:2: the block has no \"z\"; it is as high as the model",
                          "w/t.world:3: the block has no height; it is as high as the model"));
}

TEST(WorldBodies, a_size_without_extent_is_a_thin_wall_or_no_body_with_a_warning) {
  const SceneDesc wall = loaded("model( size [0 2 1] )");
  EXPECT_EQ(extent(wall.models[0].blocks.at(0).points), (std::array<double, 4>{-0.005, 0.005, -1, 1}));
  EXPECT_EQ(wall.models[0].blocks[0].z_max, 1);
  EXPECT_THAT(wall.warnings,
              ElementsAre("w/t.world:1: \"size\" has no extent in x; the body is 0.01 m thick there"));
  const SceneDesc shaped = loaded(std::string("model( size [2 0 1] block( ") + kTriangle + "z [0 1] ) )");
  EXPECT_EQ(extent(shaped.models[0].blocks.at(0).points), (std::array<double, 4>{-1, 1, -0.005, 0.005}));
  EXPECT_THAT(shaped.warnings, ElementsAre(HasSubstr("no extent in y; the body is 0.01 m thick")));
  const SceneDesc dot = loaded("model( size [0 0 1] boundary 1 )");
  EXPECT_TRUE(dot.models[0].blocks.empty());
  EXPECT_THAT(dot.warnings, ElementsAre(HasSubstr("no extent in x and y, so the model has no body")));
  const SceneDesc flat = loaded("model( size [2 2 0] )");
  EXPECT_EQ(flat.models[0].blocks.at(0).z_max, 0);
  EXPECT_THAT(flat.warnings, ElementsAre(HasSubstr("no extent in z, so the body collides with nothing")));
  EXPECT_TRUE(loaded("model( size [0 0 0] noblocks 1 ) ranger( size [0 0 0] )").warnings.empty());
}

TEST(WorldBodies, a_boundary_is_four_walls_inside_the_size_that_blocks_do_not_remove) {
  const ModelDesc walls = model_of("model( size [4 2 1] boundary 1 )");
  ASSERT_EQ(walls.blocks.size(), 4u);
  EXPECT_EQ(extent(walls.blocks[0].points), (std::array<double, 4>{-2, -1.99, -1, 1}));
  EXPECT_EQ(extent(walls.blocks[3].points), (std::array<double, 4>{-2, 2, 0.99, 1}));
  EXPECT_EQ(model_of(std::string("model( boundary 1 block( ") + kTriangle + ") )").blocks.size(), 5u);
}

TEST(WorldBodies, a_bitmap_fills_the_size_with_its_dark_pixels_and_its_first_row_is_at_positive_y) {
  const ModelDesc model = model_of("model( size [4 2 3] bitmap \"b.pbm\" )",
                                   {{"w/b.pbm", "P1 6 4\n000000\n011000\n001100\n000000\n"}});
  EXPECT_TRUE(model.blocks.empty());
  ASSERT_EQ(model.bitmaps.size(), 1u);
  const Contours& contours = model.bitmaps[0];
  EXPECT_EQ(contours.z_max, 3);
  ASSERT_EQ(contours.loops.size(), 1u);
  EXPECT_EQ(extent(contours.loops[0]), (std::array<double, 4>{-2, 2, -1, 1}));
  EXPECT_NEAR(signed_area(contours.loops[0]), 4 * (4.0 / 3) * 1, 1e-12) << "4 pixels of 4/3 m x 1 m";
  EXPECT_THAT(contours.loops[0], testing::Contains(geom::Vec2{-2, 1})) << "the upper left pixel is solid";
}

TEST(WorldBodies, a_bitmap_and_blocks_share_one_bounding_box) {
  const ModelDesc model = model_of(
      "model( size [4 2 1] bitmap \"b.pbm\" block( points 3 point[0] [2 0] point[1] [4 0] point[2] [4 2] z "
      "[0 1] ) )",
      {{"w/b.pbm", "P1 2 2 11 11"}});
  EXPECT_EQ(extent(model.bitmaps.at(0).loops.at(0)), (std::array<double, 4>{-2, 0, -1, 1}));
  EXPECT_EQ(extent(model.blocks.at(0).points), (std::array<double, 4>{0, 2, -1, 1}));
}

TEST(WorldBodies, wrong_shapes_are_errors_with_the_place) {
  EXPECT_THAT(error_of("model( bitmap \"gone.png\" )"),
              HasSubstr("w/t.world:1: bitmap \"w/gone.png\" cannot be opened: no such file"));
  EXPECT_THAT(error_of("model( bitmap \"b\" )", {{"w/b", "text"}}), HasSubstr("bitmap \"w/b\" is not a PNG"));
  EXPECT_THAT(error_of("model(\nblock( points 1 ) )"), HasSubstr("w/t.world:2: a block needs \"points\""));
  EXPECT_THAT(error_of("model( block( points 1000000000 ) )"), HasSubstr("corners of bodies"));
  EXPECT_THAT(error_of("model( block( z [2 1] points 3 point[0] [0 0] point[1] [1 0] point[2] [2 1] ) )"),
              HasSubstr("ends below its start"));
  EXPECT_THAT(error_of("model( block( model( ) ) )"), HasSubstr("a block holds no entities"));
}

TEST(WorldBodies, a_missing_point_is_the_origin_with_one_warning) {
  const std::string block =
      "define m model( size [1 1 1]\nblock( points 4 point[1] [1 0] point[2] [1 1] z [0 1] ) )\n";
  const SceneDesc scene = loaded(block + "m( ) m( )");
  EXPECT_THAT(scene.models[1].blocks.at(0).points, ElementsAre(geom::Vec2{-0.5, -0.5}, geom::Vec2{0.5, -0.5},
                                                               geom::Vec2{0.5, 0.5}, geom::Vec2{-0.5, -0.5}));
  EXPECT_THAT(scene.warnings,
              ElementsAre("w/t.world:2: the block has 4 points, but \"point[0]\" is missing; what "
                          "is missing is [0 0]"));
}

TEST(WorldBodies, a_block_that_is_a_line_is_a_thin_wall_at_the_edge_with_a_warning) {
  const auto near = [](double x_min, double x_max, double y_min, double y_max) {
    using testing::DoubleNear;
    return ElementsAre(DoubleNear(x_min, 1e-12), DoubleNear(x_max, 1e-12), DoubleNear(y_min, 1e-12),
                       DoubleNear(y_max, 1e-12));
  };
  const SceneDesc two =
      loaded("model( size [4 2 1] block( points 2 point[0] [3 5] point[1] [1 5] z [0 1] ) )");
  EXPECT_THAT(extent(two.models[0].blocks.at(0).points), near(-2, 2, -1.005, -0.995));
  EXPECT_GT(signed_area(two.models[0].blocks[0].points), 0);
  EXPECT_THAT(two.warnings, ElementsAre("w/t.world:1: the block is a line; it is a wall 0.01 m thick"));
  const SceneDesc three =
      loaded("model( size [4 2 1] block( points 3 point[0] [7 0] point[1] [7 1] point[2] [7 2] ) )");
  EXPECT_THAT(extent(three.models[0].blocks.at(0).points), near(-2.005, -1.995, -1, 1));
  const SceneDesc slanted =
      loaded(std::string("model( size [1 1 1] block( points 2 point[0] [0 0] point[1] [1 1] ) block( ") +
             kTriangle + ") )");
  EXPECT_EQ(slanted.models[0].blocks.at(0).points.size(), 4u);
  EXPECT_EQ(slanted.models[0].blocks.at(1).points.size(), 3u);
  const SceneDesc dot = loaded("model( block( points 2 z [0 1] ) )");
  EXPECT_TRUE(dot.models[0].blocks.empty());
  EXPECT_THAT(dot.warnings, ElementsAre(HasSubstr("\"point[0]\" is missing"), HasSubstr("no body")));
}

TEST(WorldBodies, all_bitmaps_together_have_a_limit_of_pixels_bytes_and_corners) {
  const Files files{{"w/a", "P1 3 3 101010101"}, {"w/b", "P1 3 3 101010101"}};
  const auto fault = [&files](const std::string& world, const WorldLimits& limits) {
    const Result<SceneDesc> scene = load(world, files, limits);
    return scene ? "no error" : scene.error().line();
  };
  const std::string two = "model( bitmap \"a\" )\nmodel( bitmap \"b\" )";
  EXPECT_EQ(fault(two, {.pixels = 18}), "no error");
  EXPECT_EQ(fault(two, {.pixels = 17}), "w/t.world:2: the world holds more than 17 pixels of bitmaps");
  EXPECT_EQ(fault(two, {.bitmap_bytes = 32}), "no error");
  EXPECT_EQ(fault(two, {.bitmap_bytes = 31}),
            "w/t.world:2: the world holds more than 31 bytes of bitmap files");
  const std::string same = "model( bitmap \"a\" )\nmodel( bitmap \"a\" )";
  EXPECT_EQ(fault(same, {.pixels = 9, .bitmap_bytes = 16}), "no error") << "one file is read once";
  // Without a body nobody spends corners, yet the outlines are kept.
  const std::string flat = "model( bitmap \"a\" size [0 0 0] )\nmodel( bitmap \"b\" size [0 0 0] )";
  EXPECT_EQ(fault(flat, {.corners = 40}), "no error");
  EXPECT_EQ(fault(flat, {.corners = 39}), "w/t.world:2: the world holds more than 39 corners of bitmaps");
}

TEST(WorldBodies, bitmaps_of_one_name_beside_two_includes_are_two) {
  Files files{{"w/a/x.inc", "model( bitmap \"m\" )"},
              {"w/a/m", "P1 3 3 111111111"},
              {"w/b/x.inc", "model( bitmap \"m\" )"},
              {"w/b/m", "P1 3 3 101010101"}};
  const SceneDesc scene = loaded("include \"a/x.inc\"\ninclude \"b/x.inc\"", files);
  EXPECT_EQ(scene.models.at(0).bitmaps.at(0).loops.size(), 1u);
  EXPECT_GT(scene.models.at(1).bitmaps.at(0).loops.size(), 1u);
  files.erase("w/b/m");
  EXPECT_EQ(error_of("include \"a/x.inc\"\ninclude \"b/x.inc\"", files),
            "w/b/x.inc:1: bitmap \"w/m\" cannot be opened: no such file, also not in w/b/");
}

TEST(WorldBodies, a_bitmap_without_dark_pixels_is_no_body_and_a_warning) {
  const SceneDesc scene = loaded("model( bitmap \"b\" )", {{"w/b", "P1 1 1 0"}});
  EXPECT_TRUE(scene.models[0].blocks.empty());
  EXPECT_TRUE(scene.models[0].bitmaps.empty());
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no dark pixel")));
}

// ---- kinds
// ------------------------------------------------------------------------------------------------------

TEST(WorldModels, base_properties_are_read_and_have_their_defaults) {
  const ModelDesc model = model_of(
      "model( origin [1 2 3 90] obstacle_return 0 ranger_return -1 fiducial_return -5 fiducial_key 3 "
      "gripper_return 1\n"
      "update_interval 250 alwayson 1 gui_move 0 say \"hi\" trail_length 7 ctrl [\"wander\" \"lib a b\"] )");
  EXPECT_EQ(model.X_MB, (geom::Pose{1, 2, 3, geom::kPi / 2}));
  EXPECT_FALSE(model.obstacle_return);
  EXPECT_EQ(model.ranger_return, -1);
  EXPECT_EQ(model.fiducial_return, -5);
  EXPECT_EQ(model.fiducial_key, 3);
  EXPECT_TRUE(model.gripper_return);
  EXPECT_EQ(model.update_interval, 0.25);
  EXPECT_TRUE(model.alwayson);
  EXPECT_FALSE(model.gui_move);
  EXPECT_EQ(model.say, "hi");
  EXPECT_EQ(model.trail_length, 7);
  EXPECT_THAT(model.ctrl, ElementsAre("wander", "lib a b"));

  const SceneDesc defaults = loaded("model( update_interval 0 model( ) )");
  EXPECT_TRUE(defaults.models[0].obstacle_return);
  EXPECT_EQ(defaults.models[0].ranger_return, 1);
  EXPECT_EQ(defaults.models[0].update_interval, 0.1) << "at most once a tick";
  const SceneDesc below = loaded("model( update_interval -5 )");
  EXPECT_EQ(below.models[0].update_interval, 0.1);
  EXPECT_THAT(below.warnings,
              ElementsAre("w/t.world:1: \"update_interval\" is below 0; every tick is meant"));
  EXPECT_TRUE(defaults.models[0].gui_move);
  EXPECT_FALSE(defaults.models[1].gui_move);
}

TEST(WorldModels, milliseconds_are_whole_microseconds_so_that_equal_times_are_equal) {
  const SceneDesc scene = loaded("interval_sim 33.3333\nmodel( update_interval 33.3333 )");
  EXPECT_EQ(scene.interval, 0.033333);
  EXPECT_EQ(scene.models[0].update_interval, scene.interval);
  EXPECT_THAT(error_of("interval_sim 0.0001"), HasSubstr("above 0 ms"));
}

TEST(WorldModels, what_is_below_0_and_makes_no_sense_is_0_with_a_warning) {
  const SceneDesc scene = loaded("quit_time -1\nmodel( trail_length -3 )");
  EXPECT_EQ(scene.quit_time, 0);
  EXPECT_EQ(scene.models[0].trail_length, 0);
  EXPECT_THAT(scene.warnings, ElementsAre("w/t.world:1: \"quit_time\" is below 0; no end is meant",
                                          "w/t.world:2: \"trail_length\" is below 0; no trail is meant"));
}

TEST(WorldModels, a_position_has_its_drive_and_bounds) {
  const PositionDesc defaults = model_of("position( )").position.value();
  EXPECT_EQ(defaults.drive, Drive::kDiff);
  EXPECT_EQ(defaults.localization, Localization::kGps);
  EXPECT_FALSE(defaults.localization_origin);
  EXPECT_FALSE(defaults.odom_error);
  EXPECT_EQ(defaults.velocity_bounds[0].max, 1);
  EXPECT_EQ(defaults.acceleration_bounds[3].min, -geom::kPi / 2);
  const PositionDesc car = model_of(
                               "position( drive \"car\" wheelbase 0.5 localization \"odom\" "
                               "localization_origin [1 2 0 180] velocity [1 0 0 90] )")
                               .position.value();
  EXPECT_EQ(car.drive, Drive::kCar);
  EXPECT_EQ(car.wheelbase, 0.5);
  EXPECT_EQ(car.localization, Localization::kOdometry);
  EXPECT_EQ(*car.localization_origin, (geom::Pose{1, 2, 0, geom::kPi}));
  EXPECT_EQ(car.velocity, (geom::Twist{1, 0, 0, geom::kPi / 2}));
  EXPECT_EQ(error_of("position( drive \"dif\" )"),
            "w/t.world:1: \"drive\" is one of \"diff\", \"omni\", \"walk\", \"car\", found \"dif\" (did you "
            "mean \"diff\"?)");
  EXPECT_THAT(error_of("position( velocity_bounds [1 0 0 0 0 0 0 0] )"),
              HasSubstr("minimum above its maximum"));
  EXPECT_THAT(error_of("position( wheelbase 0 )"), HasSubstr("above 0"));
}

TEST(WorldModels, a_ranger_has_its_sensors) {
  const ModelDesc ranger = model_of(
      "ranger( sensor( ) sensor( pose [0.1 0 0.2 90] size [0.1 0.1 0.4] range [0.5 8] fov 180 samples 181\n"
      "noise [0.01 0.02 180] color_rgba [0 1 0 0.2] ) )");
  EXPECT_EQ(ranger.size, (geom::Size{0.15, 0.15, 0.2}));
  ASSERT_EQ(ranger.sensors.size(), 2u);
  EXPECT_EQ(ranger.sensors[0].range_max, 5);
  EXPECT_EQ(ranger.sensors[0].samples, 1u);
  EXPECT_EQ(ranger.sensors[0].fov, 0.1);
  EXPECT_EQ(ranger.sensors[0].size.z, 0.02);
  const RangerSensorDesc& sensor = ranger.sensors[1];
  EXPECT_EQ(sensor.X_BS.a, geom::kPi / 2);
  EXPECT_EQ(sensor.range_min, 0.5);
  EXPECT_EQ(sensor.samples, 181u);
  EXPECT_EQ(sensor.noise_angular, geom::kPi);
  EXPECT_EQ(sensor.color.a, 0.2f);
  EXPECT_THAT(error_of("ranger( sensor( samples 0 ) )"), HasSubstr("from 1 to 65536"));
  EXPECT_THAT(error_of("ranger( sensor( range [3 1] ) )"), HasSubstr("0 <= min <= max"));
  EXPECT_THAT(error_of("ranger( sensor( range 5 ) )"),
              HasSubstr("\"range\" needs 2 values [min max], found 1"));
}

TEST(WorldModels, a_battery_is_full_of_what_it_has_unless_its_capacity_is_told) {
  const auto charge = [](const std::string& words) {
    const ModelDesc model = model_of("model( " + words + " )");
    EXPECT_TRUE(has_pack(model)) << words;
    const Charge charge = charge_of(model);
    return std::pair(charge.stored, charge.capacity);
  };
  EXPECT_FALSE(has_pack(model_of("model( watts 5 give_watts 1 take_watts 2 )")));
  EXPECT_EQ(charge("joules 5"), std::pair(5.0, 5.0));
  EXPECT_EQ(charge("joules_capacity 8"), std::pair(0.0, 8.0));
  EXPECT_EQ(charge("joules_capacity 8 joules 5"), std::pair(5.0, 8.0)) << "in whatever order";
  EXPECT_EQ(charge("joules 5 joules_capacity 3"), std::pair(3.0, 3.0));
  EXPECT_EQ(charge("joules 5 joules_capacity 800 kjoules 1"), std::pair(1000.0, 1000.0));
  EXPECT_EQ(charge("joules 500 kjoules_capacity 2"), std::pair(500.0, 2000.0));
  EXPECT_LT(charge("joules -1").first, 0) << "without end";
  EXPECT_LT(charge("joules -1 joules_capacity 10").first, 0);
}

TEST(WorldModels, a_fiducial_finder_has_its_ranges) {
  const FiducialDesc defaults = model_of("fiducial( )").fiducial.value();
  EXPECT_EQ(defaults.range_max, 8);
  EXPECT_DOUBLE_EQ(defaults.fov, geom::kPi);
  const FiducialDesc finder =
      model_of("fiducial( range_min 1 range_max 4 range_max_id 2 fov 90 ignore_zloc 1 )").fiducial.value();
  EXPECT_EQ(finder.range_min, 1);
  EXPECT_EQ(finder.range_max_id, 2);
  EXPECT_DOUBLE_EQ(finder.fov, geom::kPi / 2);
  EXPECT_TRUE(finder.ignore_zloc);
}

TEST(WorldModels, a_bumper_has_its_switches_each_with_its_own_words_or_those_of_all) {
  const SceneDesc scene = loaded(
      "define skirt bumper( bcount 3 bpose[0] [1 2 0.5 90] bpose [3 0 0 180] blength 0.3 )\n"
      "skirt( blength[1] 0.1 bpose[2] [4 0 0 0] )\n"
      "bumper( )");
  EXPECT_THAT(scene.warnings, IsEmpty());
  const BumperDesc& skirt = *scene.models[0].bumper;
  EXPECT_THAT(skirt.X_BS, ElementsAre(geom::Pose{1, 2, 0.5, geom::radians(90)},
                                      geom::Pose{3, 0, 0, geom::kPi}, geom::Pose{4, 0, 0, 0}));
  EXPECT_THAT(skirt.blength, ElementsAre(0.3, 0.1, 0.3));
  EXPECT_EQ(*scene.models[1].bumper, BumperDesc{});
}

TEST(WorldModels, words_with_numbers_beyond_their_count_and_those_that_are_missing_have_a_line) {
  const auto warnings_of = [](const std::string& words) {
    return loaded("bumper( " + words + " )").warnings;
  };
  EXPECT_THAT(
      warnings_of("bcount 2 blength 1 bpose[0] [0 0 0 0]\nbpose[2] [0 0 0 0]"),
      ElementsAre("w/t.world:2: \"bpose[2]\" has no effect: \"bcount\" is 2",
                  "w/t.world:1: \"bcount\" is 2, but \"bpose[1]\" is missing; what is missing is as by "
                  "default"));
  EXPECT_THAT(
      warnings_of("bcount 1 bpose [0 0 0 0] blength[00] 1 blength[99999999999999999999] 1 blength[0] 1"),
      ElementsAre(HasSubstr("\"blength[00]\" has no effect"),
                  HasSubstr("\"blength[99999999999999999999]\" has no effect")));
  EXPECT_THAT(warnings_of("bpose[0] [0 0 0 0]"), ElementsAre(HasSubstr("\"bcount\" is 0")));
  EXPECT_THAT(warnings_of("bcount 1 bpose [0 0 0 0]"), ElementsAre(HasSubstr("\"blength[0]\" is missing")));
  EXPECT_THAT(warnings_of("bcount 1 bpose [0 0 0 0] blength 1 bpose[x] [0 0 0 0]"),
              ElementsAre(HasSubstr("unknown property \"bpose[x]\"")));
}

TEST(WorldModels, words_with_numbers_are_checked_each) {
  const auto line_of = [](const std::string& words) { return error_of("bumper(\n" + words + " )"); };
  EXPECT_THAT(line_of("bcount 1 bpose[0] [1 2]"), HasSubstr("w/t.world:2: \"bpose[0]\" needs 4 values"));
  EXPECT_THAT(line_of("bcount 1 bpose[0] [1 2 3 \"north\"]"), HasSubstr("\"bpose[0]\" needs a number"));
  EXPECT_EQ(line_of("bcount 2 blength 1 blength[1] -0.1"),
            "w/t.world:2: \"blength[1]\" must not be negative, found \"-0.1\"");
  EXPECT_EQ(line_of("blength -0.1"), "w/t.world:2: \"blength\" must not be negative, found \"-0.1\"");
  EXPECT_EQ(line_of("bcount 257"), "w/t.world:2: \"bcount\" must be from 0 to 256, found \"257\"");
}

TEST(WorldModels, a_gripper_has_its_paddles) {
  const GripperDesc defaults = model_of("gripper( )").gripper.value();
  EXPECT_EQ(defaults.paddle_length, 0.66);
  EXPECT_EQ(defaults.paddles, Paddles::kOpen);
  EXPECT_EQ(defaults.lift, Lift::kDown);
  EXPECT_FALSE(defaults.autosnatch);
  const GripperDesc gripper =
      model_of("gripper( paddle_size [0.5 0.2 0.3] paddle_state [ \"closed\" \"up\" ] autosnatch 1 )")
          .gripper.value();
  EXPECT_EQ(gripper.paddle_width, 0.2);
  EXPECT_EQ(gripper.paddles, Paddles::kClosed);
  EXPECT_EQ(gripper.lift, Lift::kUp);
  EXPECT_TRUE(gripper.autosnatch);
  EXPECT_EQ(error_of("gripper( paddle_state [ \"opn\" \"down\" ] )"),
            "w/t.world:1: paddles of \"paddle_state\" is one of \"open\", \"closed\", found \"opn\" "
            "(did you mean \"open\"?)");
  EXPECT_EQ(error_of("gripper( paddle_state [ \"up\" \"closed\" ] )"),
            "w/t.world:1: paddles of \"paddle_state\" is one of \"open\", \"closed\", found \"up\"");
  EXPECT_EQ(error_of("gripper( paddle_state \"open\" )"),
            "w/t.world:1: \"paddle_state\" needs 2 values [paddles lift], found 1");
  EXPECT_THAT(loaded("gripper( paddle_state [ \"open\" \"up\" \"closed\" ] )").warnings,
              ElementsAre(HasSubstr("\"paddle_state\" takes 2 values, found 3")));
  EXPECT_THAT(error_of("gripper( paddle_size [0.5 2 0.5] )"), HasSubstr("numbers from 0 to 1"));
}

TEST(WorldModels, an_actuator_has_its_way_and_what_cannot_be_is_a_warning) {
  const ActuatorDesc defaults = model_of("actuator( )").actuator.value();
  EXPECT_EQ(defaults.type, ActuatorType::kLinear);
  EXPECT_EQ(defaults.max_position, 1);
  const SceneDesc scene = loaded(
      "actuator( type \"rotational\" axis [1 0 -2] )\nactuator( min_position -1 start_position -3 )\n"
      "actuator( min_position 2 )\nactuator( type \"linear\" axis [1 1 0] max_speed 0 )");
  EXPECT_EQ(scene.models[0].actuator->axis_z, -2);
  EXPECT_EQ(scene.models[1].actuator->start_position, -1);
  EXPECT_EQ(scene.models[2].actuator->max_position, 2);
  EXPECT_EQ(scene.models[2].actuator->start_position, 2);
  EXPECT_THAT(scene.warnings,
              ElementsAre("w/t.world:1: nothing turns about another axis than z; [0 0 -1] is meant",
                          "w/t.world:2: \"start_position\" is beyond its ends; \"min_position\" is meant",
                          "w/t.world:3: \"max_position\" is below \"min_position\"; it does not move"));
  EXPECT_THAT(error_of("actuator( max_speed -1 )"), HasSubstr("\"max_speed\" must not be negative"));
  EXPECT_THAT(error_of("actuator( type \"hydraulic\" )"), HasSubstr("linear"));
}

TEST(WorldModels, every_type_is_simulated) {
  for (const Kind& kind : kinds()) EXPECT_TRUE(kind.simulated) << kind.name;
}

TEST(WorldModels, cameras_have_lenses_limits_and_an_image_that_counts) {
  const SceneDesc scene = loaded(
      "camera( resolution [80 60] fov [60 40] pantilt [10 -20] range [0.1 5] image \"depth\" noise [0 0.02] "
      ")");
  const CameraDesc& camera = *scene.models[0].camera;
  EXPECT_EQ(camera.width, 80);
  EXPECT_EQ(camera.height, 60);
  EXPECT_DOUBLE_EQ(camera.fov_horizontal, geom::radians(60));
  EXPECT_DOUBLE_EQ(camera.tilt, geom::radians(-20));
  EXPECT_EQ(camera.image, ImageKind::kDepth);
  EXPECT_EQ(camera.noise_depth, 0.02);
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
  EXPECT_THAT(loaded("camera( image \"depth\" compression \"jpeg\" )").warnings,
              ElementsAre("w/t.world:1: images of distances are sent raw; \"compression\" has no effect"));
  EXPECT_THAT(loaded("camera( image \"segmentation\" compression \"jpeg\" )").warnings,
              ElementsAre("w/t.world:1: images of models are sent raw; \"compression\" has no effect"));
  EXPECT_THAT(error_of("camera( resolution [0 10] )"), HasSubstr("resolution"));
  EXPECT_EQ(loaded("camera( resolution [1000 1000] baseline 0.1 )").models[0].camera->baseline, 0.1);
  EXPECT_THAT(
      error_of("camera( resolution [1000 1001] baseline 0.1 )"),
      HasSubstr(
          "\"resolution\" of a camera with a baseline needs 1000000 pixels at most; this one has 1001000"));
  EXPECT_THAT(error_of("camera( baseline -0.1 )"), HasSubstr("baseline"));
  EXPECT_THAT(error_of("camera( fov [180 40] )"), HasSubstr("fov"));
  EXPECT_THAT(error_of("camera( image \"colour\" )"), HasSubstr("\"color\""));
}

TEST(WorldModels, words_of_older_blobfinders_say_what_to_write) {
  EXPECT_THAT(loaded("blobfinder( channels_count 1 )").warnings,
              testing::Contains(
                  HasSubstr("\"channels_count\" of blobfinder is of older versions: write colors_count")));
}

TEST(WorldModels, types_and_forms_that_nobody_reads_are_errors_that_say_what_to_write) {
  EXPECT_THAT(error_of("environment( )"), HasSubstr("write model( bitmap "));
  EXPECT_THAT(error_of("position( driver( ) )"), HasSubstr("unknown model type \"driver\""));
  EXPECT_EQ(error_of("positoin( )"),
            "w/t.world:1: unknown model type \"positoin\" (did you mean \"position\"?)");
  EXPECT_THAT(error_of("model( size [1] )"), HasSubstr("\"size\" needs 3 values [x y z]"));
  EXPECT_THAT(error_of("model( pose [1 2] )"), HasSubstr("\"pose\" needs 4 values [x y z heading]"));
  EXPECT_THAT(error_of("model( size 1 )"), HasSubstr("\"size\" needs 3 values"));
  EXPECT_THAT(error_of("model( joules \"much\" )"), HasSubstr("\"joules\" needs a number, found \"much\""));
  EXPECT_EQ(error_of("model(\ntake_watts -1 )"),
            "w/t.world:2: \"take_watts\" must not be negative, found \"-1\"");
  EXPECT_EQ(error_of("model( joules_capacity -1 )"),
            "w/t.world:1: \"joules_capacity\" must not be negative, found \"-1\"");
  EXPECT_THAT(error_of("model( mass \"heavy\" )"), HasSubstr("\"mass\" needs a number, found \"heavy\""));
  EXPECT_THAT(error_of("model( mass 1.2.3 )"), HasSubstr("found \"1.2.3\""));
  EXPECT_THAT(error_of("model( pose [1e300 0 0 0] )"), HasSubstr("at most 1e9"));
  EXPECT_THAT(error_of("model( size [-1 1 1] )"), HasSubstr("must not be negative"));
  EXPECT_THAT(error_of("model( sensor( ) )"), HasSubstr("\"sensor\" belongs into a ranger"));
  EXPECT_THAT(error_of("block( )"), HasSubstr("\"block\" belongs into a model"));
  EXPECT_THAT(error_of("model( window( ) )"), HasSubstr("\"window\" belongs into no model"));
}

// ---- the world and its window
// -----------------------------------------------------------------------------------

TEST(WorldGlobals, world_properties_may_stand_anywhere) {
  const SceneDesc scene =
      loaded("model( )\nname \"here\" interval_sim 20 quit_time 60 speedup -1 paused 1\n");
  EXPECT_EQ(scene.name, "here");
  EXPECT_EQ(scene.interval, 0.02);
  EXPECT_EQ(scene.quit_time, 60);
  EXPECT_EQ(scene.speedup, -1);
  EXPECT_TRUE(scene.paused);
  EXPECT_EQ(loaded("").name, "w/t.world");
  EXPECT_THAT(error_of("interval_sim 0"), HasSubstr("above 0"));
  EXPECT_THAT(error_of("resolution 0"), HasSubstr("above 0"));
  EXPECT_EQ(error_of("unit_angle \"degree\""),
            "w/t.world:1: unit_angle is one of \"degrees\", \"radians\", found \"degree\" (did you mean "
            "\"degrees\"?)");
}

TEST(WorldGlobals, the_first_window_counts) {
  const SceneDesc scene = loaded(
      "unit_length \"cm\"\nwindow( center [1 2] scale 30 rotate [90 180] show_data 1 follow_model "
      "\"model:1\" )\n"
      "window( scale 5 )\nmodel( )");
  EXPECT_EQ(scene.window.center, (geom::Vec2{1, 2}));
  EXPECT_EQ(scene.window.scale, 30);
  EXPECT_DOUBLE_EQ(scene.window.pitch, geom::kPi / 2);
  EXPECT_TRUE(scene.window.show_data);
  EXPECT_EQ(scene.window.follow_model, "model:1");
  EXPECT_THAT(scene.warnings, ElementsAre("w/t.world:3: a second window has no effect"));
}

TEST(WorldGlobals, following_a_model_that_does_not_exist_is_a_warning) {
  EXPECT_THAT(
      loaded("window(\nfollow_model \"r\" ) model( name \"r0\" )").warnings,
      ElementsAre("w/t.world:2: the window follows \"r\", which is not a model (did you mean \"r0\"?)"));
}

TEST(WorldWarnings, an_unknown_property_is_told_once_per_line_with_the_nearest_word) {
  const SceneDesc scene =
      loaded("define m model ( colour \"red\" )\nm( ) m( )\nmodel( boundry 1 )\nresolutoin 1");
  EXPECT_THAT(
      scene.warnings,
      ElementsAre("w/t.world:4: unknown property \"resolutoin\" of the world (did you mean \"resolution\"?)",
                  "w/t.world:1: unknown property \"colour\" of model (did you mean \"color\"?)",
                  "w/t.world:3: unknown property \"boundry\" of model (did you mean \"boundary\"?)"));
}

TEST(WorldWarnings, of_each_kind_the_first_are_lines_and_the_rest_a_count) {
  std::string text = "position(\n";
  for (int i = 0; i < 50; ++i) text += "word" + std::to_string(i) + " 1\n";
  text += ")\n" + repeated("model( name \"x\" color \"boo\" )\n", 30);
  const SceneDesc scene = loaded(text);
  EXPECT_EQ(scene.warnings.size(), 3 * limits::kWarningsOfAKind + 3);
  EXPECT_EQ(scene.warnings.front(), "w/t.world:2: unknown property \"word0\" of position");
  EXPECT_THAT(std::vector(scene.warnings.end() - 3, scene.warnings.end()),
              ElementsAre("w/t.world: and 30 more unknown words", "w/t.world: and 10 more unknown colors",
                          "w/t.world: and 9 more names that were given already"));
}

TEST(WorldWarnings, words_of_other_versions_that_mean_nothing_say_that_they_have_no_effect) {
  const SceneDesc scene = loaded(
      "gui_interval 100\nmodel( sonar_return 1 ) model( sonar_return 1 )\nranger( samples 32 sensor() )");
  EXPECT_THAT(
      scene.warnings,
      ElementsAre(
          "w/t.world:1: \"gui_interval\" of the world has no effect",
          "w/t.world:2: \"sonar_return\" of model has no effect: ranger_return is for lasers and sonars",
          "w/t.world:3: \"samples\" of ranger has no effect: it belongs into a sensor( ... )"));
}

TEST(WorldWarnings, words_for_display_and_scheduling_are_silent) {
  EXPECT_THAT(loaded("threads 4\nmodel( trail_interval 5 blob_return 1 )\nwindow( size [1 2] )").warnings,
              IsEmpty());
}

// ---- disk
// -------------------------------------------------------------------------------------------------------

TEST(WorldFiles, a_world_is_found_in_stagepath_by_its_base_name) {
  const TestFolder own;
  const std::filesystem::path folder = own.path();
  std::filesystem::create_directories(folder / "deep");
  std::ofstream(folder / "deep" / "there.world") << "include \"it.inc\"";
  std::ofstream(folder / "deep" / "it.inc") << "model( name \"found\" )";
  const std::string path = folder.string() + "/none:" + (folder / "deep").string();
  setenv("STAGEPATH", path.c_str(), 1);
  const auto scene = load_world("nowhere/there.world");
  const auto missing = load_world("nowhere/missing.world");
  unsetenv("STAGEPATH");
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  EXPECT_EQ(scene->models[0].name, "found");
  EXPECT_EQ(missing.error().line(),
            "nowhere/missing.world: cannot be opened: no such file, also not in STAGEPATH");
  EXPECT_EQ(load_world(folder.string()).error().line(),
            folder.string() + ": cannot be opened: neither a regular file nor a pipe");
}

TEST(WorldFiles, an_include_is_looked_for_beside_the_files_and_then_in_the_search_path) {
  config::MemoryFiles files({{"w/in.inc", "include \"near.inc\"\ninclude \"far.inc\""},
                             {"w/near.inc", "model( name \"beside\" )"},
                             {"lib/near.inc", "model( name \"hidden\" )"},
                             {"lib/far.inc", "include \"further.inc\"\nmodel( name \"far\" bitmap \"b\" )"},
                             {"lib/further.inc", "model( name \"further\" )"},
                             {"lib/b", "P1 1 1 1"}},
                            {"none/", "lib/"});
  const auto scene = load_world_text("include \"in.inc\"", "w/t.world", files);
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  EXPECT_THAT(names_of(expanded(*scene)), ElementsAre("beside", "further", "far"));
  EXPECT_EQ(
      load_world_text("include \"gone.inc\"", "w/t.world", files).error().line(),
      "w/t.world:1: included file \"w/gone.inc\" cannot be opened: no such file, also not in none/, lib/");
  EXPECT_EQ(
      load_world_text("include \"furthr.inc\"", "w/t.world", files).error().line(),
      "w/t.world:1: included file \"w/furthr.inc\" cannot be opened: no such file, also not in none/, lib/ "
      "(did you mean \"further.inc\"?)");
  EXPECT_EQ(load_world_text("include \"/far.inc\"", "w/t.world", files).error().line(),
            "w/t.world:1: included file \"/far.inc\" cannot be opened: no such file; \"far.inc\" alone is "
            "found in lib/");
}

TEST(WorldFiles, a_bitmap_is_looked_for_as_an_include_is_and_a_warning_says_where_it_was_found) {
  config::MemoryFiles files({{"w/in.inc", "model( bitmap \"maps/b.pbm\" )"},
                             {"w/beside.pbm", "P1 1 1 1"},
                             {"lib/beside.pbm", "P1 2 1 1 0"},
                             {"lib/maps/b.pbm", "P1 1 1 1"}},
                            {"none/", "lib/"});
  const auto load = [&](const std::string& text) { return load_world_text(text, "w/t.world", files); };
  const auto beside = load("model( bitmap \"beside.pbm\" )");
  ASSERT_TRUE(beside.ok()) << beside.error().line();
  EXPECT_TRUE(beside->warnings.empty());
  EXPECT_EQ(beside->models.at(0).body.bitmap, "w/beside.pbm");
  const auto found = load("include \"in.inc\"\ninclude \"in.inc\"");
  ASSERT_TRUE(found.ok()) << found.error().line();
  EXPECT_EQ(found->models.at(0).body.bitmap, "lib/maps/b.pbm");
  EXPECT_EQ(found->warnings, std::vector<std::string>{"w/in.inc:1: bitmap \"w/maps/b.pbm\" is not there, so "
                                                      "\"lib/maps/b.pbm\" is read"});
  EXPECT_EQ(load("model( bitmap \"maps/bb.pbm\" )").error().line(),
            "w/t.world:1: bitmap \"w/maps/bb.pbm\" cannot be opened: no such file, also not in none/, lib/ "
            "(did you mean \"maps/b.pbm\"?)");
  EXPECT_EQ(load("model( bitmap \"/x/gone.pbm\" )").error().line(),
            "w/t.world:1: bitmap \"/x/gone.pbm\" cannot be opened: no such file");
}

TEST(WorldFiles, what_comes_with_the_program_is_included_from_any_folder) {
  const TestFolder own;
  const std::filesystem::path folder = own.path();
  std::filesystem::create_directories(folder / "own");
  std::ofstream(folder / "own" / "thing.inc") << "define thing model( )";
  const std::string world = (folder / "t.world").string();
  std::ofstream(world) << "include \"thing.inc\"\nthing( )";
  EXPECT_FALSE(load_world(world));
  setenv("PLAYHOUSE_PATH", (folder / "own").c_str(), 1);
  EXPECT_TRUE(load_world(world));
  unsetenv("PLAYHOUSE_PATH");
  setenv("STAGEPATH", ("/nowhere:" + (folder / "own").string()).c_str(), 1);
  EXPECT_TRUE(load_world(world));
  unsetenv("STAGEPATH");
  std::ofstream(world) << "include \"pionee.inc\"";
  EXPECT_THAT(load_world(world).error().line(), HasSubstr("/worlds/ (did you mean \"pioneer.inc\"?)"));
  std::ofstream(world) << "include \"pioneer.inc\"\npioneer2dx( )";
  const auto scene = load_world(world);
  EXPECT_TRUE(scene.ok()) << scene.error().line();
}

TEST(WorldErrors, of_a_file_are_told_all_once_and_within_a_limit) {
  const auto errors = [](const std::string& text, Files others = {}) {
    config::MemoryFiles files(std::move(others));
    std::vector<Error> next;
    const Result<SceneDesc> scene = load_world_text(text, "w/t.world", files, {}, &next);
    std::vector<std::string> lines;
    if (scene) return lines;
    lines.push_back(scene.error().line());
    for (const Error& error : next) lines.push_back(error.line());
    return lines;
  };
  EXPECT_THAT(errors("define m model( size [1 \"x\" 1] )\n"
                     "m( )\nm( )\n"
                     "modle( )\n"
                     "position( drive \"dif\"\n pose [0 0] )\n"
                     "model( bitmap \"gone\" )\nmodel( bitmap \"gone\" )"),
              ElementsAre(HasSubstr("w/t.world:1: \"size\""), HasSubstr("w/t.world:4: unknown"),
                          HasSubstr("w/t.world:6: \"pose\""), HasSubstr("w/t.world:5: \"drive\""),
                          HasSubstr("w/t.world:7: bitmap \"w/gone\" cannot")));
  EXPECT_EQ(errors(repeated("modle( )\n", 100)).size(), limits::kWarningsOfAKind);
}

TEST(WorldErrors, of_conditions_and_limits_of_detectors_are_told_where_they_are) {
  const auto fault = [](const std::string& text) {
    config::MemoryFiles none({});
    const Result<SceneDesc> scene = load_world_text("detector(\n" + text + " )", "w/t.world", none);
    return scene ? "none" : scene.error().line();
  };
  EXPECT_EQ(fault("sees [\"kind=position\" \"colour=red\"]"),
            "w/t.world:2: \"sees\" has an unknown property \"colour\" (did you mean \"color\"?)");
  EXPECT_EQ(fault("through \"material\""),
            "w/t.world:2: \"through\" needs =, !=, < or > behind \"material\"");
  EXPECT_EQ(fault("miss 1.5"), "w/t.world:2: \"miss\" must be from 0 to 1, found \"1.5\"");
  EXPECT_EQ(fault("fov 361"), "w/t.world:2: \"fov\" must be from 0 to 360, found \"361\"");
  EXPECT_EQ(fault("fov 360 fov_vertical 170 miss 1 attenuation [3 4]"), "none");
  EXPECT_EQ(fault("attenuation [-1 0]"), "w/t.world:2: \"attenuation\" needs numbers from 0 to 1000");
}

TEST(WorldWarnings, more_values_than_a_property_takes_are_told) {
  EXPECT_THAT(loaded("model( pose [0 0 0 90 6]\n size [1 1 1] )").warnings,
              ElementsAre("w/t.world:1: \"pose\" takes 4 values, found 5; the others have no effect"));
}

TEST(WorldFiles, what_a_file_names_is_a_regular_file) {
  const TestFolder own;
  const std::filesystem::path folder = own.path();
  std::filesystem::create_directories(folder / "folder");
  const std::string pipe = (folder / "pipe").string();  // nobody writes: who opens it waits for ever
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string world = (folder / "t.world").string();
  const auto fault = [&](const std::string& text) {
    std::ofstream(world) << text;
    const auto scene = load_world(world);
    return scene ? "no error" : scene.error().line();
  };
  const std::string why = " cannot be opened: not a regular file";
  EXPECT_THAT(fault("model( bitmap \"pipe\" )"), HasSubstr(world + ":1: bitmap \"" + pipe + "\"" + why));
  EXPECT_THAT(fault("model( bitmap \"folder\" )"),
              HasSubstr(world + ":1: bitmap \"" + (folder / "folder").string() + "\"" + why));
  EXPECT_EQ(fault("model( bitmap \"/dev/zero\" )"), world + ":1: bitmap \"/dev/zero\"" + why);
  EXPECT_THAT(fault("include \"pipe\""), HasSubstr(world + ":1: included file \"" + pipe + "\"" + why));
  EXPECT_EQ(load_world(pipe, config::NamedBy::kFile).error().line(), pipe + ":" + why);
}

TEST(WorldFiles, a_pipe_is_read_to_its_end_and_a_file_that_fails_midway_is_an_error) {
  const TestFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::thread writer(
      [&path] { std::ofstream(path) << repeated("# comment\n", 10'000) << "model( name \"piped\" )"; });
  const auto scene = load_world(path);
  writer.join();
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  EXPECT_EQ(scene->models.at(0).name, "piped");
  if (std::filesystem::exists("/proc/self/mem")) {
    EXPECT_EQ(load_world("/proc/self/mem").error().line(),
              "/proc/self/mem: cannot be read: Input/output error");
  }
}

constexpr const char* kTypes = R"(
robot_types [ "cart" "scanner" "cart" ]
define scanner ranger( sensor( samples 3 ) )
define cart position( name "given" scanner( name "eye" ) )
model( name "wall" )
)";

TEST(RobotTypes, are_descriptions_of_which_the_world_has_no_tree) {
  config::MemoryFiles files({});
  const Result<SceneDesc> scene = load_world_text(kTypes, "w/t.world", files);
  ASSERT_TRUE(scene) << scene.error().line();
  ASSERT_EQ(scene->trees.size(), 1u);
  ASSERT_EQ(scene->models.size(), 4u) << "each type once";
  EXPECT_EQ(scene->models[1].prototype, "cart");
  EXPECT_EQ(scene->models[2].name, "cart (type).eye") << "no name of a model of the world";
  EXPECT_EQ(scene->models[3].prototype, "scanner");
  EXPECT_THAT(scene->warnings, IsEmpty());
}

TEST(RobotTypes, are_the_defines_without_what_a_model_of_the_world_adds) {
  config::MemoryFiles files({});
  const Result<SceneDesc> scene =
      load_world_text(std::string(kTypes) + "cart( name \"r0\" scanner( ) )", "w/t.world", files);
  ASSERT_TRUE(scene) << scene.error().line();
  ASSERT_TRUE(scene->robot_types.contains("cart"));
  EXPECT_EQ(tree_size(*scene, scene->robot_types.at("cart")), 2u);
  EXPECT_NE(scene->robot_types.at("cart"), scene->trees.back().top);
}

TEST(RobotTypes, share_the_description_of_a_model_that_is_like_them) {
  config::MemoryFiles files({});
  const Result<SceneDesc> scene =
      load_world_text(std::string(kTypes) + "cart( name \"r0\" pose [1 2 0 0] )", "w/t.world", files);
  ASSERT_TRUE(scene) << scene.error().line();
  EXPECT_EQ(scene->trees.size(), 2u);
  EXPECT_EQ(scene->models.size(), 4u);
}

TEST(RobotTypes, that_are_none_or_are_all_there_is_are_errors) {
  EXPECT_EQ(error_of("robot_types \"cat\"\ndefine cart position()\nmodel()"),
            "w/t.world:1: robot_types: there is no define \"cat\" (did you mean \"cart\"?)");
  EXPECT_EQ(error_of("robot_types \"cart\"\ndefine cart position()"),
            "w/t.world:1: a world with robot_types has at least one model of its own, as a floorplan");
  EXPECT_THAT(error_of("robot_types \"s\"\ndefine s sensor()\nmodel()"), HasSubstr("belongs into"));
}

}  // namespace
}  // namespace playhouse::scene
