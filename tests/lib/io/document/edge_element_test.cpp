#include "io/document/edge_element.h"

#include "lib/io/bytes.h"
#include "lib/io/ply_text.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

ReadResult read_edges(const std::string& first_vertex) {
  return read_mesh(
      header("ascii", "element vertex 4\n" + vertex_header + "element face 1\n" + face_header +
                          "element edge 1\nproperty int vertex1\nproperty int vertex2\n") +
          first_vertex + "\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n2 3\n",
      "a.ply");
}

/// True if the document is written with the element `edge` and no note, false if it is written
/// without it and with a note.
bool keeps_edges(const Document& document) {
  const WriteResult result = write_mesh(document);
  const bool is_kept = result.bytes.find("element edge 1") != std::string::npos;
  CHECK(result.notes.size() == (is_kept ? 0U : 1U));
  return is_kept;
}

}  // namespace

TEST_CASE("edges are kept while vertices move, or faces change between the same vertices") {
  Document document = read_edges("5 5 5").document;
  CHECK(keeps_edges(document));
  document.mesh.faces[0] = {1, 3, 2};
  for (Vec3& position : document.mesh.positions) position *= 2;
  CHECK(keeps_edges(document));
  document = read_edges("5 5 5").document;
  document.mesh.faces.push_back({0, 1, 2});
  CHECK(keeps_edges(document));
}

TEST_CASE("edges are dropped with a note if vertices are dropped or change places") {
  Document document = read_edges("5 5 5").document;
  std::swap(document.mesh.positions[0], document.mesh.positions[3]);
  document.mesh.faces[0] = {1, 2, 0};
  CHECK_FALSE(keeps_edges(document));
  document = read_edges("5 5 5").document;
  document.mesh.positions.erase(document.mesh.positions.begin());
  document.mesh.faces[0] = {0, 1, 2};
  CHECK_FALSE(keeps_edges(document));
}

TEST_CASE("edges are dropped with a note if the reader drops vertices") {
  const ReadResult result = read_edges("nan 5 5");
  CHECK(result.document.mesh.positions.size() == 3);
  CHECK(result.document.other_elements.empty());
  REQUIRE(result.notes.size() == 2);
  CHECK(result.notes[1] == "element 'edge' dropped: the vertices that it numbers have changed");
}
