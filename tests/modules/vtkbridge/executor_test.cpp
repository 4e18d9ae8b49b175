#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "cloud/preview.h"
#include "pipeline/paraview_xml.h"
#include "toy_stages.h"
#include "vtkBolePipeline.h"
#include "vtkBoleStage.h"
#include "vtkbridge/executor.h"
#include "vtkbridge/file_keys.h"
#include "vtkbridge/stage_execution.h"

namespace bole::vtkbridge {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* chain = R"({"title": "toy", "stages": [
  {"id": "a", "type": "toy.points", "options": {"count": 10}},
  {"id": "b", "type": "toy.lift", "inputs": {"points": "a.points"}},
  {"id": "c", "type": "toy.count", "inputs": {"points": "b.points"}},
  {"id": "d", "type": "toy.write", "inputs": {"table": "c.table", "extra": "e.points"}},
  {"id": "e", "type": "toy.lift", "inputs": {"points": "a.points"}, "options": {"by": 2.0}}]})";

class Executor : public testing::Test {
 protected:
  void SetUp() override {
    toy::register_toys();
    settings_.output_dir = out_.path() / "out";
  }
  static pipeline::PipelineDocument document(const std::string& text = chain) {
    return pipeline::PipelineDocument::parse(text, pipeline::StageRegistry::global());
  }
  static int total_runs() {
    int n = 0;
    for (const auto& [name, count] : toy::runs()) n += count;
    return n;
  }
  nlohmann::json summary() const {
    std::ifstream in(settings_.output_dir / "summary.json");
    return nlohmann::json::parse(in);
  }
  std::string written() const {
    std::ifstream in(settings_.output_dir / "figures" / "count.txt");
    std::string line;
    std::getline(in, line);
    return line;
  }
  toy::TemporaryFolder out_;
  RunSettings settings_;
};

class Watcher : public Preview {
 public:
  bool wants() override { return true; }
  void show(DataSet snapshot) override { seen.push_back(std::move(snapshot)); }
  std::vector<DataSet> seen;
};

TEST_F(Executor, WhoWatchesAStageIsShownItsWork) {
  const auto watcher = std::make_shared<Watcher>();
  std::vector<std::string> asked;
  settings_.preview = [&](const pipeline::StageNode& node) -> std::shared_ptr<Preview> {
    asked.push_back(node.id);
    if (node.id == "b") return watcher;
    return nullptr;
  };
  const auto outcome = run_pipeline(document(), settings_);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(asked, testing::UnorderedElementsAre("a", "b", "c", "d", "e"));
  ASSERT_EQ(watcher->seen.size(), 1u);
  EXPECT_EQ(watcher->seen[0].cloud("points").size(), 10u);
  // Watching is no part of the key: the cache answers, and nothing is shown.
  settings_.preview = {};
  for (const auto& stage : run_pipeline(document(), settings_).stages)
    EXPECT_EQ(stage.state, StageState::from_cache) << stage.record.id;
  EXPECT_EQ(watcher->seen.size(), 1u);
}

TEST_F(Executor, RunsADocumentAndTellsAboutIt) {
  std::vector<std::string> heard;
  settings_.progress = [&](const std::string& stage, double, std::string_view text) {
    heard.push_back(stage + ": " + std::string(text));
  };
  const auto outcome = run_pipeline(document(), settings_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(total_runs(), 5);
  EXPECT_EQ(written(), "10 extra");
  EXPECT_THAT(heard, testing::ElementsAre("a: made points", "b: lifting", "e: lifting"));
  const auto s = summary();
  EXPECT_EQ(s["exit_code"], 0);
  EXPECT_EQ(s["axes"], "global");
  EXPECT_EQ(s["stages"].size(), 5U);
  EXPECT_EQ(s["stages"][0]["id"], "a");
  EXPECT_EQ(s["stages"][0]["counts"]["points"], 10);
  EXPECT_EQ(s["stages"][0]["options"], nlohmann::json({{"count", "10"}}));
  EXPECT_EQ(s["stages"][1]["metrics"]["lift"]["unit"], "m");
  EXPECT_EQ(s["stages"][1]["from_cache"], false);
  EXPECT_EQ(s["files"], nlohmann::json({"figures/count.txt", "summary.json"}));
  EXPECT_EQ(s["document"]["title"], "toy");
}

TEST_F(Executor, ASecondRunDoesNoWork) {
  run_pipeline(document(), settings_);
  const auto outcome = run_pipeline(document(), settings_);
  EXPECT_EQ(total_runs(), 5);
  for (const auto& stage : outcome.stages) EXPECT_EQ(stage.state, StageState::from_cache) << stage.record.id;
  const auto s = summary();
  EXPECT_EQ(s["stages"][0]["counts"]["points"], 10);
  EXPECT_EQ(s["files"], nlohmann::json({"figures/count.txt", "summary.json"}));
}

TEST_F(Executor, AChangedOptionRunsWhatIsDownstream) {
  run_pipeline(document(), settings_);
  auto changed = document();
  changed.set("b.by", "5");
  const auto outcome = run_pipeline(changed, settings_);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(toy::runs()["toy.points"], 1);
  EXPECT_EQ(toy::runs()["toy.lift"], 3);  // b and e, then b
  EXPECT_EQ(toy::runs()["toy.count"], 2);
  EXPECT_EQ(toy::runs()["toy.write"], 2);
  run_pipeline(document(), settings_);  // back again: only the sink, whose file was written over
  EXPECT_EQ(toy::runs()["toy.lift"], 3);
  EXPECT_EQ(toy::runs()["toy.write"], 3);
}

TEST_F(Executor, StagesKnowWhatRanBefore) {
  PipelineExecutor executor(document());
  ASSERT_EQ(executor.run(settings_).exit_code, 0);
  executor.stage("c")->FillOutputs();
  EXPECT_EQ(vtkTable::SafeDownCast(executor.stage("c")->GetOutputDataObject(0))->GetValueByName(1, "value").ToDouble(),
            2);  // a and b
}

TEST_F(Executor, ResultsComeBackFromTheCacheAsTheyWere) {
  {
    PipelineExecutor executor(document());
    executor.run(settings_);
  }
  PipelineExecutor executor(document());
  ASSERT_EQ(executor.run(settings_).exit_code, 0);
  auto* stage = executor.stage("b");
  ASSERT_TRUE(stage->FillOutputs());
  auto* poly = vtkPolyData::SafeDownCast(stage->GetOutputDataObject(0));
  ASSERT_EQ(poly->GetNumberOfPoints(), 10);
  EXPECT_EQ(poly->GetPoint(3)[0], 1.5);
  ASSERT_TRUE(executor.stage("c")->FillOutputs());
  EXPECT_EQ(vtkTable::SafeDownCast(executor.stage("c")->GetOutputDataObject(0))->GetValueByName(0, "value").ToDouble(),
            10);
  EXPECT_EQ(total_runs(), 5);
}

TEST_F(Executor, DamagedEntriesAreRunAgain) {
  run_pipeline(document(), settings_);
  for (const auto& entry : fs::recursive_directory_iterator(settings_.output_dir / "cache" / "blobs"))
    if (entry.is_regular_file() && entry.file_size() > 0) {
      std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
      file.put('\x7f');
    }
  auto changed = document();
  changed.set("b.by", "7");  // needs the points of stage a
  const auto outcome = run_pipeline(changed, settings_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(toy::runs()["toy.points"], 2);
  EXPECT_EQ(written(), "10 extra");

  for (const auto& entry : fs::directory_iterator(settings_.output_dir / "cache" / "results")) {
    std::ofstream file(entry.path(), std::ios::app);
    file << "}";
  }
  EXPECT_EQ(run_pipeline(changed, settings_).exit_code, 0);
  EXPECT_EQ(toy::runs()["toy.points"], 3);
}

TEST_F(Executor, InputFilesCountByContent) {
  const auto file = out_.path() / "in.txt";
  std::ofstream(file) << "abc";
  auto with_file = document();
  with_file.set("a.file", file.string());
  run_pipeline(with_file, settings_);
  EXPECT_EQ(written(), "13 extra");
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
  run_pipeline(with_file, settings_);
  EXPECT_EQ(toy::runs()["toy.points"], 1);
  std::ofstream(file) << "abcd";
  run_pipeline(with_file, settings_);
  EXPECT_EQ(toy::runs()["toy.points"], 2);
  EXPECT_EQ(written(), "14 extra");
}

// A program that keeps its pipeline, as Python's vtkBolePipeline does, sees that a file was edited in between.
TEST_F(Executor, AFileThatIsEditedBetweenTwoRunsIsReadAgain) {
  for (const bool use_cache : {true, false}) {
    SCOPED_TRACE(use_cache);
    toy::runs()["toy.points"] = 0;
    settings_.use_cache = use_cache;
    const auto file = out_.path() / "in.txt";
    std::ofstream(file) << "abc";
    auto with_file = document();
    with_file.set("a.file", file.string());
    PipelineExecutor executor(with_file);
    executor.run(settings_);
    EXPECT_EQ(written(), "13 extra");
    executor.run(settings_);
    EXPECT_EQ(toy::runs()["toy.points"], 1);
    std::ofstream(file) << "abcd";
    executor.run(settings_);
    EXPECT_EQ(toy::runs()["toy.points"], 2);
    EXPECT_EQ(written(), "14 extra");
    fs::remove_all(settings_.output_dir / "cache");
  }
}

TEST(FileKeys, TimesBesideAFolderOfFramesCount) {
  const toy::TemporaryFolder out;
  const auto frames = out.path() / "walk" / "frames";
  fs::create_directories(frames);
  std::ofstream(frames / "0.bin") << "0123456789abcdef";
  FileKeys keys({});
  const auto key = keys.key(frames), stamp = change_stamp(frames);
  EXPECT_EQ(keys.key(frames), key);
  EXPECT_EQ(change_stamp(frames), stamp);
  std::ofstream(out.path() / "walk" / "times.txt") << "1.5\n";
  const auto timed_key = keys.key(frames), timed_stamp = change_stamp(frames);
  EXPECT_NE(timed_key, key);
  EXPECT_NE(timed_stamp, stamp);
  std::ofstream(out.path() / "walk" / "times.txt") << "2.25\n";
  EXPECT_NE(keys.key(frames), timed_key);
  EXPECT_NE(change_stamp(frames), timed_stamp);
  EXPECT_EQ(keys.key(frames / ""), keys.key(frames));
}

// A reader finds it by itself, so a result without it is not a result with it.
TEST(FileKeys, AnInertialUnitBesideAScanCounts) {
  const toy::TemporaryFolder out;
  const auto scan = out.path() / "walk.pcap", frames = out.path() / "frames";
  fs::create_directories(frames);
  std::ofstream(scan) << "0123456789abcdef";
  std::ofstream(frames / "0.bin") << "0123456789abcdef";
  FileKeys keys({});
  const auto scan_key = keys.key(scan), frames_key = keys.key(frames), stamp = change_stamp(scan);
  std::ofstream(out.path() / "imu.csv") << "1\n";
  const auto with_unit = keys.key(scan);
  EXPECT_NE(with_unit, scan_key);
  EXPECT_NE(keys.key(frames), frames_key);
  EXPECT_NE(change_stamp(scan), stamp);
  std::ofstream(out.path() / "walk_imu.csv") << "2\n";
  EXPECT_NE(keys.key(scan), with_unit);
  fs::remove(out.path() / "imu.csv");
  fs::remove(out.path() / "walk_imu.csv");
  EXPECT_EQ(keys.key(scan), scan_key);
}

TEST(FileKeys, ReadingABigFileTellsHowFarItIsAndCanBeCancelled) {
  const toy::TemporaryFolder out;
  std::ofstream(out.path() / "scan.pcap") << 'x';
  fs::resize_file(out.path() / "scan.pcap", 300U << 20);  // takes no room on the disk
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  double last = 0;
  run.progress = [&](double fraction, std::string_view what) {
    EXPECT_THAT(std::string(what), HasSubstr("scan.pcap"));
    last = fraction;
    if (fraction > 0.5) stop.request_stop();
  };
  FileKeys keys({});
  EXPECT_THROW(keys.key(out.path() / "scan.pcap", run), Error);
  EXPECT_GT(last, 0.5);
  EXPECT_LT(last, 0.9);
  EXPECT_EQ(keys.key(out.path() / "scan.pcap").size(), 32U);
}

TEST(StageKey, AFileThatAnOptionMayNameCountsByItsContent) {
  const toy::TemporaryFolder out;
  const auto file = out.path() / "unit.json";
  struct Options {
    std::string sensor = "auto";
  };
  const auto table = make_option_table<Options>({Option<Options, std::string>{
      "sensor", &Options::sensor, TextKind::input_path_or_name, {}, Tier::basic, "A name or a file."}});
  pipeline::StageType type;
  type.name = "toy.sensor", type.options = &table;
  OptionSet options(table);
  ResultCache cache(out.path() / "cache");
  const auto key = [&] { return stage_key(type, options, {}, {}, cache); };
  const auto unnamed = key();
  options.set("sensor", std::string("vlp16"));
  EXPECT_NE(key(), unnamed);
  options.set("sensor", file.string());
  std::ofstream(file) << "1";
  const auto first = key();
  EXPECT_EQ(key(), first);
  std::ofstream(file) << "22";
  EXPECT_NE(key(), first);
}

TEST_F(Executor, ASinkWritesAgainWhenItsFileIsGone) {
  run_pipeline(document(), settings_);
  fs::remove_all(settings_.output_dir / "figures");
  run_pipeline(document(), settings_);
  EXPECT_EQ(written(), "10 extra");
  EXPECT_EQ(total_runs(), 6);
}

TEST_F(Executor, WithoutCacheEverythingRuns) {
  settings_.use_cache = false;
  run_pipeline(document(), settings_);
  run_pipeline(document(), settings_);
  EXPECT_EQ(total_runs(), 10);
  EXPECT_FALSE(fs::exists(settings_.output_dir / "cache"));
}

TEST_F(Executor, AFailureTakesOnlyWhatNeedsIt) {
  auto broken = document();
  broken.set("e.fail", "true");  // an optional input of the sink
  auto outcome = run_pipeline(broken, settings_);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, testing::AllOf(HasSubstr("stage 'e'"), HasSubstr("the toy is broken")));
  EXPECT_EQ(written(), "10");
  broken.set("b.fail", "true");
  outcome = run_pipeline(broken, settings_);
  const auto s = summary();
  EXPECT_EQ(s["stages"][1]["state"], "failed");
  EXPECT_EQ(s["stages"][2]["state"], "skipped");
  EXPECT_THAT(s["stages"][2]["error"].get<std::string>(), HasSubstr("stage 'b' gave no points"));
}

TEST_F(Executor, AStageWhoseInputsAllFailedIsSkipped) {
  const auto glance = document(R"({"stages": [{"id": "a", "type": "toy.points", "options": {"count": 10}},
    {"id": "b", "type": "toy.lift", "inputs": {"points": "a.points"}},
    {"id": "g", "type": "toy.glance", "inputs": {"extra": "b.points"}},
    {"id": "alone", "type": "toy.glance"}]})");
  auto broken = glance;
  broken.set("b.fail", "true");
  EXPECT_EQ(run_pipeline(glance, settings_).exit_code, 0);
  EXPECT_THAT(run_pipeline(broken, settings_).error, HasSubstr("the toy is broken"));
  for (const auto& s : summary()["stages"]) {
    if (s["id"] == "g") {
      EXPECT_EQ(s["state"], "skipped");
      EXPECT_THAT(s["error"].get<std::string>(), HasSubstr("all of its inputs failed"));
    } else {
      EXPECT_EQ(s["state"], s["id"] == "b" ? "failed" : "done") << s["id"];
    }
  }
}

TEST_F(Executor, AnOutputThatAStageDoesNotGiveIsNoInput) {
  std::string text = chain;
  const std::string maker =
      R"({"id": "e", "type": "toy.lift", "inputs": {"points": "a.points"}, "options": {"by": 2.0}})";
  text.replace(text.find(maker), maker.size(), R"({"id": "e", "type": "toy.nothing"})");
  for (int round = 0; round < 2; ++round) {  // the second from the cache
    const auto outcome = run_pipeline(document(text), settings_);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(written(), "10");
  }
  const auto outcome = run_pipeline(
      document(
          R"({"stages": [{"id": "n", "type": "toy.nothing"}, {"id": "l", "type": "toy.lift", "inputs": {"points": "n.points"}}]})"),
      settings_);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, testing::AllOf(HasSubstr("input 'points'"), HasSubstr("gave nothing")));
}

TEST_F(Executor, AnOptionalStageWithoutItsFileIsSkipped) {
  std::string text = chain;
  const std::string maker =
      R"({"id": "e", "type": "toy.lift", "inputs": {"points": "a.points"}, "options": {"by": 2.0}})";
  text.replace(text.find(maker), maker.size(), R"({"id": "e", "type": "toy.points", "optional": true})");
  const auto outcome = run_pipeline(document(text), settings_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(written(), "10");
  for (const auto& stage : outcome.stages) {
    EXPECT_EQ(stage.state == StageState::skipped, stage.record.id == "e");
    EXPECT_TRUE(stage.record.report.warnings.empty());
  }
}

TEST_F(Executor, ADocumentThatCannotRunIsRefusedBefore) {
  const auto outcome = run_pipeline(
      document(
          R"({"stages": [{"id": "a", "type": "toy.points"}, {"id": "c", "type": "toy.count", "inputs": {"points": "a.points"}}, {"id": "l", "type": "toy.lift"}]})"),
      settings_);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, testing::AllOf(HasSubstr("'l'"), HasSubstr("not joined")));
  EXPECT_EQ(total_runs(), 0);
}

constexpr const char* slow_chain =
    R"({"stages": [{"id": "a", "type": "toy.points"}, {"id": "s", "type": "toy.slow", "inputs": {"points": "a.points"}}, {"id": "l", "type": "toy.lift", "inputs": {"points": "s.points"}}]})";

TEST_F(Executor, CancelEndsTheRun) {
  std::stop_source cancel;
  settings_.cancel = cancel.get_token();
  std::chrono::steady_clock::time_point asked;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    asked = std::chrono::steady_clock::now();
    cancel.request_stop();
  });
  const auto outcome = run_pipeline(document(slow_chain), settings_);
  const auto end = std::chrono::steady_clock::now();
  other.join();
  EXPECT_LT(std::chrono::duration<double>(end - asked).count(), 0.5);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.stages[1].state, StageState::cancelled);
  EXPECT_EQ(toy::runs()["toy.lift"], 0);
  EXPECT_EQ(summary()["exit_code"], 3);
}

TEST_F(Executor, FinishEndsOneStageAndIsNotCached) {
  for (int round = 1; round <= 2; ++round) {
    std::stop_source finish;
    settings_.finish = finish.get_token();
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      finish.request_stop();
    });
    const auto outcome = run_pipeline(document(slow_chain), settings_);
    other.join();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.stages[1].record.report.status, Status::finished_early);
    EXPECT_EQ(outcome.stages[2].record.report.status, Status::ok);
    EXPECT_EQ(toy::runs()["toy.slow"], round);
    EXPECT_EQ(toy::runs()["toy.lift"], 1);  // the same half result, known by its content
  }
}

TEST_F(Executor, FramesAreReopenedOnlyWhenNeeded) {
  const auto scan = document(
      R"({"stages": [{"id": "f", "type": "toy.frames"}, {"id": "u", "type": "toy.use_frames", "inputs": {"frames": "f.frames"}}]})");
  run_pipeline(scan, settings_);
  PipelineExecutor again(scan);
  again.run(settings_);
  EXPECT_EQ(toy::runs()["toy.frames"], 1);
  EXPECT_EQ(toy::runs()["toy.use_frames"], 1);
  ASSERT_TRUE(again.stage("f")->FillOutputs());
  EXPECT_EQ(vtkPolyData::SafeDownCast(again.stage("f")->GetOutputDataObject(0))->GetNumberOfPoints(), 1);
  EXPECT_EQ(toy::runs()["toy.frames"], 2);
}

TEST_F(Executor, OldResultsMakeRoom) {
  settings_.cache_bytes = 1000;
  for (int i = 0; i < 5; ++i) {
    auto doc = document();
    doc.set("a.count", std::to_string(20 + i));
    run_pipeline(doc, settings_);
  }
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(settings_.output_dir / "cache" / "blobs"))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LE(bytes, 1000U);
  EXPECT_GT(bytes, 0U);
}

TEST_F(Executor, APipelineObjectRunsOnlyWhatChanged) {
  vtkNew<vtkBolePipeline> pipeline;
  ASSERT_TRUE(pipeline->ParseDocument(chain));
  vtkNew<vtkCallbackCommand> silence;
  pipeline->AddObserver(vtkCommand::ErrorEvent, silence);
  pipeline->SetUseCache(false);
  pipeline->SetOutputDirectory(settings_.output_dir.c_str());
  ASSERT_TRUE(pipeline->Run()) << pipeline->GetErrorText();
  EXPECT_FALSE(pipeline->SetOption("c.none", "1"));
  ASSERT_TRUE(pipeline->SetOption("b.by", 4.0));
  ASSERT_TRUE(pipeline->Run()) << pipeline->GetErrorText();
  EXPECT_EQ(toy::runs()["toy.points"], 1);
  EXPECT_EQ(toy::runs()["toy.lift"], 3);
  auto* table = vtkTable::SafeDownCast(pipeline->GetStage("c")->GetOutputDataObject(0));
  EXPECT_NEAR(table->GetValueByName(0, "mean_height").ToDouble(), 6, 1e-5);
}

TEST(ParaviewXml, HasPortsAndOptionsOfEveryStage) {
  toy::register_toys();
  const auto xml = pipeline::paraview_xml(pipeline::StageRegistry::global());
  EXPECT_THAT(xml, HasSubstr(R"(class="vtkBoleStage" label="toy.lift")"));
  EXPECT_THAT(xml, HasSubstr(R"(command="SetOption" initial_string="by" number_of_elements="1" default_values="1")"));
  EXPECT_THAT(xml, HasSubstr(R"(min="-100" max="100")"));
  EXPECT_THAT(xml, HasSubstr("<Optional/>"));
  EXPECT_THAT(xml, HasSubstr("<TimeStepsInformationHelper/>"));
  EXPECT_THAT(xml, HasSubstr(R"x(label="By (m)")x"));
  EXPECT_THAT(xml, HasSubstr(R"(name="extra" port_index="1" command="SetInputConnection" null_on_empty="1")"));
  EXPECT_THAT(xml, HasSubstr(R"(command="SetOutputDirectory")"));  // of the stage that writes files
  EXPECT_THAT(xml, HasSubstr(R"(panel_visibility="advanced")"));
  EXPECT_THAT(xml, testing::Not(HasSubstr("ReaderFactory")));
  const auto opened =
      pipeline::paraview_xml(pipeline::StageRegistry::global(), {{"toy.points", {"pts xyz", "Points"}}});
  EXPECT_THAT(opened, HasSubstr(R"(<ReaderFactory extensions="pts xyz" file_description="Points"/>)"));

  // A stage with a class of its own needs no property that names its type.
  pipeline::StageRegistry registry;
  auto named = pipeline::StageRegistry::global().at("toy.lift");
  named.vtk_class = "vtkBoleLift";
  registry.add(std::move(named));
  const auto named_xml = pipeline::paraview_xml(registry);
  EXPECT_THAT(named_xml, HasSubstr(R"(class="vtkBoleLift" label="toy.lift")"));
  EXPECT_THAT(named_xml, testing::Not(HasSubstr("SetStageType")));
}

}  // namespace
}  // namespace bole::vtkbridge
