#include "remesh/guards/error_bound.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "remesh/halfedges/valences.h"

namespace transformesh {
namespace {

/// The allowed distance is reduced by this share of the largest coordinate. Closest points and the
/// cuts of triangle_cover.h have rounding errors of up to 1e-14 of that coordinate. Without the
/// reduction, a result could exceed the allowed distance by these errors.
constexpr double rounding_share = 1e-13;
/// Larger distances are replaced by this distance, so that their squares are finite.
constexpr double largest_distance = 1e150;
/// A patch may take least_cuts cuts of triangles, and cuts_per_face more for each face of the input
/// in gather(). The limit keeps the cost of a patch linear. With half of the cuts, noisy and folded
/// shapes keep 2 % more faces. With twice as many cuts, they keep 1 % fewer faces in the same time.
constexpr std::size_t least_cuts = 64;
constexpr std::size_t cuts_per_face = 8;
/// The limit on faces and on cuts for one face of the result when certified() measures the
/// distance.
constexpr std::size_t most_measured_faces = 4096;
/// certified() tries growing distances. The first distance is `first_share` of the error, and each
/// later distance is `growth` times as large.
constexpr double first_share = 1.0 / 1024;
constexpr double growth = 1.25;

std::vector<Index> opposites_of(const EditableMesh& mesh) {
  std::vector<Index> opposites(mesh.halfedge_slots());
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) opposites[h] = mesh.opposite(h);
  return opposites;
}

double largest_coordinate(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

ErrorBound::ErrorBound(const EditableMesh& mesh, const Mesh& input, double error)
    : mesh_(mesh),
      input_(input),
      input_query_(input),
      error_(error),
      distance_(std::min(error, largest_distance) - rounding_share * largest_coordinate(input)),
      links_(static_cast<Index>(input.faces.size())),
      projected_(input, opposites_of(mesh), has_high_valence(mesh)),
      nearest_(mesh.vertex_slots(), no_index),
      replaced_stamp_(input.faces.size(), 0),
      input_stamp_(input.faces.size(), 0),
      vertex_stamp_(input.positions.size(), 0),
      row_(input.positions.size(), 0) {
  for (Index v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.has_vertex(v)) nearest_[v] = mesh.outgoing(v) / 3;
  if (has_high_valence(mesh)) stars_.emplace(input, opposites_of(mesh));
}

ErrorBound::Stars::Stars(const Mesh& input, std::vector<Index> opposites)
    : mesh(Mesh{input.positions, input.faces, {}, {}}, std::move(opposites)), tree(mesh) {}

NearInput ErrorBound::near_input(double distance) const {
  return {input_, input_query_, stars_ ? &stars_->tree : nullptr, distance};
}

bool ErrorBound::allows(const Patch& patch) {
  const bool result = distance_ > 0 && keeps_bound(patch);
  refused_ += !result;
  return result;
}

bool ErrorBound::keeps_bound(const Patch& patch) {
  const NearInput input = near_input(distance_);
  nearest_center_ = input.nearest(patch.center_position, nearest_[patch.center]);
  if (nearest_center_ == no_index) return false;
  gather(patch);
  if (!find_close_witnesses()) return false;
  std::size_t cuts = least_cuts + cuts_per_face * inputs_.size();
  for (const Index face : open_inputs_)
    if (!find_witnesses(face, cuts)) return false;
  return is_near_input(patch);
}

/// Finds the faces of the input that lose witnesses, and the candidates for new witnesses.
/// Witnesses of an input face are faces of the result that together are near all of its points
/// (error_bound.h).
void ErrorBound::gather(const Patch& patch) {
  ++stamp_;
  inputs_.clear();
  candidates_.clear();
  distances_.clear();
  witnesses_.clear();
  open_inputs_.clear();
  for (const Index face : patch.replaced) {
    if (replaced_stamp_[face] == stamp_) continue;
    replaced_stamp_[face] = stamp_;
    links_.for_each_input(face, [&](Index input) {
      if (input_stamp_[input] == stamp_) return;
      input_stamp_[input] = stamp_;
      inputs_.push_back(input);
    });
  }
  made_ = patch.made.size();
  for (std::size_t i = 0; i < made_; ++i)
    candidates_.push_back({patch.spokes[i] / 3, NearTriangle(patch.made[i])});
  for (const Index spoke : patch.spokes) {
    const Index across = mesh_.opposite(next_halfedge(spoke));
    if (across == no_index || replaced_stamp_[across / 3] == stamp_) continue;
    candidates_.push_back({across / 3, NearTriangle(mesh_.triangle(across / 3))});
  }
}

/// Returns the squared distances of a vertex of the input from each new face. They are computed
/// once per patch.
const double* ErrorBound::distances_of(Index vertex) {
  if (vertex_stamp_[vertex] != stamp_) {
    vertex_stamp_[vertex] = stamp_;
    row_[vertex] = static_cast<Index>(distances_.size());
    for (std::size_t i = 0; i < made_; ++i)
      distances_.push_back(candidates_[i].triangle.squared_distance(input_.positions[vertex]));
  }
  return distances_.data() + row_[vertex];
}

CoverTriangle ErrorBound::corners_of(Index input) const {
  const Triangle triangle = triangle_of(input_, input);
  return {CoverCorner{triangle[0]}, CoverCorner{triangle[1]}, CoverCorner{triangle[2]}};
}

/// Finds the input faces that are near a single new face, by the distances of their corners.
/// Returns false if a corner is not near any face that may be a witness. Most refused patches are
/// refused here.
bool ErrorBound::find_close_witnesses() {
  for (const Index input : inputs_) {
    const Face& corners = input_.faces[input];
    // all rows are added first, because adding a row moves the other rows in memory
    for (const Index v : corners) distances_of(v);
    const double *a = distances_of(corners[0]), *b = distances_of(corners[1]),
                 *c = distances_of(corners[2]);
    Index best = no_index;
    double least = distance_ * distance_;
    for (Index i = 0; i < made_; ++i) {
      const double farthest = std::max({a[i], b[i], c[i]});
      if (!(best == no_index ? farthest <= least : farthest < least)) continue;
      best = i;
      least = farthest;
    }
    if (best != no_index) {
      witnesses_.push_back({input, candidates_[best].face});
    } else if (is_near_candidates(input)) {
      open_inputs_.push_back(input);
    } else {
      return false;
    }
  }
  return true;
}

bool ErrorBound::is_near_candidates(Index input) const {
  const double limit = distance_ * distance_;
  return std::all_of(input_.faces[input].begin(), input_.faces[input].end(), [&](Index vertex) {
    const auto row = distances_.begin() + row_[vertex];
    if (std::any_of(row, row + static_cast<std::ptrdiff_t>(made_),
                    [&](double squared) { return squared <= limit; }))
      return true;
    const Vec3& corner = input_.positions[vertex];
    bool is_near = false;
    links_.for_each_witness(input, [&](Index face) {
      is_near = is_near || (replaced_stamp_[face] != stamp_ &&
                            NearTriangle(mesh_.triangle(face)).squared_distance(corner) <= limit);
    });
    return is_near || std::any_of(candidates_.begin() + static_cast<std::ptrdiff_t>(made_),
                                  candidates_.end(), [&](const NearCandidate& candidate) {
                                    return candidate.triangle.squared_distance(corner) <= limit;
                                  });
  });
}

bool ErrorBound::find_witnesses(Index input, std::size_t& cuts) {
  const std::size_t around = candidates_.size();
  add_witness_candidates(input, candidates_);
  NearCandidates faces(candidates_, distance_ * distance_);
  TriangleCover<NearCandidates> cover(faces, cuts);
  const bool is_covered = cover.covers(corners_of(input));
  cuts = cover.cuts_left();
  for (const Index i : faces.used()) witnesses_.push_back({input, candidates_[i].face});
  candidates_.resize(around, candidates_.front());
  return is_covered;
}

/// Adds the witnesses of the input face that are not replaced and not yet among the candidates.
void ErrorBound::add_witness_candidates(Index input, Candidates& candidates) const {
  links_.for_each_witness(input, [&](Index face) {
    if (replaced_stamp_[face] == stamp_) return;
    if (std::none_of(candidates.begin(), candidates.end(),
                     [&](const NearCandidate& candidate) { return candidate.face == face; }))
      candidates.push_back({face, NearTriangle(mesh_.triangle(face))});
  });
}

/// True if all points of the new faces are within the allowed distance of the input. Vertices 2 i
/// and 2 i + 1 of the patch are corners of new face i.
bool ErrorBound::is_near_input(const Patch& patch) {
  NearInput input = near_input(distance_);
  const std::size_t most = least_cuts + cuts_per_face * inputs_.size();
  TriangleCover<NearInput> cover(input, most);
  for (std::size_t i = 0; i < made_; ++i) {
    const auto& [center, first, second] = patch.made[i];
    const Vec3 middle = (center + first + second) / 3;
    const Index seed = stars_ ? input.nearest(middle, nearest_center_)
                              : input_query_.face_within(middle, distance_, nearest_center_);
    if (seed == no_index) return false;
    if (projected_.covers(patch.made[i], seed, input.limit(), most)) continue;
    if (!cover.covers({CoverCorner{center, nearest_center_},
                       CoverCorner{first, nearest_[patch.vertices[2 * i]]},
                       CoverCorner{second, nearest_[patch.vertices[2 * i + 1]]}}))
      return false;
  }
  return true;
}

void ErrorBound::commit(const Patch& patch) {
  nearest_[patch.center] = nearest_center_;
  for (const Index input : inputs_) links_.clear(input);
  for (const Witness& witness : witnesses_) links_.add(witness.input, witness.face);
}

bool ErrorBound::covers_input(Index input, double distance) const {
  Candidates candidates;
  const auto add = [&](Index face) {
    if (std::none_of(candidates.begin(), candidates.end(),
                     [&](const NearCandidate& candidate) { return candidate.face == face; }))
      candidates.push_back({face, NearTriangle(mesh_.triangle(face))});
  };
  links_.for_each_witness(input, add);
  links_.for_each_witness(input, [&](Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      if (!mesh_.is_border(h)) add(mesh_.opposite(h) / 3);
  });
  NearCandidates faces(candidates, distance * distance);
  return TriangleCover<NearCandidates>(faces, least_cuts).covers(corners_of(input));
}

bool ErrorBound::covers_result(Index face, double distance) {
  NearInput input = near_input(distance);
  const Triangle triangle = mesh_.triangle(face);
  const Index nearest = input.nearest((triangle[0] + triangle[1] + triangle[2]) / 3,
                                      nearest_[mesh_.source(3 * face)]);
  if (nearest == no_index) return false;
  if (projected_.covers(triangle, nearest, input.limit(), most_measured_faces)) return true;
  CoverTriangle corners;
  for (Index i = 0; i < 3; ++i) corners[i] = {triangle[i], nearest_[mesh_.source(3 * face + i)]};
  return std::all_of(corners.begin(), corners.end(),
                     [&](const CoverCorner& corner) {
                       return corner.face != no_index &&
                              input.squared_distance(corner.point, corner.face) <= input.limit();
                     }) &&
         TriangleCover<NearInput>(input, most_measured_faces).covers(corners);
}

double ErrorBound::certified() {
  double distance = first_share * distance_;
  const auto raise_until = [&](const auto& is_covered) {
    while (distance < distance_ && !is_covered()) distance *= growth;
  };
  const NearInput all = near_input(distance_);
  for (Index v = 0; v < mesh_.vertex_slots(); ++v)
    if (mesh_.has_vertex(v)) nearest_[v] = all.nearest(mesh_.position(v), nearest_[v]);
  for (Index input = 0; input < input_.faces.size(); ++input)
    raise_until([&] { return covers_input(input, distance); });
  for (Index face = 0; face < mesh_.face_slots(); ++face)
    if (mesh_.has_face(face)) raise_until([&] { return covers_result(face, distance); });
  return distance < distance_ ? distance + (error_ - distance_) : error_;
}

}  // namespace transformesh
