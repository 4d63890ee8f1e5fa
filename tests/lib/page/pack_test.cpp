#include "page/pack.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "helpers/shapes.h"
#include "helpers/unpacked.h"

using namespace transformesh;

namespace {

using test::unpacked;

/// Checks that the corners of all faces, in order, have the same positions up to quantization.
void check_same_place(const Mesh& mesh, const Mesh& back, const PackedMesh& packed) {
  REQUIRE(back.faces.size() == mesh.faces.size());
  REQUIRE(back.positions.size() == mesh.positions.size());
  const Vec3 most = (packed.high - packed.low) * (0.501 / 65535);
  bool are_near = true;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 off = mesh.positions[mesh.faces[f][i]] - back.positions.at(back.faces[f][i]);
      are_near = are_near && (off.cwiseAbs().array() <= most.array()).all();
    }
  }
  CHECK(are_near);
}

}  // namespace

TEST_CASE("meshes are decoded within half a quantization step, also far away, tiny and large") {
  for (const double size : {1.0, 1e-200, 1e200}) {
    for (const double shift : {0.0, 1e6 * size}) {
      CAPTURE(size);
      CAPTURE(shift);
      const Mesh mesh = test::moved(test::scaled(test::icosphere(3), size), Vec3(shift, 0, -shift));
      const PackedMesh packed = pack(mesh);
      const auto back = unpacked(packed.block);
      CHECK(back.is_complete);
      check_same_place(mesh, back.mesh, packed);
      CHECK(packed.radius == doctest::Approx(size).epsilon(0.01));
    }
  }
}

TEST_CASE("a hundred frames of ten thousand faces stay below 30 MB") {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  Mesh mesh = test::icosphere(5);
  for (Vec3& position : mesh.positions)
    position += Vec3(noise(random), noise(random), noise(random));
  const double bytes_per_face =
      static_cast<double>(pack(mesh).block.size()) / static_cast<double>(mesh.faces.size());
  // A page with 100 meshes of 10,000 faces takes less than 30 MB. Base64 increases the size by 4 /
  // 3.
  CHECK(bytes_per_face * 1e4 * 100 * 4 / 3 < 30e6);
}

TEST_CASE("more vertices than two bytes count") {
  Mesh mesh;
  for (int i = 0; i < 70000; ++i) mesh.positions.emplace_back(i, i % 7, 0);
  for (Index i = 0; i + 2 < 70000; ++i) mesh.faces.push_back({69999 - i, i + 1, i});
  const PackedMesh packed = pack(mesh);
  check_same_place(mesh, unpacked(packed.block).mesh, packed);
}

TEST_CASE("columns come back with their vertices and faces; what is not finite is none") {
  Mesh mesh = test::icosphere(1);
  std::vector<double>& heat =
      mesh.vertex_columns.get("heat", Scalar::float64, mesh.positions.size()).values;
  for (std::size_t i = 0; i < heat.size(); ++i) heat[i] = mesh.positions[i].z();
  heat[3] = INFINITY;
  heat[4] = NAN;
  std::vector<double>& label =
      mesh.face_columns.get("label", Scalar::int32, mesh.faces.size()).values;
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = static_cast<double>(i % 5);
  for (const char* name : {"red", "green", "blue", "nx", "vy"})
    mesh.vertex_columns.get(name, Scalar::uint8, mesh.positions.size()).values[7] = name[0];

  const PackedMesh packed = pack(mesh);
  REQUIRE(packed.columns.size() == 3);
  CHECK(packed.columns[0].name == "heat");
  CHECK(packed.columns[1].name == "label");
  CHECK(packed.columns[2].of == PackedColumn::Of::color);
  CHECK(packed.columns[1].high == 4);

  const auto back = unpacked(packed.block);
  CHECK(back.is_complete);
  int none = 0;
  for (std::size_t i = 0; i < back.mesh.positions.size(); ++i) {
    none += std::isnan(back.columns[0][i]) ? 1 : 0;
    if (!std::isnan(back.columns[0][i]))
      CHECK(std::abs(back.columns[0][i] - back.mesh.positions[i].z()) < 1e-4);
  }
  CHECK(none == 2);
  for (std::size_t i = 0; i < label.size(); ++i)
    CHECK(back.columns[1][i] == doctest::Approx(label[i]).epsilon(1e-4));
  // The colored vertex keeps its position.
  for (std::size_t i = 0; i < back.mesh.positions.size(); ++i) {
    const bool is_colored = (back.mesh.positions[i] - mesh.positions[7]).norm() < 1e-3;
    CHECK(back.columns[2][i] == (is_colored ? 'r' : 0));
    CHECK(back.columns[4][i] == (is_colored ? 'b' : 0));
  }
}

TEST_CASE("colors of any type become bytes") {
  for (const Scalar type : {Scalar::uint16, Scalar::float32, Scalar::int32}) {
    const double full = type == Scalar::uint16 ? 65535 : type == Scalar::int32 ? 255 : 1;
    Mesh mesh = test::icosphere(1);
    for (const char* name : {"red", "green", "blue"})
      mesh.vertex_columns.get(name, type, 0).values.assign(mesh.positions.size(), full / 5);
    mesh.vertex_columns.find("blue")->values[0] = NAN;
    const auto back = unpacked(pack(mesh).block);
    REQUIRE(back.columns.size() == 3);
    CHECK(back.columns[0] == std::vector<double>(mesh.positions.size(), 51));
  }
}

TEST_CASE("points, flat meshes and nothing at all") {
  const Mesh nothing;
  CHECK(unpacked(pack(nothing).block).is_complete);

  Mesh points;
  points.positions = {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(5, 2, -3)};
  const PackedMesh packed = pack(points);
  const auto back = unpacked(packed.block);
  CHECK(back.mesh.faces.empty());
  CHECK(back.mesh.positions == points.positions);

  Mesh unused = test::tetrahedron();
  unused.positions.insert(unused.positions.begin(), Vec3(9, 9, 9));
  for (Face& face : unused.faces)
    for (Index& corner : face) ++corner;
  check_same_place(unused, unpacked(pack(unused).block).mesh, pack(unused));
}
