#include "tm/clean/angular_order.h"

#include <algorithm>

namespace transformesh {
namespace {

Index smaller_end(const std::vector<Piece>& pieces, Index h) {
  return std::min(halfedge_source(pieces, h), halfedge_target(pieces, h));
}

Index larger_end(const std::vector<Piece>& pieces, Index h) {
  return std::max(halfedge_source(pieces, h), halfedge_target(pieces, h));
}

// Angles around one edge by exact signs of the faces' normals: an inward direction and the normal
// of the piece (turned about for backward halfedges) differ by a right angle, the same for all.
class AngleOrder {
 public:
  AngleOrder(const Arrangement& arrangement, Index first_halfedge)
      : arrangement_(arrangement), first_(spoke(first_halfedge)) {
    const Index u = smaller_end(arrangement.pieces, first_halfedge);
    const Index v = larger_end(arrangement.pieces, first_halfedge);
    const ExactPoint from = arrangement.point(u);
    const ExactPoint to = arrangement.point(v);
    const Vec3 along = (to.center - from.center).cwiseAbs();
    along.maxCoeff(&coordinate_);
    for (int i = 0; i < 3 && direction_ == 0; ++i) {
      if (i > 0) coordinate_ = (coordinate_ + 1) % 3;
      direction_ = arrangement.geometry().compare_coordinate(to, from, coordinate_);
    }
  }

  struct Spoke {
    Triangle triangle;
    int sign;      ///< of the turned normal relative to the triangle's
    int half = 0;  ///< 0 at the first spoke, 1 before the opposite direction, 2 there, 3 after
  };

  Spoke spoke(Index h) const {
    const Piece& piece = arrangement_.pieces[h / 3];
    const Source source = arrangement_.sources_of(piece).front();
    const bool turned = source.reversed == is_forward(arrangement_.pieces, h);
    return {arrangement_.soup->triangle(source.face), turned ? -1 : 1};
  }

  // The sign of the sine of the angle from one spoke to the other.
  int turn(const Spoke& a, const Spoke& b) const {
    return normals_cross(a.triangle, b.triangle, coordinate_) * a.sign * b.sign * direction_;
  }

  int half(const Spoke& s) const {
    const int sine = turn(first_, s);
    if (sine != 0) return sine > 0 ? 1 : 3;
    return normals_dot(first_.triangle, s.triangle) * first_.sign * s.sign > 0 ? 0 : 2;
  }

 private:
  const Arrangement& arrangement_;
  Spoke first_;
  int coordinate_ = 0;
  int direction_ = 0;
};

}  // namespace

Index halfedge_source(const std::vector<Piece>& pieces, Index h) {
  return pieces[h / 3].corners[h % 3];
}

Index halfedge_target(const std::vector<Piece>& pieces, Index h) {
  return pieces[h / 3].corners[(h % 3 + 1) % 3];
}

bool is_forward(const std::vector<Piece>& pieces, Index h) {
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
  const AngleOrder order(arrangement, halfedges.front());
  std::vector<std::pair<AngleOrder::Spoke, Index>> spokes;
  for (const Index h : halfedges) {
    spokes.emplace_back(order.spoke(h), h);
    spokes.back().first.half = order.half(spokes.back().first);
  }
  std::sort(spokes.begin(), spokes.end(), [&](const auto& a, const auto& b) {
    if (a.first.half != b.first.half) return a.first.half < b.first.half;
    return order.turn(a.first, b.first) > 0;
  });
  std::vector<Index> sorted;
  for (const auto& [spoke, h] : spokes) sorted.push_back(h);
  return sorted;
}

}  // namespace transformesh
