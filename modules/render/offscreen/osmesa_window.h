// A render window of VTK that draws through OSMesa into memory: what vtkOSOpenGLRenderWindow is in a VTK built for
// OSMesa, for a VTK that was built for X (Debian's).
#pragma once

#include <vtkOpenGLRenderWindow.h>

#include <array>

class vtkBoleOSMesaRenderWindow : public vtkOpenGLRenderWindow {
 public:
  static vtkBoleOSMesaRenderWindow* New();
  vtkTypeMacro(vtkBoleOSMesaRenderWindow, vtkOpenGLRenderWindow)
  vtkBoleOSMesaRenderWindow(const vtkBoleOSMesaRenderWindow&) = delete;
  void operator=(const vtkBoleOSMesaRenderWindow&) = delete;

  void Start() override;
  void Frame() override;
  void Initialize() override;
  void Finalize() override;
  void WindowRemap() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void OpenGLInitContext() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 0; }
  vtkTypeBool GetEventPending() override { return 0; }
  int* GetScreenSize() override { return this->ScreenSize; }
  void* GetGenericContext() override { return context_; }
  void* GetGenericWindowId() override { return pixels_.data(); }
  void* GetGenericDisplayId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }

  // There is no window system to tell.
  void SetFullScreen(vtkTypeBool) override {}
  void ShowCursor() override {}
  void HideCursor() override {}
  void SetWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetDisplayId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}

 protected:
  vtkBoleOSMesaRenderWindow();
  ~vtkBoleOSMesaRenderWindow() override;
  void CreateAWindow() override;
  void DestroyWindow() override;

 private:
  // The picture itself is drawn into VTK's own framebuffer objects; OSMesa only wants some buffer to call the default
  // one.
  static constexpr int buffer_side = 32;
  std::array<unsigned char, 4 * buffer_side * buffer_side> pixels_{};
  void* context_ = nullptr;  // OSMesaContext
};
