#include "io/document/missing_colors.h"

#include <algorithm>
#include <array>

namespace transformesh {
namespace {

bool differ_in_colors(const Columns& a, const Columns& b) {
  constexpr std::array names{"red", "green", "blue", "alpha"};
  return std::any_of(names.begin(), names.end(), [&](const char* name) {
    return (a.find(name) == nullptr) != (b.find(name) == nullptr);
  });
}

std::string note_on(const std::string& element) {
  return "only one input has colors of its " + element + ": the other becomes white";
}

}  // namespace

std::vector<std::string> notes_of_missing_colors(const Mesh& first, const Mesh& second) {
  std::vector<std::string> notes;
  const bool have_vertices = !first.positions.empty() && !second.positions.empty();
  if (have_vertices && differ_in_colors(first.vertex_columns, second.vertex_columns))
    notes.push_back(note_on("vertices"));
  const bool have_faces = !first.faces.empty() && !second.faces.empty();
  if (have_faces && differ_in_colors(first.face_columns, second.face_columns))
    notes.push_back(note_on("faces"));
  return notes;
}

}  // namespace transformesh
