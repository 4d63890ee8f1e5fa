#include "frame/observer.h"

namespace transformesh::tool {

bool may_continue(std::string_view /*phase*/, double /*fraction*/) { return true; }

}  // namespace transformesh::tool
