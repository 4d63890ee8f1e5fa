#include "tm/clean/intersect/contacts.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr Place outside = 255;

// One of the two faces together with what is known about it relative to the other.
struct Side {
  std::array<const Vec3*, 3> p{};
  std::array<int, 3> sign{};    // of each corner over the plane of the other face
  std::array<int, 3> shared{};  // the corner of the other face that is this point, or -1
};

Side make_side(const Soup& soup, Index face) {
  Side side;
  for (std::size_t i = 0; i < 3; ++i) side.p[i] = &soup.points[soup.faces[face][i]];
  side.shared.fill(-1);
  return side;
}

int match_shared_corners(const Face& f, const Face& g, Side& a, Side& b) {
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

void compute_signs(Side& a, const Side& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    a.sign[i] = a.shared[i] >= 0 ? 0 : orient3d(*b.p[0], *b.p[1], *b.p[2], *a.p[i]);
  }
}

// Whether the face can reach the other's plane beyond shared corners.
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

// The place on a triangle, given on which side of each of its edges a point lies.
Place place_by_edges(std::array<int, 3> turn) {
  const bool left = turn[0] > 0 || turn[1] > 0 || turn[2] > 0;
  const bool right = turn[0] < 0 || turn[1] < 0 || turn[2] < 0;
  if (left && right) return outside;
  for (Place k = 0; k < 3; ++k) {
    if (turn[k] == 0 && turn[(k + 2) % 3] == 0) return k;
  }
  for (Place k = 0; k < 3; ++k) {
    if (turn[k] == 0) return static_cast<Place>(3 + k);
  }
  return interior;
}

// Where the edge from corner i of a, which crosses the plane of b, passes b.
Place place_of_edge(const Side& a, std::size_t i, const Side& b) {
  std::array<int, 3> turn{};
  for (std::size_t k = 0; k < 3; ++k) {
    turn[k] = orient3d(*a.p[i], *a.p[(i + 1) % 3], *b.p[k], *b.p[(k + 1) % 3]);
  }
  return place_by_edges(turn);
}

// Where a point in the plane of b lies on b.
Place place_of_point(const Vec3& point, const Side& b, PlaneProjection projection) {
  std::array<int, 3> turn{};
  for (std::size_t k = 0; k < 3; ++k) {
    turn[k] = orient2d(*b.p[k], *b.p[(k + 1) % 3], point, projection);
  }
  return place_by_edges(turn);
}

void add(Contacts& result, Place first, Place second) {
  for (int i = 0; i < result.count; ++i) {
    const Contact& known = result.contacts[static_cast<std::size_t>(i)];
    if (known.first == first && known.second == second) return;
  }
  if (result.count < 4) result.contacts[static_cast<std::size_t>(result.count++)] = {first, second};
}

// Contacts of a's corners and edges with b. `swapped` tells that a is the second face.
void add_contacts(const Side& a, const Side& b, bool swapped, Contacts& result) {
  const auto record = [&](Place on_a, Place on_b) {
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
      record(static_cast<Place>(i), place_of_point(*a.p[i], b, projection));
    }
    if (a.sign[i] * a.sign[(i + 1) % 3] < 0) {
      record(static_cast<Place>(3 + i), place_of_edge(a, i, b));
    }
  }
}

bool edges_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, PlaneProjection p) {
  return orient2d(a, b, c, p) * orient2d(a, b, d, p) < 0 &&
         orient2d(c, d, a, p) * orient2d(c, d, b, p) < 0;
}

bool has_corner_in(const Side& a, const Side& b, PlaneProjection projection) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.shared[i] < 0 && place_of_point(*a.p[i], b, projection) != outside) return true;
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

}  // namespace

Contacts find_contacts(const Soup& soup, Index first, Index second) {
  Contacts result;
  Side a = make_side(soup, first);
  Side b = make_side(soup, second);
  const int shared = match_shared_corners(soup.faces[first], soup.faces[second], a, b);

  // Most neighbours and most faces whose boxes overlap part here.
  compute_signs(a, b);
  if (shared < 3 && !reaches_plane(a)) return result;
  if (a.sign == std::array<int, 3>{}) {
    result.coplanar = result.meet = coplanar_faces_meet(a, b, shared);
    return result;
  }
  compute_signs(b, a);
  if (!reaches_plane(b)) return result;

  // The common segment ends where an edge or a corner of one meets the other.
  add_contacts(a, b, false, result);
  add_contacts(b, a, true, result);
  if (!result.meet) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.shared[i] >= 0) add(result, static_cast<Place>(i), static_cast<Place>(a.shared[i]));
  }
  return result;
}

}  // namespace transformesh
