#include "pipeline/document.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "modules/pipeline/toy_stages.h"

namespace bole::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const StageRegistry& registry() {
  static const StageRegistry r = toy::toy_registry();
  return r;
}

constexpr const char* chain = R"({"title": "Toy", "stages": [
  {"id": "slice", "type": "toy.slice", "inputs": {"points": "height.points"}, "options": {"height": 1.37}},
  {"id": "scan", "type": "toy.scan"},
  {"id": "height", "type": "toy.height", "inputs": {"points": "scan.points"}}]})";

std::string error_of_document(const std::string& text) {
  try {
    PipelineDocument::parse(text, registry());
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_code(), 2);
    return e.what();
  }
  return "no error";
}

TEST(Document, StagesRunAfterThoseTheyTakeFrom) {
  const auto document = PipelineDocument::parse(chain, registry());
  std::vector<std::string> ids;
  for (const auto* node : document.in_order()) ids.push_back(node->id);
  EXPECT_THAT(ids, ::testing::ElementsAre("scan", "height", "slice"));
  EXPECT_EQ(document.at("slice").options.as<toy::SliceOptions>().height, 1.37);
  EXPECT_THAT(validate(document), IsEmpty());
}

TEST(Document, RoundTripsThroughJson) {
  const auto document = PipelineDocument::parse(chain, registry());
  const auto again = PipelineDocument::parse(document.to_json(), registry());
  EXPECT_EQ(document.to_json(), again.to_json());
  EXPECT_THAT(document.to_json(), HasSubstr("1.37"));
  EXPECT_THAT(document.to_json(), ::testing::Not(HasSubstr("thickness"))) << "an option at its default is not written";
}

TEST(Document, ErrorsNameThePlaceAndTheRemedy) {
  EXPECT_THAT(error_of_document("{"), HasSubstr("not a JSON text"));
  EXPECT_THAT(error_of_document("[]"), HasSubstr("no list of stages"));
  EXPECT_THAT(error_of_document(R"({"stages": []})"), HasSubstr("no stage"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.slcie"}]})"),
              HasSubstr("Did you mean toy.slice"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.slice", "opts": {}}]})"),
              HasSubstr("unknown key 'opts'"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.slice", "options": {"heigth": 1}}]})"),
              HasSubstr("Did you mean height"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.slice", "options": {"height": 99}}]})"),
              HasSubstr("a number from 0.1 to 5 m"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.slice", "options": {"height": [1]}}]})"),
              HasSubstr("option height is [1]"));
  EXPECT_THAT(error_of_document(R"({"stages": [{"id": "a", "type": "toy.scan"}, {"id": "a", "type": "toy.scan"}]})"),
              HasSubstr("two stages have the id 'a'"));
}

TEST(Document, SetTakesStageDotOption) {
  auto document = PipelineDocument::parse(chain, registry());
  document.set("slice.thickness", "0.2");
  EXPECT_EQ(document.at("slice").options.as<toy::SliceOptions>().thickness, 0.2);
  EXPECT_THROW(document.set("slice", "1"), Error);
  EXPECT_THROW(document.set("slices.height", "1"), Error);
  EXPECT_THROW(document.set("slice.height", "tall"), Error);
}

TEST(Document, PathsAreTakenFromTheDocumentsFolder) {
  const auto document = PipelineDocument::parse(
      R"({"stages": [{"id": "a", "type": "toy.read", "options": {"file": "data/x.las"}}]})", registry(), "/plots/one");
  EXPECT_EQ(document.at("a").options.as<toy::ReadOptions>().file, "/plots/one/data/x.las");
}

TEST(Document, AnOptionalStageIsSkippedWhileItsFileIsNotGiven) {
  auto document = PipelineDocument::parse(R"({"stages": [
    {"id": "reference", "type": "toy.read", "optional": true},
    {"id": "compare", "type": "toy.compare", "inputs": {"reference": "reference.points"}},
    {"id": "needs", "type": "toy.height", "inputs": {"points": "reference.points"}}]})",
                                          registry());
  EXPECT_THAT(document.in_order(), SizeIs(2));
  EXPECT_THAT(document.joints(document.at("compare")), IsEmpty());
  ASSERT_THAT(validate(document), SizeIs(1));
  EXPECT_THAT(validate(document)[0].message, HasSubstr("'reference', which is skipped"));
  document.set("reference.file", "/");
  EXPECT_THAT(document.in_order(), SizeIs(3));
  EXPECT_THAT(document.joints(document.at("compare")), SizeIs(1));
  EXPECT_THAT(validate(document), IsEmpty());
}

// What only works on an optional file has nothing to do without it either, however many stages lie between.
TEST(Document, StagesBehindASkippedOneAreSkippedWhereTheySayThatTheyMay) {
  auto document = PipelineDocument::parse(R"({"stages": [
    {"id": "reference", "type": "toy.read", "optional": true},
    {"id": "height", "type": "toy.height", "optional": true, "inputs": {"points": "reference.points"}},
    {"id": "again", "type": "toy.height", "optional": true, "inputs": {"points": "height.points"}},
    {"id": "compare", "type": "toy.compare", "optional": true, "inputs": {"reference": "again.points"}}]})",
                                          registry());
  ASSERT_THAT(document.in_order(), SizeIs(1));  // its input is not required
  EXPECT_EQ(document.in_order()[0]->id, "compare");
  EXPECT_THAT(document.joints(document.at("compare")), IsEmpty());
  EXPECT_THAT(validate(document), IsEmpty());
  document.set("reference.file", "/");
  EXPECT_THAT(document.in_order(), SizeIs(4));
  EXPECT_THAT(document.joints(document.at("compare")), SizeIs(1));
}

TEST(Document, ACircleOfOptionalStagesIsReportedAndNotFollowed) {
  const auto document = PipelineDocument::parse(R"({"stages": [
    {"id": "a", "type": "toy.height", "optional": true, "inputs": {"points": "b.points"}},
    {"id": "b", "type": "toy.height", "optional": true, "inputs": {"points": "a.points"}},
    {"id": "c", "type": "toy.height", "optional": true, "inputs": {"points": "gone.points"}}]})",
                                                registry());
  std::string all;
  for (const auto& p : validate(document)) all += p.message + "\n";
  EXPECT_THAT(all, HasSubstr("takes its own output"));
  EXPECT_THAT(all, HasSubstr("gone"));
}

TEST(Validate, FindsWhatCannotRun) {
  const auto problems_of = [](const std::string& text) {
    std::string all;
    for (const auto& p : validate(PipelineDocument::parse(text, registry()))) all += p.stage + ": " + p.message + "\n";
    return all;
  };
  EXPECT_THAT(problems_of(R"({"stages": [{"id": "s", "type": "toy.slice"}]})"),
              HasSubstr("input 'points' is not joined"));
  EXPECT_THAT(
      problems_of(
          R"({"stages": [{"id": "r", "type": "toy.scan"}, {"id": "s", "type": "toy.slice", "inputs": {"points": "r.points"}}]})"),
      HasSubstr("needs the array 'height_above_ground'"));
  EXPECT_THAT(
      problems_of(
          R"({"stages": [{"id": "r", "type": "toy.scan"}, {"id": "s", "type": "toy.height", "inputs": {"points": "r.cloud"}}]})"),
      HasSubstr("needed: one of points"));
  EXPECT_THAT(
      problems_of(
          R"({"stages": [{"id": "r", "type": "toy.scan", "inputs": {"frames": "h.points"}}, {"id": "h", "type": "toy.height", "inputs": {"points": "r.points"}}]})"),
      HasSubstr("takes a frames"));
  EXPECT_THAT(problems_of(R"({"stages": [{"id": "r", "type": "toy.read"}]})"), HasSubstr("--set r.file=PATH"));
  EXPECT_THAT(problems_of(R"({"stages": [{"id": "r", "type": "toy.read", "options": {"file": "/no/such"}}]})"),
              HasSubstr("there is no file"));
}

TEST(Validate, ACircleIsFound) {
  const auto document = PipelineDocument::parse(
      R"({"stages": [{"id": "a", "type": "toy.height", "inputs": {"points": "b.points"}}, {"id": "b", "type": "toy.height", "inputs": {"points": "a.points"}}]})",
      registry());
  ASSERT_THAT(validate(document), SizeIs(1));
  EXPECT_THAT(validate(document)[0].message, HasSubstr("takes its own output"));
}

// Each stage takes two clouds: looking back along every path would never end.
TEST(Validate, ManyPathsToOneStageAreWalkedOnce) {
  EXPECT_THAT(validate(PipelineDocument::parse(R"({"stages": [
    {"id": "a", "type": "toy.merge", "inputs": {"points": "b.points", "slice": "b.points"}},
    {"id": "b", "type": "toy.merge", "inputs": {"points": "a.points", "slice": "a.points"}}]})",
                                               registry()))[0]
                  .message,
              HasSubstr("takes its own output"));
  std::string path = R"({"stages": [{"id": "m0", "type": "toy.scan"})";
  for (int i = 1; i <= 70; ++i) {
    const std::string before = "m" + std::to_string(i - 1) + ".points";
    path += R"(, {"id": "m)" + std::to_string(i) + R"(", "type": "toy.merge", "inputs": {"points": ")" + before +
            R"(", "slice": ")" + before + "\"}}";
  }
  EXPECT_THAT(validate(PipelineDocument::parse(path + "]}", registry())), IsEmpty());
  const auto sliced = path + R"(, {"id": "slice", "type": "toy.slice", "inputs": {"points": "m70.points"}}]})";
  ASSERT_THAT(validate(PipelineDocument::parse(sliced, registry())), SizeIs(1));
  EXPECT_THAT(validate(PipelineDocument::parse(sliced, registry()))[0].message, HasSubstr("height_above_ground"));
}

TEST(Validate, RelationsBetweenOptionsCount) {
  auto document = PipelineDocument::parse(chain, registry());
  document.set("slice.height", "0.1");
  document.set("slice.thickness", "0.5");
  EXPECT_THAT(validate(document), SizeIs(1));
}

}  // namespace
}  // namespace bole::pipeline
