// Rows of binary PLY written by hand, truncated at every byte, and with wrong counts.
#include "lib/io/bytes.h"
#include "lib/io/ply_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::string head(bool is_big, const std::string& rest) {
  return std::string("ply\nformat ") + (is_big ? "binary_big_endian" : "binary_little_endian") +
         " 1.0\n" + rest + "end_header\n";
}

const std::string three_vertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

/// A triangle whose face has a list of shorts and an 8-byte number.
std::string triangle(bool is_big) {
  Bytes file(is_big);
  file.text(head(is_big, three_vertices +
                             "element face 1\nproperty list uchar int vertex_indices\n"
                             "property list ushort short marks\nproperty double weight\n"));
  for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) file.f32(value);
  file.u8(3).u32(0).u32(1).u32(2).u16(2).u16(7).u16(0xffff).f64(0.25);
  return file.str();
}

}  // namespace

TEST_CASE("binary ply: lists and numbers of a face in both byte orders") {
  for (const bool is_big : {false, true}) {
    const Document document = read_document(triangle(is_big));
    CHECK(document.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}});
    const Column& marks = column(document.mesh.face_columns, "marks");
    CHECK(marks.values == std::vector<double>{7, -1});
    CHECK(marks.list_offsets == std::vector<std::size_t>{0, 2});
    CHECK(column(document.mesh.face_columns, "weight").values == std::vector<double>{0.25});
    CHECK(rewritten(triangle(is_big)) == triangle(is_big));
  }
}

TEST_CASE("binary ply: a file that is cut at any byte is refused") {
  const std::string whole = triangle(false);
  const std::size_t data = whole.find("end_header\n") + 11;
  for (std::size_t size = data; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK(read_error(whole.substr(0, size)) != "read");
  }
}

TEST_CASE("binary ply: counts and indices beyond the file are refused before memory is taken") {
  Bytes many;
  many.text(head(false,
                 "element vertex 4000000000\nproperty float x\nproperty float y\n"
                 "property float z\n"));
  many.f32(0).f32(0).f32(0);
  CHECK(read_error(many.str()) != "read");

  for (const std::uint64_t index : {std::uint64_t{3}, std::uint64_t{0xffffffff}}) {
    Bytes file;
    file.text(
        head(false, three_vertices + "element face 1\nproperty list uchar int vertex_indices\n"));
    for (int i = 0; i < 9; ++i) file.f32(static_cast<float>(i * i));
    file.u8(3).u32(0).u32(1).u32(index);
    CHECK(read_error(file.str()) != "read");
  }
}

TEST_CASE("binary ply: strict reading refuses a coordinate that is not finite, with its vertex") {
  Bytes file;
  file.text(head(false, three_vertices));
  for (int i = 0; i < 8; ++i) file.f32(1);
  file.f32(std::numeric_limits<float>::infinity());
  CHECK(contains(strict_error(file.str()), "vertex 2"));
  CHECK(read_document(file.str()).mesh.positions.size() == 2);
}

namespace {

/// Three vertices and the row of one face.
std::string face_row(const std::string& list, const Bytes& row) {
  Bytes file;
  file.text(
      head(false, three_vertices + "element face 1\nproperty list " + list + " vertex_indices\n"));
  for (int i = 0; i < 9; ++i) file.f32(static_cast<float>(i * i));
  return file.text(row.str()).str();
}

}  // namespace

TEST_CASE("binary ply: errors name the face, its value and the byte") {
  const auto check = [](const std::string& list, const Bytes& row, const std::string& what,
                        std::size_t end) {
    const std::size_t place = face_row(list, Bytes()).size() + end;
    CHECK(read_error(face_row(list, row)) == what + " (input byte " + std::to_string(place) + ")");
  };
  const std::string index = "face 0 has vertex index ", count = ", but there are 3 vertices";
  // Different loops read rows of the common layout and rows with shorts.
  check("uchar int", Bytes().u8(3).u32(0).u32(1).u32(3), index + "3" + count, 13);
  check("uchar int", Bytes().u8(3).u32(0).u32(0xffffffff).u32(1), index + "-1" + count, 9);
  check("uchar short", Bytes().u8(3).u16(0).u16(1).u16(0xffff), index + "-1" + count, 7);

  const std::string length = "the length of property 'vertex_indices' of face 0 is ";
  const std::string left = ", with only 12 bytes left";
  check("int int", Bytes().u32(0xffffffff).u32(0).u32(1).u32(2), length + "-1" + left, 4);
  check("uint int", Bytes().u32(0xffffffff).u32(0).u32(1).u32(2), length + "4294967295" + left, 4);
  check("char int", Bytes().u8(0x83).u32(0).u32(1).u32(2), length + "-125" + left, 1);
}
