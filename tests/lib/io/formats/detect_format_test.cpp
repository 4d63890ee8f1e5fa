#include "io/formats/detect_format.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

FileKind kind(const std::string& bytes, const std::string& name = "-") {
  return detect_format({bytes, name});
}

std::string refusal(const std::string& bytes, const std::string& name = "-") {
  try {
    kind(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Returns a binary STL file that announces `says` facets and holds `holds`. Its header begins with
/// `header`.
std::string binary_stl(std::size_t says, std::size_t holds, std::string header = "") {
  header.resize(80, ' ');
  for (int i = 0; i < 4; ++i) header += static_cast<char>(says >> 8 * i & 255);
  return header + std::string(50 * holds, '\0');
}

/// Returns a file with a triangle and the comment. Letters are appended to the comment if the file
/// is otherwise shorter than `size` bytes.
std::string file_of_size(const std::string& comment, Format format, std::size_t size) {
  Document document;
  document.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  document.mesh.faces = {{0, 1, 2}};
  document.style.format = format;
  document.style.comments = {comment};
  const std::size_t written = write_mesh(document).bytes.size();
  if (written < size) document.style.comments[0] += std::string(size - written, 'y');
  return write_mesh(document).bytes;
}

}  // namespace

TEST_CASE("formats are detected by their first words, whatever the name says") {
  CHECK(kind("ply\nformat ascii 1.0\n", "a.off") == FileKind::ply);
  CHECK(kind("ply \r\n") == FileKind::ply);
  CHECK(kind("# a comment\n\nOFF 3 1 0\n", "a.obj") == FileKind::off);
  CHECK(kind("STCNOFF\n") == FileKind::off);
  CHECK(kind("# by hand\nv 0 0 0\n", "a.stl") == FileKind::obj);
  CHECK(kind("mtllib a.mtl\n") == FileKind::obj);
  CHECK(kind("solid name\n facet normal 0 0 1\n") == FileKind::stl_ascii);
  CHECK(kind("Solid\nEndSolid\n") == FileKind::stl_ascii);
}

TEST_CASE("binary STL is detected by its size, also where the header says solid") {
  CHECK(kind(binary_stl(3, 3)) == FileKind::stl_binary);
  CHECK(kind(binary_stl(2, 2, "solid facet")) == FileKind::stl_binary);
  CHECK(kind(binary_stl(0, 0, "solid")) == FileKind::stl_binary);
  for (const std::string header : {"OFF", "OFF of a box", "# \nOFF 3 1 0\n", "\xef\xbb\xbfname"}) {
    CHECK(kind(binary_stl(2, 2, header)) == FileKind::stl_binary);
    CHECK(read_mesh(binary_stl(2, 2, header), "-").document.mesh.faces.size() == 2);
  }
  CHECK_FALSE(refusal(binary_stl(3, 2)).empty());
}

TEST_CASE("a written file is detected as its format, for any comment") {
  // Some comments put a number to the place at which binary STL has the count of facets. The files
  // then have exactly the size of a binary STL with that count.
  std::vector<std::pair<std::string, std::size_t>> comments{
      {"OFF OFF\xb6", 0}, {"ply", 0}, {"solid", 0}, {"v 0 0 0", 0}, {"\rOFF 0 0 0", 0}};
  for (std::size_t padding = 60; padding < 80; ++padding) {
    for (const int count : {0, 1, 2, 8, 9, 118, 182}) {
      const std::string text = std::string(padding, 'x') + static_cast<char>(count);
      comments.emplace_back(text + std::string(3, '\0'), 84 + 50 * count);
    }
  }
  for (const auto& [comment, size] : comments) {
    for (const Format format : {Format::ply_ascii, Format::ply_little, Format::ply_big, Format::off,
                                Format::obj, Format::stl_ascii, Format::stl_binary}) {
      const std::string bytes = file_of_size(comment, format, size);
      CAPTURE(bytes);
      const Document again = read_mesh(bytes, "-").document;
      CHECK(again.style.format == format);
      CHECK(again.mesh.faces.size() == 1);
    }
  }
}

TEST_CASE("text STL is detected for names of any length") {
  for (std::size_t length = 1900; length < 2050; ++length) {
    const std::string start = "solid " + std::string(length, 'x') + "\n";
    CAPTURE(length);
    CHECK(kind(start + "facet normal 0 0 1\n") == FileKind::stl_ascii);
    CHECK(kind(start + "endsolid\n") == FileKind::stl_ascii);
  }
}

TEST_CASE("other formats are detected by their first bytes") {
  CHECK(kind("glTF\2") == FileKind::gltf);
  CHECK(kind(" {\"asset\": {}}") == FileKind::gltf);
  CHECK(kind("PK\3\4") == FileKind::three_mf);
  CHECK(kind("# vtk DataFile Version 2.0\n") == FileKind::vtk);
  CHECK(kind("<?xml version=\"1.0\"?>\n<!-- x -->\n<VTKFile type=\"PolyData\">") == FileKind::vtp);
  CHECK(kind("# .PCD v.7\nVERSION .7\n") == FileKind::pcd);
  CHECK(kind("1 2 3\n") == FileKind::points);
  CHECK(kind("x,y,z\n1,2,3\n") == FileKind::point_table);
  // The header of binary STL may hold anything.
  for (const char* header : {"glTF", "{\"asset\"", "# vtk DataFile Version 2.0", "VERSION .7"})
    CHECK(kind(binary_stl(2, 2, header)) == FileKind::stl_binary);
  CHECK(kind(binary_stl(0, 0, "glTF")) == FileKind::stl_binary);
}

TEST_CASE("the name decides where bytes cannot") {
  CHECK(kind("3 1 0\n0 0 0\n", "mesh.off") == FileKind::off);
  CHECK(kind("3 1 0\n0 0 0\n", "MESH.OFF") == FileKind::off);
  CHECK(kind(binary_stl(3, 2), "a.stl") == FileKind::stl_binary);
  CHECK(kind("# nothing else\n", "a.obj") == FileKind::obj);
  CHECK(kind("plywood", "a.ply") == FileKind::ply);
}

TEST_CASE("files that are no meshes are refused by name") {
  CHECK(refusal("").find("it contains no mesh") != std::string::npos);
  CHECK(refusal("\x1f\x8b\x08 and more", "a.ply").find("compressed twice") != std::string::npos);
  CHECK(refusal("<?xml version=\"1.0\"?>").find("unknown mesh format") != std::string::npos);
  CHECK(refusal("<?xml version=\"1.0\"?>").find("<?xml version=") != std::string::npos);
  CHECK(refusal("v").find("unknown mesh format") != std::string::npos);  // a word without values
}

TEST_CASE("OBJ is detected by its vertices where other lines come first") {
  CHECK(kind("4 4\nv 0 0 0\n") == FileKind::obj);
  CHECK(kind("# model\n$ by hand\nv 1.5 0 -2 0.5 0.5 0.5\n") == FileKind::obj);
  CHECK_FALSE(refusal("4 4\nv x y z\n").empty());
}

TEST_CASE("text in UTF-16 and binary OFF are named") {
  std::string little, big;
  for (const char c : std::string("OFF\n4 4 0\n0 0 0\n1 0 0\n")) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  for (const std::string& bytes : {little, big, "\xff\xfe" + little, "\xfe\xff" + big}) {
    CHECK(refusal(bytes, "a.off").find("iconv -f UTF-16 -t UTF-8") != std::string::npos);
  }
  for (const std::string& bytes :
       {std::string("OFF BINARY\n\0\0\0\4", 15), std::string("COFF BINARY \n\0", 14)}) {
    CHECK_THROWS_WITH_AS(read_mesh(bytes, "a.off"),
                         doctest::Contains("binary OFF is not supported"), InputError);
  }
}
