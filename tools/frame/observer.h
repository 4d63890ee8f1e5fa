/// An observer is a function of the process inside which a program runs, such as JavaScript that
/// runs the WebAssembly module (wasm/observer.cpp). It receives the progress and can end the run. A
/// native program has no observer.
#pragma once

#include <string_view>

namespace transformesh::tool {

/// Passes the phase of the run and its fraction to the observer. Returns false if the observer ends
/// the run.
bool may_continue(std::string_view phase, double fraction);

}  // namespace transformesh::tool
