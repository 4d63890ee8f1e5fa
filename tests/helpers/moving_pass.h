#pragma once

#include "evolution/reconstruction/scale_rule.h"

namespace transformesh::test {

/// A surface that moves, agrees better and better, and loses nothing.
inline Pass moving(double dissimilarity) {
  Pass pass;
  pass.scale_step.scale = 4;
  pass.mesh.vertices = 1000;
  pass.mesh.topology = {1, 0};
  pass.steps.last.mean_share = 0.1;
  pass.steps.last.dissimilarity = dissimilarity;
  pass.steps.last.coverage = pass.steps.first.coverage = 0.8;
  pass.steps.last.pixels = pass.steps.first.pixels = 900;
  return pass;
}

}  // namespace transformesh::test
