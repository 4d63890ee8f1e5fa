/// Generalized winding numbers of the open components of a mesh, sampled at pieces of an
/// arrangement (Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013). The winding number of a component at a point
/// of its own surface is the mean of the values on both sides. Medians are weighted by the areas of
/// the pieces. Floating point; deterministic; independent of the order of faces. Cost: about
/// O(sqrt(m)) per sample for a connected component of m faces.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "clean/arrange/arrange.h"
#include "geometry/winding_hierarchy.h"

namespace transformesh {

class ComponentWinding {
 public:
  /// Keeps a reference to `arrangement`.
  explicit ComponentWinding(const Arrangement& arrangement);

  static constexpr Index closed_part = no_index;
  /// Returns the open component of a welded face, or `closed_part`.
  Index component_of_face(Index face) const;
  /// Returns the open component of a piece, or `closed_part`. If the piece is part of several
  /// faces, the first one with the direction of the piece decides.
  Index component_of(Index piece) const;
  /// Returns the components of all faces that contain a piece and have its direction.
  std::set<Index> components_of(Index piece) const;
  /// Returns whether the face of the component that contains one of the pieces has the opposite
  /// direction, or nothing if there is no such face.
  std::optional<bool> is_reverse_of(const std::vector<Index>& pieces, Index component) const;
  const Mesh& mesh_of(Index component) const { return meshes_[component]; }

  double area_of(Index component);
  double area_of(const std::vector<Index>& pieces) const;
  Vec3 centroid(Index piece) const;
  /// Returns the winding number of a component at the centroid of a piece.
  double number_at(Index component, Index piece);

  /// Returns the median of the winding number of a component at the centroids of the given pieces.
  double median(Index component, const std::vector<Index>& pieces);
  /// Returns the typical winding number of a component at those of its own pieces that none of its
  /// other parts hide. It is 0 for a flat sheet, 1/2 for a closed body, and -1/2 for a closed body
  /// with inward orientation. The number at hidden pieces differs from it by an integer. Hence the
  /// result is the median modulo 1, if the numbers agree modulo 1 in most of the area. Otherwise it
  /// is the median, limited to the range from 0 to 1/2.
  double on_itself(Index component);
  /// True if the component is a body with holes: it encloses most of what it would enclose without
  /// its holes.
  bool is_body(Index component);

 private:
  struct Sample {
    double area;
    Vec3 at;
    Index piece;
  };

  struct Number {
    double number, area;
  };

  struct Fraction {
    double fraction, deviation;
  };

  std::size_t samples_of(Index component) const;
  static std::vector<Sample> choose(const std::vector<Sample>& samples, std::size_t count);
  std::vector<Number> numbers_at(Index component, const std::vector<Sample>& samples);
  std::vector<Number> sampled_numbers(Index component, const std::vector<Index>& pieces);
  static Fraction fraction_of(const std::vector<Number>& numbers);
  static double median_of(const std::vector<Number>& numbers);
  const WindingHierarchy& hierarchy_of(Index component);
  double number_at(const WindingHierarchy& hierarchy, Index component, Index piece) const;

  const Arrangement& arrangement_;
  std::vector<Mesh> meshes_;  ///< mesh of each open component
  /// Index of each open face in the mesh of its open component.
  std::vector<Index> number_of_face_;
  std::vector<std::vector<Index>> pieces_of_;  ///< pieces of each open component
  /// Hierarchies of the open components, computed on demand.
  std::vector<std::optional<WindingHierarchy>> windings_;
  /// Result of on_itself() for each open component, computed on demand.
  std::vector<std::optional<double>> on_itself_;
  std::vector<std::optional<double>> areas_;  ///< area of each component, computed on demand
};

}  // namespace transformesh
