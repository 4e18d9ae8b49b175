#include "base/option.h"

#include <gmock/gmock.h>

#include "base/option_text.h"

namespace bole {
namespace {

struct SliceOptions {
  double height = 1.30;
  int rings = 3;
  bool level = true;
  std::string method = "circle";
};

const OptionTable& table() {
  using S = SliceOptions;
  static const OptionTable t = make_option_table<S>({
      Option<S, double>{"height", &S::height, Unit::metre, {0.1, 5.0}, Tier::basic, "Height."},
      Option<S, int>{"rings", &S::rings, Unit::none, {1, 9}, Tier::expert, "Rings."},
      Option<S, bool>{"level", &S::level, Tier::advanced, "Level."},
      Option<S, std::string>{"method", &S::method, TextKind::choice, {"circle", "cylinder"}, Tier::basic, "Method."},
  });
  return t;
}

TEST(Option, DefaultsComeFromTheStruct) {
  const OptionSet set(table());
  EXPECT_EQ(std::get<double>(set.get("height")), 1.30);
  EXPECT_TRUE(set.is_default("method"));
}

TEST(Option, TextIsParsedToTheDeclaredType) {
  OptionSet set(table());
  set.set_text("height", "1.37");
  set.set_text("rings", "7");
  set.set_text("level", "off");
  set.set_text("method", "cylinder");
  const auto& s = set.as<SliceOptions>();
  EXPECT_EQ(s.height, 1.37);
  EXPECT_EQ(s.rings, 7);
  EXPECT_FALSE(s.level);
  EXPECT_EQ(s.method, "cylinder");
}

TEST(Option, AnErrorNamesOptionValueAndWhatWasNeeded) {
  OptionSet set(table());
  try {
    set.set_text("height", "9");
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "option height is '9'; needed: a number from 0.1 to 5 m");
    EXPECT_EQ(e.exit_code(), 2);
  }
  EXPECT_THROW(set.set_text("height", "nan"), Error);
  EXPECT_THROW(set.set_text("height", "1.3m"), Error);
  EXPECT_THROW(set.set_text("rings", "2.5"), Error);
  EXPECT_THROW(set.set("method", std::string("square")), Error);
}

TEST(Option, LimitsOfWholeNumbersAreWrittenInFull) {
  OptionSpec spec;
  spec.kind = ValueKind::integer;
  EXPECT_EQ(limit_text(spec, 1000000), "1000000");
  EXPECT_EQ(limit_text(spec, 0.5), "0.5");
  spec.name = "seed", spec.min = 0, spec.max = 1e6;
  EXPECT_EQ(spec.needed(), "a whole number from 0 to 1000000");
  spec.kind = ValueKind::number;
  EXPECT_EQ(limit_text(spec, 1000000), "1e+06");
}

TEST(Option, ATextIsANumberAsAWholeOrNotAtAll) {
  EXPECT_EQ(number_from_text(number_text(0.1)), 0.1);
  EXPECT_EQ(number_from_text("-7.5"), -7.5);
  for (const char* text : {"", "7,5", "7.5 ", " 7.5", "7.5m", "x"}) EXPECT_FALSE(number_from_text(text)) << text;
}

TEST(Option, ATextMayNameAFileOrSomethingKnown) {
  OptionSpec spec;
  spec.default_value = std::string();
  const auto is_path = [&](TextKind kind, const char* value) {
    spec.text_kind = kind;
    return is_input_path(spec, std::string(value));
  };
  EXPECT_TRUE(is_path(TextKind::input_path, "scan.pcap"));
  EXPECT_FALSE(is_path(TextKind::input_path, ""));
  EXPECT_FALSE(is_path(TextKind::plain, "unit.json"));
  EXPECT_TRUE(is_path(TextKind::input_path_or_name, "unit.json"));
  EXPECT_TRUE(is_path(TextKind::input_path_or_name, "walk_imu.csv"));
  EXPECT_FALSE(is_path(TextKind::input_path_or_name, "vlp16"));
  EXPECT_FALSE(is_path(TextKind::input_path_or_name, "/imu/data"));
}

TEST(Option, AnUnknownNameIsAnsweredWithTheNearest) {
  OptionSet set(table());
  try {
    set.set_text("heigth", "1");
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.hint(), testing::HasSubstr("height"));
  }
}

TEST(Option, CopiesAreDeep) {
  OptionSet a(table());
  OptionSet b = a;
  b.set("height", 2.0);
  EXPECT_EQ(a.as<SliceOptions>().height, 1.30);
}

struct FitOptions {
  std::string model = "ray";
  bool offset = true;
  double offset_sd = 1;
  std::string path;
};

std::vector<OptionEntry<FitOptions>> fit_rows() {
  using S = FitOptions;
  return {
      Option<S, std::string>{"model", &S::model, TextKind::choice, {"auto", "ray", "surface"}, Tier::basic, "Model."},
      Option<S, bool>{"offset", &S::offset, Tier::basic, "Offset."},
      Option<S, double>{"offset_sd", &S::offset_sd, Unit::none, {0, 9}, Tier::basic, "Spread."},
      Option<S, std::string>{"path", &S::path, TextKind::input_path, {}, Tier::basic, "Path."},
      Unless{"model", {"surface"}, {"offset"}},
      OnlyIf{"offset", {"true"}, {"offset_sd"}},
      OnlyIf{"path", {""}, {"offset_sd"}},
  };
}

const OptionTable& fit_table() {
  static const OptionTable t = make_option_table<FitOptions>(fit_rows());
  return t;
}

TEST(Option, AConditionThatDoesNotHoldIsFoundAlsoBehindTheOptionThatItNames) {
  OptionSet set(fit_table());
  const auto unmet = [&](const char* name) {
    const auto* c = fit_table().unmet(fit_table().at(name), [&](const OptionSpec& o) { return set.get(o.name); });
    return c == nullptr ? std::string() : c->text();
  };
  EXPECT_EQ(unmet("model"), "");
  EXPECT_EQ(unmet("offset_sd"), "");
  set.set_text("path", "poses.tum");
  EXPECT_EQ(unmet("offset_sd"), "only if path is empty");
  set.set_text("model", "surface");
  EXPECT_EQ(unmet("offset_sd"), "only if model is not surface");
  set.set_text("model", "auto");
  set.set_text("offset", "false");
  EXPECT_EQ(unmet("offset"), "");
  EXPECT_EQ(unmet("offset_sd"), "only if offset is true");
}

TEST(Option, HelpTellsItsConditions) {
  EXPECT_EQ(fit_table().specs.size(), 4u);
  EXPECT_EQ(fit_table().at("offset_sd").full_help(), "Spread. Only if offset is true. Only if path is empty.");
  EXPECT_EQ((Condition{"shape", {"auto", "circle", "none"}}.text()), "only if shape is auto, circle or none");
  EXPECT_EQ((Condition{"path", {""}, false}.text()), "only if path is given");
}

TEST(Option, AConditionOnWhatTheTableHasNotIsRefused) {
  const auto with = [](OptionEntry<FitOptions> row) {
    auto rows = fit_rows();
    rows.push_back(std::move(row));
    return make_option_table<FitOptions>(std::move(rows));
  };
  EXPECT_THROW(with(OnlyIf{"modle", {"ray"}, {"offset"}}), Error);
  EXPECT_THROW(with(OnlyIf{"model", {"rays"}, {"offset"}}), Error);
  EXPECT_THROW(with(OnlyIf{"model", {"ray"}, {"ofset"}}), Error);
}

}  // namespace
}  // namespace bole
