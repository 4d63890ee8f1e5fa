/// The PLY element `edge`, whose properties vertex1 and vertex2 are numbers of vertices. It is kept
/// as other elements are, but only as long as the vertices keep their numbers.
#pragma once

#include <string>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

/// Stores in each element `edge` to which vertices its numbers refer. Called after reading. Drops
/// elements with a note if the reader has dropped vertices. O(n).
void number_edges(Document& document, std::vector<std::string>& notes);

/// True if the document has an element `edge` whose numbers may refer to other vertices than when
/// it was read. Vertices have the same numbers if their count is the same, and also all positions
/// or the corners of all faces in any order. O(n).
bool has_stale_edges(const Document& document);
/// Drops the elements `edge`, and adds a note.
void drop_edges(Document& document, std::vector<std::string>& notes);

/// Adds `vertices` to the numbers of vertices of an element `edge`, and widens their type. Other
/// elements, numbers that are negative or not integers, and lists stay unchanged.
void shift_edges(OtherElement& element, std::size_t vertices);

}  // namespace transformesh
