#include "playhouse/app/commands/command_line.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/version.h"

namespace playhouse::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Result<CommandLine> parse(std::vector<const char*> words) {
  return parse_command_line(words);
}

template <typename T>
T parsed(std::vector<const char*> words) {
  const Result<CommandLine> line = parse(std::move(words));
  EXPECT_TRUE(line) << (line ? "" : line.error().text);
  if (!line) return {};
  const T* options = line->get_if<T>();
  EXPECT_NE(options, nullptr);
  return options == nullptr ? T{} : *options;
}

std::string fault(std::vector<const char*> words) {
  const Result<CommandLine> line = parse(std::move(words));
  return line ? "accepted" : line.error().text;
}

TEST(CommandLine, who_draws_is_left_open_or_named) {
  EXPECT_EQ(parsed<PictureOptions>({"picture", "w.world", "-o", "a.png"}).renderer, "");
  EXPECT_EQ(parsed<FilmOptions>({"film", "w.world", "-o", "a.mp4", "--renderer", "playhouse"}).renderer,
            kPlayhouse);
  EXPECT_EQ(parsed<PictureOptions>({"picture", "w.world", "-o", "a.png", "--renderer=chromium"}).renderer,
            kChromium);
  EXPECT_THAT(fault({"picture", "w.world", "-o", "a.png", "--renderer", "firefox"}),
              HasSubstr(R"(invalid renderer "firefox": chromium and playhouse are valid)"));
}

TEST(CommandLine, run_has_the_defaults_of_a_players_server) {
  const auto run = parsed<RunOptions>({"run", "cave.world"});
  EXPECT_EQ(run.world, "cave.world");
  EXPECT_EQ(run.serving.port, 6665);
  EXPECT_EQ(run.serving.web, 8080);
  EXPECT_EQ(run.serving.bind, "127.0.0.1");
  EXPECT_FALSE(run.running.speed);
  EXPECT_FALSE(run.running.duration);
  EXPECT_EQ(run.running.workers, 1u);
}

TEST(CommandLine, run_takes_every_option) {
  const auto run = parsed<RunOptions>({"run", "--port", "0", "--web=9000", "--bind", "0.0.0.0", "--insecure",
                                       "--speed", "2.5", "--duration", "60", "--seed", "7", "--workers", "4",
                                       "--paused", "--json", "w"});
  EXPECT_EQ(run.serving.port, 0);
  EXPECT_EQ(run.serving.web, 9000);
  EXPECT_EQ(run.serving.bind, "0.0.0.0");
  EXPECT_EQ(run.running.speed, 2.5);
  EXPECT_EQ(run.running.duration, 60);
  EXPECT_EQ(run.running.seed, 7u);
  EXPECT_EQ(run.running.workers, 4u);
  EXPECT_TRUE(run.running.paused);
  EXPECT_TRUE(run.running.json);
}

TEST(CommandLine, runs_name_their_engine_and_saved_runs_have_one) {
  EXPECT_EQ(parsed<RunOptions>({"run", "w"}).running.engine, kStage);
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--engine", "arena"}).running.engine, kArena);
  EXPECT_EQ(parsed<BenchOptions>({"bench", "sonar", "--engine", "arena"}).engine, kArena);
  EXPECT_THAT(fault({"run", "w", "--engine", "arnea"}), HasSubstr("did you mean \"arena\"?"));
  EXPECT_THAT(fault({"run", "--from", "f", "--engine", "arena"}), HasSubstr("--from"));
  EXPECT_THAT(fault({"bench", "server", "--engine", "arena"}), HasSubstr("measures with stage"));
}

TEST(CommandLine, lock_step_is_for_one_client_for_some_or_for_those_of_names) {
  EXPECT_FALSE(parsed<RunOptions>({"run", "w"}).running.lock_step);
  const auto one = parsed<RunOptions>({"run", "w", "--lock-step"}).running.lock_step;
  ASSERT_TRUE(one);
  EXPECT_EQ(one->clients, 1u);
  EXPECT_TRUE(one->names.empty());
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--lock-step", "3"}).running.lock_step->clients, 3u);
  const auto serve = parsed<ServeOptions>({"serve", "w", "--lock-step=a,b-2", "--lock-step-timeout", "2.5"});
  EXPECT_EQ(serve.running.lock_step->clients, 2u);
  EXPECT_EQ(serve.running.lock_step->names, (std::set<std::string>{"a", "b-2"}));
  EXPECT_EQ(serve.running.lock_step_timeout, 2.5);
  for (const char* wrong : {"0", "9999999", "a,,b", "a,a", "3,b", "my.world"})
    EXPECT_THAT(fault({"run", "w", "--lock-step", wrong}), HasSubstr("invalid clients")) << wrong;
  for (const char* wrong : {"--lock-step=-1", "--lock-step=-a"})
    EXPECT_THAT(fault({"run", "w", wrong}), HasSubstr("invalid clients")) << wrong;
  EXPECT_EQ(fault({"run", "w", "--lock-step-timeout", "3"}), "--lock-step-timeout requires --lock-step");
}

TEST(CommandLine, gym_wants_a_socket_and_serves_no_page_unless_told_to) {
  const auto gym = parsed<GymOptions>({"gym", "w", "--socket", "5"});
  EXPECT_EQ(gym.socket, 5);
  EXPECT_FALSE(gym.serving.web);
  EXPECT_EQ(gym.serving.port, 0);
  EXPECT_EQ(gym.running.lock_step->clients, 1u);
  EXPECT_EQ(parsed<GymOptions>({"gym", "w", "--socket", "5", "--web", "0"}).serving.web, 0);
  EXPECT_THAT(fault({"gym", "w"}), HasSubstr("--socket"));
  const auto recorded =
      parsed<GymOptions>({"gym", "w", "--socket", "5", "--record", "a.mcap", "--record-only", "position"});
  EXPECT_EQ(recorded.running.record, "a.mcap");
  EXPECT_EQ(recorded.running.record_only, "position");
}

TEST(CommandLine, files_and_libraries_may_be_several) {
  using testing::ElementsAre;
  EXPECT_THAT(parsed<CheckOptions>({"check", "a.world", "b.cfg"}).files, ElementsAre("a.world", "b.cfg"));
  EXPECT_THAT(fault({"check"}), HasSubstr("FILE"));
  const auto run = parsed<RunOptions>({"run", "--allow-library", "/a.so", "--allow-library=/b.so", "w"});
  EXPECT_THAT(run.running.allowed_libraries, ElementsAre("/a.so", "/b.so"));
  EXPECT_EQ(run.world, "w");
}

TEST(CommandLine, a_run_begins_with_a_world_or_goes_on_from_a_saved_one) {
  const auto run = parsed<RunOptions>({"run", "--save-at", "2.5", "a.run", "w", "--save-at", "7", "b.run"});
  EXPECT_EQ(run.world, "w");
  ASSERT_EQ(run.saves.size(), 2u);
  EXPECT_EQ(run.saves[0].seconds, 2.5);
  EXPECT_EQ(run.saves[0].file, "a.run");
  EXPECT_EQ(run.saves[1].file, "b.run");
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--save-world", "x.world"}).running.save_world, "x.world");
  EXPECT_EQ(parsed<ServeOptions>({"serve", "c.cfg", "--save-world=x.world"}).running.save_world, "x.world");
  EXPECT_EQ(parsed<RunOptions>({"run", "w"}).running.save_world, "") << "clients write no files";
  const auto on = parsed<RunOptions>({"run", "--from", "a.run", "--save-at", "9", "c.run"});
  EXPECT_EQ(on.from, "a.run");
  EXPECT_EQ(on.world, "");
  EXPECT_THAT(fault({"run"}), HasSubstr("WORLD"));
  EXPECT_THAT(fault({"run", "--from", "a.run", "w"}), HasSubstr("WORLD"));
  EXPECT_THAT(fault({"run", "--from", "a.run", "--seed", "2"}), HasSubstr("--seed"));
  EXPECT_THAT(fault({"run", "w", "--save-at", "-1", "a.run"}), HasSubstr("--save-at"));
  EXPECT_THAT(fault({"run", "w", "--save-at", "soon", "a.run"}), HasSubstr("--save-at"));
  EXPECT_THAT(fault({"run", "w", "--save-at", "1"}), HasSubstr("--save-at"));
}

TEST(CommandLine, verify_takes_numbers_of_workers) {
  const auto verify = parsed<VerifyOptions>({"verify", "w", "--ticks", "5", "--workers", "1,3"});
  EXPECT_EQ(verify.world, "w");
  EXPECT_EQ(verify.ticks, 5u);
  EXPECT_THAT(verify.workers, testing::ElementsAre(1u, 3u));
  EXPECT_THAT(fault({"verify", "w"}), HasSubstr("--ticks"));
  EXPECT_THAT(fault({"verify", "w", "--ticks", "0"}), HasSubstr("--ticks"));
  EXPECT_THAT(fault({"verify", "w", "--ticks", "5", "--workers", "1,0"}), HasSubstr("--workers"));
}

TEST(CommandLine, convert_writes_to_a_file_or_to_standard_output) {
  EXPECT_EQ(parsed<ConvertOptions>({"convert", "a.world"}).output, "");
  const auto options = parsed<ConvertOptions>({"convert", "a.world", "-o", "b.world"});
  EXPECT_EQ(options.input, "a.world");
  EXPECT_EQ(options.output, "b.world");
  EXPECT_EQ(parsed<ConvertOptions>({"convert", "a.world", "--output", "c.world"}).output, "c.world");
}

TEST(CommandLine, convert_takes_the_scale_of_an_image_and_the_height_of_its_walls) {
  const auto options = parsed<ConvertOptions>({"convert", "a.png", "--scale", "0.05", "--height", "2"});
  EXPECT_EQ(options.scale, 0.05);
  EXPECT_EQ(options.height, 2);
  EXPECT_FALSE(parsed<ConvertOptions>({"convert", "a.world"}).scale);
  EXPECT_THAT(fault({"convert", "a.png", "--scale", "0"}), HasSubstr("above 0"));
  EXPECT_THAT(fault({"convert", "a.png", "--height", "-1"}), HasSubstr("above 0"));
}

TEST(CommandLine, kinds_takes_a_name_or_none) {
  EXPECT_EQ(parsed<KindsOptions>({"kinds"}).name, "");
  const auto kinds = parsed<KindsOptions>({"kinds", "ranger", "--json"});
  EXPECT_EQ(kinds.name, "ranger");
  EXPECT_TRUE(kinds.json);
}

TEST(CommandLine, drivers_takes_a_name_or_none) {
  EXPECT_EQ(parsed<DriversOptions>({"drivers"}).name, "");
  const auto drivers = parsed<DriversOptions>({"drivers", "vfh", "--json"});
  EXPECT_EQ(drivers.name, "vfh");
  EXPECT_TRUE(drivers.json);
}

TEST(CommandLine, headless_and_web_off_mean_no_page) {
  EXPECT_FALSE(parsed<RunOptions>({"run", "w", "--headless"}).serving.web);
  EXPECT_FALSE(parsed<ServeOptions>({"serve", "f.cfg", "--web", "off"}).serving.web);
}

TEST(CommandLine, fast_is_speed_zero) {
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--fast"}).running.speed, 0);
}

TEST(CommandLine, a_mistyped_command_gets_the_nearest_one) {
  EXPECT_THAT(fault({"rnu", "cave.world"}), HasSubstr("did you mean \"run\"?"));
}

TEST(CommandLine, a_mistyped_flag_gets_the_nearest_one) {
  EXPECT_THAT(fault({"run", "w", "--hedless"}), HasSubstr("did you mean \"--headless\"?"));
  EXPECT_THAT(fault({"run", "w", "--prot=1"}), HasSubstr("did you mean \"--port\"?"));
}

TEST(CommandLine, wrong_values_are_refused_and_named) {
  EXPECT_THAT(fault({"run", "w", "--web", "maybe"}), HasSubstr("\"maybe\""));
  EXPECT_THAT(fault({"run", "w", "--port", "70000"}), HasSubstr("--port"));
  EXPECT_THAT(fault({"run", "w", "--speed", "-1"}), HasSubstr("--speed"));
  EXPECT_THAT(fault({"run", "w", "--duration", "nan"}), HasSubstr("--duration"));
  EXPECT_THAT(fault({"run", "w", "--workers", "0"}), HasSubstr("--workers"));
  EXPECT_THAT(fault({"run"}), HasSubstr("WORLD"));
  EXPECT_EQ(fault({"run", "w", "--port", "-1"}), "--port: invalid port \"-1\": 0 to 65535 is valid");
  EXPECT_EQ(fault({"run", "w", "--duration"}), "--duration needs a value");
}

TEST(CommandLine, an_empty_value_is_refused) {
  for (const char* option : {"--record", "--save-world", "--guests"})
    EXPECT_EQ(fault({"run", "w", option, ""}), std::string(option) + " needs a value, found \"\"");
  EXPECT_EQ(fault({"run", "w", "--save-at", "1", ""}), "--save-at needs a value, found \"\"");
  EXPECT_EQ(fault({"convert", "w", "-o", ""}), "--output needs a value, found \"\"");
  EXPECT_EQ(fault({"export", "a.mcap", "--csv", "-o", ""}), "--output needs a value, found \"\"");
  EXPECT_EQ(fault({"check", ""}), "FILE needs a value, found \"\"");
  EXPECT_EQ(fault({"kinds", ""}), "NAME needs a value, found \"\"");
  EXPECT_EQ(fault({"drivers", ""}), "NAME needs a value, found \"\"");
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--lock-step"}).running.lock_step->clients, 1u);
}

TEST(CommandLine, a_whole_number_that_does_not_fit_is_refused) {
  for (const char* text : {"-1", "99999999999999999999999", "1.5", "1e3", ""}) {
    EXPECT_THAT(fault({"run", "w", "--seed", text}), HasSubstr("--seed: invalid number")) << text;
    EXPECT_THAT(fault({"watch", "localhost", "laser:0", "--count", text}), HasSubstr("--count")) << text;
    EXPECT_EQ(
        fault({"bench", "laser", "--robots", text}),
        fmt::format("--robots: invalid number \"{}\": a whole number from 1 to 1000000 is valid", text));
  }
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--seed", "18446744073709551615"}).running.seed,
            18446744073709551615u);
}

TEST(CommandLine, what_means_nothing_is_refused) {
  EXPECT_THAT(fault({"bench", "laser", "--robots", "0"}), HasSubstr("from 1 to 1000000"));
  EXPECT_THAT(fault({"bench", "cave", "--duration", "0"}), HasSubstr("above 0"));
  EXPECT_THAT(fault({"bench", "server", "--duration", "3"}), HasSubstr("--duration"));
  EXPECT_THAT(fault({"bench", "load", "--duration", "3"}), HasSubstr("--duration"));
  EXPECT_THAT(fault({"bench", "world"}), HasSubstr(".world file"));
  EXPECT_THAT(fault({"bench", "world", "a.world", "--robots", "3"}), HasSubstr("robots of its file"));
  EXPECT_THAT(fault({"bench", "laser", "a.world"}), HasSubstr("belongs to bench world"));
  EXPECT_THAT(fault({"watch", "localhost", "laser:0", "--count", "0"}), HasSubstr("from 1 to"));
  EXPECT_EQ(fault({"run", "w", "--port", "0", "--port", "1"}), "--port is given more than once");
}

TEST(CommandLine, only_an_address_can_be_bound) {
  for (const char* text : {"abc", "", "127.0.0.1:80", "1.2.3", "[::1]"})
    EXPECT_THAT(fault({"run", "w", "--bind", text}), HasSubstr("--bind: invalid address")) << text;
  for (const char* text : {"0.0.0.0", "localhost", "::", "fe80::1%lo"})
    EXPECT_EQ(parsed<RunOptions>({"run", "w", "--bind", text, "--insecure"}).serving.bind, text);
}

TEST(CommandLine, an_address_that_others_reach_needs_guests_or_a_word_that_it_is_meant) {
  for (const char* text : {"0.0.0.0", "::", "192.168.7.5", "fe80::1%lo"}) {
    for (std::vector<const char*> words :
         std::vector<std::vector<const char*>>{{"run", "w"},
                                               {"serve", "w.cfg"},
                                               {"replay", "w.mcap"},
                                               {"robot", "r.toml", "--server", "lab"}}) {
      words.insert(words.end(), {"--bind", text});
      EXPECT_THAT(fault(words), HasSubstr("--insecure allows it")) << text;
      words.push_back("--insecure");
      EXPECT_EQ(fault(words), "accepted") << text;
    }
  }
  EXPECT_THAT(fault({"robot", "r.toml", "--server", "lab", "--bind", "0.0.0.0"}), Not(HasSubstr("--guests")));
  for (const char* text : {"127.0.0.1", "127.1.2.3", "localhost", "::1"})
    EXPECT_EQ(parsed<RunOptions>({"run", "w", "--bind", text}).serving.bind, text);
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--bind", "0.0.0.0", "--guests", "g"}).serving.guests, "g");
}

TEST(CommandLine, the_page_may_have_further_names) {
  EXPECT_THAT(
      parsed<RunOptions>({"run", "--web-host", "robots.example", "--web-host=b", "w"}).serving.web_hosts,
      ElementsAre("robots.example", "b"));
  for (const char* text : {"", "http://robots.example", "robots.example:80", "a b"})
    EXPECT_THAT(fault({"run", "w", "--web-host", text}), HasSubstr("--web-host: invalid host")) << text;
}

TEST(CommandLine, proxies_in_front_of_the_page_are_named_by_address) {
  const auto proxies = parsed<RunOptions>({"run", "--trusted-proxy", "10.0.0.2,::1", "w"}).serving.proxies;
  EXPECT_EQ(*proxies.client_of("10.0.0.2:1", "10.0.0.9"), "10.0.0.9:1");
  EXPECT_THAT(fault({"run", "w", "--trusted-proxy", "nginx"}),
              HasSubstr("--trusted-proxy: invalid proxy \"nginx\": a numeric address is valid"));
}

TEST(CommandLine, a_letter_has_no_nearest_option_and_two_dashes_end_the_options) {
  EXPECT_EQ(fault({"run", "-p", "3", "w"}), "unknown option -p; playhouse COMMAND --help lists them");
  EXPECT_EQ(parsed<RunOptions>({"run", "--paused", "--", "-w.world"}).world, "-w.world");
}

TEST(CommandLine, help_has_examples_and_version_has_the_number) {
  EXPECT_THAT(parsed<HelpText>({"--help"}).text, HasSubstr("playhouse run worlds/cave.world"));
  EXPECT_THAT(parsed<HelpText>({"run", "--help"}).text, HasSubstr("--duration"));
  EXPECT_THAT(parsed<HelpText>({"run", "--help"}).text, HasSubstr("playhouse run [OPTIONS] [WORLD]"));
  EXPECT_THAT(parsed<HelpText>({"--version"}).text, HasSubstr(std::string(version())));
  EXPECT_EQ(parsed<HelpText>({"-V"}).text, parsed<HelpText>({"--version"}).text);
}

TEST(CommandLine, watch_needs_a_server_and_a_device_or_a_robot_alone) {
  const auto watch = parsed<WatchOptions>({"watch", "localhost:7000", "laser:0", "--count", "3"});
  EXPECT_EQ(watch.server, "localhost:7000");
  EXPECT_EQ(watch.device, "laser:0");
  EXPECT_EQ(watch.count, 3u);
  for (const char* const server : {"localhost", "lab:7000", "7000", "10.0.0.1", "[::1]"}) {
    EXPECT_THAT(fault({"watch", server}), HasSubstr("DEVICE is required"));
    EXPECT_THAT(fault({"drive", server}), HasSubstr("ROBOT is required"));
  }
  EXPECT_EQ(parsed<WatchOptions>({"watch", "r0"}).server, "r0");
  EXPECT_EQ(parsed<DriveOptions>({"drive", "r0"}).device, "");
  EXPECT_TRUE(parsed<DevicesOptions>({"devices", "--network"}).network);
  EXPECT_THAT(fault({"devices", "lab", "--network"}), HasSubstr("--network"));
}

TEST(CommandLine, observers_have_a_port_where_one_is_given_and_a_budget) {
  EXPECT_FALSE(parsed<RunOptions>({"run", "w"}).serving.observers);
  const auto run = parsed<RunOptions>({"run", "w", "--observers", "6670", "--observer-bytes", "8000"});
  EXPECT_EQ(run.serving.observers, 6670);
  EXPECT_EQ(run.serving.observer_bytes, 8000u);
  EXPECT_EQ(parsed<ReplayOptions>({"replay", "a.mcap", "--observers", "0"}).serving.observers, 0);
  EXPECT_THAT(fault({"run", "w", "--observers", "65536"}), HasSubstr(": 0 to 65535 is valid"));
  EXPECT_THAT(fault({"run", "w", "--observers", "1", "--observer-bytes", "1"}), HasSubstr("from 4000 to"));
  EXPECT_THAT(fault({"run", "w", "--observer-bytes", "8000"}), HasSubstr("--observers"));
}

TEST(CommandLine, pages_have_a_budget) {
  EXPECT_EQ(parsed<RunOptions>({"run", "w"}).serving.page_bytes, limits::kPageBytesPerSecond);
  EXPECT_EQ(parsed<RunOptions>({"run", "w", "--page-bytes", "64000"}).serving.page_bytes, 64000u);
  EXPECT_THAT(fault({"run", "w", "--page-bytes", "1"}), HasSubstr("from 4000 to"));
}

TEST(CommandLine, observe_looks_at_what_it_is_told) {
  const auto all = parsed<ObserveOptions>({"observe", "host"});
  EXPECT_EQ(all.server, "host");
  EXPECT_FALSE(all.view);
  EXPECT_EQ(all.rate, 0);
  const auto some = parsed<ObserveOptions>({"observe", "host:7", "--name", "a", "--name", "b.c:0", "--view",
                                            "-1,2.5,3", "--rate", "2", "--token", "blue-chair-7", "--stats"});
  EXPECT_THAT(some.names, ElementsAre("a", "b.c:0"));
  EXPECT_EQ(some.view->x, -1);
  EXPECT_EQ(some.view->y, 2.5);
  EXPECT_EQ(some.view->radius, 3);
  EXPECT_TRUE(some.stats);
  for (const char* const view : {"1,2", "1,2,3,4", "1,2,0", "a,b,c", "1,2,nan", ""})
    EXPECT_THAT(fault({"observe", "h", "--view", view}), HasSubstr("X,Y,RADIUS")) << view;
}

}  // namespace
}  // namespace playhouse::app
