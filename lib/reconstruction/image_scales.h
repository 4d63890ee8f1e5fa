/// The schedule of a reconstruction from coarse to fine (paper 5.3.1): factors by which photographs
/// are reduced (scales), and lengths of edges at these scales.
#pragma once

#include <optional>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/document.h"
#include "transformesh/reconstruction_options.h"

namespace transformesh {

struct ScaleStep {
  double scale = 1;
  double edge = 0;  ///< edge length; input units
};

/// Returns steps from the coarsest scale to scale 1, whose scales decrease by a factor of sqrt(2).
/// They are followed by steps at scale 1 whose edges decrease by the same factor. Scales are
/// rounded to 4 decimals and edges to 9 digits, as in a CSV file, so that the file contains exactly
/// the numbers that were used. `pixel` is the length of a pixel's side at scale 1.
std::vector<ScaleStep> coarse_to_fine(const ScaleOptions& options, int image_width, double pixel);

/// Returns `factor` times `edge`, rounded to 9 digits like the edge lengths that remesh() gets.
double edge_times(double factor, double edge);

/// Calls remesh() for edges of about this length, and rounds the result as written to a file.
void remesh_to(Document& document, double edge, int iterations = 1,
               const Progress& progress = Progress());

/// Coarsens the mesh if its edges are shorter than `edge`. Doubles the edge length repeatedly,
/// which is much faster than coarsening in one step. Throws as remesh() does.
void coarsen(Document& document, double edge, const Progress& progress = Progress());

}  // namespace transformesh
