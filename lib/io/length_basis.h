/// The reference lengths of relative lengths: the bounding-box diagonal for a length such as 1%,
/// and the reference edge for a length such as 0.7x.
#pragma once

#include <optional>
#include <string>

#include "transformesh/document.h"
#include "transformesh/length.h"

namespace transformesh {

/// Returns the mean edge length of the mesh. Throws InputError if it is not positive and finite.
double measured_reference_edge(const Mesh& mesh);

class LengthBasis {
 public:
  /// Sets how the reference edge is chosen. `choice` is the text of an option: empty, `auto` or a
  /// length.
  explicit LengthBasis(std::string choice) : choice_(std::move(choice)) {}

  /// Sets the input document, from which diagonal and reference edge are computed when they are
  /// used first. The document must not change before.
  void set_document(const Document* document) { document_ = document; }
  void set_diagonal(double diagonal) { diagonal_ = diagonal; }

  /// Return the bounding-box diagonal or the reference edge, computed at first use. Throw
  /// UsageError without a document, and InputError if the mesh has no size.
  double diagonal();
  double reference_edge();
  /// Returns the length in input units. Computes the diagonal or the reference edge only if the
  /// length is relative to it.
  double resolve(const Length& length);

  /// True if the reference edge was computed, so that it has to be stored as a comment of the
  /// output.
  bool has_reference_edge() const { return reference_edge_.has_value(); }
  bool is_reference_edge_chosen() const { return !choice_.empty(); }

 private:
  double inherited_edge() const;

  std::string choice_;
  const Document* document_ = nullptr;
  std::optional<double> diagonal_;
  std::optional<double> reference_edge_;
};

}  // namespace transformesh
