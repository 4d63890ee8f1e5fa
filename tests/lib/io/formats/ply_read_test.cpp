#include "lib/io/bytes.h"
#include "lib/io/ply_text.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// A binary mesh with values that are not finite.
std::string binary_with_bad_values(bool is_big) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  Bytes file(is_big);
  file.text(header(is_big ? "binary_big_endian" : "binary_little_endian",
                   "element face 3\n" + face_header + "property float nx\nproperty float ny\n" +
                       "property float nz\nproperty int label\nelement vertex 5\n" + vertex_header +
                       "property float nx\nproperty float ny\n" +
                       "property float nz\nproperty float red\nproperty float green\n" +
                       "property float blue\n"));
  file.u8(3).u32(0).u32(1).u32(2).f32(0).f32(nan).f32(0).u32(5);
  file.u8(3).u32(1).u32(2).u32(3).f32(0).f32(0).f32(1).u32(6);
  file.u8(3).u32(2).u32(1).u32(4).f32(0).f32(0).f32(1).u32(7);
  const auto vertex = [&](const std::vector<float>& values) {
    for (const float value : values) file.f32(value);
  };
  vertex({0, 0, 0, 0, 0, 1, 0, 0, 0});
  vertex({1, 0, 0, nan, 0, 1, 1, 1, 1});
  vertex({0, 1, 0, 0, 0, 1, 1, infinity, 1});
  vertex({nan, nan, nan, 0, 0, 1, 0, 0, 0});
  vertex({0, 0, 1, 0, 0, 1, 0, 0, 0});
  return file.str();
}

}  // namespace

TEST_CASE("ply: ascii by hand") {
  const Document document = read_document(
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info num_cols 3\ncomment \n"
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
      "0.1 -2e3 3 255\n  1 2 3   0  \n\n7 8 9 17\n3 2 1 0\n");
  CHECK(document.mesh.positions == std::vector<Vec3>{{0.1, -2000, 3}, {1, 2, 3}, {7, 8, 9}});
  CHECK(document.mesh.faces == std::vector<Face>{{2, 1, 0}});
  CHECK(document.style.format == Format::ply_ascii);
  CHECK(document.style.coordinate == Scalar::float64);
  CHECK(document.style.comments == std::vector<std::string>{"made by hand", ""});
  CHECK(document.style.obj_info == std::vector<std::string>{"num_cols 3"});
  CHECK(document.style.face_list == "vertex_index");
  const Column& red = column(document.mesh.vertex_columns, "red");
  CHECK(red.type == Scalar::uint8);
  CHECK(red.values == std::vector<double>{255, 0, 17});
}

TEST_CASE("ply: binary by hand, both byte orders, coordinates among odd properties") {
  for (const bool is_big : {false, true}) {
    const std::string encoding = is_big ? "binary_big_endian" : "binary_little_endian";
    Bytes file(is_big);
    file.text(header(encoding,
                     "element vertex 3\nproperty uint16 code\nproperty float64 x\n"
                     "property float64 y\nproperty float64 z\nproperty list uint8 int16 around\n"
                     "element face 2\nproperty int8 side\nproperty list uint32 uint16 "
                     "vertex_indices\nproperty float32 weight\n"));
    file.u16(65535).f64(0.1).f64(-1).f64(1e300).u8(2).u16(0x8000).u16(7);
    file.u16(1).f64(1).f64(2).f64(3).u8(0);
    file.u16(2).f64(4).f64(5).f64(6).u8(1).u16(1);
    file.u8(0xff).u32(3).u16(0).u16(1).u16(2).f32(0.25F);
    file.u8(5).u32(3).u16(2).u16(1).u16(0).f32(-1);
    const Document document = read_document(file.str());
    CHECK(document.mesh.positions == std::vector<Vec3>{{0.1, -1, 1e300}, {1, 2, 3}, {4, 5, 6}});
    CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}, {2, 1, 0}});
    CHECK(document.style.position_column == 1);
    CHECK(document.style.face_list_column == 1);
    CHECK(document.style.face_list_count == Scalar::uint32);
    CHECK(document.style.face_list_index == Scalar::uint16);
    const Columns& columns = document.mesh.vertex_columns;
    CHECK(column(columns, "code").values == std::vector<double>{65535, 1, 2});
    CHECK(column(columns, "around").values == std::vector<double>{-32768, 7, 1});
    CHECK(column(columns, "around").list_offsets == std::vector<std::size_t>{0, 2, 2, 3});
    CHECK(column(document.mesh.face_columns, "side").values == std::vector<double>{-1, 5});
    CHECK(column(document.mesh.face_columns, "weight").values == std::vector<double>{0.25, -1});
    CHECK(write_mesh(document).bytes == file.str());
  }
}

TEST_CASE("ply: a column of every scalar type keeps its extremes, in both spellings") {
  const std::vector<std::string> plain{"char", "uchar", "short", "ushort",
                                       "int",  "uint",  "float", "double"};
  const std::vector<std::string> sized{"int8",  "uint8",  "int16",   "uint16",
                                       "int32", "uint32", "float32", "float64"};
  for (const auto& names : {plain, sized}) {
    std::string lines = "element vertex 2\n";
    for (const char* axis : {"x", "y", "z"}) lines += "property " + names[6] + ' ' + axis + '\n';
    for (std::size_t i = 0; i < names.size(); ++i) {
      lines += "property " + names[i] + " p" + std::to_string(i) + '\n';
    }
    Bytes file;
    file.text(header("binary_little_endian", lines));
    file.f32(0).f32(1).f32(2);
    file.u8(0x80).u8(0xff).u16(0x8000).u16(0xffff).u32(0x80000000).u32(0xffffffff);
    file.f32(1e-45F).f64(5e-324);
    file.f32(3).f32(4).f32(5);
    file.u8(0x7f).u8(0).u16(0x7fff).u16(0).u32(0x7fffffff).u32(0).f32(-3e38F).f64(1.7e308);
    Document document = read_document(file.str());
    const double lowest[] = {-128, 255, -32768, 65535, -2147483648.0, 4294967295.0};
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(document.mesh.vertex_columns.columns[i].values[0] == lowest[i]);
    }
    CHECK(write_mesh(document).bytes == file.str());

    // The same mesh as text and in the other byte order.
    for (const Format format : {Format::ply_ascii, Format::ply_big}) {
      document.style.format = format;
      Document back = read_document(write_mesh(document).bytes);
      back.style.format = Format::ply_little;
      CHECK(write_mesh(back).bytes == file.str());
    }
  }
}

TEST_CASE("ply: unknown elements keep their place and their lists") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement camera 1\nproperty float focal\nelement face 1\n"
      "property list uchar int vertex_indices\nelement edge 2\nproperty int vertex1\n"
      "property int vertex2\nelement nothing 4\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement path 2\nproperty list uchar uint stops\n"
      "end_header\n1.5\n3 0 1 2\n0 1\n1 2\n0 0 0\n1 0 0\n0 1 0\n3 7 8 9\n0\n";
  const Document document = read_document(text);
  REQUIRE(document.other_elements.size() == 4);
  CHECK(document.other_elements[0].name == "camera");
  CHECK(document.other_elements[2].rows == 4);
  CHECK(column(document.other_elements[3].columns, "stops").list_offsets ==
        std::vector<std::size_t>{0, 3, 3});
  CHECK(write_mesh(document).bytes == text);
}

TEST_CASE("ply: a point cloud stays without a face element") {
  const std::string text = header("ascii", "element vertex 1\n" + vertex_header) + "1 2 3\n";
  CHECK(read_document(text).mesh.faces.empty());
  CHECK(rewritten(text) == text);
  Document with_face = read_document(text);
  with_face.mesh.faces.push_back({0, 0, 0});
  CHECK(contains(write_mesh(with_face).bytes, "element face 1\n"));
}

TEST_CASE("ply: polygons become fans with their columns; small faces are dropped") {
  const std::string text =
      header("ascii", "element vertex 5\n" + vertex_header + "element face 4\n" + face_header +
                          "property int label\nproperty list uchar float uv\n") +
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n"
      "2 0 1 10 0\n4 0 1 2 3 20 1 0.5\n3 0 1 4 30 0\n5 4 3 2 1 0 40 2 1 2\n";
  const ReadResult result = read_mesh(text, "input");
  const Mesh& mesh = result.document.mesh;
  const std::vector<Face> expected{{0, 1, 2}, {0, 2, 3}, {0, 1, 4},
                                   {4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
  CHECK(mesh.faces == expected);
  CHECK(column(mesh.face_columns, "label").values == std::vector<double>{20, 20, 30, 40, 40, 40});
  CHECK(column(mesh.face_columns, "uv").values == std::vector<double>{0.5, 0.5, 1, 2, 1, 2, 1, 2});
  CHECK(result.notes ==
        std::vector<std::string>{"ply: 2 polygons cut into 5 triangles",
                                 "ply: 1 face with fewer than three corners dropped"});
}

TEST_CASE("ply: the fast path and the general one read the same") {
  // Faces have a property before and one after the corners. If `has_quad`, a face in the middle is
  // a quad.
  for (const bool has_quad : {false, true}) {
    std::vector<std::string> results;
    for (const std::string count_type : {"uchar", "int"}) {
      Bytes file;
      file.text(header("binary_little_endian",
                       "element vertex 100\n" + vertex_header + "element face 300\n" +
                           "property short before\nproperty list " + count_type +
                           " uint vertex_indices\nproperty double after\n"));
      for (int i = 0; i < 100; ++i) file.f32(static_cast<float>(i)).f32(0).f32(0.5F);
      for (std::uint32_t i = 0; i < 300; ++i) {
        const std::uint32_t corners = has_quad && i == 150 ? 4 : 3;
        file.u16(i);
        count_type == "int" ? file.u32(corners) : file.u8(corners);
        for (std::uint32_t k = 0; k < corners; ++k) file.u32((i * 7 + k * 13) % 100);
        file.f64(i * 0.1);
      }
      Document document = read_document(file.str());
      CHECK(document.mesh.faces.size() == (has_quad ? 301 : 300));
      CHECK(document.mesh.faces.back() == Face{93, 6, 19});
      CHECK(document.mesh.face_columns.find("before")->values.back() == 299);
      CHECK(document.mesh.face_columns.find("after")->values.back() == 299 * 0.1);
      document.style.format = Format::ply_ascii;
      document.style.face_list_count = Scalar::uint8;
      results.push_back(write_mesh(document).bytes);
    }
    CHECK(results[0] == results[1]);
  }
}

TEST_CASE("ply: coordinates of any type and in any order") {
  const ReadResult result =
      read_mesh(header("ascii",
                       "element vertex 1\nproperty short z\nproperty uchar q\n"
                       "property int x\nproperty char y\n") +
                    "-300 9 70000 -7\n",
                "input");
  CHECK(result.document.mesh.positions == std::vector<Vec3>{{70000, -7, -300}});
  CHECK(result.document.style.coordinate == Scalar::float64);
  CHECK(has_note(result.notes, "ply: integer coordinates become double"));
  CHECK(
      has_note(result.notes,
               "ply: the vertex properties x, y and z will be written side by side in this order"));
}

TEST_CASE("ply: what is not a number may be an attribute but not a coordinate") {
  const std::string lines = "element vertex 1\n" + vertex_header + "property float q\n";
  CHECK(std::isnan(read_document(header("ascii", lines) + "0 0 0 nan\n")
                       .mesh.vertex_columns.columns[0]
                       .values[0]));
  CHECK(strict_error(header("ascii", lines) + "0 nan 0 1\n") ==
        "property 'y' of vertex 0 is not a finite number: 'nan' (input line 9)");
  CHECK(read_document(header("ascii", lines) + "0 nan 0 1\n").mesh.positions.empty());
  const float infinity = std::numeric_limits<float>::infinity();
  const std::string start = header("binary_little_endian", lines);
  const std::string bytes = Bytes().text(start).f32(0).f32(infinity).f32(0).f32(1).str();
  CHECK(strict_error(bytes) ==
        "vertex 0 has a coordinate that is not a finite number (input byte " +
            std::to_string(start.size()) + ")");
  CHECK(read_document(bytes).mesh.vertex_columns.columns[0].values.empty());
}

TEST_CASE(
    "ply: normals and colors that are not finite become 0, and vertices go with their faces") {
  const std::string text =
      header("ascii", "element face 3\n" + face_header + "property float nx\nproperty float ny\n" +
                          "property float nz\nproperty int label\nelement vertex 5\n" +
                          vertex_header + "property float nx\nproperty float ny\n" +
                          "property float nz\nproperty float red\nproperty float green\n" +
                          "property float blue\n") +
      "3 0 1 2 0 nan 0 5\n3 1 2 3 0 0 1 6\n3 2 1 4 0 0 1 7\n"
      "0 0 0 0 0 1 0 0 0\n1 0 0 nan 0 1 1 1 1\n0 1 0 0 0 1 1 inf 1\n"
      "nan nan nan 0 0 1 0 0 0\n0 0 1 0 0 1 0 0 0\n";
  for (const Format format : {Format::ply_ascii, Format::ply_little, Format::ply_big}) {
    std::string bytes = text;
    // written by hand, because the library does not write such values
    if (format != Format::ply_ascii) {
      bytes = binary_with_bad_values(format == Format::ply_big);
    }
    const ReadResult result = read_mesh(bytes, "input");
    const Mesh& mesh = result.document.mesh;
    CHECK(mesh.positions.size() == 4);
    CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {2, 1, 3}});
    CHECK(column(mesh.face_columns, "label").values == std::vector<double>{5, 7});
    CHECK(column(mesh.face_columns, "nz").values == std::vector<double>{0, 1});
    CHECK(column(mesh.vertex_columns, "nz").values == std::vector<double>{1, 0, 1, 1});
    CHECK(column(mesh.vertex_columns, "blue").values == std::vector<double>{0, 1, 0, 0});
    CHECK(result.notes ==
          std::vector<std::string>{"ply: 1 normal that is not finite becomes 0",
                                   "ply: 1 normal that is not finite becomes 0",
                                   "ply: 1 color that is not finite becomes 0",
                                   "ply: 1 vertex with a coordinate that is not finite "
                                   "dropped, and 1 face that uses it"});
    CHECK(contains(strict_error(bytes), "is not a finite number"));
  }
}

TEST_CASE("ply: rows of text that are longer than the header states are noted") {
  const ReadResult result = read_mesh(ascii_triangle("3 0 1 2 9 9"), "input");
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(result.notes.size() == 1);
  CHECK(contains(result.notes[0], "1 row of element 'face' with more values"));
  CHECK(contains(result.notes[0], "from line 13 on"));
}

TEST_CASE("ply: bytes after the data are noted") {
  const std::string text = ascii_triangle("3 0 1 2");
  CHECK(read_mesh(text + "\n\n", "input").notes.empty());
  CHECK(has_note(read_mesh(text + "junk", "input").notes,
                 "ply: data after the last element ignored"));
  Document document = read_document(text);
  document.style.format = Format::ply_little;
  CHECK(has_note(read_mesh(write_mesh(document).bytes + "junk", "input").notes,
                 "ply: 4 bytes after the last element ignored"));
}

TEST_CASE("ply: wrong values are refused with their place") {
  CHECK(read_error(ascii_triangle("3 0 1 3")) ==
        "face 0 has vertex index 3, but there are 3 vertices (input line 13)");
  CHECK(read_error(ascii_triangle("3 0 1 -1")) ==
        "face 0 has vertex index -1, but there are 3 vertices (input line 13)");
  CHECK(read_error(ascii_triangle("3 0 1")) ==
        "property 'vertex_indices' of face 0 is missing (input line 13)");
  CHECK(read_error(ascii_triangle("300 0 1 2")) ==
        "property 'vertex_indices' of face 0 does not fit its type uchar (input line 13)");
  CHECK(read_error(ascii_triangle("-3 0 1 2")) ==
        "property 'vertex_indices' of face 0 does not fit its type uchar (input line 13)");
  CHECK(read_error(ascii_triangle("3 0 1 2.5")) ==
        "property 'vertex_indices' of face 0 does not fit its type int (input line 13)");
  CHECK(read_error(ascii_triangle("3 0 1 two")) ==
        "property 'vertex_indices' of face 0 is not a number: 'two' (input line 13)");
  CHECK(read_error(ascii_triangle("")) == "the data ends before face 0 of 1 (input line 14)");
  CHECK(contains(strict_error(header("ascii", "element vertex 1\n" + vertex_header) + "0 1e39 0\n"),
                 "property 'y' of vertex 0 is out of range: '1e39'"));
}

TEST_CASE("ply: every cut of a binary file is refused") {
  Bytes file;
  file.text(header("binary_little_endian",
                   "element vertex 3\n" + vertex_header + "element face 2\n" + face_header +
                       "property uchar label\nelement path 1\nproperty list uchar short stops\n"));
  for (int i = 0; i < 9; ++i) file.f32(static_cast<float>(i));
  for (int i = 0; i < 2; ++i) file.u8(3).u32(0).u32(1).u32(2).u8(9);
  file.u8(2).u16(1).u16(2);
  CHECK(read_error(file.str()) == "read");
  for (std::size_t size = 0; size < file.str().size(); ++size) {
    INFO("size " << size);
    CHECK(read_error(file.str().substr(0, size)) != "read");
  }
}

TEST_CASE("ply: triangle strips are read as faces") {
  const std::string vertices = "1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n";
  const std::string start = "element vertex 6\n" + vertex_header +
                            "element tristrips 1\nproperty list int int " + "vertex_indices\n";
  const std::string strip = "20 0 1 4 2 -1 2 3 4 0 -1 1 0 5 3 -1 3 2 5 1 -1\n";
  const ReadResult result = read_mesh(header("ascii", start) + vertices + strip, "input");
  CHECK(
      result.document.mesh.faces ==
      std::vector<Face>{
          {0, 1, 4}, {4, 1, 2}, {2, 3, 4}, {4, 3, 0}, {1, 0, 5}, {5, 0, 3}, {3, 2, 5}, {5, 2, 1}});
  CHECK(result.notes ==
        std::vector<std::string>{"ply: 1 row of triangle strips cut into 8 triangles"});
  CHECK(read_document(write_mesh(result.document).bytes).mesh.faces.size() == 8);
  // A vertex that is named twice changes the parity of the strip.
  CHECK(read_document(header("ascii", start) + vertices + "6 0 1 2 2 3 4\n").mesh.faces ==
        std::vector<Face>{{0, 1, 2}, {3, 2, 4}});
  CHECK(contains(read_error(header("ascii", start) + vertices + "3 0 1 6\n"), "vertex index 6"));
  CHECK(contains(read_error(header("ascii", start) + vertices + "3 0 1 -2\n"), "vertex index -2"));
  // If there are faces, strips are ignored.
  const ReadResult both = read_mesh(
      header("ascii", start + "element face 1\n" + face_header) + vertices + strip + "3 0 1 2\n",
      "input");
  CHECK(both.document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(has_note(both.notes, "ply: 1 row of triangle strips left out, as there are faces"));
}
