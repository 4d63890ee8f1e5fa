#pragma once

#include "reconstruction/scale_rule.h"

namespace transformesh::test {

/// Returns a sweep with a given dissimilarity in which vertices move and no coverage is lost.
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
