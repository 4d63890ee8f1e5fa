#include "clean/open/border_strips.h"

#include <algorithm>

#include "clean/exterior/angular_order.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/corners.h"

namespace transformesh {
namespace {

/// Largest distance of a strip's corners from the border edge, in spacings. Cutting by a plane
/// moves vertices by up to one spacing. The border moves farther where the surface is nearly
/// parallel to the plane. docs/design/open-meshes.md has results for other values.
constexpr double strip_spacings = 16;

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 way = point - a;
  const double length = (b - a).stableNorm();
  if (length == 0) return way.stableNorm();
  const Vec3 direction = (b - a) / length;
  return (way - std::clamp(way.dot(direction), 0.0, length) * direction).stableNorm();
}

class StripFinder {
 public:
  StripFinder(const Arrangement& arrangement, const Edges& edges, Scalar coordinate,
              std::vector<Index>& connected)
      : arrangement_(arrangement),
        edges_(edges),
        coordinate_(coordinate),
        connected_(connected),
        is_strip_(arrangement.pieces.size(), 0) {}

  std::vector<StripSide> run() {
    std::vector<char> is_border_point(arrangement_.point_count(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto halfedges = edges_.halfedges(e);
      if (halfedges.size() != 1) continue;
      const Index h = halfedges.front();
      is_border_point[source(h)] = is_border_point[target(h)] = 1;
      grow(h);
    }
    disconnect_strips();
    for (Index h = 3 * arrangement_.whole_pieces; h < connected_.size(); ++h)
      if (connected_[h] != no_index && is_border_point[target(h)] && is_short(h)) disconnect(h);
    return std::move(sides_);
  }

 private:
  Index source(Index h) const { return halfedge_source(arrangement_.pieces, h); }
  Index target(Index h) const { return halfedge_target(arrangement_.pieces, h); }
  const Vec3& at(Index point) const { return arrangement_.position(point); }
  double tolerance_at(Index point) const {
    return strip_spacings * spacing_around(at(point), coordinate_);
  }
  bool is_short(Index h) const {
    return (at(target(h)) - at(source(h))).stableNorm() <= tolerance_at(target(h));
  }

  // Takes the pieces beside a border halfedge that are near its edge.
  void grow(Index border) {
    const Vec3 &a = at(source(border)), &b = at(target(border));
    std::vector<Index> entered{border};
    while (!entered.empty()) {
      const Index h = entered.back();
      entered.pop_back();
      const Index piece = h / 3, apex = target(next_edge(h));
      if (piece < arrangement_.whole_pieces || is_strip_[piece]) continue;
      if (!arrangement_.pieces[piece].is_open) continue;
      if (!(distance_to_segment(at(apex), a, b) <= tolerance_at(apex))) continue;
      is_strip_[piece] = 1;
      for (const Index side : {next_edge(h), previous_edge(h)})
        if (connected_[side] != no_index) entered.push_back(connected_[side]);
    }
  }

  void disconnect_strips() {
    for (Index h = 0; h < connected_.size(); ++h) {
      if (connected_[h] == no_index || !is_strip_[h / 3]) continue;
      const Index beside = connected_[h] / 3;
      if (is_strip_[beside]) continue;
      sides_.push_back({h / 3, beside});
      disconnect(h);
    }
  }

  void disconnect(Index h) {
    const Index other = connected_[h];
    connected_[h] = connected_[other] = no_index;
  }

  const Arrangement& arrangement_;
  const Edges& edges_;
  Scalar coordinate_;
  std::vector<Index>& connected_;
  std::vector<char> is_strip_;  ///< 1 for each piece of a strip
  std::vector<StripSide> sides_;
};

}  // namespace

std::vector<StripSide> disconnect_border_strips(const Arrangement& arrangement, const Edges& edges,
                                                Scalar coordinate, std::vector<Index>& connected) {
  return StripFinder(arrangement, edges, coordinate, connected).run();
}

}  // namespace transformesh
