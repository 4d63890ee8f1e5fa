#include "io/formats/obj_labels.h"

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

  // Names survive a conversion to PLY and back. Numbers without a comment are names themselves.
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

TEST_CASE("obj: a name ends before comments and line ends, and has no blanks around it") {
  CHECK(as_obj_name(" \t a#b\\\tc \r\n") == "a_b_ c");
  CHECK(as_obj_name(" \n ").empty());
  CHECK(as_obj_name("").empty());
}

TEST_CASE("obj: labels count for the rows behind them, and names get numbers that are free") {
  ObjLabelReader reader;
  reader.set(1, "wing");
  reader.set(3, "gone");
  reader.set(3, "1");
  reader.set(4, "2147483648");
  reader.set(5, "-7");
  reader.set(6, "behind the last row");
  Document document;
  reader.move_into(obj_label_kinds[1], 6, document);
  // The name "1" takes the label 1. A number beyond 32 bits is a name.
  CHECK(column(document.mesh.face_columns, "group").values ==
        std::vector<double>{0, 2, 2, 1, 4, -7});
  CHECK(document.style.comments ==
        std::vector<std::string>{"tm:group 2 wing", "tm:group 4 2147483648"});
}

TEST_CASE("obj: labels of an appended document keep their names, not their numbers") {
  Document all, other;
  all.style.comments = {"tm:group 1 wing", "tm:group 2 tail"};
  all.mesh.face_columns.get("group", Scalar::int32, 3).values = {0, 1, 2};
  other.style.comments = {"tm:group 1 tail", "made by hand", "tm:group 2 fin"};
  other.mesh.face_columns.get("group", Scalar::int32, 4).values = {1, 2, 3, 0};
  CHECK(have_obj_labels(all, other));
  separate_obj_labels(all, other);
  CHECK(column(other.mesh.face_columns, "group").values == std::vector<double>{2, 4, 3, 0});
  CHECK(other.style.comments ==
        std::vector<std::string>{"tm:group 2 tail", "made by hand", "tm:group 4 fin"});

  const Document none;
  CHECK_FALSE(have_obj_labels(all, none));
}
