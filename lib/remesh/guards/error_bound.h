/// Keeps a surface within a distance of its input, in both directions, while patches of it are
/// replaced.
///
/// Both directions are certified by triangle_cover.h. Each face of the input has witnesses
/// (witness_links.h): faces of the result such that all of its points are within the distance of
/// them. A patch is allowed if each input face with a witness in the patch finds other witnesses.
/// These are new faces, faces around them, or witnesses that stay. Each new face has to be within
/// the distance of faces of the input. So nothing accumulates, and the bound holds after each step.
/// A change that keeps the bound may be refused, as certificates may be missed. The whole is in
/// docs/design/decimation-error.md.
/// Reference: Cohen, Varshney et al., "Simplification envelopes", SIGGRAPH 1996, for the bound in
/// both directions; certificates by witnesses are our own.
#pragma once

#include <cstdint>
#include <vector>

#include "remesh/guards/embedding_guard.h"
#include "remesh/guards/near_faces.h"
#include "remesh/guards/projected_faces.h"
#include "remesh/guards/witness_links.h"

namespace transformesh {

class ErrorBound {
 public:
  /// `mesh` was made of `input`, and has not been changed. Both stay, and faces of the mesh are
  /// only replaced by patches that were allowed.
  ErrorBound(const EditableMesh& mesh, const Mesh& input, double error);

  /// Whether the patch, with `Patch::spokes`, keeps the bound.
  bool allows(const Patch& patch);
  /// To be called after the mesh was changed by the patch that was allowed last.
  void commit(const Patch& patch);
  std::size_t refused() const { return refused_; }
  /// A distance within which both surfaces are certified to be; at most the error.
  double certified();

 private:
  using Candidates = std::vector<NearCandidate>;
  /// A face of the input with one of its witnesses to be.
  struct Witness {
    Index input, face;
  };

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
  double error_;
  double distance_;  ///< the error less what rounding may add
  WitnessLinks links_;
  ProjectedFaces projected_;    ///< those of the input
  std::vector<Index> nearest_;  ///< per vertex of the result: the nearest face of the input
  Index nearest_center_ = no_index;
  std::size_t refused_ = 0;

  // About the patch in question.
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> replaced_stamp_;  ///< per face of the result
  std::vector<std::uint32_t> input_stamp_;     ///< per face of the input
  std::vector<std::uint32_t> vertex_stamp_;    ///< per vertex of the input
  std::vector<Index> row_;                     ///< per vertex of the input, of distances_
  std::vector<double> distances_;              ///< squared, from the new faces
  Candidates candidates_;                      ///< the new faces, and those around them
  std::size_t made_ = 0;                       ///< how many of these are new
  std::vector<Index> inputs_;                  ///< faces of the input that lose a witness
  std::vector<Index> open_inputs_;             ///< not all near one new face
  std::vector<Witness> witnesses_;             ///< which they all get
};

}  // namespace transformesh
