#include "io/length_basis.h"

#include <cmath>

#include "io/comments.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

double LengthBasis::diagonal() {
  if (!diagonal_) {
    if (document_ == nullptr) throw UsageError("a length in % needs a mesh to refer to");
    diagonal_ = diagonal_of(bounding_box(document_->mesh));
  }
  return *diagonal_;
}

double measured_reference_edge(const Mesh& mesh) {
  const EdgeLengths edges = edge_lengths(mesh);
  if (edges.mean > 0 && std::isfinite(edges.mean)) return edges.mean;
  if (edges.count == 0)
    throw InputError("the mesh has no edges, so lengths in x have no reference edge");
  throw InputError("the mean edge of the mesh is " + shortest_text(edges.mean) +
                   ", so lengths in x have no reference edge" +
                   (edges.mean > 0 ? "; scale the mesh down" : ""));
}

double LengthBasis::inherited_edge() const {
  const auto inherited = reference_edge_of(document_->style.comments);
  return inherited ? *inherited : measured_reference_edge(document_->mesh);
}

double LengthBasis::reference_edge() {
  if (reference_edge_) return *reference_edge_;
  if (document_ == nullptr) throw UsageError("a length in x needs a mesh to refer to");
  if (choice_.empty()) {
    reference_edge_ = inherited_edge();
  } else if (choice_ == "auto") {
    reference_edge_ = measured_reference_edge(document_->mesh);
  } else {
    const Length length = parse_length(choice_);
    const bool is_relative = length.unit == Length::Unit::reference_edge;
    const bool needs_diagonal = length.unit == Length::Unit::diagonal;
    reference_edge_ =
        length.resolve(needs_diagonal ? diagonal() : 0, is_relative ? inherited_edge() : 0);
  }
  return *reference_edge_;
}

double LengthBasis::resolve(const Length& length) {
  switch (length.unit) {
    case Length::Unit::diagonal:
      return length.resolve(diagonal(), 0);
    case Length::Unit::reference_edge:
      return length.resolve(0, reference_edge());
    default:
      return length.value;
  }
}

}  // namespace transformesh
