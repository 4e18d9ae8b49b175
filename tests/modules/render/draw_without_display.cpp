// Draws a red sphere and white text on blue with DISPLAY unset, and looks at the colours. --open-display opens a
// display on purpose, to show that the guard of this test can fail.
#include <dlfcn.h>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "render/offscreen/offscreen.h"

namespace {

constexpr int width = 320, height = 240;

int check(bool good, const char* what) {
  if (!good) std::fprintf(stderr, "wrong: %s\n", what);
  return good ? 0 : 1;
}

int count_white(vtkUnsignedCharArray* pixels) {
  int white = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < width; ++x) {
      const auto* p = pixels->GetPointer(3 * (y * width + x));
      white += p[0] > 220 && p[1] > 220 && p[2] > 220;
    }
  return white;
}

int draw() {
  if (bole::render::use_backend(bole::render::Backend::automatic) != bole::render::Backend::osmesa)
    return check(false, "automatic chose another backend");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1, 0, 0);
  actor->GetProperty()->SetAmbient(1);
  vtkNew<vtkTextActor> text;
  text->SetInput("without a screen");
  text->SetPosition(10, 10);
  text->GetTextProperty()->SetFontSize(18);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0, 0, 1);
  renderer->AddActor(actor);
  renderer->AddActor2D(text);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(width, height);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
  const auto* centre = pixels->GetPointer(3 * (height / 2 * width + width / 2));
  const auto* corner = pixels->GetPointer(3 * ((height - 5) * width + 5));
  int wrong = check(std::strcmp(window->GetClassName(), "vtkBoleOSMesaRenderWindow") == 0, "class of the window");
  wrong += check(centre[0] > 200 && centre[1] < 40 && centre[2] < 40, "the centre is red");
  wrong += check(corner[0] == 0 && corner[1] == 0 && corner[2] == 255, "the corner is blue");
  wrong += check(count_white(pixels) > 100, "there is white text");
  return wrong;
}

void open_display() {
  void* x11 = dlopen("libX11.so.6", RTLD_NOW);
  if (x11 == nullptr) return;
  using Open = void* (*)(const char*);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  if (open != nullptr) open(":0");
}

}  // namespace

int main(int argc, char** argv) {
  if (std::getenv("DISPLAY") != nullptr) return check(false, "DISPLAY is set");
  if (argc > 1 && std::strcmp(argv[1], "--open-display") == 0) open_display();
  try {
    return draw() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const bole::Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return e.exit_code();
  }
}
