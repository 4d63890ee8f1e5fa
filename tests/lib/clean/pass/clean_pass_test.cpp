/// The counts of one clean pass, checked by brute force and by closed forms.
#include "clean/pass/clean_pass.h"

#include <doctest/doctest.h>

#include <set>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

CleanPass pass_over(const Mesh& mesh, const CleanPassOptions& options = {}) {
  return run_clean_pass(mesh, options, Progress());
}

Mesh two_balls() {
  return test::joined(test::icosphere(3), test::moved(test::icosphere(3), {0.9, 0.2, 0.1}));
}

}  // namespace

TEST_CASE("pairs, cut faces and removed faces are those of the input") {
  const Mesh mesh = two_balls();
  const std::vector<FacePair> pairs = find_intersections(mesh);
  std::set<Index> cut;
  for (const auto& [f, g] : pairs) cut.insert({f, g});
  // An uncut face of a ball is removed if and only if it lies in the other ball.
  const Mesh first = test::icosphere(3), second = test::moved(first, {0.9, 0.2, 0.1});
  std::size_t inside = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Vec3& corner = mesh.positions[mesh.faces[f][0]];
    const Mesh& other = f < first.faces.size() ? second : first;
    inside += !cut.contains(f) && test::winding_number(other, corner) > 0.5 ? 1 : 0;
  }
  const CleanPass pass = pass_over(mesh);
  CHECK(pass.pairs == pairs.size());
  CHECK(pass.cut_faces == cut.size());
  CHECK(pass.removed_faces == inside);
  CHECK(inside > 100);
  CHECK(!pass.is_open);
  CHECK(!pass.unchanged);
  CHECK(pass.rays == 2);
  CHECK(test::count(pass.assembly.mesh).is_manifold);
}

TEST_CASE("a mesh with nothing to clean is unchanged, and one to be stitched is not") {
  const CleanPass whole = pass_over(test::icosphere(2));
  CHECK(whole.unchanged);
  CHECK(whole.assembly.mesh.faces.empty());
  const CleanPass soup = pass_over(test::soup_of(test::icosphere(2)));
  CHECK(!soup.unchanged);
  CHECK(soup.removed_faces == 0);
  CHECK(soup.assembly.mesh.positions.size() == test::icosphere(2).positions.size());
}

TEST_CASE("with too many pairs only their number is reported") {
  const std::size_t pairs = find_intersections(two_balls()).size();
  CleanPassOptions options;
  options.most_pairs = pairs - 1;
  const CleanPass pass = pass_over(two_balls(), options);
  CHECK(pass.pairs == pairs);
  CHECK(pass.cut_faces == 0);
  CHECK(pass.assembly.mesh.faces.empty());
  options.most_pairs = pairs;
  CHECK(!pass_over(two_balls(), options).assembly.mesh.faces.empty());
}

TEST_CASE("a pass takes the arrangement of an earlier pass, which has removed other pieces") {
  const auto pass_with = [](bool keeps, ArrangedMesh* arranged) {
    CleanPassOptions options;
    options.arranged = arranged;
    options.change_kept = [keeps](Arrangement& arrangement, std::vector<char>& kept) {
      for (std::size_t p = 0; p < kept.size() && !keeps; ++p) {
        kept[p] = kept[p] ? 0 : 1;
        reverse_piece(arrangement, arrangement.pieces[p]);
      }
    };
    return pass_over(two_balls(), options).assembly.mesh;
  };
  ArrangedMesh arranged;
  const Mesh inner = pass_with(false, &arranged);
  REQUIRE(!arranged.kept.empty());
  const Vec3* points = arranged.arrangement.cut_positions.data();
  const Mesh outer = pass_with(true, &arranged);
  CHECK(points == arranged.arrangement.cut_positions.data());
  CHECK(outer.positions == pass_with(true, nullptr).positions);
  CHECK(outer.faces == pass_with(true, nullptr).faces);
  CHECK(inner.faces != outer.faces);
}

TEST_CASE("an open mesh is reported, and static refuses it") {
  CHECK(pass_over(test::grid(3)).is_open);
  CleanPassOptions options;
  options.method = ExteriorMethod::static_test;
  CHECK_THROWS_WITH_AS(pass_over(test::grid(3), options),
                       doctest::Contains("the static test needs a closed mesh"), UsageError);
}

TEST_CASE("a mesh that is not oriented is refused, unless that is not to be checked") {
  Mesh mesh = test::icosphere(1);
  std::swap(mesh.faces[3][0], mesh.faces[3][1]);
  CHECK_THROWS_AS(pass_over(mesh), InputError);
  CleanPassOptions options;
  options.check_orientation = false;
  CHECK_NOTHROW(pass_over(mesh, options));
}
