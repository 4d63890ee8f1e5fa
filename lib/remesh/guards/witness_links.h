/// Which faces of a result are witnesses of which faces of its input: all points of an input face
/// are within a distance of its witnesses. Both ways in lists, so that a change takes constant
/// time. About 25 bytes per link.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class WitnessLinks {
 public:
  /// Each input face has the result face of the same number as its witness.
  explicit WitnessLinks(Index faces);

  /// Calls visit(input face) for the faces of which `face` is a witness.
  template <class Visit>
  void for_each_input(Index face, const Visit& visit) const {
    for (Index i = first_of_face_[face]; i != no_index; i = links_[i].next_of_face)
      visit(links_[i].input);
  }
  /// Calls visit(face) for the witnesses of an input face.
  template <class Visit>
  void for_each_witness(Index input, const Visit& visit) const {
    for (Index i = first_of_input_[input]; i != no_index; i = links_[i].next_of_input)
      visit(links_[i].face);
  }
  /// Adds a witness that the input face does not have.
  void add(Index input, Index face);
  /// Takes all its witnesses from an input face.
  void clear(Index input);

 private:
  struct Link {
    Index input, face;
    Index next_of_input;
    Index next_of_face, previous_of_face;
  };

  std::vector<Link> links_;
  std::vector<Index> first_of_face_;
  std::vector<Index> first_of_input_;
  Index first_free_ = no_index;  ///< links without use follow each other as those of an input
};

}  // namespace transformesh
