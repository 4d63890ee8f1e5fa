#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

TEST_CASE("obj: texture coordinates of corners") {
  const std::string text = points +
                           "vt 0.1 0.25\nvt 1 0\nvt -3 2\n"
                           "f 1/1 2/2 3/3\nf 1 3 4\nf 4/3 2/1 1/1\n";
  const Document document = read_document(text);
  const Column& lists = column(document.mesh.face_columns, "texcoord");
  CHECK(lists.type == Scalar::float32);
  CHECK(lists.list_offsets == std::vector<std::size_t>{0, 6, 6, 12});
  CHECK(lists.values ==
        std::vector<double>{0.1F, 0.25, 1, 0, -3, 2, -3, 2, 0.1F, 0.25, 0.1F, 0.25});
  CHECK(write_mesh(document).bytes == text);
  CHECK(write_mesh(document).notes.empty());

  // Coordinates are doubles if floats would lose digits. A polygon is triangulated together with
  // its coordinates.
  const Document polygon =
      read_document(points + "vt 0.123456789 0\nvt 1\nvt 1 1 0\nvt 0 1\nf 4/-4/7 1/-3 2/3 3/4//\n");
  const Column& fan = column(polygon.mesh.face_columns, "texcoord");
  CHECK(fan.type == Scalar::float64);
  CHECK(fan.values == std::vector<double>{0.123456789, 0, 1, 0, 1, 1, 0.123456789, 0, 1, 1, 0, 1});
}

TEST_CASE("obj: texture coordinates that vertices have by their numbers") {
  const std::string text =
      points + "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3\nf 4/4 2/2 1/1\n";
  const Document document = read_document(text);
  CHECK(document.mesh.face_columns.columns.empty());
  CHECK(column(document.mesh.vertex_columns, "s").values == std::vector<double>{0, 1, 0, 1});
  CHECK(column(document.mesh.vertex_columns, "t").values == std::vector<double>{0, 0, 1, 1});
  CHECK(write_mesh(document).bytes == text);
}

TEST_CASE("obj: missing texture coordinates are refused") {
  const ReadResult result = read_mesh(
      points + "vt 0 0\nvt nan 0\nvt 1 1 7\nf 1/1 2/2 3/1\nf 1/1 2/1 3/4\nf 1/1 2 3/1\n", "input");
  CHECK(result.document.mesh.face_columns.columns.empty());
  CHECK(result.document.mesh.faces.size() == 3);
  CHECK(has_note(
      result.notes,
      "obj: 3 faces left without texture coordinates, because those of a corner are missing"));
  CHECK(has_note(result.notes, "obj: third numbers of 1 texture coordinate left out"));
  CHECK(read_error("v 0 0 0\nvt a 0\n") ==
        "a texture coordinate is not a number: 'a' (input line 2)");
  CHECK(read_error("v 0 0 0\nvt\n") == "a texture coordinate is missing (input line 2)");
}

TEST_CASE("obj: numbers of texture points count back from those read so far") {
  // Two more texture coordinates precede the second face.
  const Document document = read_document(points +
                                          "vt 0 0\nvt 1 0\nvt 0 1\nf 1/-3 2/-2 3/-1\n"
                                          "vt 4 4\nvt 5 5\nf 1/-5 2/-2 4/-1\n");
  CHECK(column(document.mesh.face_columns, "texcoord").values ==
        std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 4, 4, 5, 5});
}

TEST_CASE("obj: numbers of texture points as large as they get name no point") {
  for (const std::string number : {"9223372036854775807", "-9223372036854775808", "4294967297",
                                   "-2", "2", "99999999999999999999"}) {
    CAPTURE(number);
    const ReadResult result =
        read_mesh(points + "vt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/1 4/" + number + "\n", "input");
    const Column& lists = column(result.document.mesh.face_columns, "texcoord");
    CHECK(lists.list_offsets == std::vector<std::size_t>{0, 6, 6});
    CHECK(has_note(
        result.notes,
        "obj: 1 face left without texture coordinates, because those of a corner are missing"));
  }
}
