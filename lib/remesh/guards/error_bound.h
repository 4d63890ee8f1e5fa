/// Keeps a surface within a distance of its input, in both directions, while patches of it are
/// replaced.
///
/// Both directions are certified by triangle_cover.h. Each face of the input has witnesses
/// (witness_links.h): faces of the result such that each point of the input face is within the
/// distance of one of them. A patch is allowed under two conditions. Each input face that loses a
/// witness must get new witnesses. These are new faces, faces around new faces, and remaining
/// witnesses. Each new face must be within the distance of faces of the input. Errors therefore do
/// not accumulate, and the bound holds after each step. A certificate is not always found, so a
/// patch that keeps the bound may be refused. See docs/design/decimation-error.md. Reference:
/// Cohen, Varshney, Manocha, Turk, Weber, Agarwal, Brooks & Wright, "Simplification envelopes",
/// SIGGRAPH 1996, for the bound in both directions. Witnesses replace the envelopes of that paper.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "remesh/guards/embedding_guard.h"
#include "remesh/guards/near_faces.h"
#include "remesh/guards/projected_faces.h"
#include "remesh/guards/witness_links.h"

namespace transformesh {

class ErrorBound {
 public:
  /// `mesh` must equal `input`. Keeps references to both. Afterwards faces of the mesh may be
  /// replaced only by allowed patches.
  ErrorBound(const EditableMesh& mesh, const Mesh& input, double error);

  /// True if the patch certainly keeps the bound. Needs Patch::spokes.
  bool allows(const Patch& patch);
  /// Call after the mesh was changed by the last allowed patch.
  void commit(const Patch& patch);
  std::size_t refused() const { return refused_; }
  /// Returns a certified upper bound of the distance between both surfaces. It is at most the error
  /// that the constructor allowed.
  double certified();

 private:
  using Candidates = std::vector<NearCandidate>;
  /// A face of the input, and a face of the result that becomes its witness.
  struct Witness {
    Index input, face;
  };

  /// Faces of an input with vertices of high valence, at which `input_query_` is slow.
  struct Stars {
    Stars(const Mesh& input, std::vector<Index> opposites);
    EditableMesh mesh;
    FaceTree tree;
  };

  NearInput near_input(double distance) const;
  bool keeps_bound(const Patch& patch);
  bool is_near_input(const Patch& patch);
  void gather(const Patch& patch);
  bool find_close_witnesses();
  bool is_near_candidates(Index input) const;
  bool find_witnesses(Index input, std::size_t& cuts);
  const double* distances_of(Index vertex);
  CoverTriangle corners_of(Index input) const;
  void add_witness_candidates(Index input, Candidates& candidates) const;
  bool covers_input(Index input, double distance) const;
  bool covers_result(Index face, double distance);

  const EditableMesh& mesh_;
  const Mesh& input_;
  ClosestPointQuery input_query_;
  std::optional<Stars> stars_;
  double error_;
  double distance_;  ///< allowed distance: `error_` minus a bound of rounding errors
  WitnessLinks links_;
  ProjectedFaces projected_;    ///< certificates by projection onto input faces
  std::vector<Index> nearest_;  ///< nearest input face of each vertex of the result
  Index nearest_center_ = no_index;
  std::size_t refused_ = 0;

  // Data of the current patch.
  std::uint32_t stamp_ = 0;  ///< number of the current patch
  /// For each face of the result: number of the last patch that replaced it.
  std::vector<std::uint32_t> replaced_stamp_;
  std::vector<std::uint32_t>
      input_stamp_;  ///< for each input face: last patch with it in `inputs_`
  /// For each input vertex: number of the last patch that stored distances of the vertex.
  std::vector<std::uint32_t> vertex_stamp_;
  std::vector<Index> row_;  ///< first entry of each input vertex in `distances_`
  /// Squared distances from the new faces, one row for each input vertex.
  std::vector<double> distances_;
  Candidates candidates_;           ///< new faces, then the faces around the new faces
  std::size_t made_ = 0;            ///< number of new faces in candidates_
  std::vector<Index> inputs_;       ///< faces of the input that lose a witness
  std::vector<Index> open_inputs_;  ///< faces of `inputs_` that are not near a single new face
  std::vector<Witness> witnesses_;  ///< new witnesses of inputs_
};

}  // namespace transformesh
