#pragma once

#include "reconstruction/scale_rule.h"

namespace transformesh::test {

/// Returns the measures of one iteration of a reconstruction (a sweep) with the given
/// dissimilarity. In this iteration vertices move, and `coverage`, the fraction of visible pixels
/// that are compared, stays the same.
inline Sweep moving(double dissimilarity) {
  Sweep sweep;
  sweep.scale_step.scale = 4;
  sweep.mesh.vertices = 1000;
  sweep.mesh.topology = {1, 0};
  sweep.steps.last.mean_share = 0.1;
  sweep.steps.last.dissimilarity = dissimilarity;
  sweep.steps.last.coverage = sweep.steps.first.coverage = 0.8;
  sweep.steps.last.pixels = sweep.steps.first.pixels = 900;
  return sweep;
}

}  // namespace transformesh::test
