#include "render/offscreen/osmesa_window.h"

#include <vtk_glew.h>  // before any other OpenGL header

// GLEW takes these away again, osmesa.h needs them.
#define GLAPI extern
#define GLAPIENTRY
#define APIENTRY
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <vtkCollection.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace {

// OSMesa is looked up in the running process, so that this library does not force it upon programs that draw on a
// screen.
template <class Function>
Function osmesa(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

constexpr GLenum glew_no_glx_display = 4;

}  // namespace

vtkStandardNewMacro(vtkBoleOSMesaRenderWindow)

vtkBoleOSMesaRenderWindow::vtkBoleOSMesaRenderWindow() {
  this->UseOffScreenBuffers = true;
  this->ShowWindow = false;
  this->MultiSamples = 0;
  this->ScreenSize[0] = 16384;
  this->ScreenSize[1] = 16384;
}

vtkBoleOSMesaRenderWindow::~vtkBoleOSMesaRenderWindow() {
  this->vtkBoleOSMesaRenderWindow::Finalize();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (auto* renderer = this->Renderers->GetNextRenderer(it)) renderer->SetRenderWindow(nullptr);
}

void vtkBoleOSMesaRenderWindow::Start() {
  this->Initialize();
  this->Superclass::Start();
}

void vtkBoleOSMesaRenderWindow::Frame() {
  this->MakeCurrent();
  this->Superclass::Frame();
}

void vtkBoleOSMesaRenderWindow::Initialize() {
  if (context_ == nullptr) this->CreateAWindow();
}

void vtkBoleOSMesaRenderWindow::Finalize() {
  if (context_ != nullptr) this->DestroyWindow();
}

void vtkBoleOSMesaRenderWindow::WindowRemap() {
  this->Finalize();
  this->Initialize();
}

void vtkBoleOSMesaRenderWindow::CreateAWindow() {
  using Create = OSMesaContext (*)(const int*, OSMesaContext);
  const auto create = osmesa<Create>("OSMesaCreateContextAttribs");
  if (create == nullptr) {
    vtkErrorMacro("libOSMesa is not among the libraries of this program");
    return;
  }
  constexpr int attributes[] = {OSMESA_FORMAT,
                                OSMESA_RGBA,
                                OSMESA_DEPTH_BITS,
                                24,
                                OSMESA_STENCIL_BITS,
                                8,
                                OSMESA_PROFILE,
                                OSMESA_CORE_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION,
                                3,
                                OSMESA_CONTEXT_MINOR_VERSION,
                                2,
                                0};
  context_ = create(attributes, nullptr);
  if (context_ == nullptr) {
    vtkErrorMacro("OSMesa gave no OpenGL 3.2 context");
    return;
  }
  if (this->Size[0] <= 0) this->Size[0] = 300;
  if (this->Size[1] <= 0) this->Size[1] = 300;
  this->OwnContext = 1;
  this->MakeCurrent();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (auto* renderer = this->Renderers->GetNextRenderer(it)) {
    renderer->SetRenderWindow(nullptr);
    renderer->SetRenderWindow(this);
  }
  this->OpenGLInit();
}

void vtkBoleOSMesaRenderWindow::DestroyWindow() {
  this->MakeCurrent();
  this->ReleaseGraphicsResources(this);
  osmesa<void (*)(OSMesaContext)>("OSMesaDestroyContext")(static_cast<OSMesaContext>(context_));
  context_ = nullptr;
  this->Mapped = 0;
  this->Initialized = false;
}

void vtkBoleOSMesaRenderWindow::MakeCurrent() {
  using MakeContextCurrent = GLboolean (*)(OSMesaContext, void*, GLenum, GLsizei, GLsizei);
  if (context_ == nullptr || this->IsCurrent()) return;
  if (!osmesa<MakeContextCurrent>("OSMesaMakeCurrent")(static_cast<OSMesaContext>(context_), pixels_.data(),
                                                       GL_UNSIGNED_BYTE, buffer_side, buffer_side))
    vtkErrorMacro("OSMesaMakeCurrent failed");
}

bool vtkBoleOSMesaRenderWindow::IsCurrent() {
  return context_ != nullptr &&
         osmesa<OSMesaContext (*)()>("OSMesaGetCurrentContext")() == static_cast<OSMesaContext>(context_);
}

// GLEW loads the entry points first and looks for a GLX display afterwards. Without one it answers "no GLX display", by
// which time all that VTK needs is in place; the base class would take that for a failure.
void vtkBoleOSMesaRenderWindow::OpenGLInitContext() {
  this->ContextCreationTime.Modified();
  if (this->Initialized) return;
  const GLenum answer = glewInit();
  this->GlewInitValid = answer == GLEW_OK || answer == glew_no_glx_display;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2) {
    vtkErrorMacro("GLEW found no OpenGL 3.2 in OSMesa (answer " << answer << ")");
    return;
  }
  GLfloat line_widths[2] = {1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, line_widths);
  this->MaximumHardwareLineWidth = line_widths[1];
  this->Initialized = true;
}
