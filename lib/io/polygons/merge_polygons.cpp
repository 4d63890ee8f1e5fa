#include "io/polygons/merge_polygons.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "mesh/surface_columns.h"

namespace transformesh {
namespace {

using Halfedge = std::pair<Index, Index>;

/// Returns the boundary vertices of adjacent triangles in order, starting at the first corner of
/// the first triangle. Returns nothing if the boundary has several loops, or if a loop visits a
/// vertex twice.
std::vector<Index> outline_of(std::span<const Face> triangles) {
  std::set<Halfedge> border;
  for (const Face& face : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge halfedge(face[i], face[(i + 1) % 3]);
      if (border.erase({halfedge.second, halfedge.first}) > 0) continue;
      if (!border.insert(halfedge).second) return {};
    }
  std::map<Index, Index> next;
  for (const auto& [from, to] : border)
    if (!next.emplace(from, to).second) return {};
  std::vector<Index> outline;
  const Index start = triangles.front()[0];
  Index at = start;
  do {
    const auto step = next.find(at);
    if (step == next.end() || outline.size() == next.size()) return {};
    outline.push_back(at);
    at = step->second;
  } while (at != start);
  return outline.size() == next.size() ? outline : std::vector<Index>();
}

/// A face of the written file: the triangles that it replaces, and its vertices in order.
struct Row {
  std::vector<Index> faces;
  std::vector<Index> outline;
};

class Merger {
 public:
  explicit Merger(const Document& document) : document_(document), mesh_(document.mesh) {}
  MergedPolygons merge();

 private:
  void add_triangle(Index face) {
    const auto& [a, b, c] = mesh_.faces[face];
    rows_.push_back({{face}, {a, b, c}});
  }
  void add_polygon(std::vector<Index> faces);
  void find_rows();
  Column outlines() const;
  Column merged_list(const Column& column) const;

  const Document& document_;
  const Mesh& mesh_;
  std::vector<Row> rows_;
  std::size_t unmerged_ = 0;
};

void Merger::add_polygon(std::vector<Index> faces) {
  std::vector<Face> triangles;
  triangles.reserve(faces.size());
  for (const Index face : faces) triangles.push_back(mesh_.faces[face]);
  std::vector<Index> outline = outline_of(triangles);
  if (!outline.empty()) return rows_.push_back({std::move(faces), std::move(outline)});
  for (const Index face : faces) add_triangle(face);
  ++unmerged_;
}

// Lists the faces to write, in the order of the triangles. A polygon takes the place of its first
// triangle.
void Merger::find_rows() {
  const std::vector<double>& numbers = mesh_.face_columns.find(polygon_column)->values;
  std::map<double, std::vector<Index>> polygons;
  for (Index f = 0; f < mesh_.faces.size(); ++f)
    if (numbers[f] > 0) polygons[numbers[f]].push_back(f);
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    if (!(numbers[f] > 0)) {
      add_triangle(f);
    } else if (auto& faces = polygons[numbers[f]]; !faces.empty()) {
      add_polygon(std::exchange(faces, {}));
    }
  }
}

Column Merger::outlines() const {
  Column column{"", Scalar::uint32, {}, document_.style.face_list_count, {0}};
  for (const Row& row : rows_) {
    column.values.insert(column.values.end(), row.outline.begin(), row.outline.end());
    column.list_offsets.push_back(column.values.size());
  }
  return column;
}

/// Merges a list column with values for the corners of triangles. The list of each polygon has the
/// values of the polygon's corners.
Column Merger::merged_list(const Column& column) const {
  Column merged{column.name, column.type, {}, column.list_count_type, {0}};
  for (const Row& row : rows_) {
    std::map<Index, std::pair<std::size_t, std::size_t>> of_vertex;
    for (const Index face : row.faces) {
      const std::size_t first = column.list_offsets[face];
      const std::size_t width = (column.list_offsets[face + 1] - first) / 3;
      for (std::size_t i = 0; i < 3; ++i)
        of_vertex.emplace(mesh_.faces[face][i], std::pair(first + i * width, width));
    }
    for (const Index vertex : row.outline) {
      const auto& [first, width] = of_vertex.at(vertex);
      const auto from = column.values.begin() + static_cast<std::ptrdiff_t>(first);
      merged.values.insert(merged.values.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
    merged.list_offsets.push_back(merged.values.size());
  }
  return merged;
}

MergedPolygons Merger::merge() {
  find_rows();
  std::vector<Index> first_faces;
  for (const Row& row : rows_) first_faces.push_back(row.faces.front());
  MergedPolygons result{document_, outlines(), unmerged_};
  Mesh& mesh = result.document.mesh;
  mesh.faces.clear();
  for (const Index face : first_faces) mesh.faces.push_back(mesh_.faces[face]);
  mesh.face_columns = mesh_.face_columns.select(first_faces);
  for (std::size_t i = 0; i < mesh.face_columns.columns.size(); ++i)
    if (is_corner_list(mesh_.face_columns.columns[i]))
      mesh.face_columns.columns[i] = merged_list(mesh_.face_columns.columns[i]);
  mesh.face_columns.erase(polygon_column);
  return result;
}

}  // namespace

MergedPolygons merge_polygons(const Document& document) { return Merger(document).merge(); }

PolygonCount count_polygons(const Columns& face_columns) {
  PolygonCount count;
  const Column* numbers = face_columns.find(polygon_column);
  if (numbers == nullptr || numbers->list_count_type) return count;
  std::set<double> polygons;
  for (const double number : numbers->values) {
    if (!(number > 0)) continue;
    polygons.insert(number);
    ++count.triangles;
  }
  count.polygons = polygons.size();
  return count;
}

}  // namespace transformesh
