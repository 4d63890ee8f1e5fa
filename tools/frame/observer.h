/// The caller of a program that runs inside another process: JavaScript, of the WebAssembly module
/// (wasm/observer.cpp). A native program has none.
#pragma once

#include <string_view>

namespace transformesh::tool {

/// Tells the caller the phase of the run and its fraction. Returns false if the caller ends the
/// run.
bool may_continue(std::string_view phase, double fraction);

}  // namespace transformesh::tool
