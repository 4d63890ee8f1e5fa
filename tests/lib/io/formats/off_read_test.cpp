#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

}  // namespace

TEST_CASE("off: the plain format by hand") {
  const std::string text = "OFF\n# a comment\n3 1 0\n0.1 0 1e-20\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Document document = read_document(text);
  CHECK(document.mesh.positions == std::vector<Vec3>{{0.1, 0, 1e-20}, {1, 0, 0}, {0, 1, 0}});
  CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(document.style.format == Format::off);
  CHECK(document.style.coordinate == Scalar::float64);
  CHECK(document.style.comments == std::vector<std::string>{"a comment"});
  CHECK(write_mesh(document).bytes == text);
}

TEST_CASE("off: counts, comments and blank lines at unusual places") {
  for (const std::string start :
       {"OFF\n4 1 6\n", "OFF 4 1 6\n", "OFF4 1 6\n", "OFF 4 1\n",
        "\n\n# first\n  OFF # kind\n\n4 1 6 # n\n", "OFF\r\n4 1 6\r\n", "COFF 4 1 0\n"}) {
    const bool has_colors = start[0] == 'C';
    std::string body = "\n" + points;
    if (has_colors) body = "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n0 0 1 1 2 3\n";
    const Mesh mesh = read_document(start + body + "# faces\n3 1 2 3 # last\n").mesh;
    CHECK(mesh.positions[3] == Vec3(0, 0, 1));
    CHECK(mesh.faces == std::vector<Face>{{1, 2, 3}});
  }
  CHECK(read_mesh("4 1 0\n" + points + "3 0 1 2\n", "a.off").document.mesh.faces.size() == 1);
  CHECK(has_note(read_mesh("OFF 1 0 0 # x\n0 0 0\n", "input").notes,
                 "off: 1 comment after data dropped"));
}

TEST_CASE("off: normals, colors and texture coordinates of vertices") {
  const std::string text =
      "STCNOFF\n2 0 0\n0 0 0 1 0 0 10 20 30 255 0.5 0.25\n1 0 0 0 0.5 1 11 21 31 0 1 0\n";
  const Document document = read_document(text);
  const Columns& columns = document.mesh.vertex_columns;
  CHECK(column(columns, "ny").values == std::vector<double>{0, 0.5});
  CHECK(column(columns, "red").type == Scalar::uint8);
  CHECK(column(columns, "red").values == std::vector<double>{10, 11});
  CHECK(column(columns, "alpha").values == std::vector<double>{255, 0});
  CHECK(column(columns, "t").values == std::vector<double>{0.25, 0});
  CHECK(write_mesh(document).bytes == text);

  for (const std::string keyword : {"NOFF", "CNOFF", "NCOFF", "COFF", "STOFF", "NCSTOFF"}) {
    std::string row = "0 0 0";
    if (contains(keyword, "N")) row += " 1 0 0";
    if (contains(keyword, "C")) row += " 0.5 1.0 0.0";
    if (contains(keyword, "ST")) row += " 0.25 0.75";
    const Document each = read_document(keyword + "\n1 0 0\n" + row + "\n");
    CHECK((each.mesh.vertex_columns.find("nx") != nullptr) == contains(keyword, "N"));
    CHECK((each.mesh.vertex_columns.find("blue") != nullptr) == contains(keyword, "C"));
    CHECK((each.mesh.vertex_columns.find("s") != nullptr) == contains(keyword, "ST"));
    CHECK(contains(write_mesh(each).bytes, "\n" + row + "\n"));
  }
}

TEST_CASE("off: an empty mesh keeps its normals") {
  CHECK(rewritten("NOFF\n0 0 0\n") == "NOFF\n0 0 0\n");
}

TEST_CASE("off: numbers behind plain vertices are a color, and that is said") {
  const ReadResult result = read_mesh("OFF\n1 0 0\n0 0 0 255 0 7\n", "input");
  CHECK(column(result.document.mesh.vertex_columns, "blue").values == std::vector<double>{7});
  CHECK(has_note(result.notes, "off: 3 further numbers of each vertex are read as its color"));
}

TEST_CASE("off: colors of faces as integers, as decimals and as an index") {
  const std::string start = "OFF\n4 2 0\n" + points;
  const auto faces = [&](const std::string& lines) { return read_document(start + lines).mesh; };
  Mesh mesh = faces("3 0 1 2 255 0 9\n3 0 1 3 1 2 3\n");
  CHECK(column(mesh.face_columns, "red").type == Scalar::uint8);
  CHECK(column(mesh.face_columns, "blue").values == std::vector<double>{9, 3});
  CHECK(mesh.face_columns.find("alpha") == nullptr);

  mesh = faces("3 0 1 2 1.0 0.000 0.25 0.75\n4 0 1 2 3 1 0 0 1\n");
  CHECK(column(mesh.face_columns, "red").type == Scalar::float64);
  CHECK(column(mesh.face_columns, "alpha").values == std::vector<double>{0.75, 1, 1});
  const std::string decimals = start + "3 0 1 2 1.0 0.0 0.25\n3 0 1 3 1.0 1.0 1.0\n";
  CHECK(rewritten(decimals) == decimals);

  // Integers and decimals in one file: each row has its scale.
  const ReadResult mixed = read_mesh(
      "OFF\n4 3 0\n" + points + "3 0 1 2 0.5 0 1\n3 0 1 3 255 51 0\n3 0 2 3 1 0 1\n", "input");
  CHECK(column(mixed.document.mesh.face_columns, "red").values == std::vector<double>{0.5, 1, 1});
  CHECK(column(mixed.document.mesh.face_columns, "green").values == std::vector<double>{0, 0.2, 0});
  CHECK(has_note(
      mixed.notes,
      "off: 1 color of integers up to 255 divided by 255, because others have decimals up to 1"));
  // Decimals up to 255.
  mesh = faces("3 0 1 2 127.5 0 1\n3 0 1 3 255 51 0\n");
  CHECK(column(mesh.face_columns, "red").values == std::vector<double>{127.5, 255});

  mesh = faces("3 0 1 2 7\n3 0 1 3 8\n");
  CHECK(column(mesh.face_columns, "color_index").values == std::vector<double>{7, 8});
}

TEST_CASE("off: values that are not finite are dropped with a count") {
  const std::string text =
      "STNCOFF\n4 2 0\n0 0 0 0 0 1 1 2 3 0 0\n1 0 0 0 nan 1 1 2 3 0 0\n"
      "0 1 0 0 0 1 1 inf 3 0 nan\n0 -inf 0 0 0 1 1 2 3 0 0\n3 0 1 2 1 nan 1\n3 0 1 3 1 2 3\n";
  const ReadResult result = read_mesh(text, "input");
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(column(mesh.vertex_columns, "nz").values == std::vector<double>{1, 0, 1});
  CHECK(column(mesh.vertex_columns, "blue").values == std::vector<double>{3, 3, 0});
  CHECK(column(mesh.vertex_columns, "t").values == std::vector<double>{0, 0, 0});
  CHECK(column(mesh.face_columns, "red").values == std::vector<double>{0});
  CHECK(result.notes ==
        std::vector<std::string>{
            "off: 1 normal that is not finite becomes 0",
            "off: 1 color that is not finite becomes 0",
            "off: 1 texture coordinate that is not finite becomes 0",
            "off: 1 color that is not finite becomes 0",
            "off: 1 vertex with a coordinate that is not finite dropped, and 1 face that uses it"});
  CHECK(strict_error(text) ==
        "the normal of vertex 1 is not a finite number: 'nan' (input line 4)");
  CHECK(strict_error("OFF\n2 0 0\n0 0 0\n0 inf 0\n") ==
        "a coordinate of vertex 1 is not a finite number: 'inf' (input line 4)");
}

TEST_CASE("off: errors name the place") {
  const std::string start = "OFF\n4 1 0\n" + points;
  CHECK(read_error(start + "3 0 1 4\n") ==
        "face 0 has vertex index 4, but there are 4 vertices (input line 7)");
  CHECK(read_error(start + "3 0 1 -2\n") ==
        "face 0 has vertex index -2, but there are 4 vertices (input line 7)");
  CHECK(read_error(start + "3 0 1\n") == "a corner of face 0 is missing (input line 7)");
  CHECK(read_error(start + "-3 0 1 2\n") ==
        "the number of corners of face 0 is not a whole number of 0 or more: '-3' (input line 7)");
  CHECK(read_error(start) == "the data ends before face 0 of 1 (input line 7)");
  CHECK(read_error("OFF\n2 0 0\n0 0 0\n0 0\n") ==
        "a coordinate of vertex 1 is missing (input line 4)");
  CHECK(read_error("OFF\n2 0 0\n0 0 0\n0 0 0 5\n") ==
        "vertex 1 has more values than it should, beginning with '5' (input line 4)");
  CHECK(read_error("OFF\n1 0 0\n0 0 0 5\n") ==
        "vertex 0 has 4 numbers, which does not fit the header (input line 3)");
  CHECK(strict_error("OFF\n1 0 0\n1e400 0 0\n") ==
        "a coordinate of vertex 0 is out of range: '1e400' (input line 3)");
  CHECK(read_error("OFF\nx 0 0\n") ==
        "the count of vertices is not a whole number of 0 or more: 'x' (input line 2)");
  CHECK(read_error("OFF\n") ==
        "the data ends before the counts of vertices and faces (input line 2)");
  CHECK(contains(read_error("OFF BINARY\n\1\2\3"), "binary OFF is not supported"));
  CHECK(contains(read_error("OFF\n9223372036854775808 1 0\n0 0 0\n"),
                 "the header announces 9223372036854775808 vertices"));
  CHECK(read_error("OFF\n1 9223372036854775808 0\n0 0 0\n") ==
        "the data ends before face 0 of 9223372036854775808 (input line 4)");
}

TEST_CASE("off: a file that is cut at any byte, or lies about its counts, is refused") {
  const std::string text = "OFF\n4 2 0\n" + points + "3 0 1 2\n3 0 1 3\n";
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    CAPTURE(size);
    CHECK(read_error(text.substr(0, size), "a.off") != "read");
  }
  CHECK(read_error("OFF\n4 1 0\n" + points + "18446744073709551615 0 1 2\n") ==
        "a corner of face 0 is missing (input line 7)");
  CHECK(read_error("OFF\n4 1 0\n" + points + "3 0 1 1.5\n") != "read");
  CHECK(has_note(read_mesh("OFF\n4 1 0\n" + points + "3 0 1 2\n3 0 1 3\n", "input").notes,
                 "off: data after the last face ignored"));
}
