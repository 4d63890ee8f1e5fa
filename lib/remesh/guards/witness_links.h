/// The relation between faces of the input and their witnesses. Witnesses are faces of the result
/// such that each point of the input face is within a distance of one of them. Each link is stored
/// in a list of the input face and a list of the witness, so that a change takes constant time. A
/// link takes about 25 bytes.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class WitnessLinks {
 public:
  /// Initially each input face has the result face with the same index as its witness.
  explicit WitnessLinks(Index faces);

  /// Calls visit(input face) for each input face of which `face` is a witness.
  template <class Visit>
  void for_each_input(Index face, const Visit& visit) const {
    for (Index i = first_of_face_[face]; i != no_index; i = links_[i].next_of_face)
      visit(links_[i].input);
  }
  /// Calls visit(face) for each witness of an input face.
  template <class Visit>
  void for_each_witness(Index input, const Visit& visit) const {
    for (Index i = first_of_input_[input]; i != no_index; i = links_[i].next_of_input)
      visit(links_[i].face);
  }
  /// Adds a witness that the input face does not yet have.
  void add(Index input, Index face);
  /// Removes all witnesses of an input face.
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
  Index first_free_ = no_index;  ///< first unused link; unused links are chained by next_of_input
};

}  // namespace transformesh
