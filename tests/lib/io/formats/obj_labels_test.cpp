#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

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
