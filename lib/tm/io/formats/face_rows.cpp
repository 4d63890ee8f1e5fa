#include "tm/io/formats/face_rows.h"

#include <algorithm>

#include "tm/io/formats/finite_values.h"
#include "tm/io/polygons/triangulate_polygon.h"
#include "tm/mesh/surface_columns.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh {

struct FaceRows::Cut {
  PolygonTriangles result;
  bool is_finite = true;
};

void FaceRows::add(std::span<const Index> corners) {
  if (corners.size() == 3) return add(Face{corners[0], corners[1], corners[2]});
  polygons_.push_back({rows_, corners_.size()});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  ++rows_;
}

void FaceRows::move_into(Mesh& mesh, const std::string& format, std::vector<std::string>& notes,
                         std::uint32_t first_number) {
  std::size_t dropped = 0;
  if (polygons_.empty()) {
    mesh.faces = std::move(triangles_);
  } else {
    const std::vector<Cut> cuts = cut_polygons(mesh);
    put_together(mesh, cuts);
    add_notes(cuts, format, notes, first_number);
    dropped = static_cast<std::size_t>(
        std::count_if(cuts.begin(), cuts.end(), [](const Cut& cut) { return !cut.is_finite; }));
  }
  if (mesh.faces.size() >= no_index / 3)
    throw InputError(format + ": more triangles than 32 bits can count");
  drop_points_not_finite(mesh, dropped, format, notes);
}

std::span<const Index> FaceRows::corners_of(std::size_t polygon) const {
  const std::size_t first = polygons_[polygon].first;
  const std::size_t last =
      polygon + 1 < polygons_.size() ? polygons_[polygon + 1].first : corners_.size();
  return std::span(corners_).subspan(first, last - first);
}

std::vector<FaceRows::Cut> FaceRows::cut_polygons(const Mesh& mesh) const {
  constexpr std::size_t grain = 256;
  std::vector<Cut> cuts(polygons_.size());
  parallel_for(polygons_.size(), grain, [&](std::size_t first, std::size_t last) {
    std::vector<Vec3> positions;
    for (std::size_t i = first; i < last; ++i) {
      const std::span<const Index> corners = corners_of(i);
      positions.clear();
      for (const Index corner : corners) positions.push_back(mesh.positions[corner]);
      cuts[i].is_finite = std::all_of(positions.begin(), positions.end(),
                                      [](const Vec3& position) { return position.allFinite(); });
      if (cuts[i].is_finite) cuts[i].result = triangulate_polygon(positions, corners);
    }
  });
  return cuts;
}

void FaceRows::put_together(Mesh& mesh, const std::vector<Cut>& cuts) const {
  std::vector<std::uint32_t> source;
  std::vector<PolygonTriangle> cut_from;
  const auto add_face = [&](const Face& face, const PolygonTriangle& from) {
    mesh.faces.push_back(face);
    source.push_back(from.row);
    cut_from.push_back(from);
  };
  std::size_t triangle = 0, polygon = 0;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    if (polygon == polygons_.size() || polygons_[polygon].row != row) {
      add_face(triangles_[triangle++], {row, 3, {0, 1, 2}});
      continue;
    }
    const std::span<const Index> corners = corners_of(polygon);
    for (const CornerTriangle& cut : cuts[polygon].result.triangles)
      add_face({corners[cut[0]], corners[cut[1]], corners[cut[2]]},
               {row, static_cast<std::uint32_t>(corners.size()), cut});
    ++polygon;
  }
  mesh.face_columns = mesh.face_columns.select(source);
  split_corner_lists(mesh.face_columns, cut_from);
}

void FaceRows::add_notes(const std::vector<Cut>& cuts, const std::string& format,
                         std::vector<std::string>& notes, std::uint32_t first_number) const {
  std::size_t polygons = 0, triangles = 0, folded = 0, small = 0;
  std::uint32_t first_folded = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const bool is_polygon = corners_of(i).size() > 3;
    is_polygon ? ++polygons : ++small;
    triangles += cuts[i].result.triangles.size();
    if (cuts[i].result.folds > 0 && folded++ == 0) first_folded = polygons_[i].row + first_number;
  }
  if (polygons > 0)
    notes.push_back(format + ": " + counted(polygons, "polygon") + " cut into " +
                    counted(triangles, "triangle"));
  if (folded > 0)
    notes.push_back(format + ": " + counted(folded, "polygon") +
                    " cut with folds, as the outline crosses itself; the first is face " +
                    std::to_string(first_folded));
  if (small > 0)
    notes.push_back(format + ": " + counted(small, "face") +
                    " with fewer than three corners dropped");
}

}  // namespace transformesh
