#include "geometry/section_svg.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "support/number.h"

namespace transformesh {
namespace {

using Vec2 = Eigen::Vector2d;
/// Width of the margin around the drawing, as a fraction of its larger side.
constexpr double margin = 0.02;

/// Axes of a drawing in a plane: x points to the right and y upwards. If the normal of the plane is
/// the z axis, these are the coordinate axes.
struct DrawingPlane {
  Vec3 right, up;

  explicit DrawingPlane(const Vec3& normal) {
    const Vec3 n = normal.stableNormalized();
    Eigen::Index axis = 0;
    n.cwiseAbs().maxCoeff(&axis);
    right = Vec3::Unit((axis + 1) % 3);
    right = (right - n.dot(right) * n).normalized();
    up = n.cross(right);
  }
  /// Returns the position of a point in the drawing. The y axis of SVG points downwards.
  Vec2 operator()(const Vec3& point) const { return {right.dot(point), -up.dot(point)}; }
};

std::string text_of(const Vec2& point) {
  return shortest_text(point.x()) + ' ' + shortest_text(point.y());
}

/// Joins segments to polylines. A segment is appended to the polyline that ends at its start.
std::vector<std::vector<Vec3>> chains_of(const std::vector<std::pair<Vec3, Vec3>>& segments) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::multimap<Vec3, std::size_t, decltype(less)> starts(less);
  for (std::size_t i = 0; i < segments.size(); ++i) starts.emplace(segments[i].first, i);
  std::vector<std::vector<Vec3>> chains;
  while (!starts.empty()) {
    auto next = starts.begin();
    std::vector<Vec3> chain{segments[next->second].first};
    while (next != starts.end()) {
      chain.push_back(segments[next->second].second);
      starts.erase(next);
      next = starts.find(chain.back());
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace

std::string section_svg(const std::vector<std::pair<Vec3, Vec3>>& segments, const Vec3& normal) {
  const DrawingPlane plane(normal);
  Eigen::AlignedBox2d box;
  std::string paths;
  for (const std::vector<Vec3>& chain : chains_of(segments)) {
    std::string path;
    const bool is_closed = chain.size() > 2 && chain.front() == chain.back();
    for (std::size_t i = 0; i + (is_closed ? 1 : 0) < chain.size(); ++i) {
      const Vec2 point = plane(chain[i]);
      box.extend(point);
      path += (i == 0 ? "M" : " L") + text_of(point);
    }
    paths += "<path d=\"" + path + (is_closed ? " Z" : "") + "\"/>\n";
  }
  if (box.isEmpty()) box.extend(Vec2::Zero());
  const double larger = (box.max() - box.min()).maxCoeff();
  const Vec2 room = Vec2::Constant(margin * larger);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + text_of(box.min() - room) + ' ' +
         text_of(box.max() - box.min() + 2 * room) +
         "\" fill=\"none\" stroke=\"black\" stroke-width=\"" + shortest_text(larger / 400) +
         "\">\n" + paths + "</svg>\n";
}

}  // namespace transformesh
