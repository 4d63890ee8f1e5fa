/// The bases of relative lengths: the bounding-box diagonal for lengths like 1%, the reference edge
/// for lengths like 0.7x.
#pragma once

#include <optional>
#include <string>

#include "transformesh/document.h"
#include "transformesh/length.h"

namespace transformesh {

/// Returns the mean edge. Throws InputError if it is not positive and finite.
double measured_reference_edge(const Mesh& mesh);

class LengthBasis {
 public:
  /// `choice` is the text of an option: empty, `auto` or a length.
  explicit LengthBasis(std::string choice) : choice_(std::move(choice)) {}

  /// Sets the input document. The bases are computed from the document at first use, so it must not
  /// change before.
  void set_document(const Document* document) { document_ = document; }
  void set_diagonal(double diagonal) { diagonal_ = diagonal; }

  /// Return a basis, which is computed at first use. Throw UsageError without a document, and
  /// InputError if the mesh has no size.
  double diagonal();
  double reference_edge();
  /// Returns the length in input units. Computes only the basis that the length uses.
  double resolve(const Length& length);

  /// True if the reference edge was used, so that the output needs its comment.
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
