// The library bole_osmesa. An executable that lists it and libOSMesa first among its libraries has VTK's gl* calls
// bound to OSMesa by the ordinary rules of dynamic linking. GLEW asks glXGetProcAddressARB for everything newer than
// OpenGL 1.1, so that one function answers for OSMesa as long as an OSMesa context is current and stands aside
// otherwise.
#include <GL/osmesa.h>
#include <dlfcn.h>

extern "C" {

using GlFunction = void (*)();

__attribute__((visibility("default"))) GlFunction glXGetProcAddressARB(const unsigned char* name) {
  if (OSMesaGetCurrentContext() != nullptr) return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
  using Lookup = GlFunction (*)(const unsigned char*);
  static const auto next = reinterpret_cast<Lookup>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));
  return next != nullptr ? next(name) : nullptr;
}

}  // extern "C"
