/// Calls `observe(phase, fraction)` of the module, if JavaScript has set it.
#include "frame/observer.h"

#include <emscripten.h>

EM_JS(int, call_observer, (const char* phase, int size, double fraction),
      { return !Module.observe || Module.observe(UTF8ToString(phase, size), fraction); });

namespace transformesh::tool {

bool may_continue(std::string_view phase, double fraction) {
  return call_observer(phase.data(), static_cast<int>(phase.size()), fraction) != 0;
}

}  // namespace transformesh::tool
