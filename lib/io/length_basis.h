/// What relative lengths refer to: the diagonal for 1%, the reference edge for 0.7x.
#pragma once

#include <optional>
#include <string>

#include "transformesh/document.h"
#include "transformesh/length.h"

namespace transformesh {

/// The mean edge; throws InputError where it is no positive finite length.
double measured_reference_edge(const Mesh& mesh);

class LengthBasis {
 public:
  /// `choice` is empty, `auto` or a length.
  explicit LengthBasis(std::string choice) : choice_(std::move(choice)) {}

  /// The mesh read, as long as it is as read: bases are taken from it when first needed.
  void set_document(const Document* document) { document_ = document; }
  void set_diagonal(double diagonal) { diagonal_ = diagonal; }

  /// Both throw UsageError without a mesh and InputError where it has no size.
  double diagonal();
  double reference_edge();
  /// In input units; asks only for the basis that the length uses.
  double resolve(const Length& length);

  /// Whether it was asked for, so that it belongs into the output's comments.
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
