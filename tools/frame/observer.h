/// A program may run inside another process, for example as a WebAssembly module in JavaScript
/// (wasm/observer.cpp). This process may have a function, the observer, that receives the progress
/// and can end the run. A native program has no observer.
#pragma once

#include <string_view>

namespace transformesh::tool {

/// Passes the phase of the run and its fraction to the observer. Returns false if the observer ends
/// the run.
bool may_continue(std::string_view phase, double fraction);

}  // namespace transformesh::tool
