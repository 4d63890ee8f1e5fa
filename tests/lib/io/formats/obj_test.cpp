#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

TEST_CASE("obj: by hand and back") {
  const std::string text = "# made by hand\nv 0.1 -2e-05 3\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n";
  const Document document = read_document(text);
  CHECK(document.mesh.positions == std::vector<Vec3>{{0.1, -2e-5, 3}, {1, 0, 0}, {0, 1, 0}});
  CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}, {2, 1, 0}});
  CHECK(document.style.format == Format::obj);
  CHECK(write_mesh(document).bytes == text);
}

TEST_CASE("obj: corners with textures and normals, negative and forward indices") {
  for (const std::string face : {"f 1/2/3 2/2/2 4/1/1", "f 1//3 2//-1 4//1", "f 1/1 2/1 4/1",
                                 "f 1// 2// 4//", "f -4 -3 -1", "f\t+1 2  4 ", "fo 1 2 4"}) {
    CHECK(read_document(points + face + "\n").mesh.faces == std::vector<Face>{{0, 1, 3}});
  }
  CHECK(read_document("f 1 2 3\n" + points).mesh.faces == std::vector<Face>{{0, 1, 2}});
  // Negative indices count from the vertices read so far.
  CHECK(read_document("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\n").mesh.faces ==
        std::vector<Face>{{0, 1, 2}});
}

TEST_CASE("obj: lines joined by a backslash, but not out of a comment") {
  CHECK(read_document(points + "f 1 \\\n2 \\\r\n 4\n").mesh.faces == std::vector<Face>{{0, 1, 3}});
  CHECK(read_document("v 0 0\\\n 5\n").mesh.positions == std::vector<Vec3>{{0, 0, 5}});
  CHECK(read_document("v 0 0 5\\\n").mesh.positions == std::vector<Vec3>{{0, 0, 5}});
  CHECK(read_document("# C:\\models\\\nv 1 2 3\n").mesh.positions == std::vector<Vec3>{{1, 2, 3}});
}

TEST_CASE("obj: polygons are cut, small faces dropped, the rest is named once") {
  const ReadResult result = read_mesh(
      "mtllib a.mtl\no thing\n" + points +
          "vn 0 0 1\nvn 0 1 0\nvt 0 0\ng part\nusemtl red\ns off\nf 1 2 3 4\nf 1 2\nl 1 2 # x\n",
      "input");
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 2, 3}});
  CHECK(result.notes ==
        std::vector<std::string>{"obj: 1 polygon cut into 2 triangles",
                                 "obj: 1 face with fewer than three corners dropped",
                                 "obj: 1 line 'l' left out", "obj: 1 line 's' left out",
                                 "obj: 2 lines 'vn' left out", "obj: 1 line 'vt' left out",
                                 "obj: 1 comment behind data left out"});
}

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

  // Doubles where floats would lose digits; a polygon is cut together with its coordinates.
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

TEST_CASE("obj: texture coordinates that are not there") {
  const ReadResult result = read_mesh(
      points + "vt 0 0\nvt nan 0\nvt 1 1 7\nf 1/1 2/2 3/1\nf 1/1 2/1 3/4\nf 1/1 2 3/1\n", "input");
  CHECK(result.document.mesh.face_columns.columns.empty());
  CHECK(result.document.mesh.faces.size() == 3);
  CHECK(has_note(result.notes,
                 "obj: 3 faces with texture coordinates that are not there left without"));
  CHECK(has_note(result.notes, "obj: third numbers of 1 texture coordinate left out"));
  CHECK(read_error("v 0 0 0\nvt a 0\n") ==
        "a texture coordinate is not a number: 'a' (input line 2)");
  CHECK(read_error("v 0 0 0\nvt\n") == "a texture coordinate is missing (input line 2)");
}

TEST_CASE("obj: groups, objects and materials") {
  const std::string text = "mtllib scan.mtl\n" + points +
                           "f 1 2 3\no Cube 1\ng left wing\nusemtl skin\nf 1 3 4\n"
                           "g 7\nf 2 3 4\ng default\nusemtl hair\nf 1 2 4\ng left wing\nf 1 2 3\n";
  const Document document = read_document(text);
  const Columns& columns = document.mesh.face_columns;
  CHECK(column(columns, "object").values == std::vector<double>{0, 1, 1, 1, 1});
  CHECK(column(columns, "group").values == std::vector<double>{0, 1, 7, 0, 1});
  CHECK(column(columns, "group").type == Scalar::int32);
  CHECK(column(columns, "material").values == std::vector<double>{0, 1, 1, 2, 2});
  CHECK(document.style.comments ==
        std::vector<std::string>{"tm:mtllib scan.mtl", "tm:object 1 Cube 1", "tm:group 1 left wing",
                                 "tm:material 1 skin", "tm:material 2 hair"});
  const WriteResult written = write_mesh(document);
  CHECK(written.bytes == text);
  CHECK(written.notes.empty());

  // By way of PLY too; numbers that no comment names are names themselves.
  Document other = read_document(written.bytes);
  other.style.format = Format::ply_little;
  other = read_document(write_mesh(other).bytes);
  other.style.format = Format::obj;
  CHECK(write_mesh(other).bytes == text);
  other.style.comments.clear();
  CHECK(contains(write_mesh(other).bytes, "o 1\ng 1\nusemtl 1\nf 1 3 4\ng 7\n"));
}

TEST_CASE("obj: names that could be taken for numbers, and comments that are none") {
  const std::string text = points + "g 1\nf 1 2 3\ng a\nf 1 2 4\ng 007\nf 2 3 4\n";
  const Document document = read_document(text);
  CHECK(column(document.mesh.face_columns, "group").values == std::vector<double>{1, 2, 3});
  CHECK(write_mesh(document).bytes == text);
  Document odd = document;
  odd.style.comments = {"tm:group 2 5", "tm:group 3 default", "tm:group x y", "tm:group 1 a#b\\"};
  CHECK(contains(write_mesh(odd).bytes, "g a_b_\nf 1 2 3\ng 2\nf 1 2 4\ng 3\n"));
  CHECK(
      read_document(points + "g\nf 1 2 3\ng default\nf 1 2 4\n").mesh.face_columns.columns.empty());
}

TEST_CASE("obj: colors from bytes become bytes, others stay decimals") {
  const Columns bytes = read_document("v 0 0 0 1 0 0.5019607843137255\n").mesh.vertex_columns;
  CHECK(column(bytes, "blue").type == Scalar::uint8);
  CHECK(column(bytes, "blue").values == std::vector<double>{128});
  const std::string text = "v 0 0 0 0.3 1 0.5\nv 1 0 0 0 0 0\n";
  CHECK(column(read_document(text).mesh.vertex_columns, "red").type == Scalar::float64);
  CHECK(rewritten(text) == text);

  Document document;
  document.style.format = Format::obj;
  for (int i = 0; i < 256; ++i) document.mesh.positions.emplace_back(i, 0, 0);
  for (const char* name : {"red", "green", "blue"}) {
    std::vector<double>& values = document.mesh.vertex_columns.get(name, Scalar::uint8, 256).values;
    for (std::size_t i = 0; i < 256; ++i) values[i] = static_cast<double>(i);
  }
  const Document back = read_document(write_mesh(document).bytes);
  CHECK(column(back.mesh.vertex_columns, "green").type == Scalar::uint8);
  CHECK(column(back.mesh.vertex_columns, "green").values ==
        document.mesh.vertex_columns.find("green")->values);

  const ReadResult partial = read_mesh("v 0 0 0 1 1 1\nv 1 0 0\n", "input");
  CHECK(has_note(partial.notes, "obj: 1 point without a color made black"));
}

TEST_CASE("obj: weights are left out, and said") {
  CHECK(read_mesh("v 0 0 0 1\n", "input").notes.empty());
  CHECK(has_note(read_mesh("v 0 0 0 2\n", "input").notes, "obj: weights of 1 vertex left out"));
}

TEST_CASE("obj: errors name the place") {
  CHECK(read_error(points + "f 1 2 5\n") ==
        "face 1 has vertex index 5, but there are 4 vertices (input line 5)");
  CHECK(read_error(points + "f 1 2 3\nf 1 2 -5\n") ==
        "face 2 has vertex index -5, but there are 4 vertices (input line 6)");
  CHECK(read_error(points + "f 1 2 0\n") ==
        "face 1 has vertex index 0, but there are 4 vertices (input line 5)");
  CHECK(read_error(points + "f 1 2 99999999999999999999\n") ==
        "a corner of face 1 is not an index: '99999999999999999999' (input line 5)");
  CHECK(contains(read_error(points + "f 1 2 9223372036854775807\n"), "has vertex index"));
  CHECK(contains(read_error(points + "f 1 2 -9223372036854775808\n"), "has vertex index"));
  CHECK(read_error(points + "f 1 2 3x\n") ==
        "a corner of face 1 is not an index: '3x' (input line 5)");
  CHECK(read_error("v 0 0\n") ==
        "vertex 1 has 2 numbers; 3 are needed, 4 with a weight or 6 with a color (input line 1)");
  CHECK(read_error("v 0,5 0 0\n") ==
        "a coordinate of vertex 1 is not a number: '0,5' (input line 1)");
  // Without any vertex it is no OBJ.
  CHECK(read_error("f 1 2 3\n\nquux 1\nquuz 1\n") ==
        "an OBJ file has no lines that start with 'quux' (input line 3)");
}

TEST_CASE("obj: values that are not finite and unknown lines are left out with a count") {
  const std::string bad_point = points + "v 0 nan 0\nv 0 0 1e999\nv -1.#IND00 0 0\n";
  const ReadResult result =
      read_mesh(bad_point + "f 1 2 3\nf 1 2 5\nf 2 4 7 3\nf 4 3 2\n", "input");
  CHECK(result.document.mesh.positions.size() == 4);
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 2, 1}});
  CHECK(result.notes.back() ==
        "obj: 3 vertices with a coordinate that is not finite dropped, and 2 faces that use them");
  CHECK(strict_error(bad_point) ==
        "a coordinate of vertex 5 is not a finite number: 'nan' (input line 5)");

  const std::string bad_color = "v 0 0 0 0.5 0.5 0.5\nv 1 0 0 nan inf 1.#QNAN # one\n";
  const ReadResult colored = read_mesh(bad_color, "input");
  CHECK(column(colored.document.mesh.vertex_columns, "red").values == std::vector<double>{0.5, 0});
  CHECK(has_note(colored.notes, "obj: 1 color that is not finite becomes 0"));
  CHECK(strict_error(bad_color) ==
        "the color of vertex 2 is not a finite number: 'nan' (input line 2)");

  const std::string unknown = "4 4\n$ by hand\n" + points + "t crease 2\nvw 0 0 1\nf 1 2 3\n";
  const ReadResult skipped = read_mesh(unknown + std::string(2, '\0'), "input");
  CHECK(skipped.document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(skipped.notes ==
        std::vector<std::string>{"obj: 4 unknown statements skipped; the first is '4' in line 1",
                                 "obj: 2 bytes of value 0 at the end skipped"});
  CHECK(strict_error(unknown) == "an OBJ file has no lines that start with '4' (input line 1)");
  CHECK(contains(strict_error(points + std::string(1, '\0')), "ends in a byte of value 0"));
  CHECK(strict_error(points) == "read");
}
