/// Rows of PLY files, compared with the reader of whole files.
#include "io/formats/ply_rows.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

Document example(Format format, Scalar coordinate) {
  Document document;
  Mesh& mesh = document.mesh;
  mesh = test::icosphere(2);
  Column& quality = mesh.vertex_columns.get("quality", Scalar::uint8, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    quality.values[v] = static_cast<double>(v % 256);
  for (const char* name : {"before", "behind"}) {
    Column& label = mesh.face_columns.get(name, Scalar::int16, mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) label.values[f] = -static_cast<double>(f);
  }
  document.style.format = format;
  document.style.coordinate = coordinate;
  document.style.position_column = 1;
  document.style.face_list_column = 1;
  document.style.comments = {"made by a test"};
  return document;
}

std::string message_of(const std::string& path) {
  try {
    const PlyRows rows(path);
    for (std::size_t f = 0; f < rows.face_count(); ++f) rows.triangle(rows.face(f));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("rows are those of the whole file, in both byte orders, and are written as they were") {
  const test::TemporaryFolder folder;
  for (const Format format : {Format::ply_little, Format::ply_big}) {
    for (const Scalar coordinate : {Scalar::float32, Scalar::float64}) {
      const std::string bytes = write_mesh(example(format, coordinate)).bytes;
      test::make_file(folder / "a.ply", bytes);
      const PlyRows rows(folder / "a.ply");
      const Mesh mesh = read_mesh(bytes, "a").document.mesh;
      REQUIRE(rows.vertex_count() == mesh.positions.size());
      REQUIRE(rows.face_count() == mesh.faces.size());
      CHECK(rows.coordinate() == coordinate);
      std::string copy = rows.header_text(rows.header().style.comments, rows.vertex_count(),
                                          rows.face_count(), rows.index_type());
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        CHECK(rows.position(v) == mesh.positions[v]);
        rows.append_vertex(v, copy);
      }
      for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        CHECK(rows.face(f) == mesh.faces[f]);
        rows.append_face(f, rows.face(f), rows.index_type(), copy);
      }
      CHECK(copy == bytes);
    }
  }
}

TEST_CASE("corners are written with other indices and another type") {
  const test::TemporaryFolder folder;
  Document document = example(Format::ply_big, Scalar::float64);
  test::make_file(folder / "a.ply", write_mesh(document).bytes);
  const PlyRows rows(folder / "a.ply");
  std::string copy = rows.header_text({}, rows.vertex_count(), rows.face_count(), Scalar::uint8);
  for (std::size_t v = 0; v < rows.vertex_count(); ++v) rows.append_vertex(v, copy);
  for (std::size_t f = 0; f < rows.face_count(); ++f)
    rows.append_face(f, {2, 1, 0}, Scalar::uint8, copy);
  const Document read = read_mesh(copy, "copy").document;
  CHECK(read.style.face_list_index == Scalar::uint8);
  CHECK(read.mesh.faces == std::vector<Face>(rows.face_count(), Face{2, 1, 0}));
  CHECK(read.mesh.face_columns.find("behind")->values ==
        document.mesh.face_columns.find("behind")->values);
}

TEST_CASE("files that cannot be read row by row are refused, with the place") {
  const test::TemporaryFolder folder;
  const Document document = example(Format::ply_little, Scalar::float64);
  const std::string bytes = write_mesh(document).bytes;
  const auto message = [&](const std::string& content) {
    test::make_file(folder / "a.ply", content);
    return message_of(folder / "a.ply");
  };
  CHECK(message(bytes).empty());
  CHECK(contains(message(bytes.substr(0, bytes.size() - 1)), "cut off"));
  CHECK(contains(message(bytes + "x"), "header is wrong"));
  CHECK(contains(message(bytes.substr(0, 40)), "end_header"));
  CHECK(contains(message("OFF\n"), "only binary PLY"));
  CHECK(contains(message(replaced(bytes, "element face 320", "element face 99999999999")),
                 "ends before them"));
  CHECK(contains(message(replaced(bytes, "property double y", "property double w")), "x, y and z"));
  CHECK(contains(message(replaced(bytes, "element face", "element edge")), "'edge'"));
  Document other = document;
  other.style.format = Format::ply_ascii;
  CHECK(contains(message(write_mesh(other).bytes), "text"));
  std::string broken = bytes;
  broken[broken.size() - 2 - 12 - 1] = 4;
  CHECK(contains(message(broken), "not a triangle"));
  broken = bytes;
  broken[broken.size() - 3] = '\x7f';
  CHECK(contains(message(broken), "face 319 has vertex index"));
  other = document;
  other.mesh.positions[7].z() = 0;
  broken = write_mesh(other).bytes;
  const std::size_t place = broken.find("end_header\n") + 11 + 7 * 25 + 17;
  broken.replace(place, 8, std::string("\0\0\0\0\0\0\xf8\x7f", 8));
  CHECK(contains(message(broken), "vertex 7 has a coordinate that is not a finite number"));
}
