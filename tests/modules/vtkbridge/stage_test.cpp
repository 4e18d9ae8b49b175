#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPassThrough.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <chrono>
#include <thread>

#include "toy_stages.h"
#include "vtkBoleStage.h"
#include "vtkbridge/core_conversion.h"

namespace bole::vtkbridge {
namespace {

using testing::HasSubstr;

class Stage : public testing::Test {
 protected:
  void SetUp() override { toy::register_toys(); }

  vtkSmartPointer<vtkBoleStage> make(const char* type) {
    auto stage = vtkSmartPointer<vtkBoleStage>::New();
    EXPECT_TRUE(stage->SetStageType(type));
    quiet(stage);
    return stage;
  }
  // Keeps errors off the terminal.
  void quiet(vtkBoleStage* stage) {
    stage->AddObserver(vtkCommand::ErrorEvent, silence_);
    stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence_);
  }
  vtkNew<vtkCallbackCommand> silence_;
};

TEST_F(Stage, RunsAndConverts) {
  const auto points = make("toy.points");
  const auto lift = make("toy.lift");
  const auto count = make("toy.count");
  ASSERT_TRUE(lift->ConnectInput("points", points, "points"));
  ASSERT_TRUE(count->ConnectInput("points", lift, "points"));
  ASSERT_TRUE(lift->SetOption("by", 0.5));
  count->Update();
  ASSERT_EQ(count->GetExitCode(), 0) << count->GetErrorText();
  auto* table = vtkTable::SafeDownCast(count->GetOutputDataObject(0));
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->GetValueByName(0, "value").ToDouble(), 100);
  EXPECT_NEAR(table->GetValueByName(0, "mean_height").ToDouble(), 2.5, 1e-5);
  auto* poly = vtkPolyData::SafeDownCast(lift->GetOutputDataObject(0));
  EXPECT_EQ(poly->GetNumberOfPoints(), 100);
  EXPECT_EQ(poly->GetNumberOfVerts(), 1);
  EXPECT_THAT(lift->GetReportJSON(), HasSubstr("\"lift\""));
}

// What ParaView puts between two stages.
vtkSmartPointer<vtkPolyData> shallow_copy(vtkDataObject* object) {
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(object);
  return copy;
}

TEST_F(Stage, CoreDataAreFoundThroughShallowCopies) {
  const auto points = make("toy.points");
  points->Update();
  const auto original = attached(points->GetOutputDataObject(0));
  ASSERT_NE(original, nullptr);
  const auto copy = shallow_copy(shallow_copy(points->GetOutputDataObject(0)));
  EXPECT_EQ(attached(copy), original);

  // Anything else than a copy has to be read from its arrays.
  const auto with_array = shallow_copy(copy);
  vtkNew<vtkFloatArray> further;
  further->SetName("further");
  further->SetNumberOfValues(100);
  with_array->GetPointData()->AddArray(further);
  EXPECT_EQ(attached(with_array), nullptr);
  vtkNew<vtkPolyData> deep;
  deep->DeepCopy(copy);
  EXPECT_EQ(attached(deep), nullptr);
  copy->GetPointData()->GetArray("range")->Modified();
  EXPECT_EQ(attached(copy), nullptr);
  EXPECT_EQ(attached(vtkSmartPointer<vtkPolyData>::New()), nullptr);
}

void ask_for_piece(vtkBoleStage* stage, int piece, int pieces) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  stage->UpdateInformation();
  stage->GetOutputInformation(0)->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  stage->GetOutputInformation(0)->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  vtkStreamingDemandDrivenPipeline::SafeDownCast(stage->GetExecutive())->Update(0);
}

vtkIdType points_of(vtkBoleStage* stage) {
  return vtkPolyData::SafeDownCast(stage->GetOutputDataObject(0))->GetNumberOfPoints();
}

TEST_F(Stage, GivesEverythingOnTheFirstPieceAndNothingOnOthers) {
  const auto points = make("toy.points");
  const auto lift = make("toy.lift");
  ASSERT_TRUE(lift->ConnectInput("points", points, "points"));
  EXPECT_EQ(points->GetOutputInformation(0)->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()), 0);
  ask_for_piece(lift, 1, 2);
  EXPECT_EQ(points_of(lift), 0);
  EXPECT_EQ(lift->GetExecutionCount(), 0);
  ask_for_piece(lift, 0, 2);
  EXPECT_EQ(points_of(lift), 100);
  EXPECT_EQ(points_of(points), 100);  // asked for all of it
  EXPECT_EQ(points->GetOutputInformation(0)->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()), 1);
}

TEST_F(Stage, OfAReaderThatGivesPiecesAViewGetsPiecesAndAStageTheWhole) {
  const auto points = make("toy.pieces");
  const auto lift = make("toy.lift");
  ASSERT_TRUE(lift->ConnectInput("points", points, "points"));
  ask_for_piece(points, 1, 3);
  EXPECT_EQ(points_of(points), 10);
  ask_for_piece(points, 0, 3);
  EXPECT_EQ(points_of(points), 10);
  ask_for_piece(lift, 0, 3);
  EXPECT_EQ(points_of(lift), 100);
  const int runs = toy::runs()["toy.pieces"];
  ask_for_piece(points, 0, 3);  // both are kept: the view and the stage ask in turns
  EXPECT_EQ(points_of(points), 10);
  ask_for_piece(lift, 0, 3);
  EXPECT_EQ(points_of(lift), 100);
  EXPECT_EQ(toy::runs()["toy.pieces"], runs);
  points->SetOption("count", 50);
  ask_for_piece(lift, 0, 3);
  EXPECT_EQ(points_of(lift), 50);
}

TEST_F(Stage, FiltersBehindHearOfTheExtentOfAnImageOnceItIsKnown) {
  const auto frames = make("toy.frames");
  const auto grid = make("toy.use_frames");
  ASSERT_TRUE(grid->ConnectInput("frames", frames, "frames"));
  vtkNew<vtkPassThrough> behind;  // knows of the image before it is made, and is updated together with it
  behind->SetInputConnection(grid->GetOutputPort(1));
  behind->Update();
  behind->Update();
  int extent[6]{0, -1, 0, -1, 0, -1};
  behind->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  EXPECT_GE(extent[1], extent[0]);
  EXPECT_EQ(grid->GetExecutionCount(), 1);
}

TEST_F(Stage, OptionsChangeTheTimeOnlyWhenTheyChange) {
  const auto points = make("toy.points");
  points->SetOption("count", 7);
  const auto before = points->GetMTime();
  EXPECT_TRUE(points->SetOption("count", "7"));
  EXPECT_TRUE(points->SetOption("count", 7.0));
  EXPECT_EQ(points->GetMTime(), before);
  EXPECT_TRUE(points->SetOption("count", 8));
  EXPECT_GT(points->GetMTime(), before);
  EXPECT_EQ(points->GetOption("count"), "8");
  EXPECT_FALSE(points->IsOptionDefault("count"));
  points->ResetOption("count");
  EXPECT_EQ(points->GetOption("count"), "100");
  EXPECT_EQ(points->GetNumberOfOptions(), 3);
  EXPECT_EQ(points->GetOptionName(1), "spacing");
  EXPECT_EQ(points->GetOptionUnit("spacing"), "m");
}

TEST_F(Stage, RefusedOptionsSayWhatIsNeeded) {
  const auto points = make("toy.points");
  EXPECT_FALSE(points->SetOption("spacing", "wide"));
  EXPECT_THAT(points->GetErrorText(), testing::AllOf(HasSubstr("spacing"), HasSubstr("wide"), HasSubstr("0.001")));
  EXPECT_FALSE(points->SetOption("spacing", -1.0));
  EXPECT_FALSE(points->SetOption("spacin", 1.0));
  EXPECT_THAT(points->GetErrorText(), HasSubstr("spacing"));  // did you mean
  EXPECT_FALSE(points->SetOption(nullptr, "1"));
  EXPECT_EQ(points->GetOption("spacing"), "0.5");
  points->Update();
  EXPECT_EQ(points->GetExitCode(), 0);
  EXPECT_EQ(points->GetErrorText(), "");
}

TEST_F(Stage, OnlyWhatIsDownstreamOfAChangeRunsAgain) {
  const auto points = make("toy.points");
  const auto lift = make("toy.lift");
  const auto count = make("toy.count");
  lift->ConnectInput("points", points, "points");
  count->ConnectInput("points", lift, "points");
  count->Update();
  count->Update();
  EXPECT_EQ(toy::runs()["toy.points"], 1);
  EXPECT_EQ(toy::runs()["toy.lift"], 1);
  EXPECT_EQ(toy::runs()["toy.count"], 1);
  lift->SetOption("by", 3.0);
  count->Update();
  EXPECT_EQ(toy::runs()["toy.points"], 1);
  EXPECT_EQ(toy::runs()["toy.lift"], 2);
  EXPECT_EQ(toy::runs()["toy.count"], 2);
}

TEST_F(Stage, TakesDataOfForeignFilters) {
  auto cloud = std::make_shared<PointCloud>(PointCloud::Positions{{0, 0, 1}, {0, 0, 3}});
  vtkNew<vtkPolyData> poly;
  to_vtk(std::shared_ptr<const PointCloud>(cloud), poly);
  const auto lift = make("toy.lift");
  lift->SetInputDataObject(0, poly);
  lift->Update();
  auto* out = vtkPolyData::SafeDownCast(lift->GetOutputDataObject(0));
  ASSERT_EQ(out->GetNumberOfPoints(), 2);
  EXPECT_EQ(out->GetPointData()->GetArray("height_above_ground")->GetComponent(1, 0), 4);
}

TEST_F(Stage, AnEmptyInputIsTheStagesOwnAffair) {
  vtkNew<vtkPolyData> poly;
  const auto lift = make("toy.lift");
  lift->SetInputDataObject(0, poly);
  lift->Update();
  EXPECT_EQ(lift->GetExitCode(), 0) << lift->GetErrorText();
  EXPECT_EQ(vtkPolyData::SafeDownCast(lift->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

TEST_F(Stage, AMissingArrayIsNamedAndOutputsAreEmpty) {
  const auto points = make("toy.points");
  const auto count = make("toy.count");
  count->ConnectInput("points", points, "points");
  count->Update();
  EXPECT_EQ(count->GetExitCode(), 2);
  EXPECT_NE(count->GetErrorCode(), 0U);
  EXPECT_THAT(count->GetErrorText(),
              testing::AllOf(HasSubstr("toy.count"), HasSubstr("height_above_ground"), HasSubstr("range")));
  EXPECT_EQ(vtkTable::SafeDownCast(count->GetOutputDataObject(0))->GetNumberOfRows(), 0);
  EXPECT_EQ(toy::runs()["toy.count"], 0);
}

TEST_F(Stage, AnErrorReachesObserversAndGoesAwayWhenMended) {
  const auto points = make("toy.points");
  const auto lift = make("toy.lift");
  std::string heard;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&heard);
  listen->SetCallback([](vtkObject*, unsigned long, void* client, void* text) {
    *static_cast<std::string*>(client) = static_cast<const char*>(text);
  });
  lift->AddObserver(vtkCommand::ErrorEvent, listen);
  lift->ConnectInput("points", points, "points");
  lift->SetOption("fail", "true");
  lift->Update();
  EXPECT_THAT(heard, testing::AllOf(HasSubstr("the toy is broken"), HasSubstr("Set fail to false")));
  EXPECT_EQ(lift->GetExitCode(), 2);
  lift->SetOption("fail", "false");
  lift->Update();
  EXPECT_EQ(lift->GetExitCode(), 0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(lift->GetOutputDataObject(0))->GetNumberOfPoints(), 100);
}

TEST_F(Stage, WrongJointsAreRefused) {
  const auto points = make("toy.points");
  const auto lift = make("toy.lift");
  EXPECT_FALSE(lift->ConnectInput("cloud", points, "points"));
  EXPECT_THAT(lift->GetErrorText(), HasSubstr("one of: points"));
  EXPECT_FALSE(lift->ConnectInput("points", points, "dem"));
  EXPECT_THAT(lift->GetErrorText(), HasSubstr("no output 'dem'"));
}

TEST_F(Stage, AnUnknownTypeSaysSo) {
  vtkNew<vtkBoleStage> stage;
  quiet(stage);
  EXPECT_FALSE(stage->SetStageType("toy.absent"));
  stage->Update();
  EXPECT_EQ(stage->GetExitCode(), 2);
  EXPECT_THAT(stage->GetErrorText(), HasSubstr("this build has no stage 'toy.absent'"));
  EXPECT_FALSE(stage->SetOption("a", "b"));
}

class Cancelled : public Stage, public testing::WithParamInterface<bool> {};

TEST_P(Cancelled, ReturnsWithinHalfASecond) {
  const auto points = make("toy.points");
  const auto slow = make("toy.slow");
  slow->ConnectInput("points", points, "points");
  points->Update();
  std::chrono::steady_clock::time_point asked;
  std::thread other;
  vtkNew<vtkCallbackCommand> observer;  // used by the variant that asks from within, as VTK programs do
  struct Context {
    std::chrono::steady_clock::time_point* asked;
  } context{&asked};
  if (GetParam()) {
    other = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      asked = std::chrono::steady_clock::now();
      slow->SetAbortExecute(1);
    });
  } else {
    observer->SetClientData(&context);
    observer->SetCallback([](vtkObject* caller, unsigned long, void* client, void* progress) {
      if (*static_cast<double*>(progress) < 0.01) return;
      *static_cast<Context*>(client)->asked = std::chrono::steady_clock::now();
      static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
    });
    slow->AddObserver(vtkCommand::ProgressEvent, observer);
  }
  slow->Update();
  const auto end = std::chrono::steady_clock::now();
  if (other.joinable()) other.join();
  EXPECT_LT(std::chrono::duration<double>(end - asked).count(), 0.5);
  EXPECT_EQ(slow->GetExitCode(), 3);
  EXPECT_EQ(vtkPolyData::SafeDownCast(slow->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(points->GetOutputDataObject(0))->GetNumberOfPoints(), 100);
}

INSTANTIATE_TEST_SUITE_P(Ways, Cancelled, testing::Bool(),
                         [](const auto& way) { return way.param ? "FromAThread" : "FromAnObserver"; });

TEST_F(Stage, FinishKeepsTheBestSoFar) {
  const auto points = make("toy.points");
  const auto slow = make("toy.slow");
  slow->ConnectInput("points", points, "points");
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    slow->Finish();
  });
  slow->Update();
  other.join();
  EXPECT_EQ(slow->GetExitCode(), 0);
  EXPECT_THAT(slow->GetReportJSON(), HasSubstr("finished_early"));
  EXPECT_EQ(vtkPolyData::SafeDownCast(slow->GetOutputDataObject(0))->GetNumberOfPoints(), 100);
}

TEST_F(Stage, FramesAreTimeSteps) {
  const auto frames = make("toy.frames");
  frames->UpdateInformation();
  auto* info = frames->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 4);
  EXPECT_DOUBLE_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE())[1], 100.3);
  frames->UpdateTimeStep(100.25);  // within frame 2
  auto* poly = vtkPolyData::SafeDownCast(frames->GetOutputDataObject(0));
  EXPECT_EQ(poly->GetNumberOfPoints(), 3);
  EXPECT_EQ(poly->GetPointData()->GetArray("range")->GetComponent(0, 0), 5);
  EXPECT_NEAR(poly->GetPointData()->GetArray("time")->GetComponent(2, 0), 100.22, 1e-6);
  frames->UpdateTimeStep(100.0);
  EXPECT_EQ(poly->GetNumberOfPoints(), 1);
  EXPECT_EQ(toy::runs()["toy.frames"], 1);
}

TEST_F(Stage, FramesStreamToTheNextStage) {
  const auto frames = make("toy.frames");
  const auto use = make("toy.use_frames");
  use->ConnectInput("frames", frames, "frames");
  use->Update();
  ASSERT_EQ(use->GetExitCode(), 0) << use->GetErrorText();
  EXPECT_EQ(vtkPolyData::SafeDownCast(use->GetOutputDataObject(use->FindOutputPort("trajectory")))->GetNumberOfPoints(),
            4);
  auto* dem = vtkImageData::SafeDownCast(use->GetOutputDataObject(use->FindOutputPort("dem")));
  EXPECT_EQ(dem->GetNumberOfPoints(), 6);
  EXPECT_EQ(toy::runs()["toy.frames"], 1);
  EXPECT_EQ(toy::runs()["toy.use_frames"], 1);
  vtkNew<vtkPolyData> poly;
  use->SetInputDataObject(0, poly);
  use->Update();
  EXPECT_THAT(use->GetErrorText(), HasSubstr("without the frames of a scan"));
}

}  // namespace
}  // namespace bole::vtkbridge
