/// Exact triangle-triangle intersection test (paper 3.1), used by detection and arrangement.
/// Classifies each contact of two faces by the vertices, edges and interiors that meet. The sign
/// tests follow Guigue & Devillers, "Fast and robust triangle-triangle overlap test using
/// orientation predicates", JGT 2003. Unlike their test, this one classifies every contact, and
/// touching counts as an intersection. Cost: O(1).
#pragma once

#include <array>

#include "clean/intersect/welded_mesh.h"
#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// One of the seven open simplices of a face. The corners are 0, 1 and 2; the edges that start at
/// these corners are 3, 4 and 5; the interior is 6.
using FaceSimplex = std::uint8_t;
/// The interior of a face; corners are 0 to 2, edges are 3 to 5.
inline constexpr FaceSimplex interior = 6;

/// A common point of two faces, given by the simplex of each face that contains the point.
struct Contact {
  FaceSimplex first;
  FaceSimplex second;
};

struct Contacts {
  bool coplanar = false;  ///< the faces are coplanar and meet outside shared corners and edges
  bool meet = false;      ///< the faces meet outside shared corners and edges
  /// The first `count` entries are the ends of the common segment of two non-coplanar faces, or
  /// their only common point. Shared corners are included. The entries are distinct points: a point
  /// is in one simplex of each face, and equal pairs of simplices are stored once.
  std::array<Contact, 4> contacts{};
  int count = 0;
  /// Side of each corner of the first (second) face relative to the plane of the second (first)
  /// face: +1 in front, -1 behind, 0 in the plane. Set only if non-coplanar faces meet.
  std::array<std::int8_t, 3> first_sides{}, second_sides{};
};

struct Meeting {
  Index first;
  Index second;
  Contacts contacts;
};

/// Classifies the contacts of two welded faces. Corners are shared if their point indices are
/// equal. Exact.
Contacts find_contacts(const WeldedMesh& welded, Index first, Index second);

/// Returns true if two triangles meet outside shared corners and edges. Corners are shared if their
/// coordinates are equal. Exact; returns false if one of the triangles has no area.
bool triangles_meet(const Triangle& first, const Triangle& second);

/// Returns how a contact point is defined: as a corner, as the intersection of an edge and a face,
/// or as the intersection of two edges. A contact of two edges or of an edge and a face has the
/// same definition for either order of the two faces.
PointDefinition contact_definition(const WeldedMesh& welded, Index first, Index second,
                                   Contact contact);

ExactPoint contact_point(const WeldedMesh& welded, const ExactGeometry& geometry, Index first,
                         Index second, Contact contact);

}  // namespace transformesh
