#include "stems/core/bark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "modules/io/io_test_tools.h"

namespace bole::stems {
namespace {

MeasureOptions with_bark(const std::string& name) {
  MeasureOptions options;
  options.bark = name;
  return options;
}

std::string refusal(const std::string& name) {
  try {
    bark_of(with_bark(name));
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

// Every kind has a number and a spread that is not small beside it: none of the depths is known well.
TEST(Bark, EveryKindThatComesWithBoleSaysHowSureItIs) {
  const auto names = bark_names();
  EXPECT_THAT(names, testing::IsSupersetOf({"mean", "smooth", "scaly", "ridged", "plated", "furrowed"}));
  for (const auto& name : names) {
    const auto bark = bark_of(with_bark(name));
    EXPECT_FALSE(bark.title.empty()) << name;
    EXPECT_GE(bark.relief_sd_m, 0.4 * bark.relief_m) << name;
    EXPECT_GT(bark.relief_sd_m, 0) << name;
  }
  EXPECT_EQ(bark_of({}).relief_m, 0);  // the convention
}

TEST(Bark, NumbersThatAreGivenCount) {
  auto options = with_bark("plated");
  const auto as_named = bark_of(options);
  options.bark_relief = 0.001;
  EXPECT_EQ(bark_of(options).relief_m, 0.001);
  EXPECT_EQ(bark_of(options).relief_sd_m, as_named.relief_sd_m);
}

TEST(Bark, OfTheOwnStandInAFile) {
  const testing_io::TempDir folder;
  const auto path = (folder.path() / "stand.json").string();
  std::ofstream(path) << R"({"title": "Measured on 20 stems", "relief_mm": 1.2, "relief_sd_mm": 0.2})";
  EXPECT_NEAR(bark_of(with_bark(path)).relief_m, 0.0012, 1e-12);
  std::ofstream(path) << R"({"title": "In metres by mistake?", "relief_mm": 120, "relief_sd_mm": 0.2})";
  EXPECT_THAT(refusal(path), testing::HasSubstr("relief_mm is 120"));
  std::ofstream(path) << R"({"title": "No spread", "relief_mm": 1})";
  EXPECT_THAT(refusal(path), testing::HasSubstr("relief_sd_mm"));
  std::ofstream(path) << "no JSON";
  EXPECT_THAT(refusal(path), testing::HasSubstr("not JSON"));
}

TEST(Bark, OtherNamesAreRefusedWithThoseThatThereAre) {
  EXPECT_THAT(refusal("corky"), testing::AllOf(testing::HasSubstr("'corky'"), testing::HasSubstr("furrowed")));
}

}  // namespace
}  // namespace bole::stems
