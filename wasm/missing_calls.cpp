/// Calls of Linux that Emscripten's C library does not have. They fail, and callers report that.
#include <cerrno>

extern "C" int memfd_create(const char* /*name*/, unsigned /*flags*/) {
  errno = ENOSYS;
  return -1;
}
