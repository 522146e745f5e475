#include "playhouse/config/cfg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>

#include "playhouse/base/finding.h"
#include "playhouse/base/limits.h"

namespace playhouse::config {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result<CfgFile> load(const std::string& text, std::map<std::string, std::string> others = {}) {
  MemoryFiles files(std::move(others));
  return load_cfg_text(text, "dir/t.cfg", files);
}

CfgFile loaded(const std::string& text, std::map<std::string, std::string> others = {}) {
  Result<CfgFile> cfg = load(text, std::move(others));
  EXPECT_TRUE(cfg.ok()) << cfg.error().line();
  return cfg ? std::move(*cfg) : CfgFile{};
}

std::string error_of(const std::string& text) {
  MemoryFiles files({});
  const Result<CfgFile> cfg = load_cfg_text(text, "dir/t.cfg", files, 6665, nullptr,
                                            [](std::string_view type) { return type == "model"; });
  return cfg ? "no error" : cfg.error().line();
}

/// All findings of a file that does not load, as they are told.
std::vector<std::string> findings_of(const std::string& text) {
  MemoryFiles files({});
  std::vector<Error> others;
  const Result<CfgFile> cfg = load_cfg_text(text, "dir/t.cfg", files, 6665, &others);
  EXPECT_FALSE(cfg);
  std::vector<std::string> lines{finding("error", cfg.error())};
  for (const Error& other : others) lines.push_back(finding("error", other));
  return lines;
}

/// One driver with `fields` after its name and device.
CfgSection driver_with(const std::string& fields, const std::string& before = "") {
  return loaded(before + "\ndriver ( name \"d\" provides [ \"gps:0\" ]\n" + fields + "\n)").drivers.at(0);
}

TEST(Cfg, the_sample_of_the_format_loads_with_macros_includes_and_overrides) {
  const CfgFile cfg = loaded(
      "# comment\nunit_length \"m\"\nunit_angle \"degrees\"\n"
      "define sonarbot driver ( name \"dummy\" rate 5 )\n"
      "include \"more.inc\"\n"
      "sonarbot ( provides [\"position2d:0\"] rate 20 )   # override\n"
      "driver\n(\n  name \"passthrough\"\n  requires [\":localhost:6666:laser:0\"]\n  provides [ \"laser:0\" "
      "]\n"
      "  alwayson 0\n)\n"
      "driver ( name \"dummy\" provides [ \"6667:gps:0\" ] )\n",
      {{"dir/more.inc", "driver ( name \"included\" provides \"power:0\" )"}});
  ASSERT_EQ(cfg.drivers.size(), 4u);
  EXPECT_EQ(cfg.drivers[0].name(), "included");
  EXPECT_EQ(cfg.drivers[0].at(), "dir/more.inc:1");
  EXPECT_EQ(cfg.drivers[1].name(), "dummy");
  EXPECT_EQ(cfg.drivers[1].integer("rate", 0), 20);
  EXPECT_EQ(cfg.drivers[2].addresses("requires").at(0), (DeviceAddress{"", "localhost", 6666, "laser", 0}));
  EXPECT_EQ(cfg.drivers[3].addresses("provides").at(0), (DeviceAddress{"", "", 6667, "gps", 0}));
  EXPECT_THAT(cfg.warnings, IsEmpty());
}

TEST(Cfg, numbers_are_read_in_metres_and_radians) {
  const CfgSection driver =
      driver_with("speed 30 turn 180 pair [1 2.5] count 3 none -0.5", "unit_length \"cm\"");
  EXPECT_DOUBLE_EQ(driver.length("speed", 0), 0.3);
  EXPECT_DOUBLE_EQ(driver.angle("turn", 0), geom::kPi);
  EXPECT_DOUBLE_EQ(driver.number("pair", 0, 1), 2.5);
  EXPECT_DOUBLE_EQ(driver.number("pair", 7, 2), 7) << "an element that is not there is the default";
  EXPECT_EQ(driver.integer("count", 0), 3);
  EXPECT_EQ(driver.count("pair"), 2u);
  EXPECT_DOUBLE_EQ(driver.number("absent", 4.5), 4.5);
  EXPECT_TRUE(driver.fault().ok());
}

TEST(Cfg, radians_apply_to_the_whole_file_wherever_they_are_declared) {
  const CfgFile cfg = loaded("driver ( name \"d\" provides \"gps:0\" turn 2 )\nunit_angle \"radians\"");
  EXPECT_DOUBLE_EQ(cfg.drivers[0].angle("turn", 0), 2);
}

TEST(Cfg, yes_true_and_one_switch_on) {
  const CfgSection driver = driver_with("a yes b true c 1 d no e false f 0 alwayson yes");
  for (const char* key : {"a", "b", "c", "alwayson"}) EXPECT_TRUE(driver.flag(key, false)) << key;
  for (const char* key : {"d", "e", "f"}) EXPECT_FALSE(driver.flag(key, true)) << key;
}

TEST(Cfg, file_names_are_relative_to_the_configuration) {
  const CfgSection driver = driver_with("a \"x.png\" b \"/x.png\" c \"~/x.png\"");
  EXPECT_EQ(driver.filename("a", ""), "dir/x.png");
  EXPECT_EQ(driver.filename("b", ""), "/x.png");
  EXPECT_EQ(driver.filename("c", ""), "~/x.png");
  EXPECT_EQ(driver.filename("absent", ""), "");
}

TEST(Cfg, a_field_of_the_wrong_form_is_a_fault_with_its_line) {
  const CfgSection driver = driver_with("\nrate \"fast\"");
  EXPECT_EQ(driver.integer("rate", 5), 5);
  ASSERT_FALSE(driver.fault().ok());
  EXPECT_EQ(driver.fault().error().line(), "dir/t.cfg:4: \"rate\" needs a number, found \"fast\"");
}

TEST(Cfg, fields_that_nobody_reads_are_told_with_the_nearest_word_that_was_asked_for) {
  const CfgSection driver = driver_with("sped 3 alwayson 1 plugin \"stageplugin\" port \"x\"");
  driver.number("speed", 1);
  EXPECT_THAT(driver.unread(),
              ElementsAre("dir/t.cfg:3: \"port\" is not used by driver \"d\"",
                          "dir/t.cfg:3: \"sped\" is not used by driver \"d\" (did you mean \"speed\"?)"));
}

TEST(Cfg, of_many_warnings_of_a_kind_the_first_are_lines_and_the_rest_a_count) {
  std::string fields, sections;
  for (int i = 0; i < 50; ++i) fields += " word" + std::to_string(i) + " 1";
  for (int i = 0; i < 50; ++i) sections += "section" + std::to_string(i) + " ( )\n";
  const std::vector<std::string> unread = driver_with(fields).unread();
  ASSERT_EQ(unread.size(), limits::kWarningsOfAKind + 1);
  EXPECT_EQ(unread.back(), "dir/t.cfg: and 30 more unknown words");
  const CfgFile cfg = loaded(sections + "driver ( name \"d\" provides \"gps:0\" )");
  ASSERT_EQ(cfg.warnings.size(), limits::kWarningsOfAKind + 1);
  EXPECT_EQ(cfg.warnings.back(), "dir/t.cfg: and 30 more unknown words");
}

TEST(Cfg, a_key_given_twice_has_its_last_value) {
  EXPECT_EQ(driver_with("rate [1 2 3] rate [4]").count("rate"), 1u);
}

TEST(Cfg, a_few_lines_cannot_expand_without_bound) {
  std::string text = "define m driver ( name \"d\"";
  for (int i = 0; i < 1200; ++i) text += " w" + std::to_string(i) + " 1";
  text += " )\n";
  for (int i = 0; i < 1000; ++i) text += "m ( provides \"gps:" + std::to_string(i) + "\" )\n";
  EXPECT_THAT(error_of(text), HasSubstr("the file holds more than 1048576 fields"));
}

TEST(Cfg, tuples_may_span_lines) {
  EXPECT_THAT(driver_with("list [ \"a\"\n\"b\"\n ]").texts("list"), ElementsAre("a", "b"));
}

TEST(Cfg, words_may_hold_colons_and_indices) {
  const CfgSection driver = driver_with("a:b 1 spose[1] [1 2 3]");
  EXPECT_EQ(driver.integer("a:b", 0), 1);
  EXPECT_EQ(driver.count("spose[1]"), 3u);
}

TEST(Cfg, names_shared_libraries_in_a_section_or_for_all) {
  const CfgFile cfg = loaded(
      "plugin \"a\"\nplugin \"libb.so\"\n"
      "driver ( name \"d\" provides \"gps:0\"\nplugin \"../c\" )\ndriver ( name \"e\" provides \"gps:1\" )");
  EXPECT_THAT(cfg.warnings, IsEmpty());
  ASSERT_EQ(cfg.plugins.size(), 2u);
  EXPECT_EQ(cfg.plugins[0].name, "a");
  EXPECT_EQ(cfg.plugins[1].name, "libb.so");
  EXPECT_EQ(cfg.plugins[1].where, "dir/t.cfg:2");
  EXPECT_EQ(std::filesystem::path(cfg.plugins[1].folder) / "x", "dir/x");
  ASSERT_TRUE(cfg.drivers[0].plugin());
  EXPECT_EQ(cfg.drivers[0].plugin()->name, "../c");
  EXPECT_EQ(cfg.drivers[0].plugin()->where, "dir/t.cfg:4");
  EXPECT_FALSE(cfg.drivers[1].plugin());
}

TEST(Cfg, what_has_no_effect_is_a_warning) {
  EXPECT_THAT(
      loaded("test 1\nrate 5\ndrivr ( x 1 )\n"
             "interface ( name \"foo\" code 128 plugin \"libfoo\" )\n"
             "driver ( name \"d\" provides \"gps:0\" inner ( ) )")
          .warnings,
      ElementsAre(HasSubstr("dir/t.cfg:1: \"test\" has no effect"),
                  HasSubstr("dir/t.cfg:2: unknown field \"rate\""),
                  HasSubstr("dir/t.cfg:3: section \"drivr\" has no effect (did you mean \"driver\"?)"),
                  HasSubstr("dir/t.cfg:4: interface \"foo\" has no effect"),
                  HasSubstr("dir/t.cfg:5: section \"inner\" inside a driver")));
}

TEST(Cfg, faults_of_a_file_are_one_line_with_the_place) {
  const std::string good = "driver ( name \"d\" provides [ \"gps:0\" ] )\n";
  EXPECT_EQ(error_of("# nothing\n"),
            "dir/t.cfg:1: the file has no driver ( ... ) section, so there is nothing to serve");
  EXPECT_EQ(error_of("define wall model ( )\nwall ( pose [0 0 0 0] )"),
            "dir/t.cfg: is a world file, not a configuration: playhouse run dir/t.cfg serves its robots");
  EXPECT_THAT(error_of("driver ( provides \"gps:0\" )"), HasSubstr("dir/t.cfg:1: a driver needs a name"));
  EXPECT_THAT(error_of("\ndriver ( name \"d\" )"), HasSubstr("dir/t.cfg:2: driver \"d\" needs the devices"));
  EXPECT_THAT(error_of(good + good),
              HasSubstr("dir/t.cfg:2: device \"gps:0\" is provided at dir/t.cfg:1 already"));
  EXPECT_THAT(error_of("driver ( name \"d\" provides [ \"gps:0\" \"6665:gps:0\" ] )"), HasSubstr("already"));
  EXPECT_THAT(error_of("driver ( name \"d\" provides \"gps\" )"),
              HasSubstr("dir/t.cfg:1: device address \"gps\""));
  EXPECT_THAT(error_of("driver ( name \"d\" provides \"gps:0\" requires \"x:y:z:a:b:1\" )"),
              HasSubstr("too many"));
  EXPECT_THAT(error_of("driver ( name \"d\" provides \"gps:0\" alwayson \"often\" )"),
              HasSubstr("yes or no"));
  EXPECT_THAT(error_of("driver\n( name \"d\"\n"), HasSubstr("dir/t.cfg:1: \"driver\" lacks its closing"));
  EXPECT_THAT(error_of("driver ( rate\n5 )"),
              HasSubstr("dir/t.cfg:1: the value of \"rate\" must be on the same"));
  EXPECT_THAT(error_of("driver ( rate 0x10 )"), HasSubstr("dir/t.cfg:1: "));
  EXPECT_THAT(error_of("driver ( a = 1 )"), HasSubstr("dir/t.cfg:1: unexpected character '='"));
  EXPECT_THAT(error_of("driver ( a b )"), HasSubstr("text takes double quotes"));
  EXPECT_THAT(error_of("driver ( a [ yes ] )"), HasSubstr("holds numbers and quoted strings"));
  EXPECT_THAT(error_of("driver ( a[1 2] )"), HasSubstr("space before its \"[\""));
  EXPECT_THAT(error_of("driver ( a \"x\n\" )"), HasSubstr("dir/t.cfg:1: string without its closing quote"));
  EXPECT_THAT(error_of("include \"gone.inc\""),
              HasSubstr("dir/t.cfg:1: included file \"dir/gone.inc\" cannot be opened"));
  EXPECT_THAT(error_of("unit_length \"dm\""),
              HasSubstr("dir/t.cfg:1: unit_length is one of \"m\", \"cm\", \"mm\", found \"dm\""));
  EXPECT_THAT(error_of("interface ( name \"foo\" code 128 )"), HasSubstr("an interface needs plugin"));
  EXPECT_THAT(error_of("define driver driver ( )\ndriver ( )"), HasSubstr("based on itself"));
}

TEST(Cfg, a_slip_in_a_word_that_must_be_there_is_told_with_the_error) {
  EXPECT_EQ(error_of("driver ( name \"d\"\nprovids [ \"gps:0\" ] rate 5 )"),
            "dir/t.cfg:1: driver \"d\" needs the devices it provides, as in: provides [ \"position2d:0\" ]; "
            "dir/t.cfg:2: \"provids\" is unknown (did you mean \"provides\"?)");
  EXPECT_THAT(error_of("driver ( nme \"d\" provides \"gps:0\" )"), HasSubstr("(did you mean \"name\"?)"));
  EXPECT_THAT(error_of("interface ( name \"foo\" cod 128 plugin \"p\" )"),
              HasSubstr("(did you mean \"code\"?)"));
  EXPECT_THAT(
      findings_of("\ndrivr ( name \"d\" provides \"gps:0\" )"),
      ElementsAre("dir/t.cfg:2: error: the file has no driver ( ... ) section, so there is nothing to serve",
                  "dir/t.cfg:2: warning: section \"drivr\" has no effect (did you mean \"driver\"?)"));
  EXPECT_THAT(findings_of("inclde \"more.inc\"").back(), HasSubstr("(did you mean \"include\"?)"));
  EXPECT_THAT(error_of("defin robot driver ( )"), HasSubstr("(did you mean \"define\"?)"));
  EXPECT_THAT(error_of("driver ( name \"d\" provides \"gps:0\" alwayson \"yse\" )"),
              HasSubstr("found \"yse\" (did you mean \"yes\"?)"));
}

TEST(Cfg, names_of_any_length_and_bytes_are_short_lines) {
  const std::string escape = "\"\x1b[2J\x01" + std::string(100'000, 'x') + "\"";
  const std::string word = "a" + std::string(100'000, 'x');
  const std::string driver = "\ndriver ( name \"d\" provides [ \"gps:0\" ] )";
  for (const std::string& text : std::initializer_list<std::string>{
           "driver ( name " + escape + " )",
           "driver ( name \"d\" provides [ " + escape + " ] )",
           "driver ( name \"d\" provides [ \"" + word + ":0\" \"" + word + ":0\" ] )",
           "driver ( name \"d\" provides [ \"gps:0\" ] " + word + " ( ) )",
           word + " 1" + driver,
           word + " ( )" + driver,
           "define " + word + " driver ( )\ndefine " + word + " driver ( )" + driver,
           "interface ( name " + escape + " code 1 plugin \"p\" )" + driver,
       }) {
    const Result<CfgFile> cfg = load(text);
    const std::vector<std::string> lines = cfg ? cfg->warnings : std::vector{cfg.error().line()};
    ASSERT_EQ(lines.size(), 1u) << text.substr(0, 40);
    EXPECT_LE(lines[0].size(), 600u) << text.substr(0, 40);
    EXPECT_EQ(std::ranges::count_if(lines[0], [](unsigned char c) { return c < ' '; }), 0) << lines[0];
  }
  const std::vector<std::string> unread = driver_with(word + " 1").unread();
  ASSERT_EQ(unread.size(), 1u);
  EXPECT_LE(unread[0].size(), 600u);
}

TEST(DeviceAddress, every_form_of_the_format_is_read) {
  const auto parse = [](std::string_view text) { return parse_device_address(text).value(); };
  EXPECT_EQ(parse("7001:ranger:1 ").text(), "7001:ranger:1") << "the original takes it";
  EXPECT_EQ(parse("laser:0"), (DeviceAddress{"", "", {}, "laser", 0}));
  EXPECT_EQ(parse("6666:laser:0"), (DeviceAddress{"", "", 6666, "laser", 0}));
  EXPECT_EQ(parse("::6666:laser:0"), (DeviceAddress{"", "", 6666, "laser", 0}));
  EXPECT_EQ(parse("192.168.1.5:6665:laser:0"), (DeviceAddress{"", "192.168.1.5", 6665, "laser", 0}));
  EXPECT_EQ(parse("odometry:::position2d:0"), (DeviceAddress{"odometry", "", {}, "position2d", 0}));
  EXPECT_EQ(parse("compass::6666:position2d:1"), (DeviceAddress{"compass", "", 6666, "position2d", 1}));
  EXPECT_EQ(parse(":host:6665:dio:007"), (DeviceAddress{"", "host", 6665, "dio", 7}));
}

TEST(DeviceAddress, hosts_of_ipv6_are_in_brackets) {
  const auto parse = [](std::string_view text) { return parse_device_address(text).value(); };
  EXPECT_EQ(parse("[::1]:17100:laser:0"), (DeviceAddress{"", "::1", 17100, "laser", 0}));
  EXPECT_EQ(parse("[fe80::1%eth0]::laser:2"), (DeviceAddress{"", "fe80::1%eth0", {}, "laser", 2}));
  EXPECT_EQ(parse("scans:[2001:db8::7]:6665:laser:0"),
            (DeviceAddress{"scans", "2001:db8::7", 6665, "laser", 0}));
  EXPECT_EQ(parse("scans:[2001:db8::7]:6665:laser:0").text(), "scans:[2001:db8::7]:6665:laser:0");
  for (const char* text : {"::1:17100:laser:0", "[::1:17100:laser:0", "::1]:17100:laser:0", "[lab]:1:laser:0",
                           "[]:1:laser:0", "key[::1]:1:laser:0", "a:b:[::1]:1:laser:0"}) {
    EXPECT_FALSE(parse_device_address(text).ok()) << text;
  }
}

TEST(DeviceAddress, what_is_no_address_is_refused) {
  for (const char* text : {"", ":", "laser", "laser:", ":0", "laser:65536", "laser:-1", "x:laser:0",
                           "65536:laser:0", "a:b:c:1:laser:0", "laser:0:"}) {
    EXPECT_FALSE(parse_device_address(text).ok()) << text;
  }
}

RC_GTEST_PROP(DeviceAddress, its_text_reads_back_as_the_same_address, ()) {
  const auto word = rc::gen::container<std::string>(rc::gen::inRange('a', 'z'));
  DeviceAddress address{*word, *word, {}, *rc::gen::nonEmpty(word), *rc::gen::arbitrary<std::uint16_t>()};
  if (*rc::gen::arbitrary<bool>()) address.port = *rc::gen::arbitrary<std::uint16_t>();
  if (*rc::gen::arbitrary<bool>()) address.host = "fe80::" + std::to_string(*rc::gen::inRange(1, 9999));
  const Result<DeviceAddress> again = parse_device_address(address.text());
  RC_ASSERT(again.ok());
  RC_ASSERT(*again == address);
}

}  // namespace
}  // namespace playhouse::config
