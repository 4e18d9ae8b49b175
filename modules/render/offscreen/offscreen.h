// Which OpenGL draws: a window system's, or Mesa in memory.
#pragma once

#include <string>
#include <string_view>

namespace bole::render {

enum class Backend {
  automatic,  // osmesa where the process can, else glx
  osmesa,     // software, no display; needs an executable linked with bole_headless_executable()
  egl,        // a graphics card without a display; VTK 9.4 and later
  glx         // an X display, also that of xvfb-run
};

std::string_view backend_name(Backend backend);
Backend backend_from_name(std::string_view name);  // "auto", "osmesa", "egl", "glx"; throws Error{bad_input}

// Decides which window every later vtkRenderWindow::New() gives. Call it once, before the first. Returns what was
// chosen. Throws Error{bad_input} with the remedy when the backend cannot work in this process.
Backend use_backend(Backend backend);

// Whether gl* calls of this process reach OSMesa: libOSMesa comes before libOpenGL among its libraries.
bool osmesa_is_linked();

}  // namespace bole::render
