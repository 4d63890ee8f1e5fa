/// Selections with a known result.
#include "mesh/face_conditions.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("components are chosen by faces, area or volume") {
  const Mesh mesh = test::joined(test::icosphere(1), test::cuboid({5, 0, 0}, {8, 3, 3}));
  const auto has_ball = [&](const std::vector<bool>& keep) {
    CHECK(keep.front() != keep.back());
    return keep.front();
  };
  CHECK(has_ball(faces_of_largest(mesh, 1, ComponentSize::faces)));
  CHECK_FALSE(has_ball(faces_of_largest(mesh, 1, ComponentSize::area)));
  CHECK_FALSE(has_ball(faces_of_largest(test::reversed(mesh), 1, ComponentSize::volume)));
  CHECK_FALSE(has_ball(faces_of_at_least(mesh, 27 - 1e-9, ComponentSize::volume)));
  const auto both = faces_of_largest(mesh, 3, ComponentSize::area);
  CHECK(std::count(both.begin(), both.end(), true) == std::ssize(mesh.faces));
}

TEST_CASE("a component of exactly the limit is kept, and equal components keep their order") {
  const Mesh box = test::cuboid({15, 20, 12}, {22, 27, 19});
  const auto count = [](const std::vector<bool>& keep) {
    return std::count(keep.begin(), keep.end(), true);
  };
  CHECK(count(faces_of_at_least(box, 343, ComponentSize::volume)) == 12);
  CHECK(count(faces_of_at_least(box, 343.01, ComponentSize::volume)) == 0);
  const Mesh pair = test::joined(box, test::moved(box, {31, 57, 11}));
  for (const Mesh& mesh : {pair, test::moved(pair, {7, 91, 3})}) {
    CHECK(faces_of_largest(mesh, 1, ComponentSize::volume).front());
    CHECK(split_components(mesh, ComponentSize::volume)[0].positions[0] == mesh.positions[0]);
  }
}

TEST_CASE("the largest component is found in meshes of extreme extents") {
  const Mesh mesh =
      test::joined(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({5, 0, 0}, {8, 3, 3}));
  for (const ComponentSize by : {ComponentSize::area, ComponentSize::volume})
    for (const double factor : {1e-200, 1e-110, 1e110, 1e200})
      CHECK(faces_of_largest(test::scaled(mesh, factor), 1, by).back());
}

TEST_CASE("a mesh is split into its components, the largest first, with all columns") {
  Mesh mesh = test::joined(test::icosphere(1), test::cuboid({5, 0, 0}, {8, 3, 3}));
  mesh.positions.insert(mesh.positions.begin(), Vec3(99, 0, 0));  // not used by a face
  for (Face& face : mesh.faces)
    for (Index& vertex : face) ++vertex;
  Column& labels = mesh.face_columns.get("label", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) labels.values[f] = static_cast<double>(f);
  const std::vector<Mesh> by_faces = split_components(mesh, ComponentSize::faces);
  const std::vector<Mesh> by_volume = split_components(mesh, ComponentSize::volume);
  REQUIRE(by_faces.size() == 2);
  REQUIRE(by_volume.size() == 2);
  CHECK(by_faces[0].faces.size() == test::icosphere(1).faces.size());
  for (std::size_t i = 0; i < 2; ++i) {
    // Part 0 is the component with the most faces, and part 1 is the rest. By volume, the order is
    // reversed.
    const std::vector<bool> keep = faces_of_largest(mesh, 1, ComponentSize::faces);
    std::vector<bool> other = keep;
    other.flip();
    const Mesh expected = select_faces(mesh, i == 0 ? keep : other);
    for (const Mesh* part : {&by_faces[i], &by_volume[1 - i]}) {
      CHECK(part->positions == expected.positions);
      CHECK(part->faces == expected.faces);
      CHECK(part->face_columns.find("label")->values ==
            expected.face_columns.find("label")->values);
    }
  }
  CHECK(split_components(Mesh(), ComponentSize::area).empty());
}

TEST_CASE("conditions on properties and boxes") {
  Mesh mesh = test::tetrahedron();
  mesh.face_columns.get("label", Scalar::int32, 4).values = {0, 1, 2, 3};
  mesh.vertex_columns.get("height", Scalar::float64, 4).values = {0, 0, 0, 1};
  using Mask = std::vector<bool>;
  CHECK(faces_where(mesh, "label>=2") == Mask{false, false, true, true});
  CHECK(faces_where(mesh, "label != 2") == Mask{true, true, false, true});
  CHECK(faces_where(mesh, "height < 1") == Mask{true, false, false, false});
  CHECK(faces_in_box(mesh, Box(Vec3::Zero(), Vec3(1, 1, 0.5))) == Mask{true, false, false, false});
  for (const char* text :
       {"", "label", "label>", ">3", "label=>3", "label>3x", "label<1 0", "label < = 1", "  <1"})
    CHECK_THROWS_AS(faces_where(mesh, text), UsageError);
  CHECK_THROWS_AS(faces_where(mesh, "none>0"), InputError);
  CHECK(faces_where(mesh, "  label  <  2  ") == Mask{true, true, false, false});
}

TEST_CASE("numbers of conditions are rounded to the type of the property") {
  Mesh mesh = test::tetrahedron();
  const double tenth = static_cast<double>(0.1F);
  mesh.face_columns.get("q", Scalar::float32, 4).values = {0, tenth, 0.5, 1};
  mesh.face_columns.get("d", Scalar::float64, 4).values = {0, tenth, 0.1, 1};
  mesh.face_columns.get("i", Scalar::int32, 4).values = {0, 1, 2, 3};
  using Mask = std::vector<bool>;
  CHECK(faces_where(mesh, "q=0.1") == Mask{false, true, false, false});
  CHECK(faces_where(mesh, "q>0.1") == Mask{false, false, true, true});
  CHECK(faces_where(mesh, "q<=0.1") == Mask{true, true, false, false});
  CHECK(faces_where(mesh, "q<1e300") == Mask(4, true));
  CHECK(faces_where(mesh, "d=0.1") == Mask{false, false, true, false});
  CHECK(faces_where(mesh, "i<0.5") == Mask{true, false, false, false});
}
