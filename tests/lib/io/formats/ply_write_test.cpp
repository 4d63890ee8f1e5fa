#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("ply: the pipe format, byte by byte") {
  Document document;
  document.mesh = tetrahedron();
  Bytes expected;
  expected.text(
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\n"
      "property double y\nproperty double z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n");
  expected.f64(0).f64(0).f64(0).f64(1).f64(0).f64(0).f64(0).f64(1).f64(0).f64(0).f64(0).f64(1);
  for (const auto& face : {Face{0, 2, 1}, Face{0, 1, 3}, Face{1, 2, 3}, Face{0, 3, 2}}) {
    expected.u8(3).u32(face[0]).u32(face[1]).u32(face[2]);
  }
  const WriteResult result = write_mesh(document);
  CHECK(result.bytes == expected.str());
  CHECK(result.notes.empty());
}

TEST_CASE("ply: text holds the shortest numbers of each type") {
  Document document;
  document.mesh.positions = {{0.1, 1.0 / 3, -0.0}};
  document.mesh.vertex_columns.get("q", Scalar::float32, 1).values = {static_cast<double>(0.1F)};
  document.mesh.vertex_columns.get("n", Scalar::uint32, 1).values = {4294967295.0};
  document.style.format = Format::ply_ascii;
  document.style.element_order = {"vertex"};
  const std::string as_double = write_mesh(document).bytes;
  CHECK(contains(as_double, "end_header\n0.1 0.3333333333333333 -0 0.1 4294967295\n"));
  document.style.coordinate = Scalar::float32;
  CHECK(contains(write_mesh(document).bytes, "end_header\n0.1 0.33333334 -0 0.1 4294967295\n"));
}

TEST_CASE("ply: types that no longer fit become wider") {
  Document document;
  document.style.format = Format::ply_ascii;
  const auto index_type = [&](Scalar type, std::size_t vertices) {
    document.mesh.positions.assign(vertices, Vec3(0, 0, 0));
    document.style.face_list_index = type;
    const std::string bytes = write_mesh(document).bytes;
    const std::size_t start = bytes.find("list uchar ") + 11;
    return bytes.substr(start, bytes.find(' ', start) - start);
  };
  CHECK(index_type(Scalar::uint8, 256) == "uchar");
  CHECK(index_type(Scalar::uint8, 257) == "short");
  CHECK(index_type(Scalar::int8, 128) == "char");
  CHECK(index_type(Scalar::int8, 129) == "short");
  CHECK(index_type(Scalar::int16, 32769) == "int");
  CHECK(index_type(Scalar::uint16, 65536) == "ushort");
  CHECK(index_type(Scalar::uint16, 65537) == "int");

  document.mesh.positions.assign(1, Vec3(0, 0, 0));
  Column& list = document.mesh.vertex_columns.get("ring", Scalar::int8, 0);
  list.list_count_type = Scalar::int8;
  list.values.assign(200, 1);
  list.list_offsets = {0, 200};
  CHECK(contains(write_mesh(document).bytes, "property list short char ring\n"));
}

TEST_CASE("ply: values that do not fit a column's type are the nearest that do") {
  Document document;
  document.style.format = Format::ply_ascii;
  document.mesh.positions.assign(4, Vec3(0, 0, 0));
  document.mesh.vertex_columns.get("red", Scalar::uint8, 4).values = {300, -1, 2.6, std::nan("")};
  CHECK(contains(write_mesh(document).bytes, "0 0 0 255\n0 0 0 0\n0 0 0 3\n0 0 0 0\n"));
}

TEST_CASE("ply: a coordinate too large for float is refused") {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.positions[2] = {0, 1e39, 0};
  document.style.coordinate = Scalar::float32;
  CHECK_THROWS_WITH_AS(write_mesh(document),
                       "vertex 2 has a coordinate too large for float: write double", GoalError);
}

TEST_CASE("ply: a column of the wrong length is refused") {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.vertex_columns.get("q", Scalar::float32, 3);
  CHECK_THROWS_AS(write_mesh(document), GoalError);
}

TEST_CASE("ply: comments stay one line each") {
  Document document;
  document.style.comments = {"two\nlines"};
  CHECK(contains(write_mesh(document).bytes, "\ncomment two lines\nelement"));
}
