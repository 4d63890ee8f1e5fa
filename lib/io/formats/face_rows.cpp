#include "io/formats/face_rows.h"

#include <algorithm>
#include <utility>

#include "io/formats/finite_values.h"
#include "io/polygons/merge_polygons.h"
#include "io/polygons/triangulate_polygon.h"
#include "mesh/index_limits.h"
#include "mesh/surface_columns.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {

/// Results of triangulating polygons. Most polygons become triangle fans, for which one byte is
/// stored.
struct FaceRows::Cuts {
  enum class Kind : std::uint8_t { fan, not_finite, other };

  std::vector<Kind> kinds;  ///< result for each polygon: fan, not finite, or other
  /// Indices of the polygons whose kind is `other`: neither fans nor non-finite.
  std::vector<std::size_t> numbers;
  std::vector<PolygonTriangles> results;  ///< triangles of the polygons in `numbers`
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
    const Cuts cuts = cut_polygons(mesh);
    put_together(mesh, cuts);
    if (keeps_polygons_) number_polygons(mesh, cuts);
    add_notes(cuts, mesh.faces.size(), format, notes, first_number);
    dropped = static_cast<std::size_t>(
        std::count(cuts.kinds.begin(), cuts.kinds.end(), Cuts::Kind::not_finite));
  }
  if (mesh.faces.size() >= no_index / 3) throw InputError(format + ": " + too_many_triangles);
  drop_points_not_finite(mesh, dropped, format, notes);
}

std::span<const Index> FaceRows::corners_of(std::size_t polygon) const {
  const std::size_t first = polygons_[polygon].first;
  const std::size_t last =
      polygon + 1 < polygons_.size() ? polygons_[polygon + 1].first : corners_.size();
  return std::span(corners_).subspan(first, last - first);
}

FaceRows::Cuts FaceRows::cut_polygons(const Mesh& mesh) const {
  const auto positions_of = [&](std::size_t polygon, std::vector<Vec3>& positions) {
    positions.clear();
    for (const Index corner : corners_of(polygon)) positions.push_back(mesh.positions[corner]);
  };
  const auto is_finite = [](const Vec3& position) { return position.allFinite(); };
  Cuts cuts;
  cuts.kinds.resize(polygons_.size());
  parallel_for(polygons_.size(), 4096, [&](std::size_t first, std::size_t last) {
    std::vector<Vec3> positions;
    for (std::size_t i = first; i < last; ++i) {
      positions_of(i, positions);
      cuts.kinds[i] = !std::all_of(positions.begin(), positions.end(), is_finite)
                          ? Cuts::Kind::not_finite
                      : is_unfolded_fan(positions) ? Cuts::Kind::fan
                                                   : Cuts::Kind::other;
    }
  });
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    if (cuts.kinds[i] == Cuts::Kind::other) cuts.numbers.push_back(i);
  cuts.results.resize(cuts.numbers.size());
  parallel_for(cuts.numbers.size(), 64, [&](std::size_t first, std::size_t last) {
    std::vector<Vec3> positions;
    for (std::size_t i = first; i < last; ++i) {
      positions_of(cuts.numbers[i], positions);
      cuts.results[i] = triangulate_polygon(positions, corners_of(cuts.numbers[i]));
    }
  });
  return cuts;
}

template <class Add>
void FaceRows::for_each_triangle(const Cuts& cuts, const Add& add) const {
  std::size_t triangle = 0, polygon = 0, other = 0;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    if (polygon == polygons_.size() || polygons_[polygon].row != row) {
      add(triangles_[triangle++], PolygonTriangle{row, 3, {0, 1, 2}});
      continue;
    }
    const std::span<const Index> corners = corners_of(polygon);
    const auto size = static_cast<std::uint32_t>(corners.size());
    const auto add_cut = [&](const CornerTriangle& cut) {
      add(Face{corners[cut[0]], corners[cut[1]], corners[cut[2]]}, PolygonTriangle{row, size, cut});
    };
    const Cuts::Kind kind = cuts.kinds[polygon++];
    if (kind == Cuts::Kind::fan)
      for (std::uint32_t i = 2; i < size; ++i) add_cut({0, i - 1, i});
    if (kind == Cuts::Kind::other)
      for (const CornerTriangle& cut : cuts.results[other++].triangles) add_cut(cut);
  }
}

void FaceRows::put_together(Mesh& mesh, const Cuts& cuts) const {
  std::vector<std::uint32_t> rows;
  mesh.faces.reserve(triangles_.size() + corners_.size() -
                     std::min(corners_.size(), 2 * polygons_.size()));
  rows.reserve(mesh.faces.capacity());
  for_each_triangle(cuts, [&](const Face& face, const PolygonTriangle& from) {
    mesh.faces.push_back(face);
    rows.push_back(from.row);
  });
  mesh.face_columns = mesh.face_columns.select(rows);
  std::vector<Column>& columns = mesh.face_columns.columns;
  if (std::none_of(columns.begin(), columns.end(), is_corner_list)) return;
  std::vector<PolygonTriangle> sources;
  sources.reserve(rows.size());
  for_each_triangle(cuts,
                    [&](const Face&, const PolygonTriangle& from) { sources.push_back(from); });
  split_corner_lists(mesh.face_columns, sources);
}

void FaceRows::number_polygons(Mesh& mesh, const Cuts& cuts) const {
  Column& numbers = mesh.face_columns.get(polygon_column, Scalar::uint32, mesh.faces.size());
  std::size_t face = 0, polygon = 0;
  std::uint32_t row = no_index;
  for_each_triangle(cuts, [&](const Face&, const PolygonTriangle& from) {
    if (from.size > 3 && std::exchange(row, from.row) != from.row) ++polygon;
    numbers.values[face++] = from.size > 3 ? static_cast<double>(polygon) : 0;
  });
}

void FaceRows::add_notes(const Cuts& cuts, std::size_t faces, const std::string& format,
                         std::vector<std::string>& notes, std::uint32_t first_number) const {
  std::size_t small = 0, folded = 0, empty = 0;
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    if (corners_of(i).size() < 3) ++small;
  std::uint32_t first_folded = 0;
  for (std::size_t i = 0; i < cuts.results.size(); ++i) {
    const bool is_large = corners_of(cuts.numbers[i]).size() >= 3;
    if (is_large && cuts.results[i].triangles.empty()) ++empty;
    if (cuts.results[i].folds > 0 && folded++ == 0)
      first_folded = polygons_[cuts.numbers[i]].row + first_number;
  }
  if (polygons_.size() > small + empty && !keeps_polygons_)
    notes.push_back(format + ": " + counted(polygons_.size() - small - empty, "polygon") +
                    " cut into " + counted(faces - triangles_.size(), "triangle"));
  if (folded > 0)
    notes.push_back(format + ": " + counted(folded, "polygon") +
                    " cut into triangles that fold over, because the outline intersects itself; "
                    "the first is face " +
                    std::to_string(first_folded));
  if (empty > 0)
    notes.push_back(format + ": " + counted(empty, "polygon") +
                    " dropped, as the outline runs back along itself");
  if (small > 0)
    notes.push_back(format + ": " + counted(small, "face") +
                    " with fewer than three corners dropped");
}

}  // namespace transformesh
