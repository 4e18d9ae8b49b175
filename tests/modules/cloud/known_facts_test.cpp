#include "cloud/known_facts.h"

#include <gmock/gmock.h>

#include <set>

#include "base/error.h"
#include "cloud/point_cloud.h"

namespace bole {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(KnownFacts, KeysAreUniqueAndEndWithTheirUnits) {
  std::set<std::string_view> keys;
  for (const auto* info : known_facts()) {
    EXPECT_TRUE(keys.insert(info->key).second) << info->key;
    EXPECT_FALSE(info->meaning.empty()) << info->key;
    if (info->unit.empty()) continue;
    if (info->unit != "1")  // of a count, whose key says what is counted
      EXPECT_TRUE(info->key.ends_with("_" + std::string(info->unit))) << info->key;
    EXPECT_LT(info->min, info->max) << info->key;
  }
}

TEST(KnownFacts, GiveBackWhatWasSet) {
  Facts f;
  EXPECT_EQ(fact_number(f, facts::beam_divergence), std::nullopt);
  EXPECT_EQ(pose_origin(f), std::nullopt);
  set_fact(f, facts::beam_divergence, 1e3 * (3.0 * 1e-3));
  set_fact(f, facts::beam_aperture, 9.5 * 1e-3);
  set_fact(f, facts::sensor, "VLP-32C");
  set_fact(f, PoseOrigin::estimated);
  EXPECT_EQ(fact_number(f, facts::beam_divergence), 3.0);
  EXPECT_EQ(fact_number(f, facts::beam_aperture), 0.0095);
  EXPECT_EQ(fact_text(f, facts::sensor), "VLP-32C");
  EXPECT_EQ(pose_origin(f), PoseOrigin::estimated);
}

TEST(KnownFacts, ValuesThatCannotBeAreErrors) {
  for (const char* text : {"", "wide", "3 mrad", "nan", "-1", "1e9"}) {
    Facts f{{"beam_divergence_mrad", text}};
    try {
      fact_number(f, facts::beam_divergence);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      EXPECT_THAT(e.what(), HasSubstr("a number from 0 to 100 mrad"));
    }
  }
  EXPECT_THROW(pose_origin({{"poses", "guessed"}}), Error);
}

TEST(KnownFacts, JsonGivesThemBack) {
  Facts f{{"sensor", "Dôme \"64\"\n"}, {"operator", "A. Smith"}};
  set_fact(f, facts::range_noise, 0.005);
  std::vector<std::string> warnings;
  const auto text = facts_to_json(f);
  for (const char c : text) EXPECT_TRUE(c >= ' ' && c < 127) << text;
  EXPECT_EQ(facts_from_json(text, warnings), f);
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(KnownFacts, DamagedJsonIsLeftOutWithWarnings) {
  std::vector<std::string> warnings;
  for (const char* text : {"", "[]", "{", "{\"sensor\":\"VLP-3", "\xff\xfe{}"}) {
    warnings.clear();
    EXPECT_THAT(facts_from_json(text, warnings), IsEmpty()) << text;
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("damaged"))) << text;
  }
  warnings.clear();
  const auto some = facts_from_json(R"({"sensor":"X","range_noise_m":"much","poses":"guessed","note":3})", warnings);
  EXPECT_EQ(some, (Facts{{"sensor", "X"}}));
  EXPECT_THAT(warnings,
              testing::UnorderedElementsAre(HasSubstr("range_noise_m"), HasSubstr("poses"), HasSubstr("note")));
}

TEST(KnownFacts, TravelWithASubset) {
  PointCloud cloud({Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)});
  set_fact(cloud.facts, facts::sensor, "VLP-32C");
  EXPECT_EQ(cloud.subset({1}).facts, cloud.facts);
}

}  // namespace
}  // namespace bole
