#include <algorithm>

#include "lib/io/stl_bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("stl: binary by hand and back; nothing is joined") {
  Bytes file = binary_start("made by hand", 2);
  add_facet(file, 0, 0);
  add_facet(file, 0, 0);
  const ReadResult result = read_mesh(file.str(), "input");
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.positions.size() == 6);
  CHECK(mesh.positions[4] == Vec3(1, 0, 0));
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 4, 5}});
  CHECK(mesh.face_columns.columns.empty());
  CHECK(result.document.style.coordinate == Scalar::float32);
  CHECK(result.document.style.comments == std::vector<std::string>{"made by hand"});
  CHECK(result.notes ==
        std::vector<std::string>{"stl: 2 faces read as a soup of separate triangles"});
  CHECK(result.soup_note == 0);
  CHECK(write_mesh(result.document).bytes == file.str());
}

TEST_CASE("stl: text by hand") {
  const Document document = read_document(text_file);
  CHECK(document.style.format == Format::stl_ascii);
  CHECK(document.mesh.positions[2] == Vec3(0, 1, static_cast<double>(0.1F)));
  CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(document.style.comments == std::vector<std::string>{"box"});
}

TEST_CASE("stl: text in upper case, several solids, odd normals, a name with facet in it") {
  const ReadResult result = read_mesh(
      "SOLID facet of a Gem\r\n  FACET NORMAL nan -nan(ind) 0\r\nOUTER LOOP VERTEX 0 0 0\r\n"
      "VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET\r\nENDSOLID facet of a Gem\r\n\r\n"
      "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
      "input");
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 4, 5}, {3, 5, 6}});
  CHECK(has_note(result.notes, "stl: 2 solids read as one mesh"));
  CHECK(has_note(result.notes, "stl: 1 polygon cut into 2 triangles"));
}

TEST_CASE("stl: text with any line breaks, also without any") {
  std::string facets =
      "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
  for (const char separator : {'\n', '\r', '\t', ' '}) {
    std::replace_if(
        facets.begin(), facets.end(), [](char c) { return c <= ' '; }, separator);
    std::string text = "solid a  b ";
    text += facets + facets + "endsolid a  b solid c " + facets + "endsolid c";
    for (const char* name : {"b facet", "b solid", "c facet"})
      if (const auto place = text.find(name); place != std::string::npos)
        text[place + 1] = separator;
    const ReadResult result = read_mesh(text, "");
    CHECK(result.document.mesh.faces.size() == 3);
    CHECK(result.document.style.comments == std::vector<std::string>{"a  b"});
    CHECK(result.notes.size() == 2);  // the soup, and the number of solids
    CHECK(contains(read_error(text.substr(0, text.size() - 20)), "ends within facet 2"));
  }
}

TEST_CASE("stl: errors name the place") {
  Bytes file = binary_start("x", 2);
  add_facet(file, 0, 0);
  CHECK(read_error(file.str(), "a.stl") ==
        "the header announces 2 facets, but only 1 follow: the file is cut off or not STL "
        "(a.stl byte 80)");
  CHECK(contains(read_error("short", "a.STL"), "not an STL file"));

  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = text_file;
    return read_error(text.replace(text.find(from), from.size(), to));
  };
  CHECK(changed("endfacet\nendsolid box\n", "") ==
        "the data ends within facet 0, before 'endsolid' (input line 8)");
  CHECK(changed("vertex 0 0 0", "vertex 0 0") ==
        "a coordinate of facet 0 is not a number: 'vertex' (input line 5)");
  CHECK(changed("outer", "inner") ==
        "'outer' is missing in facet 0, which has 'inner' (input line 3)");
}

TEST_CASE("stl: facets that are not finite are dropped with a count") {
  Bytes file = binary_start("x", 2);
  add_facet(file, std::numeric_limits<float>::infinity(), 0);
  add_facet(file, 0, 7);
  const ReadResult result = read_mesh(file.str(), "input");
  CHECK(result.document.mesh.positions.size() == 3);
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(column(result.document.mesh.face_columns, "attribute").values == std::vector<double>{7});
  CHECK(has_note(result.notes, "stl: 1 facet with a coordinate that is not finite dropped"));
  CHECK(strict_error(file.str()) ==
        "a coordinate of facet 0 is not a finite number (input byte 96)");
  for (const char* bad : {"nan", "1e39", "1.#QNAN"}) {
    std::string text = text_file;
    text.replace(text.find("vertex 0 0 0"), 10, std::string("vertex 0 ") + bad);
    CHECK(read_document(text).mesh.faces.empty());
    CHECK(read_document(text).mesh.positions.empty());
    CHECK(contains(strict_error(text), "a coordinate of facet 0"));
  }
}

TEST_CASE("stl: 0 in the header, no end and blank lines at the start") {
  Bytes open = binary_start("left at zero", 0);
  add_facet(open, 1, 0);
  add_facet(open, 2, 0);
  const ReadResult counted = read_mesh(open.str(), "-");
  CHECK(counted.document.mesh.faces.size() == 2);
  CHECK(has_note(counted.notes, "stl: the header announces 0 facets, but 2 follow and are read"));
  CHECK(contains(strict_error(open.str()), "announces 0 facets, but 2 follow"));
  CHECK(strict_error(binary_start("empty", 0).str()) == "read");

  const std::string endless = text_file.substr(0, text_file.find("endsolid"));
  const ReadResult cut = read_mesh(endless, "-");
  CHECK(cut.document.mesh.faces.size() == 1);
  CHECK(has_note(cut.notes, "stl: 'endsolid' is missing at the end: the file may be cut off"));
  CHECK(contains(strict_error(endless), "before 'endsolid'"));
  CHECK(read_document("\n \r\n\n" + text_file).mesh.faces.size() == 1);
}

TEST_CASE("stl: a file that is cut at any byte never has facets that are incomplete") {
  Bytes file = binary_start("x", 2);
  add_facet(file, 0, 0);
  add_facet(file, 1, 0);
  for (std::size_t size = 0; size < file.str().size(); ++size) {
    CAPTURE(size);
    CHECK(read_error(file.str().substr(0, size), "a.stl") != "read");
  }
  const std::size_t complete = text_file.find("endfacet") + std::string("endfacet").size();
  const std::size_t end = text_file.find("endsolid") + std::string("endsolid").size();
  for (std::size_t size = 0; size < text_file.size(); ++size) {
    CAPTURE(size);
    const std::string cut = text_file.substr(0, size);
    if (size < end) CHECK(strict_error(cut, "a.stl") != "read");
    if (read_error(cut, "a.stl") != "read") continue;
    CHECK(read_mesh(cut, "a.stl").document.mesh.faces.size() == (size < complete ? 0 : 1));
  }
}

TEST_CASE("stl: facets beyond the bytes are refused before memory is taken") {
  Bytes file = binary_start("x", 0xffffffff);
  add_facet(file, 0, 0);
  CHECK(read_error(file.str(), "a.stl") ==
        "the header announces 4294967295 facets, but only 1 follow: the file is cut off or not STL "
        "(a.stl byte 80)");
  // The header announces fewer facets than follow.
  add_facet(file, 1, 0);
  std::string bytes = file.str();
  bytes.replace(80, 4, std::string("\1\0\0\0", 4));
  const ReadResult result = read_mesh(bytes, "a.stl");
  CHECK(result.document.mesh.faces.size() == 1);
  CHECK(has_note(result.notes, "stl: 50 bytes after the last facet ignored"));
}
