/// Runs a loop, which works on a document, on a mesh.
#pragma once

#include <utility>

#include "transformesh/document.h"

namespace transformesh {

/// Moves the mesh into a document, returns `body(document)`, and moves the mesh back, also if
/// `body` throws.
template <typename Body>
auto with_document(Mesh& mesh, const Body& body) {
  Document document;
  document.mesh = std::move(mesh);
  try {
    auto result = body(document);
    mesh = std::move(document.mesh);
    return result;
  } catch (...) {
    mesh = std::move(document.mesh);
    throw;
  }
}

}  // namespace transformesh
