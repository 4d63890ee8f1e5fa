#include "tm/clean/rounding/face_cuts.h"

#include <algorithm>

#include "tm/clean/arrange/refine.h"
#include "tm/clean/rounding/face_splitter.h"
#include "tm/mesh/digits.h"

namespace transformesh {

FaceCuts::FaceCuts(Assembly& assembly, const WeldedMesh& welded, Scalar coordinate)
    : assembly_(assembly), welded_(welded), coordinate_(coordinate), points_(welded.points) {
  for (const Face& f : assembly.mesh.faces)
    corners_.push_back({welded.point_of[f[0]], welded.point_of[f[1]], welded.point_of[f[2]]});
}

Triangle FaceCuts::triangle(Index face) const { return triangle_of(points_, corners_[face]); }

void FaceCuts::add_on_edge(const PointPair& edge, double share, Index point) {
  on_edge_[edge].emplace(point, share);
}

void FaceCuts::add_inside(Index face, Index point) { inside_[face].insert(point); }

Index FaceCuts::point_between(const PointPair& first, const PointPair& second,
                              const Vec3& position) {
  const auto [entry, is_new] = between_.try_emplace(
      {std::min(first, second), std::max(first, second)}, static_cast<Index>(points_.size()));
  if (!is_new) return entry->second;
  points_.push_back(position);
  if (coordinate_ == Scalar::float32)
    for (double& x : points_.back()) x = round_to_single(x);
  return entry->second;
}

// The points of an edge with their shares, in order along it. The order must be the same for all
// faces of the edge.
std::vector<std::pair<double, Index>> FaceCuts::cuts_of(const PointPair& edge) const {
  std::vector<std::pair<double, Index>> cuts;
  const auto found = on_edge_.find(edge);
  if (found == on_edge_.end()) return cuts;
  for (const auto& [point, share] : found->second) cuts.emplace_back(share, point);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

std::vector<Index> FaceCuts::chain_of(const PointPair& edge) const {
  std::vector<Index> chain = {edge[0]};
  for (const auto& cut : cuts_of(edge)) chain.push_back(cut.second);
  chain.push_back(edge[1]);
  return chain;
}

std::set<Index> FaceCuts::points_on(Index face) const {
  std::set<Index> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Index> chain = chain_of(edge_of(corners_[face], i));
    points.insert(chain.begin(), chain.end());
  }
  const auto found = inside_.find(face);
  if (found != inside_.end()) points.insert(found->second.begin(), found->second.end());
  return points;
}

void FaceCuts::constrain(Index face, Index other) {
  const std::set<Index> points = points_on(face);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Index> chain = chain_of(edge_of(corners_[other], i));
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      if (points.contains(chain[k]) && points.contains(chain[k + 1]))
        constraints_[face].insert({chain[k], chain[k + 1]});
  }
}

// Whether the face has points. A face without area is split as well, as others have its edges; but
// not one that names a point twice, as its edges cancel out.
bool FaceCuts::is_split(Index face) const {
  if (is_collapsed(corners_[face])) return false;
  if (inside_.contains(face)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (on_edge_.contains(edge_of(corners_[face], i))) return true;
  return false;
}

std::vector<Face> FaceCuts::split(Index face, double distance) const {
  const Face& corners = corners_[face];
  FaceSplitter splitter(triangle(face), corners, distance);
  for (std::size_t i = 0; i < 3; ++i) {
    auto cuts = cuts_of(edge_of(corners, i));
    const bool is_up = corners[i] < corners[(i + 1) % 3];
    if (!is_up) std::reverse(cuts.begin(), cuts.end());
    for (const auto& [share, point] : cuts)
      splitter.add_on_edge(i, is_up ? share : 1 - share, point);
  }
  const auto inside = inside_.find(face);
  if (inside != inside_.end())
    for (const Index point : inside->second) splitter.add_inside(points_[point], point);
  const auto constraints = constraints_.find(face);
  if (constraints != constraints_.end())
    for (const auto& [from, to] : constraints->second) splitter.constrain(from, to);
  splitter.improve();
  return splitter.triangles();
}

// Appends the new points as vertices, with the columns of a face that they split. A point that no
// piece needs takes those of the first vertex.
void FaceCuts::add_vertices(const std::vector<Face>& pieces, const std::vector<Index>& rows) {
  Mesh& mesh = assembly_.mesh;
  std::vector<Index> face_at(points_.size(), no_index);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Index point : pieces[i]) face_at[point] = std::min(face_at[point], rows[i]);
  for (std::size_t p = welded_.points.size(); p < points_.size(); ++p) {
    mesh.positions.push_back(points_[p]);
    mesh.vertex_columns.append(face_at[p] == no_index ? RowBlend{}
                                                      : row_on_face(mesh, face_at[p], points_[p]));
    assembly_.vertex_is_new.push_back(1);
    assembly_.input_vertex.push_back(no_index);
  }
}

// Replaces the faces of the mesh. `rows` are the faces that they are or are cut from; those from
// `first_piece` on are new.
void FaceCuts::replace_faces(std::vector<Face> faces, const std::vector<Index>& rows,
                             std::size_t first_piece) {
  std::vector<Index> sources;
  std::vector<char> is_new;
  for (const Index row : rows) {
    sources.push_back(assembly_.source_face[row]);
    is_new.push_back(assembly_.face_is_new[row]);
  }
  std::fill(is_new.begin() + static_cast<std::ptrdiff_t>(first_piece), is_new.end(), 1);
  assembly_.mesh.faces = std::move(faces);
  assembly_.mesh.face_columns = assembly_.mesh.face_columns.select(rows);
  assembly_.source_face = std::move(sources);
  assembly_.face_is_new = std::move(is_new);
}

void FaceCuts::split_faces(double distance) {
  const Mesh& mesh = assembly_.mesh;
  std::vector<Face> faces, pieces;
  std::vector<Index> rows, piece_rows;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!is_split(f)) {
      faces.push_back(mesh.faces[f]);
      rows.push_back(f);
      continue;
    }
    for (const Face& piece : split(f, distance)) {
      pieces.push_back(piece);
      piece_rows.push_back(f);
    }
  }

  const auto first_new = static_cast<Index>(mesh.positions.size());
  const auto old_points = static_cast<Index>(welded_.points.size());
  add_vertices(pieces, piece_rows);
  for (Face& piece : pieces)
    for (Index& v : piece) v = v < old_points ? welded_.vertex_of[v] : first_new + (v - old_points);
  const std::size_t first_piece = faces.size();
  faces.insert(faces.end(), pieces.begin(), pieces.end());
  rows.insert(rows.end(), piece_rows.begin(), piece_rows.end());
  replace_faces(std::move(faces), rows, first_piece);
}

}  // namespace transformesh
