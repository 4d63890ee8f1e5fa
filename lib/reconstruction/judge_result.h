/// Judges the result of a reconstruction by its photographs, and compares it with the mesh that was
/// given.
#pragma once

#include "reconstruction/convergence.h"
#include "reconstruction/photographs.h"
#include "transformesh/reconstruct.h"

namespace transformesh {

class ResultJudge {
 public:
  /// Keeps references. `given` is the initial mesh, not intersected with the hull if it was given.
  ResultJudge(Photographs& photographs, const Document& given, const ReconstructionOptions& options)
      : photographs_(photographs), given_(given), options_(options) {}

  /// Sets the measures and the fault of `result`, and the doubt of each vertex. If the initial mesh
  /// was given, parts of it that are at least as good replace those of the document, or all of it
  /// does. The initial mesh also replaces a document that fell apart. Before the call,
  /// `result.topology` must be that of the document. `faults` are those of the sweeps.
  void judge(Document& document, ReconstructionFaults faults, ReconstructionResult& result,
             const Progress& progress) const;

 private:
  SurfaceMeasures best_of(const SurfaceMeasures& start, SurfaceMeasures end, Document& document,
                          ReconstructionResult& result, const Progress& progress) const;
  void keep_start(Document& document, ReconstructionResult& result) const;

  Photographs& photographs_;
  const Document& given_;
  const ReconstructionOptions& options_;
};

}  // namespace transformesh
