#include "io/formats/xyz.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("xyz and obj: a first comment that reads like that of VTK changes no format") {
  for (const Format format : {Format::xyz, Format::obj}) {
    Document document;
    document.mesh = tetrahedron();
    document.style.format = format;
    document.style.comments = {"vtk DataFile Version 3.0"};
    const std::string bytes = write_mesh(document).bytes;
    const Document again = read_document(bytes);
    CHECK(again.mesh.positions == document.mesh.positions);
    CHECK(again.style.comments == document.style.comments);
    if (format == Format::obj) CHECK(write_mesh(again).bytes == bytes);
  }
}

TEST_CASE("xyz: points and normals, and what is dropped") {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.faces.clear();
  document.mesh.positions[1].x() = 0.1;
  document.style.format = Format::xyz;
  document.style.comments = {"by hand"};
  CHECK(write_mesh(document).bytes == "# by hand\n0 0 0\n0.1 0 0\n0 1 0\n0 0 1\n");
  const auto set = [&](const char* name, const std::vector<double>& values) {
    document.mesh.vertex_columns.get(name, Scalar::float64, 4).values = values;
  };
  set("nx", {1, 0, 0, 0.6});
  set("ny", {0, 1, 0, 0.8});
  set("nz", {0, 0, 1, 0});
  set("heat", {1, 2, 3, 4});
  document.mesh.faces = {{0, 1, 2}};
  const WriteResult result = write_mesh(document);
  CHECK(contains(result.bytes, "\n0.1 0 0 0 1 0\n"));
  CHECK(result.notes ==
        std::vector<std::string>{"xyz: vertex property 'heat' cannot be stored in XYZ, dropped",
                                 "xyz: 1 face cannot be stored in XYZ, dropped"});
  const Document again = read_document(result.bytes);
  CHECK(again.mesh.positions == document.mesh.positions);
  CHECK(column(again.mesh.vertex_columns, "ny").values == std::vector<double>{0, 1, 0, 0.8});
  CHECK(again.style.comments == document.style.comments);
}
