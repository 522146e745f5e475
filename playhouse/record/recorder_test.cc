#include "playhouse/record/recorder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "playhouse/base/formats.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/record/mcap/mcap_reader.h"
#include "playhouse/record/mcap/mcap_writer.h"
#include "playhouse/record/rerun.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/population/population.h"

namespace playhouse::record {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kWorld = R"(
interval_sim 100
define eye ranger( sensor( range [0 8] fov 90 samples 3 ) )
define robot position( eye() )
robot( name "a.b" pose [1 2 0 90] ) robot( name "c d" pose [2 0 0 0] )
model( name "wall" pose [5 0 0 0] )
)";

/// A control that carries out what is posted when the test says so.
class Later final : public world::Control {
 public:
  void pause() override {}
  void resume() override {}
  void step_once() override {}
  void set_speed(double) override {}
  void drive(world::ModelId, const geom::Twist&) override {}
  bool post(std::function<void(world::Journal&)> change, world::ModelId) override {
    posted.push_back(std::move(change));
    return true;
  }
  void record(bool) override {}
  std::shared_ptr<const world::Timeline> timeline() const override {
    return std::make_shared<world::Timeline>();
  }
  void rewind(std::uint64_t) override {}
  std::uint64_t generation(world::ModelId) const override { return 0; }
  std::vector<std::function<void(world::Journal&)>> posted;
};

/// A controller that cannot say what it remembers.
class Shy final : public world::Decider {
 public:
  std::string_view name() const override { return "shy"; }
  std::size_t size() const override { return 0; }
  void follow(world::World&) override {}
  void decide(world::World&, std::size_t, std::size_t) override {}
  void hash(const world::World&, Hash&) const override {}
  Result<void> save(Packer&) const override { return Error{{}, "controller shy cannot be saved"}; }
  bool load(world::World&, Unpacker&) override { return false; }
};

class RecorderTest : public testing::Test {
 protected:
  void begin() {
    file_ = std::make_unique<RecordThread>(*McapWriter::create(path_, "ros2"));
    recorder_ = std::make_unique<Recorder>(*file_, Selection(), control_);
    ASSERT_TRUE(recorder_->begin(world_, sources_).ok());
  }
  void tick() {
    ++world_.tick_;
    recorder_->ticked(world_);
  }
  void change(const std::function<void(world::Journal&)>& change) {
    change(journal_);
    recorder_->changed(world_, journal_.entries());
    journal_.clear();
  }
  void carry_out_posted() {
    for (const auto& each : std::exchange(control_.posted, {})) change(each);
  }
  void end() {
    recorder_->end(world_);
    ASSERT_TRUE(file_->finish());
  }
  std::set<std::string> topics() const {
    const auto source = open_source(path_);
    McapReader reader(**source);
    EXPECT_TRUE(reader.read({}).ok());
    std::set<std::string> topics;
    for (const auto& [id, channel] : reader.channels()) topics.insert(channel.topic);
    return topics;
  }
  Result<Recording> recording() const { return read_recording(**open_source(path_)); }

  const TestFolder folder_;
  const std::string path_ = folder_ / "test.mcap";
  config::SourceFiles sources_{.path = "t.world", .files = {{"t.world", kWorld}}, .search_path = {}};
  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kWorld, "t.world", files_);
  world::World world_{scene_, 1};
  world::Journal journal_{world_};
  Later control_;
  std::unique_ptr<RecordThread> file_;
  std::unique_ptr<Recorder> recorder_;
};

TEST_F(RecorderTest, has_what_its_models_do_by_names_that_ros_can_have) {
  begin();
  tick();
  end();
  EXPECT_THAT(topics(), Contains("/tf"));
  EXPECT_THAT(topics(), Contains("/a/b/position"));
  EXPECT_THAT(topics(), Contains("/c_d/position"));
}

TEST_F(RecorderTest, has_the_channel_of_changes_before_others_take_all_there_are) {
  begin();
  tick();
  end();
  EXPECT_THAT(topics(), Contains("/playhouse/changes"));
}

TEST_F(RecorderTest, watches_the_sensors_that_it_records_also_of_who_comes) {
  begin();
  carry_out_posted();
  const world::ModelRow eye = world_.find("a.b.ranger:0");
  EXPECT_EQ(world_.models.watchers[eye], 1u);
  world::ModelId came;
  change([&](world::Journal& journal) { came = *journal.spawn(0, {}, "late"); });
  carry_out_posted();
  EXPECT_EQ(world_.models.watchers[world_.find("late.ranger:0")], 1u);
  EXPECT_EQ(world_.models.watchers[eye], 1u) << "once";
  world_.rangers.measured_tick.back() = world_.tick() + 1;
  tick();
  end();
  EXPECT_THAT(topics(), Contains("/late/ranger_0/scan"));
  EXPECT_THAT(topics(), Not(Contains("/a/b/ranger_0/scan"))) << "it has not measured";
}

TEST_F(RecorderTest, has_what_its_models_say_when_they_begin_and_end_to_say_it) {
  begin();
  const auto say = [this](const char* name, const char* text) {
    change([&](world::Journal& journal) {
      journal.apply(world::changes::Say{journal.world().id(journal.world().find(name)), text});
    });
  };
  tick();
  say("c d", "hello");
  tick();
  say("c d", "hello");
  world::set_say(world_, world_.find("a.b"), "by a controller");
  tick();
  say("c d", "");
  end();
  const auto source = open_source(path_);
  McapReader reader(**source);
  std::vector<std::string> said;
  const auto take = [&](const Channel& channel, const MessageRecord& message) -> Result<void> {
    CdrReader in(message.body);
    in.time();
    const std::string speaker = in.text();
    in.number<std::uint32_t>();
    if (channel.topic == "/playhouse/speech") said.push_back(speaker + ": " + in.text());
    return {};
  };
  ASSERT_TRUE(reader.read({.message = take, .attachment = {}}).ok());
  EXPECT_THAT(said, testing::ElementsAre("c_d: hello", "a/b: by a controller", "c_d: "));
}

TEST_F(RecorderTest, has_each_change_by_name_between_its_checks) {
  begin();
  control_.posted.clear();
  tick();
  change([](world::Journal& journal) {
    journal.apply(world::changes::Place{journal.world().id(journal.world().find("wall")), {7, 7, 0, 1}});
  });
  change([](world::Journal& journal) {
    EXPECT_FALSE(journal.apply(world::changes::Place{{99}, {}}));  // nothing happens
    journal.apply(world::changes::SetColor{{0}, {0, 1, 0, 1}});
  });
  tick();
  end();
  const Result<Recording> read = recording();
  ASSERT_TRUE(read.ok()) << read.error().line();
  ASSERT_EQ(read->items.size(), 4u);
  EXPECT_TRUE(read->items[0].change.empty());
  const auto name = [&](std::size_t item) {
    const Bytes bytes = read->items[item].change.unpacked();
    Unpacker in(bytes);
    return std::string(world::name_of(*world::unpack_change(in)));
  };
  EXPECT_EQ(name(1), "place");
  EXPECT_EQ(name(2), "set_color");
  EXPECT_EQ(read->items[1].tick, 1u);
  EXPECT_EQ(read->items[3].hash, world_.hash());
  EXPECT_EQ(read->states.size(), 1u);
  EXPECT_FALSE(read->cut);
}

TEST_F(RecorderTest, of_another_format_is_told_as_such) {
  for (const auto& [attachment, format] :
       {std::pair("playhouse recording 9", "9"), {"playhouse recording ", ""}, {kStartName, "1"}}) {
    const auto writer = *McapWriter::create(path_, "ros2");
    ASSERT_TRUE(writer->attach({0, attachment, "text/plain", {}}).ok());
    ASSERT_TRUE(writer->finish().ok());
    EXPECT_EQ(recording().error().text,
              fmt::format("is a recording of format \"{}\"; this program reads format {}", format,
                          formats::kRecording));
  }
}

// What the fuzzers of recordings start from must be one, or they never come by its head. UPDATE_CORPUS=1 writes
// it anew.
TEST_F(RecorderTest, that_fuzzers_start_from_is_read) {
  begin();
  tick();
  change([](world::Journal& journal) { journal.apply(world::changes::SetColor{{0}, {0, 1, 0, 1}}); });
  tick();
  end();
  for (const char* fuzzer : {"record_mcap", "record_export"}) {
    const std::string corpus = std::string(PLAYHOUSE_SOURCE_DIR "/tests/fuzz/") + fuzzer + "/run";
    if (std::getenv("UPDATE_CORPUS") != nullptr)
      std::filesystem::copy_file(path_, corpus, std::filesystem::copy_options::overwrite_existing);
    const Result<Recording> read = read_recording(**open_source(corpus));
    ASSERT_TRUE(read.ok()) << corpus << ": " << read.error().text;
    EXPECT_FALSE(read->cut);
    EXPECT_EQ(read->items.size(), recording()->items.size());
  }
}

TEST_F(RecorderTest, is_kept_packed_up_to_a_limit) {
  begin();
  tick();
  end();
  const Result<Recording> read = recording();
  ASSERT_TRUE(read.ok()) << read.error().line();
  const PackedBytes& state = read->states.at(0).bytes;
  EXPECT_LT(state.packed_size(), state.unpacked().size());
  const Result<Recording> refused = read_recording(**open_source(path_), state.packed_size());
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().line(), testing::HasSubstr("has too much to run again"));
}

TEST(PackedBytes, take_little_where_all_is_alike) {
  const Bytes alike(std::size_t{64} << 20, std::byte{7});
  const PackedBytes packed(alike);
  EXPECT_LT(packed.packed_size(), 100'000u);
  EXPECT_EQ(packed.unpacked(), alike);
  EXPECT_TRUE(PackedBytes().empty());
  EXPECT_TRUE(PackedBytes(Bytes{}).unpacked().empty());
}

TEST_F(RecorderTest, of_a_controller_that_cannot_be_saved_has_data_alone) {
  world_.deciders.push_back(std::make_unique<Shy>());
  begin();
  tick();
  end();
  EXPECT_THAT(topics(), Contains("/a/b/position"));
  const Result<Recording> read = recording();
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().text, HasSubstr("has data alone"));
}

}  // namespace
}  // namespace playhouse::record
