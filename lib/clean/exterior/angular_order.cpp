#include "clean/exterior/angular_order.h"

#include <algorithm>

namespace transformesh {
namespace {

// A face or piece at an edge, with the data for sorting it by angle. A rotation by 90 degrees about
// the edge maps the direction of each face, perpendicular to the edge, to the normal of the face.
// For backward halfedges, the normal is reversed. Hence the normals are sorted instead of the
// directions.
struct Spoke {
  Index face;  ///< face that contains the piece, or the face itself
  Triangle triangle;
  bool is_forward;
  Index halfedge;
  int sign;  ///< -1 if the normal of `triangle` has to be reversed, otherwise 1
  /// Angle from the first spoke, in half turns. 0: angle 0; 1: between 0 and 180 degrees; 2: 180
  /// degrees; 3: between 180 and 360 degrees.
  int half = 0;
};

// A coordinate (0 to 2) in which the ends of the edge differ, and the sign of the difference.
struct Axis {
  int coordinate;
  int direction;
};

// Returns the sign of the sine of the angle from spoke `a` to spoke `b` around the edge.
int sine_sign(const Spoke& a, const Spoke& b, Axis axis) {
  if (a.face == b.face) return 0;
  return normals_cross(a.triangle, b.triangle, axis.coordinate) * a.sign * b.sign * axis.direction;
}

int half_of(const Spoke& first, const Spoke& s, Axis axis) {
  const int sine = sine_sign(first, s, axis);
  if (sine != 0) return sine > 0 ? 1 : 3;
  const int cosine = first.face == s.face ? 1 : normals_dot(first.triangle, s.triangle);
  return cosine * first.sign * s.sign > 0 ? 0 : 2;
}

std::vector<Index> sort_spokes(std::vector<Spoke> spokes, Axis axis) {
  const Spoke first = spokes.front();
  for (Spoke& spoke : spokes) spoke.half = half_of(first, spoke, axis);
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
    if (a.half != b.half) return a.half < b.half;
    const int sine = a.half % 2 == 0 ? 0 : sine_sign(a, b, axis);
    if (sine != 0) return sine > 0;
    return a.is_forward != b.is_forward ? a.is_forward : a.halfedge < b.halfedge;
  });
  std::vector<Index> sorted;
  sorted.reserve(spokes.size());
  for (const Spoke& spoke : spokes) sorted.push_back(spoke.halfedge);
  return sorted;
}

Axis axis_between(const Arrangement& arrangement, Index u, Index v) {
  const ExactPoint from = arrangement.point(std::min(u, v));
  const ExactPoint to = arrangement.point(std::max(u, v));
  Axis axis{0, 0};
  (to.center - from.center).cwiseAbs().maxCoeff(&axis.coordinate);
  for (int i = 0; i < 3 && axis.direction == 0; ++i) {
    if (i > 0) axis.coordinate = (axis.coordinate + 1) % 3;
    axis.direction = arrangement.geometry().compare_coordinate(to, from, axis.coordinate);
  }
  return axis;
}

Axis axis_between(const Mesh& mesh, Index u, Index v) {
  const Vec3& from = mesh.positions[std::min(u, v)];
  const Vec3& to = mesh.positions[std::max(u, v)];
  Axis axis{0, 0};
  (to - from).cwiseAbs().maxCoeff(&axis.coordinate);
  axis.direction = to[axis.coordinate] > from[axis.coordinate] ? 1 : -1;
  return axis;
}

}  // namespace

Index halfedge_source(std::span<const Piece> pieces, Index h) {
  return pieces[h / 3].corners[h % 3];
}

Index halfedge_target(std::span<const Piece> pieces, Index h) {
  return pieces[h / 3].corners[(h % 3 + 1) % 3];
}

bool is_forward(std::span<const Piece> pieces, Index h) {
  return halfedge_source(pieces, h) < halfedge_target(pieces, h);
}

Edges piece_edges(const Arrangement& arrangement, const std::vector<char>& included) {
  std::vector<Face> faces(arrangement.pieces.size(), Face{0, 0, 0});
  for (std::size_t p = 0; p < faces.size(); ++p) {
    if (included[p]) faces[p] = arrangement.pieces[p].corners;
  }
  return {faces, arrangement.point_count()};
}

std::vector<Index> sort_around_edge(const Arrangement& arrangement,
                                    std::span<const Index> halfedges) {
  const auto& pieces = arrangement.pieces;
  std::vector<Spoke> spokes;
  for (const Index h : halfedges) {
    const PieceSource source = arrangement.sources_of(pieces[h / 3]).front();
    const bool forward = is_forward(pieces, h);
    spokes.push_back({source.face, arrangement.welded->triangle(source.face), forward, h,
                      forward == source.reversed ? -1 : 1});
  }
  const Index h = halfedges.front();
  return sort_spokes(std::move(spokes), axis_between(arrangement, halfedge_source(pieces, h),
                                                     halfedge_target(pieces, h)));
}

std::vector<Index> sort_around_edge(const Mesh& mesh, std::span<const Index> halfedges) {
  std::vector<Spoke> spokes;
  for (const Index h : halfedges) {
    const bool forward = is_forward(mesh.faces, h);
    spokes.push_back({h / 3, triangle_of(mesh, h / 3), forward, h, forward ? 1 : -1});
  }
  const Index h = halfedges.front();
  return sort_spokes(std::move(spokes),
                     axis_between(mesh, halfedge_source(mesh, h), halfedge_target(mesh, h)));
}

}  // namespace transformesh
