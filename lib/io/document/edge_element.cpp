#include "io/document/edge_element.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "io/document/scalar.h"

namespace transformesh {
namespace {

bool is_edges(const OtherElement& element) { return element.name == "edge"; }

template <class T>
std::size_t hash_of(const std::vector<T>& rows) {
  return std::hash<std::string_view>{}(
      {reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(T)});
}

/// The number of vertices, and hashes of their positions and of the faces.
using Numbered = std::array<std::size_t, 3>;

Numbered numbers_of(const Mesh& mesh) {
  std::vector<Face> faces = mesh.faces;
  for (Face& face : faces) std::ranges::sort(face);
  return {mesh.positions.size(), hash_of(mesh.positions), hash_of(faces)};
}

bool are_same(const Numbered& a, const Numbered& b) {
  return a[0] == b[0] && (a[1] == b[1] || a[2] == b[2]);
}

}  // namespace

void number_edges(Document& document, std::vector<std::string>& notes) {
  if (std::ranges::none_of(document.other_elements, is_edges)) return;
  const Numbered numbers = numbers_of(document.mesh);
  for (OtherElement& element : document.other_elements) {
    if (!is_edges(element)) continue;
    if (element.numbered && element.numbered->front() != numbers.front())
      return drop_edges(document, notes);
    element.numbered = numbers;
  }
}

bool has_stale_edges(const Document& document) {
  if (std::ranges::none_of(document.other_elements, is_edges)) return false;
  const Numbered numbers = numbers_of(document.mesh);
  return std::ranges::any_of(document.other_elements, [&](const OtherElement& element) {
    return is_edges(element) && element.numbered && !are_same(*element.numbered, numbers);
  });
}

void drop_edges(Document& document, std::vector<std::string>& notes) {
  std::erase_if(document.other_elements, is_edges);
  notes.emplace_back("element 'edge' dropped: the vertices that it numbers have changed");
}

void shift_edges(OtherElement& element, std::size_t vertices) {
  if (!is_edges(element)) return;
  for (const char* name : {"vertex1", "vertex2"}) {
    Column* column = element.columns.find(name);
    if (column == nullptr || column->list_count_type || is_floating(column->type)) continue;
    double largest = 0;
    for (double& value : column->values) {
      if (value >= 0) value += static_cast<double>(vertices);
      largest = std::max(largest, value);
    }
    column->type = widened(column->type, static_cast<std::uint64_t>(largest));
  }
}

}  // namespace transformesh
