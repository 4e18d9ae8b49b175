#include "report/workbook.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "base/error.h"
#include "inventory/core/value_tables.h"
#include "modules/render/small_survey.h"

namespace bole::report {
namespace {

using testing::ElementsAre;

// The workbook as another program reads it.
class Workbooks : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    if (GetGDALDriverManager()->GetDriverByName("XLSX") == nullptr) GTEST_SKIP() << "GDAL reads no XLSX here";
    data_.stems = &survey_.stems, data_.sections = &survey_.sections, data_.rejected = &survey_.rejected;
    data_.rule = {rectangle_area({0, 0}, 32, 32), 7.5};
    const auto values = inventory::plot_values(survey_.stems, data_.rule);
    plot_values_ = inventory::plot_value_table(values, {});
    classes_ = inventory::class_table(values);
    curve_ = inventory::height_curve_table(values);
    data_.plot_values = &plot_values_;
    data_.diameter_classes = &classes_;
    data_.height_curve = &curve_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

  GDALDataset* written(const bole::Run& run = {}) {
    write_workbook(path_, data_, run);
    book_.reset(static_cast<GDALDataset*>(GDALOpenEx(path_.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr)));
    return book_.get();
  }
  static std::vector<std::string> sheets(GDALDataset& book) {
    std::vector<std::string> names;
    for (auto* layer : book.GetLayers()) names.emplace_back(layer->GetName());
    return names;
  }

  testing_data::SmallSurvey survey_ = testing_data::make_small_survey();
  SurveyData data_;
  Table plot_values_, classes_, curve_;
  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".xlsx");
  std::unique_ptr<GDALDataset> book_;
};

TEST_F(Workbooks, HoldTheSurveyAsNumbers) {
  auto dbh = survey_.stems.numbers("dbh_cm");
  dbh[1] = std::nan("");
  survey_.stems.set("dbh_cm", dbh);
  auto* book = written();
  ASSERT_NE(book, nullptr);
  EXPECT_THAT(sheets(*book),
              ElementsAre("Plot", "Plot values", "Classes", "Height curve", "Trees", "Sections", "Rejected"));
  auto* trees = book->GetLayerByName("Trees");
  ASSERT_EQ(trees->GetFeatureCount(), static_cast<GIntBig>(survey_.stems.rows()));
  trees->ResetReading();
  for (std::size_t i = 0; i < dbh.size(); ++i) {
    const std::unique_ptr<OGRFeature> row(trees->GetNextFeature());
    const int column = row->GetFieldIndex("dbh_cm");
    ASSERT_GE(column, 0);
    EXPECT_EQ(row->IsFieldSetAndNotNull(column), i != 1);
    if (i == 1) continue;
    EXPECT_NEAR(row->GetFieldAsDouble(column), dbh[i], 1e-12);  // not rounded: the format does that
  }
}

TEST_F(Workbooks, PlotValuesAreThoseOfTheStage) {
  auto* book = written();
  ASSERT_NE(book, nullptr);
  auto* sheet = book->GetLayerByName("Plot values");
  ASSERT_NE(sheet, nullptr);
  ASSERT_EQ(sheet->GetFeatureCount(), static_cast<GIntBig>(plot_values_.rows()));
  const auto value = plot_values_.numbers("value");
  sheet->ResetReading();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::unique_ptr<OGRFeature> row(sheet->GetNextFeature());
    EXPECT_EQ(row->GetFieldAsString("measure"), plot_values_.texts("measure")[i]);
    if (std::isfinite(value[i])) {
      EXPECT_NEAR(row->GetFieldAsDouble("value"), value[i], 1e-12);
    }
  }
}

TEST_F(Workbooks, WithoutPlotValuesThereAreNoSheetsOfThem) {
  data_.plot_values = data_.diameter_classes = data_.height_curve = nullptr;
  auto* book = written();
  ASSERT_NE(book, nullptr);
  EXPECT_THAT(sheets(*book), ElementsAre("Trees", "Sections", "Rejected"));
}

TEST_F(Workbooks, OptionsOfTheStagesBeforeAreThere) {
  RunRecord record;
  StageRecord stage;
  stage.id = "slice", stage.type = "stems.slice", stage.options = {{"height", "1.3", "m", true}};
  record.stages.push_back(stage);
  bole::Run run;
  run.record = std::make_shared<const RunRecord>(record);
  auto* book = written(run);
  ASSERT_NE(book, nullptr);
  auto* options = book->GetLayerByName("Options");
  ASSERT_NE(options, nullptr);
  const std::unique_ptr<OGRFeature> row(options->GetNextFeature());
  EXPECT_STREQ(row->GetFieldAsString("Option"), "height");
  EXPECT_EQ(row->GetFieldAsDouble("Value"), 1.3);
}

TEST_F(Workbooks, AFolderThatCannotBeIsTold) {
  EXPECT_THROW(write_workbook("/proc/no/such.xlsx", data_, bole::Run()), Error);
}

}  // namespace
}  // namespace bole::report
