/// Runs a loop for documents on a mesh.
#pragma once

#include <utility>

#include "transformesh/document.h"

namespace transformesh {

/// Returns `body(document)` for a document that holds the mesh, and moves the mesh of the document
/// back, also if `body` throws.
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
