#include "clean/certify/certify_faces.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/numbers/predicates.h"
#include "mesh/disjoint_sets.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

/// Returns a number for each vertex of all meshes, one mesh after the other. Vertices at equal
/// positions have equal numbers.
std::vector<Index> number_positions(const std::vector<const Mesh*>& meshes) {
  std::vector<const Vec3*> positions;
  for (const Mesh* mesh : meshes)
    for (const Vec3& position : mesh->positions) positions.push_back(&position);
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto before = [&](Index a, Index b) {
    return compare_positions(*positions[a], *positions[b]) < 0;
  };
  std::sort(order.begin(), order.end(), before);

  std::vector<Index> numbers(positions.size());
  Index number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && before(order[i - 1], order[i])) ++number;
    numbers[order[i]] = number;
  }
  return numbers;
}

/// Returns the faces with position numbers as corners, rotated so that the smallest number is
/// first.
std::vector<Face> numbered_faces(const Mesh& mesh, const std::vector<Index>& numbers,
                                 std::size_t first_vertex) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    Face face{numbers[first_vertex + a], numbers[first_vertex + b], numbers[first_vertex + c]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  return faces;
}

/// Returns 1 for each face of `faces` that is not in `others`.
std::vector<char> missing(const std::vector<Face>& faces, std::vector<Face> others) {
  std::sort(others.begin(), others.end());
  std::vector<char> result(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    result[f] = std::binary_search(others.begin(), others.end(), faces[f]) ? 0 : 1;
  return result;
}

struct Halfedge {
  Index low, high;
  Index face;
  int direction;
};

/// Returns all halfedges sorted by edge. Halfedges that start and end at the same point are left
/// out.
std::vector<Halfedge> sorted_halfedges(const std::vector<Face>& faces) {
  std::vector<Halfedge> halfedges;
  halfedges.reserve(3 * faces.size());
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = faces[f][i];
      const Index b = faces[f][(i + 1) % 3];
      if (a != b) halfedges.push_back({std::min(a, b), std::max(a, b), f, a < b ? 1 : -1});
    }
  std::sort(halfedges.begin(), halfedges.end(), [](const Halfedge& a, const Halfedge& b) {
    return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
  });
  return halfedges;
}

/// Calls visit(first, last) for each edge. The halfedges of the edge have the indices from `first`
/// to before `last`.
template <class Visit>
void for_each_edge(const std::vector<Halfedge>& halfedges, const Visit& visit) {
  for (std::size_t first = 0; first < halfedges.size();) {
    std::size_t last = first + 1;
    while (last < halfedges.size() && halfedges[last].low == halfedges[first].low &&
           halfedges[last].high == halfedges[first].high)
      ++last;
    visit(first, last);
    first = last;
  }
}

bool is_closed(const std::vector<Face>& faces) {
  const std::vector<Halfedge> halfedges = sorted_halfedges(faces);
  bool result = true;
  for_each_edge(halfedges, [&](std::size_t first, std::size_t last) {
    int sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += halfedges[i].direction;
    result &= sum == 0;
  });
  return result;
}

}  // namespace

FaceMatch match_faces(const Mesh& input, const Mesh& output) {
  const std::vector<Index> numbers = number_positions({&input, &output});
  const std::vector<Face> input_faces = numbered_faces(input, numbers, 0);
  const std::vector<Face> output_faces = numbered_faces(output, numbers, input.positions.size());
  return {is_closed(input_faces), missing(input_faces, output_faces),
          missing(output_faces, input_faces)};
}

UncutPatches find_uncut_patches(const Mesh& input, const Progress& progress) {
  UncutPatches result;
  result.is_cut.resize(input.faces.size(), 0);
  for (const auto& [f, g] : find_intersections(input, progress))
    result.is_cut[f] = result.is_cut[g] = 1;

  DisjointSets sets(input.faces.size());
  const std::vector<Halfedge> halfedges =
      sorted_halfedges(numbered_faces(input, number_positions({&input}), 0));
  for_each_edge(halfedges, [&](std::size_t first, std::size_t last) {
    const Index f = halfedges[first].face;
    const Index g = halfedges[last - 1].face;
    if (last - first == 2 && !result.is_cut[f] && !result.is_cut[g]) sets.join(f, g);
  });

  std::vector<Index> patch_of(input.faces.size(), no_index);
  for (Index f = 0; f < input.faces.size(); ++f) {
    if (result.is_cut[f]) continue;
    Index& patch = patch_of[sets.find(f)];
    if (patch == no_index) {
      patch = static_cast<Index>(result.faces.size());
      result.faces.emplace_back();
    }
    result.faces[patch].push_back(f);
  }
  return result;
}

std::vector<Index> spread(const std::vector<Index>& faces, std::size_t count) {
  if (faces.size() <= count) return faces;
  std::vector<Index> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(faces[i * faces.size() / count]);
  return result;
}

std::vector<Index> marked_faces(const std::vector<char>& marks, char value) {
  std::vector<Index> result;
  for (Index f = 0; f < marks.size(); ++f)
    if (marks[f] == value) result.push_back(f);
  return result;
}

}  // namespace transformesh
