/// Where two faces meet, told by their vertices, edges and interiors: the exact triangle-triangle
/// test behind detection and arrangement. Reference for the sign tests: Guigue & Devillers, "Fast
/// and robust triangle-triangle overlap test using orientation predicates", JGT 2003; here every
/// contact is classified, so that touching counts.
#pragma once

#include <array>

#include "tm/clean/intersect/soup.h"

namespace transformesh {

/// A place on a face: 0 1 2 its corners, 3 4 5 the edges that start there, 6 its interior.
using Place = std::uint8_t;
inline constexpr Place interior = 6;

struct Contact {
  Place first;
  Place second;
};

struct Contacts {
  bool coplanar = false;  ///< the faces lie in one plane and meet beyond shared corners and edges
  bool meet = false;      ///< they meet anywhere but in shared corners and edges
  /// The ends of the common segment of faces in different planes (or its only point), shared
  /// corners included. Two entries may be needed for one end only when they are equal points of
  /// different places, which does not happen.
  std::array<Contact, 4> contacts{};
  int count = 0;
};

/// Exact. Faces that share a corner share the point index.
Contacts find_contacts(const Soup& soup, Index first, Index second);

}  // namespace transformesh
