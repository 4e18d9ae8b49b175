#include "io/core/clouds/see_cloud.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "base/angles.h"
#include "cloud/known_facts.h"
#include "io/core/las/las_reader.h"
#include "io/core/las/las_writer.h"
#include "io_test_tools.h"
#include "synthetic/stand_cloud.h"

namespace bole::io {
namespace {

using synthetic::mapped;
using synthetic::stand_cloud;
using synthetic::StandOptions;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_io::shared;

SeenCloud look(PointCloud cloud, const SeeCloudOptions& options = {}) {
  return look_at_cloud({std::move(cloud), {}}, options);
}

std::vector<std::string> codes(const SeenCloud& seen) {
  std::vector<std::string> out;
  for (const auto& f : seen.reading.report.findings) out.push_back(f.code);
  return out;
}

// x, y, z -> x, z, -y: y up.
Eigen::Matrix3d y_up() {
  Eigen::Matrix3d matrix;
  matrix << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return matrix;
}

TEST(SeeCloud, ASoundCloudIsLeftAsItIs) {
  const auto cloud = stand_cloud();
  const auto seen = look(cloud);
  EXPECT_THAT(codes(seen), IsEmpty());
  EXPECT_EQ(seen.reading.cloud.positions(), cloud.positions());
  EXPECT_EQ(seen.reading.report.facts.at("kind"), "plot");
}

TEST(SeeCloud, ACloudThatWasSavedAfterATurnIsNotTurned) {
  auto cloud = stand_cloud();
  cloud.facts["turned"] = "unit_found";
  EXPECT_FALSE(look(cloud).reading.cloud.facts.contains("turned"));
  EXPECT_TRUE(look(mapped(cloud, y_up())).reading.cloud.facts.contains("turned"));
  const auto path = std::filesystem::temp_directory_path() / "bole_turned.las";
  write_las(path, cloud);
  EXPECT_FALSE(read_las(path).facts.contains("turned"));
  std::filesystem::remove(path);
}

TEST(SeeCloud, YUpIsTurnedAndTold) {
  const auto cloud = stand_cloud();
  const auto seen = look(mapped(cloud, y_up()));
  EXPECT_THAT(codes(seen), testing::ElementsAre("up_axis_found"));
  for (std::size_t i = 0; i < cloud.size(); i += 997)
    EXPECT_LT((seen.reading.cloud.position(i) - cloud.position(i)).norm(), 1e-4);
}

TEST(SeeCloud, AnAxisThatIsSetIsKeptAndDoubted) {
  SeeCloudOptions options;
  options.up = UpAxis::z;
  const auto cloud = mapped(stand_cloud(), y_up());
  const auto seen = look(cloud, options);
  EXPECT_THAT(codes(seen), testing::Contains("up_axis_suspect"));
  EXPECT_EQ(seen.reading.cloud.positions(), cloud.positions());
}

TEST(SeeCloud, MillimetresBecomeMetres) {
  const auto cloud = stand_cloud();
  const auto seen = look(mapped(cloud, 1000 * Eigen::Matrix3d::Identity()));
  EXPECT_THAT(codes(seen), testing::ElementsAre("unit_found"));
  EXPECT_THAT(seen.reading.report.findings.at(0).text, HasSubstr("unit=millimetre"));
  EXPECT_LT((seen.reading.cloud.position(7) - cloud.position(7)).norm(), 1e-3);
}

TEST(SeeCloud, FeetAreDoubtedUnlessTheUnitIsSet) {
  StandOptions o;
  o.height = 20;
  const auto feet = mapped(stand_cloud(o), Eigen::Matrix3d::Identity() / 0.3048);
  EXPECT_THAT(codes(look(feet)), testing::Contains("unit_suspect"));
  SeeCloudOptions options;
  options.unit = LengthUnit::metre;
  EXPECT_THAT(codes(look(feet, options)), testing::Not(testing::Contains("unit_suspect")));
}

// Heights in centimetres over a plan in metres are no feet.
TEST(SeeCloud, CentimetresOfHeightAreNotTakenForFeet) {
  const auto seen = look(mapped(stand_cloud(), Eigen::Vector3d(1, 1, 100).asDiagonal()));
  const auto& findings = seen.reading.report.findings;
  const auto unit = std::ranges::find(findings, "unit_suspect", &Finding::code);
  ASSERT_NE(unit, findings.end());
  EXPECT_THAT(unit->text, HasSubstr("z looks like centimetres"));
  EXPECT_THAT(unit->text, testing::Not(HasSubstr("unit=foot")));
}

TEST(SeeCloud, ACrsInFeetGivesMetres) {
  auto cloud = mapped(stand_cloud(), Eigen::Matrix3d::Identity() / 0.3048);
  cloud.axes = Axes::global;
  cloud.crs_wkt =
      "PROJCS[\"feet\",GEOGCS[\"NAD83\",DATUM[\"North_American_Datum_1983\",SPHEROID[\"GRS "
      "1980\",6378137,298.257222101]],"
      "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
      "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",-90],PARAMETER[\"scale_factor\",1],"
      "PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],UNIT[\"foot\",0.3048]]";
  const auto seen = look(cloud);
  EXPECT_THAT(codes(seen), testing::Contains("unit_found"));
  EXPECT_TRUE(seen.reading.cloud.crs_wkt.empty());
  EXPECT_NEAR(seen.sight.stem_diameter_m, 0.25, 0.02);
}

TEST(SeeCloud, ATiltedCloudIsToldAndMadeLevelOnRequest) {
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(radians(5), Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto tilted = mapped(stand_cloud(), tilt);
  EXPECT_THAT(codes(look(tilted)), testing::ElementsAre("cloud_tilted"));
  SeeCloudOptions options;
  options.level = LevelCloud::stems;
  const auto level = look(tilted, options);
  EXPECT_THAT(codes(level), testing::ElementsAre("levelled"));
  EXPECT_LT(level.sight.lean_deg, 0.1);
}

TEST(SeeCloud, LevellingWithoutStemsIsRefusedInWords) {
  StandOptions o;
  o.stems = 4;
  o.height = 0.5;
  SeeCloudOptions options;
  options.level = LevelCloud::stems;
  EXPECT_THAT(codes(look(stand_cloud(o), options)), testing::Contains("not_levelled"));
}

TEST(SeeCloud, ASparseCloudIsTooSparseForDiameters) {
  StandOptions o;
  o.points_per_metre = 15;
  const auto seen = look(stand_cloud(o));
  ASSERT_THAT(codes(seen), testing::ElementsAre("too_sparse_for_diameters"));
  EXPECT_THAT(seen.reading.report.findings.at(0).text, HasSubstr("40 points per stem are needed"));
}

TEST(SeeCloud, ASingleTreeSaysSo) {
  StandOptions o;
  o.stems = 1;
  o.ground_points_per_m2 = 0;
  const auto seen = look(stand_cloud(o));
  EXPECT_THAT(codes(seen), testing::ElementsAre("single_tree"));
  EXPECT_EQ(fact_text(seen.reading.cloud.facts, facts::kind), "single_tree");
}

// What is up, and what kind the clouds are, by their pages.
TEST(SeeCloud, RealCloudsAreNotMisjudged) {
  struct Case {
    const char* file;
    CloudKind kind;
    bool turned;
  };
  for (const auto& c : {Case{"tls_pine_plot/pine_plot.laz", CloudKind::plot, false},
                        Case{"tls_pine_plot/pine.laz", CloudKind::plot, false},
                        Case{"tls_spanner/TLS_Clip.laz", CloudKind::plot, false},
                        Case{"tls_simulated_boles/model_boles.laz", CloudKind::plot, false},
                        Case{"tls_plantation_4trees/tls_plantation_class.csv", CloudKind::plot, false},
                        Case{"iphone_forest/trees_on_hill.laz", CloudKind::plot, true},
                        Case{"tree_adtree/tree7.xyz", CloudKind::single_tree, false},
                        Case{"tree_adtree/tree13.xyz", CloudKind::single_tree, false},
                        Case{"tree_archi_voxr/Tree_1_point_cloud.las", CloudKind::single_tree, false},
                        Case{"tree_archi_voxr/Tree_2_point_cloud.las", CloudKind::single_tree, false},
                        Case{"tree_archi_voxr/Tree_t0.asc", CloudKind::single_tree, false},
                        Case{"tree_itsme_formats/pc_tree.las", CloudKind::single_tree, false},
                        Case{"tree_treetraits/tree_0744.laz", CloudKind::single_tree, false},
                        Case{"als_ground/MixedConifer.laz", CloudKind::airborne, false},
                        Case{"als_ground/Topography.laz", CloudKind::airborne, false},
                        Case{"als_ground/AHN3.laz", CloudKind::airborne, false},
                        Case{"isprs_filter/samp31_ref.las", CloudKind::airborne, false},
                        Case{"isprs_filter/samp51_ref.las", CloudKind::airborne, false}}) {
    SCOPED_TRACE(c.file);
    BOLE_NEEDS_SHARED(c.file);
    const auto seen = see_cloud(shared(c.file));
    EXPECT_EQ(seen.sight.kind, c.kind) << choice_name(seen.sight.kind);
    EXPECT_EQ(std::ranges::count(codes(seen), "up_axis_found"), c.turned ? 1 : 0);
    EXPECT_EQ(std::ranges::count(codes(seen), "unit_found"), 0);
    EXPECT_EQ(std::ranges::count(codes(seen), "unit_suspect"), 0);
    EXPECT_EQ(std::ranges::count(codes(seen), "cloud_tilted"), 0);
  }
}

}  // namespace
}  // namespace bole::io
