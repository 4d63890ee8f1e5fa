/// A face has changed if one of its corners is at a corner of a removed input face.
#include "clean/flat/changed_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("faces at the corners of a lost face have changed, by position and not by index") {
  const Mesh result = test::moved(test::icosphere(2), {2, 0, 0});
  // The input has an additional face, with its own vertices at the positions of the first face.
  Mesh input = result;
  for (const Index v : result.faces[0]) input.positions.push_back(result.positions[v]);
  const auto first = static_cast<Index>(result.positions.size());
  input.faces.push_back({first, first + 2, first + 1});
  std::vector<Index> source_face(result.faces.size());
  std::iota(source_face.begin(), source_face.end(), Index{0});
  std::vector<char> is_new(result.faces.size(), 0);
  std::vector<char> changed = find_changed_faces(input, result, source_face, is_new);
  for (std::size_t f = 0; f < changed.size(); ++f) {
    const bool touches = std::any_of(result.faces[f].begin(), result.faces[f].end(), [&](Index v) {
      return std::count(result.faces[0].begin(), result.faces[0].end(), v) > 0;
    });
    CHECK((changed[f] != 0) == touches);
  }
  changed = find_changed_faces(result, result, source_face, is_new);
  CHECK(std::count(changed.begin(), changed.end(), 0) == static_cast<long>(changed.size()));
  is_new[5] = 1;
  changed = find_changed_faces(result, result, source_face, is_new);
  CHECK(changed[5] == 1);
}
