/// Computes volumes of unions and differences of convex prisms in closed form, by inclusion and
/// exclusion over intersections of half-spaces.
#pragma once

#include <vector>

#include "corpus/chains/triangle_mesh.h"

namespace chains {

/// The set of all x with dot(normal, x) <= offset; the normal has unit length.
struct HalfSpace {
  Point normal;
  double offset;
};

using ConvexBody = std::vector<HalfSpace>;

/// Returns the volume of a bounded intersection of half-spaces that lies within `reach` of the
/// origin.
double volume_of(const ConvexBody& body, double reach);

/// Returns the volume of the points in at least one of at most about eight bodies (winding level
/// 1), or in at least two of them (winding level 2).
double volume_at_winding_level(int level, const std::vector<ConvexBody>& bodies, double reach);

}  // namespace chains
