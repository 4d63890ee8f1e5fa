#include "io/formats/pcd.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string fields =
    "VERSION 0.7\nFIELDS x y z i\nSIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 1\n";

Bytes two_points() {
  Bytes bytes;
  bytes.f32(1).f32(2).f32(3).u16(40000).f32(5).f32(6).f32(7).u16(8);
  return bytes;
}

}  // namespace

TEST_CASE("pcd: text with normals, colors and points that were not measured") {
  const ReadResult result = read_mesh(
      "# .PCD v.7\nVERSION .7\nFIELDS x y z normal_x normal_y normal_z rgba ring\nSIZE 4 4 4 4 4 4 "
      "4 1\n"
      "TYPE F F F F F F U U\nCOUNT 1 1 1 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
      "POINTS 3\nDATA ascii\n1 2 3 0 0 1 4278255615 7\nnan nan nan 0 0 0 0 0\n4 5 6 0 1 0 1 8\n",
      "input");
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.positions == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(column(mesh.vertex_columns, "ny").values == std::vector<double>{0, 1});
  // 4278255615 is 0xff00ffff: opaque, no red, full green and blue.
  CHECK(column(mesh.vertex_columns, "red").values == std::vector<double>{0, 0});
  CHECK(column(mesh.vertex_columns, "green").values == std::vector<double>{255, 0});
  CHECK(column(mesh.vertex_columns, "alpha").values == std::vector<double>{255, 0});
  CHECK(column(mesh.vertex_columns, "ring").type == Scalar::uint8);
  CHECK(has_note(result.notes, "pcd: 1 vertex with a coordinate that is not finite dropped"));
}

TEST_CASE("pcd: binary points") {
  const std::string head = fields + "WIDTH 2\nHEIGHT 1\nDATA binary\n";
  const Document document = read_document(head + two_points().str());
  CHECK(document.mesh.positions == std::vector<Vec3>{{1, 2, 3}, {5, 6, 7}});
  CHECK(column(document.mesh.vertex_columns, "i").values == std::vector<double>{40000, 8});
  CHECK(contains(read_error(head + two_points().str().substr(1)),
                 "2 points, but only 27 bytes follow"));
}

TEST_CASE("pcd: integers that doubles may not hold are reported, in text and in bytes") {
  const std::string head =
      "VERSION 0.7\nFIELDS x y z id\nSIZE 4 4 4 8\nTYPE F F F I\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT "
      "1\n";
  const std::string note =
      "pcd: 1 integer of field 'id' is 2^53 or larger, and may be rounded: numbers are kept as "
      "doubles";
  const auto text = [&](const char* id) {
    return read_mesh(head + "DATA ascii\n0 0 0 " + id + "\n1 2 3 5\n", "input");
  };
  CHECK(has_note(text("9007199254740993").notes, note));
  CHECK(has_note(text("-9007199254740993").notes, note));
  CHECK(text("9007199254740991").notes.empty());
  Bytes bytes;
  bytes.f32(1).f32(2).f32(3).u32(1).u32(1U << 21U).f32(5).f32(6).f32(7).u32(8).u32(0);
  CHECK(has_note(read_mesh(head + "DATA binary\n" + bytes.str(), "input").notes, note));
}

TEST_CASE("pcd: points compressed by LZF, field by field") {
  // The 28 bytes are x of both points, then y, z and i. z equals y, and is thus packed as a
  // reference to the bytes 8 before.
  Bytes packed;
  packed.u8(15).f32(1).f32(5).f32(2).f32(6).u8(6 * 32).u8(7).u8(3).u16(9).u16(8);
  const auto file = [&](std::size_t size) {
    Bytes bytes;
    bytes.text(fields + "POINTS 2\nDATA binary_compressed\n").u32(packed.str().size()).u32(size);
    return bytes.text(packed.str()).str();
  };
  const Document document = read_document(file(28));
  CHECK(document.mesh.positions == std::vector<Vec3>{{1, 2, 2}, {5, 6, 6}});
  CHECK(column(document.mesh.vertex_columns, "i").values == std::vector<double>{9, 8});
  CHECK(contains(read_error(file(27)), "2 points"));
  std::string damaged = file(28);
  damaged[damaged.size() - 6] = 100;  // the reference is to bytes before the first byte
  CHECK(contains(read_error(damaged), "the compressed PCD data is damaged"));
}

TEST_CASE("pcd: headers that make no sense") {
  CHECK(contains(read_error("VERSION 0.7\nFIELDS x y\n"), "ends before the line DATA"));
  CHECK(contains(read_error("VERSION 0.7\nFIELDS x y\nDATA ascii\n"), "no field z"));
  CHECK(contains(read_error("VERSION 0.7\nFIELDS x y z\nSIZE 3 4 4\nDATA ascii\n"),
                 "field 'x' has a type that is not supported"));
  CHECK(contains(read_error("VERSION 0.7\nFIELDS x y z\nWIDTH 4000000\nDATA ascii\n1 2 3\n"),
                 "4000000 points, but only 6 bytes follow"));
  CHECK(contains(read_error("VERSION 0.7\nFIELDS x y z\nPOINTS 2\nDATA ascii\n1 2 3\n"),
                 "the data ends before point 1 of 2"));
  CHECK(
      contains(read_error(fields + "POINTS 1\nDATA zip\n"), "the encoding 'zip' is not supported"));
}

TEST_CASE("pcd: text with numbers that the type of their field does not hold") {
  const Document document = read_document(
      "VERSION .7\nFIELDS x y z ring\nSIZE 4 4 8 1\nTYPE F F F U\nCOUNT 1 1 1 1\nPOINTS 1\n"
      "DATA ascii\n0.1 0 0.1 256\n");
  CHECK(document.mesh.positions[0] == Vec3(static_cast<double>(0.1F), 0, 0.1));
  CHECK(column(document.mesh.vertex_columns, "ring").type == Scalar::float64);
}
