/// Whether faces agree which side is outside, and where their surface ends. What counts is the sum
/// of the faces along an edge, those that run one way less those that run the other: 0 where the
/// surface goes on, however many sheets meet there; 1 at the border of an open surface, be it free
/// or where a sheet ends on another surface; more where faces are misoriented.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <string>
#include <vector>

#include "tm/clean/intersect/soup.h"

namespace transformesh {

struct Borders {
  std::vector<std::vector<Index>> loops;  ///< of soup points, each running along its faces
  bool is_oriented = true;
};

/// A closed mesh has no loops. Where n faces are left over at an edge, it is in n loops. The mesh
/// faces marked in `left_out`, if any are, do not count.
Borders find_borders(const Soup& soup, const Mesh& mesh, const std::vector<char>& left_out = {});

/// In words the first misoriented edge, with faces and place; empty if there is none. Equal
/// vertices are one index.
std::string describe_misorientation(const Mesh& mesh);

/// Whether tm-stitch --orient mends a mesh that is not oriented.
bool can_be_oriented(const Soup& soup, const Mesh& mesh);

/// Throws InputError for a mesh that is not oriented, saying where and what mends it: tm-stitch
/// --orient only where it does.
[[noreturn]] void refuse_orientation(const Soup& soup, const Mesh& mesh);

}  // namespace transformesh
