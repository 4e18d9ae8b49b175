// Points and solids at rest: drawn in steps over those that are kept, the same picture as all at once.
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <numeric>
#include <vector>

#include "render/beside/painted_points.h"
#include "render/beside/point_parts.h"
#include "render/beside/still_points_renderer.h"
#include "render/offscreen/offscreen.h"

namespace bole::render {
namespace {

constexpr int side_px = 120, points_of_part = 400;

// Some square of points before a camera.
vtkSmartPointer<vtkActor> part(float x, float z, const Color& color) {
  PointCloud::Positions places;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      places.emplace_back(x + 0.05F * static_cast<float>(i), 0.05F * static_cast<float>(j), z);
  std::vector<std::uint32_t> all(places.size());
  std::iota(all.begin(), all.end(), 0U);
  PointPaint paint;
  paint.color = color;
  return painted_points_actor(PointCloud(std::move(places)), all, paint, Eigen::Vector3d::Zero(), 3, 1);
}

class StillPoints : public testing::Test {
 protected:
  StillPoints() {
    use_backend(Backend::automatic);
    for (auto& p : {part(0, 0, hex(0xff0000)), part(0.5F, 0.5F, hex(0x00ff00)), part(0.2F, 1, hex(0x0000ff))}) {
      cloud_->add(p);
      parts_.push_back(p);
    }
    show(3);
    renderer_->AddViewProp(cloud_);
    renderer_->keep(true);
    window_ = vtkSmartPointer<vtkRenderWindow>::New();
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(side_px, side_px);
    window_->AddRenderer(renderer_);
    auto* camera = renderer_->GetActiveCamera();
    camera->SetFocalPoint(0.7, 0.5, 0);
    camera->SetPosition(0.7, 0.5, 4);
    camera->SetClippingRange(1, 10);
  }

  void show(std::size_t count) { cloud_->show({parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(count)}); }
  std::vector<unsigned char> frame() {
    window_->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    window_->GetPixelData(0, 0, side_px - 1, side_px - 1, 0, rgb);
    return {rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues()};
  }

  vtkNew<PointParts> cloud_;
  std::vector<vtkActor*> parts_;
  vtkNew<StillPointsRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;  // of the backend
};

TEST_F(StillPoints, StepsEndInThePictureOfAllAtOnce) {
  renderer_->draw_at_most(points_of_part);
  const auto first = frame();
  EXPECT_FALSE(renderer_->whole());
  const auto second = frame();
  EXPECT_FALSE(renderer_->whole());
  const auto third = frame();
  EXPECT_TRUE(renderer_->whole());
  EXPECT_NE(first, second);
  EXPECT_NE(second, third);
  EXPECT_EQ(renderer_->frames_drawn(), 3U);
  EXPECT_EQ(frame(), third);
  EXPECT_EQ(renderer_->frames_from_kept(), 1U);
  renderer_->keep(false);
  EXPECT_EQ(frame(), third);  // all at once
}

TEST_F(StillPoints, AStepIsNeverLessThanAPart) {
  renderer_->draw_at_most(1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(k > 0 && renderer_->whole());
    frame();
  }
  EXPECT_TRUE(renderer_->whole());
}

TEST_F(StillPoints, PartsThatComeAreAddedAndPartsThatGoAreNotSeen) {
  show(2);
  const auto two = frame();
  show(3);
  const auto three = frame();
  EXPECT_NE(two, three);
  EXPECT_EQ(renderer_->frames_drawn(), 2U);
  show(2);
  EXPECT_EQ(frame(), two);
  cloud_->remove(parts_[1]);  // drawn, and its place may be that of another part
  show(1);
  EXPECT_NE(frame(), two);
}

TEST_F(StillPoints, WhatChangesIsDrawnAnew) {
  const auto before = frame();
  for (auto* p : parts_) p->GetProperty()->SetPointSize(9);
  cloud_->Modified();
  EXPECT_NE(frame(), before);
  const auto drawn = renderer_->frames_drawn();
  frame();
  EXPECT_EQ(renderer_->frames_drawn(), drawn);
  renderer_->GetActiveCamera()->Azimuth(20);
  EXPECT_NE(frame(), before);
  EXPECT_EQ(renderer_->frames_drawn(), drawn + 1);
}

// Without points there is no picture to come back to, neither at first nor that of another eye.
TEST_F(StillPoints, NoPointsLeaveNoPicture) {
  show(0);
  const auto empty = frame();
  EXPECT_EQ(frame(), empty);
  show(3);
  EXPECT_NE(frame(), empty);
  show(0);
  renderer_->GetActiveCamera()->Azimuth(20);
  EXPECT_EQ(frame(), empty);
  EXPECT_EQ(frame(), empty);
  EXPECT_EQ(renderer_->frames_from_kept(), 0U);
  show(3);
  const auto all = frame();
  EXPECT_NE(all, empty);
  EXPECT_EQ(frame(), all);
}

vtkSmartPointer<vtkActor> ball(double x, double z, const Color& color) {
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, 0.5, z);
  source->SetRadius(0.3);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  return actor;
}

// Balls among the points: one behind all of them, one between.
class StillSolids : public StillPoints {
 protected:
  StillSolids() : behind_(ball(0.5, -0.5, hex(0xffff00))), between_(ball(1.2, 0.5, hex(0x00ffff))) {
    for (auto& actor : {behind_, between_}) renderer_->AddActor(actor);
  }
  // As it is drawn without anything that is kept.
  std::vector<unsigned char> drawn_anew() {
    renderer_->keep(false);
    auto picture = frame();
    renderer_->keep(true);
    return picture;
  }

  vtkSmartPointer<vtkActor> behind_, between_;
};

TEST_F(StillSolids, AreTakenAsTheyWereWithThePoints) {
  const auto anew = drawn_anew();
  EXPECT_EQ(frame(), anew);
  EXPECT_EQ(renderer_->solids_from_kept(), 0U);
  EXPECT_EQ(frame(), anew);
  EXPECT_EQ(renderer_->solids_from_kept(), 1U);
  EXPECT_EQ(renderer_->frames_from_kept(), 1U);
}

TEST_F(StillSolids, WhatIsDrawnAfreshComesAndGoesOverThem) {
  frame();
  const auto without = frame();
  const auto selected = ball(0.9, 0.7, hex(0xff00ff));
  renderer_->draw_afresh(selected);
  renderer_->AddActor(selected);
  const auto with = frame();
  EXPECT_EQ(renderer_->solids_from_kept(), 2U);
  EXPECT_NE(with, without);
  EXPECT_EQ(with, drawn_anew());
  frame();
  const auto taken = renderer_->solids_from_kept();
  selected->GetProperty()->SetColor(1, 1, 1);
  EXPECT_NE(frame(), with);
  renderer_->RemoveActor(selected);
  EXPECT_EQ(frame(), without);
  EXPECT_EQ(renderer_->solids_from_kept(), taken + 2);
}

// The points are as they were: their picture is taken.
TEST_F(StillSolids, ThatChangeAreDrawnAnewOverThePoints) {
  frame();
  const auto before = frame();
  const auto points_drawn = renderer_->frames_drawn(), taken = renderer_->solids_from_kept();
  between_->GetProperty()->SetColor(1, 0, 0);
  const auto red = frame();
  EXPECT_NE(red, before);
  between_->VisibilityOff();
  const auto gone = frame();
  EXPECT_NE(gone, red);
  EXPECT_EQ(frame(), gone);
  between_->VisibilityOn();
  EXPECT_EQ(frame(), red);  // one that comes is drawn over those that are kept
  EXPECT_EQ(renderer_->solids_from_kept(), taken + 2);
  EXPECT_EQ(frame(), red);
  EXPECT_EQ(renderer_->solids_from_kept(), taken + 3);
  EXPECT_EQ(renderer_->frames_drawn(), points_drawn);
  EXPECT_EQ(red, drawn_anew());
}

TEST_F(StillSolids, PointsThatComeLieBeforeAndBehindThem) {
  show(1);
  frame();
  frame();
  show(3);
  const auto all = frame();
  EXPECT_EQ(frame(), all);
  EXPECT_EQ(all, drawn_anew());
}

}  // namespace
}  // namespace bole::render
