#include "render/offscreen/offscreen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdlib>

#include "base/error.h"

namespace bole::render {
namespace {

TEST(Offscreen, NamesRoundTrip) {
  for (const auto backend : {Backend::automatic, Backend::osmesa, Backend::egl, Backend::glx})
    EXPECT_EQ(backend_from_name(backend_name(backend)), backend);
  EXPECT_THROW(backend_from_name("opengl"), Error);
}

TEST(Offscreen, TestsAreLinkedWithOSMesaFirst) { EXPECT_TRUE(osmesa_is_linked()); }

TEST(Offscreen, EveryNewWindowIsOneInMemory) {
  EXPECT_EQ(use_backend(Backend::automatic), Backend::osmesa);
  vtkNew<vtkRenderWindow> window;
  EXPECT_STREQ(window->GetClassName(), "vtkBoleOSMesaRenderWindow");
  use_backend(Backend::osmesa);  // a second time changes nothing
  vtkNew<vtkRenderWindow> second;
  EXPECT_STREQ(second->GetClassName(), "vtkBoleOSMesaRenderWindow");
}

TEST(Offscreen, GlxWithoutDisplaySaysWhatToDo) {
  if (std::getenv("DISPLAY") != nullptr) GTEST_SKIP() << "DISPLAY is set";
  try {
    use_backend(Backend::glx);
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_code(), 2);
    EXPECT_THAT(e.what(), testing::HasSubstr("xvfb-run"));
  }
}

}  // namespace
}  // namespace bole::render
