// Preloaded into a process, stops it as soon as it opens an X display: by Xlib, by xcb, or by the socket itself.
#include <dlfcn.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

[[noreturn]] void stop(const char* how) {
  std::fprintf(stderr, "this process tried to open an X display (%s)\n", how);
  std::_Exit(99);
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void* XOpenDisplay(const char*) { stop("XOpenDisplay"); }
__attribute__((visibility("default"))) void* xcb_connect(const char*, int*) { stop("xcb_connect"); }

__attribute__((visibility("default"))) int connect(int socket, const sockaddr* address, socklen_t length) {
  if (address != nullptr && address->sa_family == AF_UNIX) {
    const auto* path = reinterpret_cast<const sockaddr_un*>(address)->sun_path;
    if (std::strstr(path[0] == '\0' ? path + 1 : path, "X11-unix") != nullptr) stop("connect");
  }
  using Connect = int (*)(int, const sockaddr*, socklen_t);
  return reinterpret_cast<Connect>(dlsym(RTLD_NEXT, "connect"))(socket, address, length);
}

}  // extern "C"
