/// Volume of unions and differences of convex prisms in closed form: inclusion and exclusion over
/// intersections of half-spaces.
#pragma once

#include <vector>

#include "corpus/chains/triangle_mesh.h"

namespace chains {

/// All x with dot(normal, x) <= offset; the normal has unit length.
struct HalfSpace {
  Point normal;
  double offset;
};

using ConvexBody = std::vector<HalfSpace>;

/// Volume of a bounded intersection of half-spaces that lies within `reach` of the origin.
double volume_of(const ConvexBody& body, double reach);

/// Volume of the union of at most about eight bodies.
double volume_of_union(const std::vector<ConvexBody>& bodies, double reach);

}  // namespace chains
