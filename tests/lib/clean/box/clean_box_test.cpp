/// Cleaning in boxes, compared with cleaning as a whole. Together, boxes give the triangles of
/// clean(); a single box leaves everything outside unchanged.
#include "clean/box/clean_box.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "clean/box/box_submesh.h"
#include "geometry/numbers/predicates.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/transform.h"

using namespace transformesh;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

/// Returns all triangles, sorted, each beginning with its smallest corner.
std::vector<Corners> sorted_triangles(const Mesh& mesh) {
  std::vector<Corners> result;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    Corners t;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[mesh.faces[f][i]];
      t[i] = {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Returns eight boxes that cover a mesh and share a corner inside of it.
std::vector<Box> octants(const Mesh& mesh, const Vec3& share) {
  const Box all = bounding_box(mesh);
  const Vec3 low = all.min().array() - 1, high = all.max().array() + 1;
  const Vec3 middle = low + share.cwiseProduct(high - low);
  std::vector<Box> boxes;
  for (int i = 0; i < 8; ++i) {
    Box box{low, middle};
    for (int k = 0; k < 3; ++k)
      if (i >> k & 1) {
        box.min()[k] = middle[k];
        box.max()[k] = high[k];
      }
    boxes.push_back(box);
  }
  return boxes;
}

/// Returns the faces of all boxes, each cleaned alone. `whole` counts boxes for which the whole
/// mesh was cleaned.
Mesh clean_in_boxes(const Mesh& mesh, CleanOptions options, std::size_t& whole) {
  Mesh all;
  std::size_t faces = 0;
  for (const Box& box : octants(mesh, {.47, .52, .5})) {
    options.box = box;
    options.only = true;
    const CleanResult result = clean(mesh, options);
    faces += result.box_faces;
    whole += result.is_whole ? 1 : 0;
    all = test::joined(all, result.mesh);
  }
  CHECK(faces == mesh.faces.size());
  return all;
}

Mesh rounded_to_floats(Mesh mesh) {
  for (Vec3& p : mesh.positions) p = p.unaryExpr([](double x) { return round_to_single(x); });
  return mesh;
}

}  // namespace

TEST_CASE("eight boxes have the triangles of the whole") {
  for (const char* kind :
       {"two-spheres", "folded", "tangle", "dumbbell", "many-spheres", "boxes", "pinch"}) {
    for (const int winding_level : {1, 2}) {
      CAPTURE(kind);
      CAPTURE(winding_level);
      const Mesh input = test::workload(kind, 6000, 3);
      CleanOptions options;
      options.winding_level = winding_level;
      Mesh expected;
      try {
        expected = clean(input, options).mesh;
      } catch (const GoalError&) {
        continue;
      }
      CleanOptions box_options;
      box_options.winding_level = winding_level;
      std::size_t whole = 0;
      const Mesh boxes = clean_in_boxes(input, box_options, whole);
      CHECK(whole == 0);
      CHECK(sorted_triangles(boxes) == sorted_triangles(expected));
    }
  }
}

TEST_CASE("eight boxes also agree for soups, coincident faces and coplanar faces") {
  Mesh blocks;
  for (int i = 0; i < 4; ++i) {
    const Vec3 low(.5 * i, i % 2 * .25, 0);
    blocks = test::joined(blocks, test::cuboid(low, low + Vec3(1, 1, 1 + i / 2)));
  }
  blocks = test::joined(blocks, test::cuboid({0, 0, 0}, {1, 1, 1}));
  const Mesh spheres = test::workload("many-spheres", 3000, 5);
  Mesh soup;
  for (const Face& face : spheres.faces) {
    const auto v = static_cast<Index>(soup.positions.size());
    for (const Index corner : face) soup.positions.push_back(spheres.positions[corner]);
    soup.faces.push_back({v, v + 1, v + 2});
  }
  std::reverse(soup.faces.begin(), soup.faces.end());
  for (const Mesh* input : {&blocks, &soup}) {
    std::size_t whole = 0;
    const Mesh boxes = clean_in_boxes(*input, {}, whole);
    CHECK(whole == 0);
    CHECK(sorted_triangles(boxes) == sorted_triangles(clean(*input).mesh));
  }
}

TEST_CASE("if rounding breaks faces, boxes are taken from the cleaned whole mesh") {
  // Boxes with sides that are coplanar up to rounding.
  Mesh turned = test::workload("boxes", 2000, 2);
  const Eigen::AngleAxisd turn(.3, Vec3(1, 2, 3).normalized());
  for (Vec3& p : turned.positions) p = turn * p;
  const Mesh input = rounded_to_floats(turned);
  CleanOptions options;
  options.coordinate = Scalar::float32;
  const CleanResult expected = clean(input, options);
  REQUIRE(expected.rounding_places > 0);
  CleanOptions box_options;
  box_options.coordinate = Scalar::float32;
  std::size_t whole = 0;
  const Mesh boxes = clean_in_boxes(input, box_options, whole);
  CHECK(whole > 0);
  CHECK(sorted_triangles(boxes) == sorted_triangles(expected.mesh));
}

TEST_CASE("a box around one self-intersection leaves others unchanged") {
  const Mesh pair = test::workload("two-spheres", 2000, 1);
  Mesh input = test::joined(pair, test::moved(pair, {10, 0, 0}));
  Column& number = input.face_columns.get("number", Scalar::int32, input.faces.size());
  for (std::size_t f = 0; f < input.faces.size(); ++f) number.values[f] = static_cast<double>(f);
  CleanOptions options;
  options.box = {Vec3::Constant(-5), Vec3::Constant(5)};
  const CleanResult result = clean(input, options);
  CHECK(result.box_faces == pair.faces.size());
  CHECK(result.changed);
  const Mesh& mesh = result.mesh;
  CHECK(check_manifold(mesh).is_closed());
  CHECK(check_manifold(mesh).is_manifold());
  // The first pair of balls equals the result of clean(), and the second pair equals the input.
  std::vector<bool> is_second(mesh.faces.size());
  const Column& kept = *mesh.face_columns.find("number");
  for (std::size_t f = 0; f < is_second.size(); ++f)
    is_second[f] = kept.values[f] >= static_cast<double>(pair.faces.size());
  const Mesh second = select_faces(mesh, is_second);
  CHECK(second.positions == test::moved(pair, {10, 0, 0}).positions);
  CHECK(second.faces == pair.faces);
  is_second.flip();
  CHECK(sorted_triangles(select_faces(mesh, is_second)) == sorted_triangles(clean(pair).mesh));
  CHECK(find_intersections(mesh).size() == find_intersections(pair).size());
}

TEST_CASE("a box without self-intersections changes no face") {
  const Mesh input = test::workload("two-spheres", 2000, 1);
  const Box all = bounding_box(input);
  CleanOptions options;
  options.box = {all.min(), all.min() + .2 * (all.max() - all.min())};
  options.box->max().y() = options.box->max().z() = all.max().z() + 1;
  const CleanResult result = clean(input, options);
  CHECK(result.box_faces > 0);
  CHECK(!result.changed);
  CHECK(result.mesh.positions == input.positions);
  CHECK(result.mesh.faces == input.faces);
  // The box covers half of the intersection; faces outside of the box stay.
  options.box = octants(input, {.5, .5, .5})[0];
  options.box->max().x() = 100;
  const Mesh half = clean(input, options).mesh;
  std::size_t stayed = 0, outside = 0;
  for (const Face& face : input.faces) {
    const Vec3& first = input.positions[face[0]];
    outside += (first.array() < options.box->max().array()).all() ? 0 : 1;
  }
  const auto triangles = sorted_triangles(input);
  for (const Corners& t : sorted_triangles(half))
    stayed += std::binary_search(triangles.begin(), triangles.end(), t) ? 1 : 0;
  CHECK(stayed >= outside);
}

TEST_CASE("what a box cannot do is said") {
  CleanOptions options;
  options.box = {Vec3::Constant(-9), Vec3::Constant(9)};
  Mesh open = test::icosphere(2);
  open.faces.pop_back();
  CHECK_THROWS_AS(clean(open, options), InputError);
  CHECK_THROWS_AS(clean(Mesh(), options), InputError);
  const Mesh input = test::workload("two-spheres", 1000, 1);
  options.refuse = true;
  CHECK_THROWS_AS(clean(input, options), GoalError);
  options.box->max().x() = -9;
  CHECK_THROWS_AS(clean(input, options), UsageError);
  // A box that contains no part of the mesh.
  options.box = {Vec3::Constant(50), Vec3::Constant(60)};
  options.only = true;
  CHECK(clean(input, options).mesh.faces.empty());
}

TEST_CASE("a tile that is the whole mesh has the pieces of its box") {
  const Mesh input = test::workload("many-spheres", 4000, 2);
  const Box all = bounding_box(input);
  CleanOptions options;
  options.only = true;
  options.box = octants(input, {.5, .5, .5})[3];
  const Box held(all.min().array() - 1, all.max().array() + 1);
  const Tile tile{{1, 0, 1}, face_sums(input).hash(), *options.box, held, {held.min(), 0}};
  const CleanResult expected = clean(input, options);
  const CleanResult result = clean_tile(input, tile, {}, Progress());
  CHECK(expected.cut_faces > 0);
  CHECK(sorted_triangles(result.mesh) == sorted_triangles(expected.mesh));
  CHECK(result.box_faces == expected.box_faces);

  // The result differs if the reference point has a wrong winding number.
  Tile wrong = tile;
  wrong.reference.winding = 1;
  CHECK(sorted_triangles(clean_tile(input, wrong, {}, Progress()).mesh) !=
        sorted_triangles(expected.mesh));

  Mesh changed = input;
  std::swap(changed.faces[0], changed.faces[1]);
  CHECK_THROWS_AS(clean_tile(changed, tile, {}, Progress()), InputError);
  CHECK_THROWS_AS(clean_tile(input, tile, options, Progress()), UsageError);
}
