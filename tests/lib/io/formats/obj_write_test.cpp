#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

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
