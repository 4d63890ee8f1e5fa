#include "lib/io/stl_bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("stl: attributes, headers that say solid, bytes behind the end") {
  Bytes file = binary_start("solid but binary", 2);
  add_facet(file, 0, 0);
  add_facet(file, 5, 0xfffe);
  const ReadResult result = read_mesh(file.str() + "rest", "input.stl");
  CHECK(column(result.document.mesh.face_columns, "attribute").values ==
        std::vector<double>{0, 65534});
  CHECK(has_note(result.notes, "stl: 4 bytes after the last facet ignored"));
  // The header does not begin with `solid`, which other programs would take for text.
  CHECK(write_mesh(result.document).bytes.substr(0, 11) == std::string("but binary\0", 11));
}

TEST_CASE("stl: a name is written as it will be read") {
  Document document;
  document.style.format = Format::stl_ascii;
  for (const auto& [comment, name] :
       {std::pair("solidarity", "arity"), std::pair(" a  b ", "a  b"),
        std::pair("solid solid x", "x"), std::pair("\tsolid", ""), std::pair(" tm:x", "")}) {
    document.style.comments = {comment};
    const Document again = read_document(write_mesh(document).bytes);
    CHECK(again.style.comments ==
          (*name ? std::vector<std::string>{name} : std::vector<std::string>{}));
  }
  // Bytes beyond ASCII are not a name, whether `char` is signed or not.
  Bytes file = binary_start("COLOR=\xff\xff", 0);
  CHECK(read_document(file.str()).style.comments.empty());
}

TEST_CASE("stl: what is written by hand") {
  Document document;
  document.mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {9, 9, 9}};
  document.mesh.faces = {{0, 2, 1}, {0, 0, 1}};
  document.style.format = Format::stl_ascii;
  document.style.comments = {"tm-shape 0.1.0 box", "a name", "another"};
  document.mesh.face_columns.get("attribute", Scalar::uint16, 2);
  const WriteResult result = write_mesh(document);
  CHECK(result.bytes ==
        "solid a name\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 2 0\n"
        "vertex 2 0 0\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
        "vertex 0 0 0\nvertex 2 0 0\nendloop\nendfacet\nendsolid a name\n");
  CHECK(result.notes ==
        std::vector<std::string>{"stl: face property 'attribute' cannot be stored in STL, dropped",
                                 "stl: 1 comment cannot be stored in STL, dropped",
                                 "stl: 1 point without a face cannot be stored in STL, dropped"});
  document.mesh.positions[1][0] = 0.1;
  CHECK(has_note(write_mesh(document).notes, "stl: coordinates are rounded to float"));
  document.mesh.positions[1][0] = 1e300;
  CHECK_THROWS_AS(write_mesh(document), GoalError);
}

TEST_CASE("stl: binary, byte by byte") {
  Document document;
  document.mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  document.mesh.faces = {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}};
  document.mesh.face_columns.get("attribute", Scalar::uint16, 3).values = {0, 258, 65535};
  document.style.format = Format::stl_binary;
  document.style.comments = {std::string(100, 'n')};
  Bytes file;
  file.text(std::string(80, 'n')).u32(3);
  file.f32(0).f32(0).f32(1);
  file.f32(0).f32(0).f32(0).f32(2).f32(0).f32(0).f32(0).f32(2).f32(0).u16(0);
  file.f32(0).f32(0).f32(-1);
  file.f32(0).f32(0).f32(0).f32(0).f32(2).f32(0).f32(2).f32(0).f32(0).u16(258);
  file.f32(0).f32(0).f32(0);
  file.f32(0).f32(0).f32(0).f32(0).f32(0).f32(0).f32(2).f32(0).f32(0).u16(65535);
  CHECK(write_mesh(document).bytes == file.str());
}
