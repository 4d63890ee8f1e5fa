#include <bit>
#include <clocale>
#include <cstdint>
#include <limits>

#include "helpers/random.h"
#include "io/document/round_as_written.h"
#include "io/formats/file_format.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::vector<Format> all_formats{Format::ply_ascii, Format::ply_little, Format::ply_big,
                                      Format::off,       Format::obj,        Format::stl_ascii,
                                      Format::stl_binary};

/// Returns a tetrahedron whose coordinates are floats, so that every format can hold them.
Document float_document() {
  Document document;
  document.mesh = tetrahedron();
  for (Vec3& position : document.mesh.positions)
    position = position * 0.75 + Vec3(0.125, -3e-5F, 7);
  round_positions(document.mesh, Scalar::float32);
  return document;
}

std::vector<Vec3> corners(const Mesh& mesh) {
  std::vector<Vec3> result;
  for (const Face& face : mesh.faces) {
    for (const Index corner : face) result.push_back(mesh.positions[corner]);
  }
  return result;
}

}  // namespace

TEST_CASE("mesh io: every format, read and written as every other, is the same mesh") {
  const Document original = float_document();
  for (const Format first : all_formats) {
    Document document = original;
    document.style.format = first;
    const Document as_first = read_document(write_mesh(document).bytes);
    CHECK(as_first.style.format == first);
    for (const Format second : all_formats) {
      Document next = as_first;
      next.style.format = second;
      const Document as_second = read_document(write_mesh(next).bytes);
      CHECK(as_second.style.format == second);
      CHECK(corners(as_second.mesh) == corners(original.mesh));
      const auto is_soup = [](Format format) { return format >= Format::stl_ascii; };
      if (is_soup(first) || is_soup(second)) continue;
      CHECK(as_second.mesh.positions == original.mesh.positions);
      CHECK(as_second.mesh.faces == original.mesh.faces);
    }
  }
}

TEST_CASE("mesh io: vertices without a face and their order stay") {
  for (const Format format : {Format::ply_ascii, Format::ply_little, Format::off, Format::obj}) {
    Document document = float_document();
    document.mesh.positions.insert(document.mesh.positions.begin(), Vec3(5, 5, 5));
    document.style.format = format;
    CHECK(read_document(write_mesh(document).bytes).mesh.positions == document.mesh.positions);
  }
}

TEST_CASE("mesh io: our comments survive the text formats") {
  for (const Format format : {Format::ply_ascii, Format::ply_big, Format::off, Format::obj}) {
    Document document = float_document();
    document.style.comments = {"tm:reference-edge 0.25", "", "  indented #"};
    document.style.format = format;
    CHECK(read_document(write_mesh(document).bytes).style.comments == document.style.comments);
  }
}

TEST_CASE("mesh io: the decimal comma of a locale changes nothing") {
  const Document original = float_document();
  std::vector<std::string> expected;
  for (const Format format : all_formats) {
    Document document = original;
    document.style.format = format;
    expected.push_back(write_mesh(document).bytes);
  }
  bool has_locale = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
    has_locale = has_locale || std::setlocale(LC_NUMERIC, name) != nullptr;
  }
  if (!has_locale) MESSAGE("no locale with a decimal comma is installed");
  for (std::size_t i = 0; i < all_formats.size(); ++i) {
    Document document = read_document(expected[i]);
    CHECK(write_mesh(document).bytes == expected[i]);
  }
  std::setlocale(LC_NUMERIC, "C");
}

TEST_CASE("mesh io: the format follows the option, else the file name, else the input") {
  CHECK(format_for(Format::off, "ply-be", "a.stl") == Format::ply_big);
  CHECK(format_for(Format::ply_big, "", "a.PLY") == Format::ply_big);
  CHECK(format_for(Format::off, "", "a.ply") == Format::ply_little);
  CHECK(format_for(Format::ply_ascii, "", "dir.ply/a.Off") == Format::off);
  CHECK(format_for(Format::ply_ascii, "", "a.b.obj") == Format::obj);
  CHECK(format_for(Format::stl_ascii, "", "a.stl") == Format::stl_ascii);
  CHECK(format_for(Format::ply_ascii, "", "a.stl") == Format::stl_binary);
  CHECK(format_for(Format::ply_ascii, "", "a.glb") == Format::glb);
  CHECK(format_for(Format::stl_ascii, "vtp", "a.glb") == Format::vtp);
  for (const char* name : {"", "ply", "a.plyx", "a.off/b", "-", "a."}) {
    CHECK(format_for(Format::ply_ascii, "", name) == Format::ply_ascii);
    CHECK(format_for(Format::off, "", name) == Format::off);
    CHECK(format_for(Format::obj, "", name) == Format::ply_little);
    CHECK(format_for(Format::stl_ascii, "", name) == Format::ply_little);
  }
}

TEST_CASE("mesh io: a format takes the coordinates that it holds") {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.positions[0] = {0.1, 0, 0};
  CHECK(set_format(document, Format::ply_big) == 0);
  CHECK(document.style.coordinate == Scalar::float64);
  CHECK(document.mesh.positions[0].x() == 0.1);
  set_format(document, Format::stl_binary, Scalar::float64);
  CHECK(document.style.coordinate == Scalar::float32);
  CHECK(document.mesh.positions[0].x() == 0.1F);
  set_format(document, Format::off);
  CHECK(document.style.coordinate == Scalar::float64);
  set_format(document, Format::glb);
  CHECK(document.style.coordinate == Scalar::float32);
  set_format(document, Format::vtp);
  CHECK(document.style.coordinate == Scalar::float64);
  set_format(document, Format::off, Scalar::float32);
  CHECK(document.style.coordinate == Scalar::float32);
}

TEST_CASE("mesh io: rounding to float") {
  Mesh mesh = tetrahedron();
  mesh.positions[0] = {0.1, 1e-60, -1.0 / 3};
  Mesh same = mesh;
  round_positions(same, Scalar::float64);
  CHECK(same.positions == mesh.positions);
  round_positions(mesh, Scalar::float32);
  CHECK(mesh.positions[0] == Vec3(static_cast<double>(0.1F), 0, static_cast<double>(-1.0F / 3)));
  mesh.positions[3][1] = -1e39;
  CHECK_THROWS_AS(round_positions(mesh, Scalar::float32), GoalError);
}

TEST_CASE("mesh io: rounding to floats leaves floats only") {
  test::Random random(4);
  for (int count = 1; count < 60; ++count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
      mesh.positions.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1),
                                  random.uniform(-9, 9));
    }
    round_positions(mesh, Scalar::float32);
    for (const Vec3& p : mesh.positions) {
      for (const double x : p) {
        // A float has 24 digits, so 29 of a double's 53 are zero.
        CHECK((std::bit_cast<std::uint64_t>(x) & ((1ULL << 29) - 1)) == 0);
      }
    }
  }
}

TEST_CASE("mesh io: files that are no meshes are refused with their first bytes") {
  CHECK(read_error("") == "the input is empty: it contains no mesh (input)");
  CHECK(read_error("\x89PNG\r\n") ==
        "unknown mesh format, starting with '\\x89PNG\\x0d\\x0a': PLY, OFF, OBJ, STL, glTF, 3MF, "
        "VTK, "
        "VTP, PCD and points as text are read (input)");
  CHECK(contains(read_error("\x1f\x8b\x08"), "the compressed data is cut off"));
  CHECK(contains(read_error("just text"), "'just text'"));
  CHECK(contains(read_error("plyx\n"), "unknown mesh format"));
  CHECK(contains(read_error("\n \n"), "unknown mesh format"));
  CHECK(contains(read_error("plyx", "a.ply"), "no line 'end_header'"));
  CHECK(
      contains(read_error("plyx\n", "a.ply"), "a PLY file starts with the line 'ply', not 'plyx'"));
  CHECK(contains(read_error("4OFF\n", "a.off"), "not '4OFF'"));
}

TEST_CASE("mesh io: a byte order mark in front of text is skipped") {
  CHECK(read_document("\xef\xbb\xbfOFF 1 0 0\n1 2 3\n").mesh.positions.size() == 1);
}

TEST_CASE("coordinates that are not finite are not written, in any format") {
  Document document;
  document.mesh.positions = {{0, 0, 0}, {0, 0, 0}};
  for (const Format format : all_formats) {
    document.style.format = format;
    for (const double value :
         {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
      document.mesh.positions[1].y() = value;
      CHECK_THROWS_AS(write_mesh(document), GoalError);
    }
  }
}

TEST_CASE("rounding as written gives what writing and reading gives, in float and in double") {
  for (const Scalar coordinate : {Scalar::float32, Scalar::float64}) {
    Document document;
    document.mesh = tetrahedron();
    for (Vec3& position : document.mesh.positions) position = position / 3 + Vec3(0.1, 0.2, 1e-9);
    document.style.coordinate = coordinate;
    document.mesh.vertex_columns.get("heat", Scalar::float32, 4).values = {0.1, -2.7, 1e-40, 3};
    document.mesh.vertex_columns.get("red", Scalar::uint8, 4).values = {0.6, 300, -1, 17};
    document.mesh.face_columns.get("size", Scalar::float64, 4).values = {0.1, 0.2, 0.3, 0.4};
    const Document read = read_mesh(write_mesh(document).bytes, "mesh").document;
    round_as_written(document);
    CHECK(document.mesh.positions == read.mesh.positions);
    for (const char* name : {"heat", "red"})
      CHECK(document.mesh.vertex_columns.find(name)->values ==
            read.mesh.vertex_columns.find(name)->values);
    CHECK(document.mesh.face_columns.find("size")->values ==
          read.mesh.face_columns.find("size")->values);
  }
  Document infinite;
  infinite.mesh = tetrahedron();
  infinite.mesh.positions[2].y() = 1e300;
  infinite.style.coordinate = Scalar::float32;
  CHECK_THROWS_AS(round_as_written(infinite), GoalError);
}
