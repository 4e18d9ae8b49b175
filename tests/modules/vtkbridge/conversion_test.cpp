#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"

namespace bole::vtkbridge {
namespace {

std::shared_ptr<PointCloud> sample_cloud() {
  auto cloud = std::make_shared<PointCloud>(PointCloud::Positions{{1, 2, 3}, {-4, 5.5F, 6}},
                                            Eigen::Vector3d(512345.678, 5601234.5, 101.25));
  cloud->axes = Axes::global;
  cloud->crs_wkt = "PROJCS[\"somewhere\"]";
  cloud->scale = {0.001, 0.001, 0.01};
  cloud->facts = {{"sensor", "VLP-32C"}, {"beam_divergence_mrad", "3"}};
  cloud->set_column("u8", std::vector<std::uint8_t>{1, 255});
  cloud->set_column("u16", std::vector<std::uint16_t>{2, 65535});
  cloud->set_column("i32", std::vector<std::int32_t>{-3, 2000000000});
  cloud->set_column("f32", std::vector<float>{0.1F, -7});
  cloud->set_column("f64", std::vector<double>{1e-300, 1700000000.123456});
  return cloud;
}

TEST(CloudConversion, RoundTripIsExact) {
  const auto cloud = sample_cloud();
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(cloud), poly);
  const auto back = cloud_from_vtk(poly);
  EXPECT_EQ(back->positions(), cloud->positions());
  EXPECT_EQ(back->origin, cloud->origin);
  EXPECT_EQ(back->scale, cloud->scale);
  EXPECT_EQ(back->axes, Axes::global);
  EXPECT_EQ(back->crs_wkt, cloud->crs_wkt);
  EXPECT_EQ(back->facts, cloud->facts);
  ASSERT_EQ(back->columns().size(), 5U);
  for (const auto& [name, column] : cloud->columns()) EXPECT_EQ(back->column(name), *column) << name;
}

TEST(CloudConversion, SharesTheMemoryAndKeepsItAlive) {
  auto cloud = std::shared_ptr<const PointCloud>(sample_cloud());
  const void* const positions = cloud->positions().data();
  const std::weak_ptr<const Column> column = cloud->columns().at("f32");
  vtkNew<vtkPolyData> poly;
  to_vtk(cloud, poly);
  EXPECT_EQ(poly->GetPoints()->GetVoidPointer(0), positions);
  cloud.reset();
  ASSERT_FALSE(column.expired());
  vtkSmartPointer<vtkDataArray> array = poly->GetPointData()->GetArray("f32");
  poly->Initialize();
  EXPECT_FALSE(column.expired());
  EXPECT_FLOAT_EQ(static_cast<float>(array->GetComponent(1, 0)), -7);
  array = nullptr;
  EXPECT_TRUE(column.expired());
}

TEST(CloudConversion, TwoVtkObjectsMayShowOneCloud) {
  auto cloud = std::shared_ptr<const PointCloud>(sample_cloud());
  const std::weak_ptr<const Column> column = cloud->columns().at("f64");
  vtkNew<vtkPolyData> first, second, shallow;
  to_vtk(cloud, first);
  to_vtk(cloud, second);
  shallow->ShallowCopy(first);
  cloud.reset();
  first->Initialize();
  second->Initialize();
  EXPECT_EQ(shallow->GetPointData()->GetArray("f64")->GetComponent(1, 0), 1700000000.123456);
  shallow->Initialize();
  EXPECT_TRUE(column.expired());
}

TEST(CloudConversion, EmptyCloud) {
  vtkNew<vtkPolyData> poly;
  to_vtk(std::make_shared<const PointCloud>(), poly);
  add_vertices(poly);
  EXPECT_EQ(poly->GetNumberOfPoints(), 0);
  EXPECT_TRUE(cloud_from_vtk(poly)->empty());
  vtkNew<vtkPolyData> bare;
  EXPECT_TRUE(cloud_from_vtk(bare)->empty());
}

TEST(CloudConversion, VerticesCoverAllPoints) {
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(sample_cloud()), poly);
  EXPECT_EQ(poly->GetNumberOfVerts(), 0);
  add_vertices(poly);
  EXPECT_EQ(poly->GetNumberOfVerts(), 1);
  EXPECT_EQ(poly->GetCell(0)->GetNumberOfPoints(), 2);
}

TEST(CloudConversion, ForeignPointsKeepMillimetresInUtm) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(512345.1234, 5601234.5678, 99.0);
  points->InsertNextPoint(512445.4321, 5601134.8765, 101.0);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("RGB");
  rgb->SetNumberOfComponents(3);
  rgb->InsertNextTuple3(255, 0, 1);
  rgb->InsertNextTuple3(0, 128, 2);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0, 0, 1);
  normals->InsertNextTuple3(1, 0, 0);
  vtkNew<vtkPolyData> poly;
  poly->SetPoints(points);
  poly->GetPointData()->AddArray(rgb);
  poly->GetPointData()->AddArray(normals);
  const auto cloud = cloud_from_vtk(poly);
  EXPECT_NEAR(cloud->position(0).x(), 512345.1234, 1e-5);
  EXPECT_NEAR(cloud->position(1).y(), 5601134.8765, 1e-5);
  EXPECT_EQ(cloud->values<std::uint16_t>(arrays::red), (std::vector<std::uint16_t>{65535, 0}));
  EXPECT_EQ(cloud->values<std::uint16_t>(arrays::green), (std::vector<std::uint16_t>{0, 128 * 257}));
  EXPECT_EQ(cloud->values<float>("Normals_2"), (std::vector<float>{1, 0}));
}

TEST(CloudConversion, AnArrayOfAnotherLengthIsNamed) {
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(sample_cloud()), poly);
  vtkNew<vtkFloatArray> wrong;
  wrong->SetName("too_short");
  wrong->InsertNextValue(1);
  poly->GetPointData()->AddArray(wrong);
  try {
    cloud_from_vtk(poly);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("too_short"), testing::HasSubstr("1 values"),
                                         testing::HasSubstr("2, one per point")));
  }
}

TEST(TableConversion, RoundTripIsExact) {
  auto table = std::make_shared<Table>();
  table->set("dbh_cm", std::vector<double>{20.5, std::nan("")});
  table->set("tree_id", std::vector<std::int64_t>{1, -9000000000000000000});
  table->set("quality", std::vector<std::string>{"good", ""});
  table->facts = {{"axes", "plot"}, {"note", "two trees"}};
  vtkNew<vtkTable> vtk_table;
  to_vtk(std::shared_ptr<const Table>(table), vtk_table);
  const auto back = table_from_vtk(vtk_table);
  EXPECT_EQ(back->facts, table->facts);
  ASSERT_EQ(back->columns().size(), 3U);
  EXPECT_EQ(back->columns()[0].name, "dbh_cm");
  EXPECT_EQ(back->numbers("dbh_cm")[0], 20.5);
  EXPECT_TRUE(std::isnan(back->numbers("dbh_cm")[1]));
  EXPECT_EQ(back->integers("tree_id"), table->integers("tree_id"));
  EXPECT_EQ(back->texts("quality"), table->texts("quality"));
}

TEST(RasterConversion, CellCentresAndRoundTrip) {
  auto raster = std::make_shared<Raster>();
  raster->nx = 2, raster->ny = 3, raster->cell_m = 0.5, raster->origin = {10, 20}, raster->axes = Axes::plot;
  raster->values = {1, 2, 3, 4, 5, std::nanf("")};
  vtkNew<vtkImageData> image;
  to_vtk(std::shared_ptr<const Raster>(raster), image);
  EXPECT_EQ(image->GetNumberOfPoints(), 6);
  double p[3];
  image->GetPoint(3, p);
  EXPECT_DOUBLE_EQ(p[0], 10.75);
  EXPECT_DOUBLE_EQ(p[1], 20.75);
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetComponent(3, 0), raster->at(1, 1));
  const auto back = raster_from_vtk(image);
  EXPECT_EQ(back->nx, 2);
  EXPECT_EQ(back->ny, 3);
  EXPECT_EQ(back->origin, raster->origin);
  EXPECT_EQ(back->cell_m, 0.5);
  EXPECT_EQ(back->axes, Axes::plot);
  EXPECT_EQ(back->quantity, "elevation_m");
  EXPECT_EQ(back->at(0, 2), 5);
  EXPECT_TRUE(std::isnan(back->at(1, 2)));
}

TEST(RasterConversion, EmptyAndUnusableImages) {
  vtkNew<vtkImageData> empty;
  to_vtk(std::make_shared<const Raster>(), empty);
  EXPECT_EQ(empty->GetNumberOfPoints(), 0);
  EXPECT_EQ(raster_from_vtk(empty)->values.size(), 0U);
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  EXPECT_THROW(raster_from_vtk(volume), Error);
  vtkNew<vtkImageData> oblong;
  oblong->SetDimensions(2, 2, 1);
  oblong->SetSpacing(1, 2, 1);
  EXPECT_THROW(raster_from_vtk(oblong), Error);
}

TEST(TrajectoryConversion, RoundTrip) {
  Trajectory path;
  path.axes = Axes::plot;
  path.facts = {{"poses", "given"}};
  for (int i = 0; i < 5; ++i) {
    StampedPose pose{100.0 + 0.1 * i, Pose::Identity()};
    pose.T_target_sensor.linear() = rotation_from_rpy(0.1 * i, -0.2, 0.7 * i);
    pose.T_target_sensor.translation() = Eigen::Vector3d(i, 2 * i, 1.5);
    path.poses.push_back(pose);
  }
  vtkNew<vtkPolyData> poly;
  to_vtk(path, poly);
  EXPECT_EQ(poly->GetNumberOfLines(), 1);
  const auto back = trajectory_from_vtk(poly);
  ASSERT_EQ(back->poses.size(), 5U);
  EXPECT_EQ(back->axes, Axes::plot);
  EXPECT_EQ(back->facts, path.facts);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(back->poses[i].time_s, path.poses[i].time_s);
    EXPECT_TRUE(back->poses[i].T_target_sensor.isApprox(path.poses[i].T_target_sensor, 1e-14));
  }
}

TEST(TrajectoryConversion, NamesTheMissingArray) {
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(sample_cloud()), poly);
  try {
    trajectory_from_vtk(poly);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("no array 'time'"));
  }
}

TEST(AttachedData, IsForgottenWhenTheVtkObjectChanges) {
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(sample_cloud()), poly);
  const auto data = std::make_shared<LazyData>(Data(std::shared_ptr<const PointCloud>(sample_cloud())));
  attach(poly, data);
  EXPECT_EQ(attached(poly), data);
  poly->GetBounds();
  EXPECT_EQ(attached(poly), data);
  poly->GetPointData()->GetArray("i32")->Modified();
  EXPECT_EQ(attached(poly), nullptr);

  vtkNew<vtkTable> table;
  auto core = std::make_shared<Table>();
  core->set("a", std::vector<double>{1, 2});
  to_vtk(std::shared_ptr<const Table>(core), table);
  attach(table, data);
  EXPECT_EQ(attached(table), data);
  vtkNew<vtkDoubleArray> more;
  more->SetName("b");
  more->SetNumberOfValues(2);
  table->AddColumn(more);
  EXPECT_EQ(attached(table), nullptr);
}

}  // namespace
}  // namespace bole::vtkbridge
