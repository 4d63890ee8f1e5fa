#include "clean/arrange/unify_points.h"

#include <algorithm>
#include <numeric>

#include "clean/arrange/definition_table.h"

namespace transformesh {
namespace {

/// Points with distinct definitions (the mesh vertices, edges and faces that determine a point),
/// numbered in order of appearance.
class DefinedPoints {
 public:
  Index number(const ExactPoint& point) {
    const Index known = numbers_.find(point.definition);
    if (known != no_index) return known;
    points_.push_back(&point);
    numbers_.insert(point.definition, static_cast<Index>(points_.size() - 1));
    return static_cast<Index>(points_.size() - 1);
  }
  const std::vector<const ExactPoint*>& points() const { return points_; }

 private:
  DefinitionTable numbers_;
  std::vector<const ExactPoint*> points_;
};

/// Returns for each point the index of the first point that is equal to it.
std::vector<Index> find_equal_points(const WeldedMesh& welded,
                                     const std::vector<const ExactPoint*>& points) {
  const ExactGeometry geometry(welded.points, welded.faces);
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return geometry.compare(*points[a], *points[b]) < 0; });
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && geometry.compare(*points[order[i - 1]], *points[order[i]]) == 0;
    first[order[i]] = is_equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

UnifiedPoints unify_points(const WeldedMesh& welded, const std::vector<PlaneCut>& cuts) {
  UnifiedPoints result;
  DefinedPoints defined;
  for (const PlaneCut& cut : cuts) {
    std::vector<Index>& ids = result.ids.emplace_back();
    ids.reserve(cut.points.size());
    for (const ExactPoint& point : cut.points) {
      const bool is_given = point.definition.kind == ExactPoint::Kind::given;
      ids.push_back(is_given ? point.definition.indices[0] : defined.number(point));
    }
  }

  const std::vector<Index> first = find_equal_points(welded, defined.points());
  std::vector<Index> id_of(first.size());
  for (Index i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      id_of[i] = static_cast<Index>(welded.points.size() + result.cut_points.size());
      result.cut_points.push_back(*defined.points()[i]);
    } else {
      id_of[i] = id_of[first[i]];
    }
  }
  for (std::size_t plane = 0; plane < cuts.size(); ++plane) {
    for (std::size_t i = 0; i < cuts[plane].points.size(); ++i) {
      if (cuts[plane].points[i].definition.kind == ExactPoint::Kind::given) continue;
      Index& id = result.ids[plane][i];
      id = id_of[id];
    }
  }
  return result;
}

}  // namespace transformesh
