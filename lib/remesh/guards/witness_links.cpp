#include "remesh/guards/witness_links.h"

namespace transformesh {

WitnessLinks::WitnessLinks(Index faces)
    : first_of_face_(faces, no_index), first_of_input_(faces, no_index) {
  links_.reserve(faces);
  for (Index face = 0; face < faces; ++face) add(face, face);
}

void WitnessLinks::add(Index input, Index face) {
  Index link = first_free_;
  if (link == no_index) {
    link = static_cast<Index>(links_.size());
    links_.emplace_back();
  } else {
    first_free_ = links_[link].next_of_input;
  }
  links_[link] = {input, face, first_of_input_[input], first_of_face_[face], no_index};
  if (first_of_face_[face] != no_index) links_[first_of_face_[face]].previous_of_face = link;
  first_of_input_[input] = first_of_face_[face] = link;
}

void WitnessLinks::clear(Index input) {
  Index link = first_of_input_[input];
  first_of_input_[input] = no_index;
  while (link != no_index) {
    Link& gone = links_[link];
    const Index next = gone.next_of_input;
    if (gone.next_of_face != no_index)
      links_[gone.next_of_face].previous_of_face = gone.previous_of_face;
    if (gone.previous_of_face != no_index)
      links_[gone.previous_of_face].next_of_face = gone.next_of_face;
    else
      first_of_face_[gone.face] = gone.next_of_face;
    gone.next_of_input = first_free_;
    first_free_ = link;
    link = next;
  }
}

}  // namespace transformesh
