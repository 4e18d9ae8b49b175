// What measure_stems() takes from the sensor of a cloud: its beam, its noise, and what goes with the tables.
#include <gmock/gmock.h>

#include "measured.h"
#include "stems/core/measure_stems.h"
#include "stems/core/sensor_facts.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

using synthetic::make_stem_cloud;
using synthetic::random_stand;
using synthetic::StemCloud;
using synthetic::StemCloudOptions;

// The beam decides where the ray model sees the bark: the same cloud with and without facts of a thin beam.
TEST(MeasureStems, TheBeamComesFromTheCloudUnlessAnOptionSaysIt) {
  auto cloud = make_stem_cloud(random_stand(4, 0.15, 0.30, 5), coarse());
  MeasureOptions thin;
  thin.beam_divergence_mrad = 0.5;
  thin.beam_aperture = 0.005;
  const auto assumed = measure(cloud), by_option = measure(cloud, thin);
  cloud.points.facts = {
      {"sensor", "Dome-64"}, {"beam_divergence_mrad", "0.5"}, {"beam_aperture_m", "0.005"}, {"range_noise_m", "0.005"}};
  const auto by_fact = measure(cloud);
  cloud.points.facts["beam_divergence_mrad"] = "3";
  const auto over = measure(cloud, thin);
  const auto diameters = [](const StemSurvey& survey) { return stem_table(survey).numbers("dbh_cm"); };
  EXPECT_EQ(diameters(by_fact), diameters(by_option));
  EXPECT_EQ(diameters(over), diameters(by_option));
  EXPECT_NE(diameters(assumed), diameters(by_option));

  EXPECT_EQ(by_fact.report.facts.at("beam_divergence"), "0.5 mrad (Dome-64)");
  EXPECT_EQ(by_fact.report.facts.at("range_noise"), "5 mm (Dome-64)");
  EXPECT_EQ(over.report.facts.at("beam_divergence"), "0.5 mrad (option)");
  EXPECT_EQ(assumed.report.facts.at("beam_divergence"), "3 mrad (assumed)");
  const auto warned = testing::Contains(testing::HasSubstr("3 mrad and 9.5 mm at the sensor are taken"));
  EXPECT_THAT(assumed.report.warnings, warned);
  EXPECT_THAT(by_fact.report.warnings, testing::Not(warned));
  EXPECT_THAT(by_option.report.warnings, testing::Not(warned));
}

TEST(MeasureStems, TheBeamOfTheVlp32cIsTheOneAssumed) {
  auto cloud = make_stem_cloud(random_stand(4, 0.15, 0.30, 5), coarse());
  const auto assumed = stem_table(measure(cloud));
  cloud.points.facts = {{"beam_divergence_mrad", "3"}, {"beam_aperture_m", "0.0095"}, {"range_noise_m", "0.012"}};
  const auto known = stem_table(measure(cloud));
  for (const auto* name : {"x_m", "y_m"})
    for (std::size_t i = 0; i < known.rows(); ++i)
      EXPECT_NEAR(known.numbers(name)[i], assumed.numbers(name)[i], 0.001) << name;
  const auto width = [](const Table& t, std::size_t i) {
    return t.numbers("dbh_hi_cm")[i] - t.numbers("dbh_lo_cm")[i];
  };
  ASSERT_EQ(known.rows(), assumed.rows());
  for (std::size_t i = 0; i < known.rows(); ++i) {
    EXPECT_NEAR(known.numbers("dbh_cm")[i], assumed.numbers("dbh_cm")[i], 0.1) << i;
    EXPECT_GT(width(assumed, i), width(known, i)) << "what is assumed is not known";
  }
}

// The maker of a Mid-360 states no beam: that of a similar sensor is nearer than that of a VLP-32C, and doubted.
TEST(MeasureStems, TheBeamOfASimilarSensorIsTakenWithItsDoubt) {
  const Facts facts{{"sensor", "Livox Mid-360"}, {"beam_divergence_mrad", "0.52"}, {"beam_divergence_sd_mrad", "1"},
                    {"beam_aperture_m", "0.01"}, {"range_noise_m", "0.02"},        {"lasers", "4"}};
  Report report;
  const auto options = with_sensor({}, facts, true, report);
  EXPECT_EQ(options.beam_divergence_mrad, 0.52);
  EXPECT_EQ(options.beam_divergence_sd_mrad, 1);
  EXPECT_EQ(options.range_offset_sd, usual_range_offset_sd(4));
  EXPECT_THAT(report.warnings, testing::ElementsAre(testing::HasSubstr("0.52 mrad of a similar sensor are taken")));
  EXPECT_EQ(report.facts.at("beam_divergence_sd"), "1 mrad (Livox Mid-360)");

  MeasureOptions told;
  told.beam_divergence_mrad = 0.6;
  told.range_offset_sd = 0.0004;
  Report quiet;
  const auto as_told = with_sensor(told, facts, true, quiet);
  EXPECT_EQ(as_told.beam_divergence_sd_mrad, 0) << "an option is taken at its word";
  EXPECT_EQ(as_told.range_offset_sd, 0.0004);
  EXPECT_THAT(quiet.warnings, testing::IsEmpty());

  Report stated;
  EXPECT_EQ(with_sensor({}, {{"beam_divergence_mrad", "3"}, {"beam_aperture_m", "0.01"}}, true, stated)
                .beam_divergence_sd_mrad,
            0);
  Report nothing;
  EXPECT_EQ(with_sensor({}, {}, true, nothing).beam_divergence_sd_mrad, assumed_beam_divergence_sd_mrad);
}

TEST(MeasureStems, ANoisySensorRaisesTheCapOfTheResiduals) {
  Report report;
  EXPECT_EQ(with_sensor({}, {}, true, report).max_sigma, 0.025);
  EXPECT_EQ(with_sensor({}, {{"range_noise_m", "0.02"}}, true, report).max_sigma, 0.025);
  EXPECT_DOUBLE_EQ(with_sensor({}, {{"range_noise_m", "0.03"}}, true, report).max_sigma, 0.0375);
}

TEST(MeasureStems, WhatTheCloudSaysGoesWithTheTables) {
  auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 8), coarse());
  cloud.points.facts = {{"sensor", "VLP-32C"}, {"poses", "given"}};
  const auto survey = measure(cloud);
  for (const auto& table : {stem_table(survey), section_table(survey), rejected_table(survey)}) {
    EXPECT_EQ(table.facts.at("sensor"), "VLP-32C");
    EXPECT_EQ(pose_origin(table.facts), PoseOrigin::given);
  }
  EXPECT_EQ(survey.points.facts, cloud.points.facts);
}

// The same stand somewhere else: everything moves, in the float32 offsets of the cloud.
StemCloud moved(const StemCloud& cloud, const Eigen::Vector3f& by) {
  StemCloud out = cloud;
  auto positions = cloud.points.positions();
  for (auto& p : positions) p += by;
  out.points.set_positions(std::move(positions));
  const auto add = [&](const ArrayInfo& info, float d) {
    auto values = cloud.points.values<float>(info);
    for (auto& v : values) v += d;
    out.points.set_column(info, std::move(values));
  };
  add(arrays::sensor_x, by.x()), add(arrays::sensor_y, by.y()), add(arrays::sensor_z, by.z());
  out.dem.origin += by.head<2>().cast<double>();
  for (auto& z : out.dem.values) z += by.z();
  return out;
}

}  // namespace
}  // namespace bole::stems
