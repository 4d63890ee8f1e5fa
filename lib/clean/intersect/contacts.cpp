#include "clean/intersect/contacts.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Value for a point outside the face; 0 to 6 are the corners, edges and interior.
constexpr FaceSimplex outside = 255;

// One of the two tested faces, with the relations of its corners to the other tested face.
struct Side {
  std::array<const Vec3*, 3> p{};
  std::array<int, 3> sign{};  ///< side of each corner relative to the other face's plane
  /// For each corner: index of the equal corner of the other face, or -1.
  std::array<int, 3> shared{};
};

Side make_side(const WeldedMesh& welded, Index face) {
  Side side;
  for (std::size_t i = 0; i < 3; ++i) side.p[i] = &welded.points[welded.faces[face][i]];
  side.shared.fill(-1);
  return side;
}

Side make_side(const Triangle& triangle) {
  Side side;
  for (std::size_t i = 0; i < 3; ++i) side.p[i] = &triangle[i];
  side.shared.fill(-1);
  return side;
}

// Finds the equal corners of two faces, and stores them in `shared` of both sides. `Corners` holds
// point indices or coordinates. Returns the number of equal corners.
template <class Corners>
int match_shared_corners(const Corners& f, const Corners& g, Side& a, Side& b) {
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (f[i] != g[k]) continue;
      a.shared[i] = static_cast<int>(k);
      b.shared[k] = static_cast<int>(i);
      ++count;
    }
  }
  return count;
}

OrientedPlane plane_of(const Side& side) { return {*side.p[0], *side.p[1], *side.p[2]}; }

// Returns true if the floating-point filter proves that all corners that are not shared are on one
// side of the plane. Stores the signs that the filter computed.
bool lies_on_one_side(Side& a, const OrientedPlane& plane) {
  int common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.shared[i] >= 0) continue;
    a.sign[i] = plane.filtered_side_of(*a.p[i]);
    if (a.sign[i] == 0 || a.sign[i] == -common) return false;
    common = a.sign[i];
  }
  return true;
}

// Computes the signs that the filter left undecided, by the exact predicate.
void complete_signs(Side& a, const OrientedPlane& plane) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.shared[i] < 0 && a.sign[i] == 0) a.sign[i] = plane.side_of(*a.p[i]);
}

// True if the face meets the plane of the other face outside shared corners.
bool reaches_plane(const Side& a) {
  bool above = false;
  bool below = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.sign[i] == 0 && a.shared[i] < 0) return true;
    above |= a.sign[i] > 0;
    below |= a.sign[i] < 0;
  }
  return above && below;
}

// Returns the corner, edge or interior of a triangle that contains a point, or `outside`.
// side_of_edge(k) is the orientation of the point relative to edge `k`: +1, 0 or -1.
template <class SideOfEdge>
FaceSimplex simplex_by_sides(const SideOfEdge& side_of_edge) {
  std::array<int, 3> side{};
  int common = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = side_of_edge(k);
    if (side[k] == 0) continue;
    if (side[k] == -common) return outside;
    common = side[k];
  }
  for (FaceSimplex k = 0; k < 3; ++k) {
    if (side[k] == 0 && side[(k + 2) % 3] == 0) return k;
  }
  for (FaceSimplex k = 0; k < 3; ++k) {
    if (side[k] == 0) return static_cast<FaceSimplex>(3 + k);
  }
  return interior;
}

// Returns the corner, edge or interior of `b` that the edge from corner `i` of `a` intersects, or
// `outside`. The ends of the edge must be on different sides of the plane of `b`.
FaceSimplex simplex_at_edge(const Side& a, std::size_t i, const Side& b) {
  return simplex_by_sides([&](std::size_t k) {
    return orient3d(*a.p[i], *a.p[(i + 1) % 3], *b.p[k], *b.p[(k + 1) % 3]);
  });
}

// Returns the corner, edge or interior of `b` that contains a point in the plane of `b`, or
// `outside`.
FaceSimplex simplex_at_point(const Vec3& point, const Side& b, PlaneProjection projection) {
  return simplex_by_sides(
      [&](std::size_t k) { return orient2d(*b.p[k], *b.p[(k + 1) % 3], point, projection); });
}

void add(Contacts& result, FaceSimplex first, FaceSimplex second) {
  for (int i = 0; i < result.count; ++i) {
    const Contact& known = result.contacts[static_cast<std::size_t>(i)];
    if (known.first == first && known.second == second) return;
  }
  if (result.count < 4) result.contacts[static_cast<std::size_t>(result.count++)] = {first, second};
}

// Adds the contacts of the corners and edges of `a` with `b`. `swapped` is true if `a` is the
// second face of the result.
void add_contacts(const Side& a, const Side& b, bool swapped, Contacts& result) {
  const auto record = [&](FaceSimplex on_a, FaceSimplex on_b) {
    if (on_b == outside) return;
    result.meet = true;
    if (swapped) {
      add(result, on_b, on_a);
    } else {
      add(result, on_a, on_b);
    }
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.sign[i] == 0 && a.shared[i] < 0) {
      const PlaneProjection projection = projection_of({*b.p[0], *b.p[1], *b.p[2]});
      record(static_cast<FaceSimplex>(i), simplex_at_point(*a.p[i], b, projection));
    }
    if (a.sign[i] * a.sign[(i + 1) % 3] < 0) {
      record(static_cast<FaceSimplex>(3 + i), simplex_at_edge(a, i, b));
    }
  }
}

bool edges_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, PlaneProjection p) {
  const auto lie_apart = [p](const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) {
    const int side = orient2d(from, to, x, p);
    return side != 0 && orient2d(from, to, y, p) == -side;
  };
  return lie_apart(a, b, c, d) && lie_apart(c, d, a, b);
}

bool has_corner_in(const Side& a, const Side& b, PlaneProjection projection) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.shared[i] < 0 && simplex_at_point(*a.p[i], b, projection) != outside) return true;
  }
  return false;
}

bool coplanar_faces_meet(const Side& a, const Side& b, int shared) {
  if (shared == 3) return true;
  const PlaneProjection projection = projection_of({*b.p[0], *b.p[1], *b.p[2]});
  if (has_corner_in(a, b, projection) || has_corner_in(b, a, projection)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (edges_cross(*a.p[i], *a.p[(i + 1) % 3], *b.p[k], *b.p[(k + 1) % 3], projection)) {
        return true;
      }
    }
  }
  return false;
}

// Returns the end points of an edge of a face, with the smaller point index first. `simplex` is 3,
// 4 or 5.
std::array<Index, 2> edge_at(const WeldedMesh& welded, Index face, FaceSimplex simplex) {
  const Index u = welded.faces[face][simplex - 3U];
  const Index v = welded.faces[face][(simplex - 2U) % 3];
  return {std::min(u, v), std::max(u, v)};
}

// True if the bounding boxes of the faces overlap in doubles. The boxes of the hierarchy that
// proposed the pair are in floats, and overlap more often.
bool boxes_overlap(const Side& a, const Side& b) {
  for (int i = 0; i < 3; ++i) {
    const double a0 = (*a.p[0])[i], a1 = (*a.p[1])[i], a2 = (*a.p[2])[i];
    const double b0 = (*b.p[0])[i], b1 = (*b.p[1])[i], b2 = (*b.p[2])[i];
    if (std::max(std::max(a0, a1), a2) < std::min(std::min(b0, b1), b2)) return false;
    if (std::max(std::max(b0, b1), b2) < std::min(std::min(a0, a1), a2)) return false;
  }
  return true;
}

Contacts contacts_of(Side& a, Side& b, int shared) {
  Contacts result;
  if (shared == 0 && !boxes_overlap(a, b)) return result;

  // The floating-point filter decides most pairs of neighbors and most pairs whose boxes overlap.
  const OrientedPlane plane_b = plane_of(b);
  if (shared < 3 && lies_on_one_side(a, plane_b)) return result;
  const OrientedPlane plane_a = plane_of(a);
  if (shared < 3 && lies_on_one_side(b, plane_a)) return result;

  complete_signs(a, plane_b);
  if (shared < 3 && !reaches_plane(a)) return result;
  if (a.sign == std::array<int, 3>{}) {
    result.coplanar = result.meet = coplanar_faces_meet(a, b, shared);
    return result;
  }
  complete_signs(b, plane_a);
  if (!reaches_plane(b)) return result;

  // The ends of the common segment are contacts of an edge or a corner of one face with the other
  // face.
  add_contacts(a, b, false, result);
  add_contacts(b, a, true, result);
  if (!result.meet) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.first_sides[i] = static_cast<std::int8_t>(a.sign[i]);
    result.second_sides[i] = static_cast<std::int8_t>(b.sign[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.shared[i] >= 0)
      add(result, static_cast<FaceSimplex>(i), static_cast<FaceSimplex>(a.shared[i]));
  }
  return result;
}

}  // namespace

Contacts find_contacts(const WeldedMesh& welded, Index first, Index second) {
  Side a = make_side(welded, first);
  Side b = make_side(welded, second);
  const int shared = match_shared_corners(welded.faces[first], welded.faces[second], a, b);
  return contacts_of(a, b, shared);
}

bool triangles_meet(const Triangle& first, const Triangle& second) {
  if (collinear(first[0], first[1], first[2]) || collinear(second[0], second[1], second[2]))
    return false;
  Side a = make_side(first);
  Side b = make_side(second);
  const int shared = match_shared_corners(first, second, a, b);
  return contacts_of(a, b, shared).meet;
}

PointDefinition contact_definition(const WeldedMesh& welded, Index first, Index second,
                                   Contact contact) {
  if (contact.first < 3) return PointDefinition::given(welded.faces[first][contact.first]);
  if (contact.second < 3) return PointDefinition::given(welded.faces[second][contact.second]);
  if (contact.second == interior) {
    const auto [u, v] = edge_at(welded, first, contact.first);
    return PointDefinition::line_plane(u, v, second);
  }
  const auto [x, y] = edge_at(welded, second, contact.second);
  if (contact.first == interior) return PointDefinition::line_plane(x, y, first);
  const auto [u, v] = edge_at(welded, first, contact.first);
  return PointDefinition::line_line(u, v, x, y);
}

ExactPoint contact_point(const WeldedMesh& welded, const ExactGeometry& geometry, Index first,
                         Index second, Contact contact) {
  return geometry.point(contact_definition(welded, first, second, contact));
}

}  // namespace transformesh
