#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

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
                                 "obj: 1 comment after data left out"});
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
  // A file without vertices is not OBJ.
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
