/// From coarse to fine (paper 5.3.1): how many times smaller photographs are while a surface moves
/// towards them, and how long its edges are then.
#pragma once

#include <optional>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/document.h"
#include "transformesh/reconstruction_options.h"

namespace transformesh {

struct ScaleStep {
  double scale = 1;
  double edge = 0;  ///< input units
};

/// Scales from the coarsest to 1 by the square root of 2, then at scale 1 shorter edges by the
/// same. Both numbers are as short as in a CSV file (4 decimals, 9 digits), so that what a file
/// records of a sweep is what was done. `pixel` is the length of a pixel's side at scale 1.
std::vector<ScaleStep> coarse_to_fine(const ScaleOptions& options, int image_width, double pixel);

/// A multiple of an edge as remesh() gets it, with 9 digits likewise.
double edge_times(double factor, double edge);

/// remesh() to edges about as long, rounded as written.
void remesh_to(Document& document, double edge, int iterations = 1,
               const Progress& progress = Progress());

/// Makes edges about as long, where they are shorter. Doubles them again and again, which is much
/// faster than going there at once. Throws as remesh() does.
void coarsen(Document& document, double edge, const Progress& progress = Progress());

}  // namespace transformesh
