/// Classifies where two faces meet by their vertices, edges and interiors: the exact
/// triangle-triangle test behind detection and arrangement (paper 3.1). Reference for the sign
/// tests: Guigue & Devillers, "Fast and robust triangle-triangle overlap test using orientation
/// predicates", JGT 2003; here every contact is classified, so that touching counts.
#pragma once

#include <array>

#include "clean/intersect/welded_mesh.h"
#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// One of the seven open simplices of a face: 0, 1 and 2 are its corners, 3, 4 and 5 the edges that
/// start there, and 6 is its interior.
using FaceSimplex = std::uint8_t;
inline constexpr FaceSimplex interior = 6;

/// A common point of two faces: the simplex of each in which it lies.
struct Contact {
  FaceSimplex first;
  FaceSimplex second;
};

struct Contacts {
  bool coplanar = false;  ///< the faces lie in one plane and meet beyond shared corners and edges
  bool meet = false;      ///< they meet anywhere but in shared corners and edges
  /// The ends of the common segment of faces in different planes (or its only point), shared
  /// corners included. One end never takes two entries: equal points lie in equal simplices.
  std::array<Contact, 4> contacts{};
  int count = 0;
  /// On which side of the other's plane each corner lies, +1 in front; of faces in different planes
  /// that meet.
  std::array<std::int8_t, 3> first_sides{}, second_sides{};
};

/// Two faces that meet, and where.
struct Meeting {
  Index first;
  Index second;
  Contacts contacts;
};

/// Exact. Faces that share a corner share the point index.
Contacts find_contacts(const WeldedMesh& welded, Index first, Index second);

/// Returns whether two triangles meet anywhere but in corners and edges that they share. Corners
/// with equal coordinates are shared. Exact; false if one of the triangles has no area.
bool triangles_meet(const Triangle& first, const Triangle& second);

/// What defines the point of a contact: a given point, an edge and a face, or two edges. It is the
/// same from whichever faces it is seen.
PointDefinition contact_definition(const WeldedMesh& welded, Index first, Index second,
                                   Contact contact);

/// The exact point of a contact.
ExactPoint contact_point(const WeldedMesh& welded, const ExactGeometry& geometry, Index first,
                         Index second, Contact contact);

}  // namespace transformesh
