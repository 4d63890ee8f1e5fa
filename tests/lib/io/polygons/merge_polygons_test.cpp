/// Polygons that were triangulated and merged again, compared with the corners that were read.
#include "io/polygons/merge_polygons.h"

#include <doctest/doctest.h>

#include "transformesh/mesh_io.h"
#include "transformesh/select.h"

using namespace transformesh;

namespace {

Document read_off(const std::string& text) {
  return read_mesh(text, "test", {.keep_polygons = true}).document;
}

std::string off_without_comments(Document document) {
  document.style.format = Format::off;
  return write_mesh(document).bytes;
}

/// A house of a square and a triangle. Beside it, a concave pentagon and a quadrilateral.
const std::string house =
    "OFF\n12 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 2 0\n3 0 0\n4 0 0\n4 2 0\n3.5 0.5 0\n3 2 0\n"
    "2 1 0\n2.5 0 0\n"
    "4 0 1 2 3\n3 3 2 4\n5 5 6 7 8 9\n4 10 11 5 9\n";

}  // namespace

TEST_CASE("polygons are written as they were read") {
  const Document document = read_off(house);
  CHECK(document.mesh.faces.size() == 2 + 1 + 3 + 2);
  const PolygonCount count = count_polygons(document.mesh.face_columns);
  CHECK(count.polygons == 3);
  CHECK(count.triangles == 7);
  CHECK(off_without_comments(document) == house);
}

TEST_CASE("dropped faces are removed from their polygon") {
  Document document = read_off(house);
  SelectionOptions options;
  options.mask.emplace(document.mesh.faces.size(), true);
  (*options.mask)[0] = false;
  select(document.mesh, options);
  const MergedPolygons merged = merge_polygons(document);
  REQUIRE(merged.document.mesh.faces.size() == 4);
  const FaceOutlines outlines(merged.document.mesh, &merged.outlines);
  CHECK(outlines.size(0) == 3);
  CHECK(outlines.size(2) == 5);
  CHECK(merged.unmerged == 0);
  CHECK(merged.document.mesh.face_columns.find(polygon_column) == nullptr);
}

TEST_CASE("a polygon around a hole has no outline, and stays in triangles") {
  // A bridge leads to the hole and back; its two sides cancel out.
  const Document document = read_off(
      "OFF\n8 1 0\n0 0 0\n3 0 0\n3 3 0\n0 3 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n"
      "10 0 1 2 3 0 4 5 6 7 4\n");
  const MergedPolygons merged = merge_polygons(document);
  CHECK(merged.unmerged == 1);
  CHECK(merged.document.mesh.faces.size() == 8);
  const WriteResult written = write_mesh(document);
  REQUIRE(written.notes.size() == 1);
  CHECK(written.notes[0].starts_with("1 polygon written as triangles"));
}

TEST_CASE("columns follow the first triangle, and texture the corners") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property int label\nproperty list uchar float texcoord\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n"
      "4 0 1 2 3 7 8 0 0 1 0 1 1 0 1\n3 3 2 4 9 6 0 1 1 1 0 2\n";
  const Document document = read_mesh(ply, "test", {.keep_polygons = true}).document;
  CHECK(document.mesh.faces.size() == 3);
  CHECK(write_mesh(document).bytes == ply);
}

TEST_CASE("OBJ keeps the texture coordinates of polygons") {
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
      "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 3/3\n";
  const WriteResult written = write_mesh(read_mesh(obj, "test", {.keep_polygons = true}).document);
  CHECK(written.bytes == obj);
  CHECK(written.notes.empty());
}

TEST_CASE("a polygon that runs back along itself is dropped, and a note says so") {
  const std::string spike = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 0 1 2 1\n";
  for (const bool keeps : {false, true}) {
    const ReadResult result = read_mesh(spike, "test", {.keep_polygons = keeps});
    CHECK(result.document.mesh.faces.size() == 2);
    REQUIRE(result.notes.size() == (keeps ? 1 : 2));
    CHECK(result.notes.back() == "off: 1 polygon dropped, as the outline runs back along itself");
    if (!keeps) CHECK(result.notes.front() == "off: 1 polygon cut into 2 triangles");
  }
}

TEST_CASE("columns of a file are never taken for outlines or numbers of polygons") {
  for (const std::string property :
       {"int tm:outline", "list uchar int tm:outline", "list uchar int tm:polygon"}) {
    CAPTURE(property);
    const std::string value = property.starts_with("int") ? " 7" : " 2 99 -5";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty " +
        property + "\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2" + value + '\n';
    for (const bool keeps : {false, true})
      CHECK(write_mesh(read_mesh(ply, "test", {.keep_polygons = keeps}).document).bytes == ply);
  }
}

TEST_CASE("XYZ drops faces, and does not say that it writes them as triangles") {
  Document document = read_off(house);
  document.style.format = Format::xyz;
  const WriteResult written = write_mesh(document);
  REQUIRE(written.notes.size() == 1);
  CHECK(written.notes[0] == "xyz: 8 faces cannot be stored in XYZ, dropped");
}

TEST_CASE("other formats say that polygons become triangles") {
  Document document = read_off(house);
  document.style.format = Format::stl_binary;
  document.style.coordinate = Scalar::float32;
  const WriteResult written = write_mesh(document);
  REQUIRE(!written.notes.empty());
  CHECK(written.notes.back() == "stl: 3 polygons written as triangles");
}
