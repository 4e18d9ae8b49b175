#include "render/offscreen/offscreen.h"

#include <dlfcn.h>
#include <vtkObjectFactory.h>
#include <vtkObjectFactoryCollection.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

#include <array>
#include <cstdlib>

#include "base/error.h"
#include "render/offscreen/osmesa_window.h"

namespace bole::render {
namespace {

constexpr std::array<std::string_view, 4> names{"auto", "osmesa", "egl", "glx"};

class OSMesaFactory : public vtkObjectFactory {
 public:
  static OSMesaFactory* New() {
    auto* factory = new OSMesaFactory;
    factory->InitializeObjectBase();
    return factory;
  }
  vtkTypeMacro(OSMesaFactory, vtkObjectFactory)
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Bole: render windows in memory through OSMesa"; }

 private:
  OSMesaFactory() {
    RegisterOverride("vtkRenderWindow", "vtkBoleOSMesaRenderWindow", "OSMesa in memory", 1,
                     [] { return static_cast<vtkObject*>(vtkBoleOSMesaRenderWindow::New()); });
  }
};

void use_osmesa() {
  static const bool registered = [] {
    vtkObjectFactory::RegisterFactory(vtkSmartPointer<OSMesaFactory>::New());
    return true;
  }();
  (void)registered;
  // The factory that came first would win: switch all off, then ours on.
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
  vtkObjectFactory::SetAllEnableFlags(1, "vtkRenderWindow", "vtkBoleOSMesaRenderWindow");
}

void use_window_system() {
  vtkObjectFactory::SetAllEnableFlags(1, "vtkRenderWindow");
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow", "vtkBoleOSMesaRenderWindow");
}

bool display_is_set() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

[[noreturn]] void refuse_osmesa() {
  throw bad_input("this program is not linked with OSMesa", "libOSMesa before libOpenGL among its libraries",
                  "Use the bole program, or run this one under xvfb-run with the backend glx");
}

}  // namespace

std::string_view backend_name(Backend backend) { return names[static_cast<std::size_t>(backend)]; }

Backend backend_from_name(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Backend>(i);
  throw bad_input("there is no drawing backend '" + std::string(name) + "'", "auto, osmesa, egl or glx");
}

bool osmesa_is_linked() {
  const void* draw = dlsym(RTLD_DEFAULT, "glDrawArrays");
  const void* create = dlsym(RTLD_DEFAULT, "OSMesaCreateContextAttribs");
  Dl_info of_draw{}, of_create{};
  return draw != nullptr && create != nullptr && dladdr(draw, &of_draw) != 0 && dladdr(create, &of_create) != 0 &&
         of_draw.dli_fbase == of_create.dli_fbase;
}

Backend use_backend(Backend backend) {
  if (backend == Backend::automatic) backend = osmesa_is_linked() ? Backend::osmesa : Backend::glx;
  switch (backend) {
    case Backend::osmesa:
      if (!osmesa_is_linked()) refuse_osmesa();
      use_osmesa();
      break;
    case Backend::egl:
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
      setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow", 1);
      use_window_system();
      break;
#else
      throw bad_input("VTK " + std::string(vtkVersion::GetVTKVersion()) + " has no EGL window", "VTK 9.4 or later",
                      "Use the backend osmesa");
#endif
    default:
      // VTK ends the whole program when the X server does not answer: say so before.
      if (!display_is_set())
        throw bad_input("the environment variable DISPLAY is not set", "an X display for the backend glx",
                        "Run it under xvfb-run, or use the bole program, which draws without a display");
      use_window_system();
  }
  return backend;
}

}  // namespace bole::render
