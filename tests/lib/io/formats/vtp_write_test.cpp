#include <boost/property_tree/xml_parser.hpp>
#include <cstring>
#include <sstream>

#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

using Tree = boost::property_tree::ptree;

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) continue;  // padding and line ends
    bits = (bits << 6) | static_cast<unsigned>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>((bits >> count) & 0xff);
  }
  return bytes;
}

/// An array in the layout of VTK's file formats: the number of bytes, then the values.
struct Array {
  std::string type;
  std::size_t components = 0;
  std::string bytes;

  template <class T>
  std::vector<double> values() const {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof(size));
    REQUIRE(size + sizeof(size) == bytes.size());
    std::vector<T> values(size / sizeof(T));
    if (size > 0) std::memcpy(values.data(), bytes.data() + sizeof(size), size);
    return {values.begin(), values.end()};
  }
};

struct Vtp {
  explicit Vtp(const std::string& file) {
    std::istringstream stream(file);
    read_xml(stream, tree);
    REQUIRE(tree.get<std::string>("VTKFile.<xmlattr>.header_type") == "UInt64");
    piece = tree.get_child("VTKFile.PolyData.Piece");
  }

  std::size_t count(const std::string& what) const {
    return piece.get<std::size_t>("<xmlattr>.NumberOf" + what);
  }

  Array array(const std::string& element, const std::string& name) const {
    for (const auto& [tag, child] : piece.get_child(element))
      if (tag == "DataArray" && child.get<std::string>("<xmlattr>.Name") == name)
        return {child.get<std::string>("<xmlattr>.type"),
                child.get<std::size_t>("<xmlattr>.NumberOfComponents"), from_base64(child.data())};
    FAIL("no array ", name);
    return {};
  }

  Tree tree, piece;
};

Document vtp_document() {
  Document document;
  document.mesh = tetrahedron();
  document.style.format = Format::vtp;
  return document;
}

}  // namespace

TEST_CASE("vtp: points in double precision, and triangles") {
  Document document = vtp_document();
  document.mesh.positions[1] = {0.1, -2, 1e-300};
  const WriteResult result = write_mesh(document);
  CHECK(result.notes.empty());
  const Vtp vtp(result.bytes);
  CHECK(vtp.count("Points") == 4);
  CHECK(vtp.count("Polys") == 4);
  CHECK(vtp.count("Verts") == 0);
  CHECK(vtp.array("Points", "Points").components == 3);
  CHECK(vtp.array("Points", "Points").values<double>() ==
        std::vector<double>{0, 0, 0, 0.1, -2, 1e-300, 0, 1, 0, 0, 0, 1});
  CHECK(vtp.array("Polys", "connectivity").values<std::int64_t>() ==
        std::vector<double>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
  CHECK(vtp.array("Polys", "offsets").values<std::int64_t>() == std::vector<double>{3, 6, 9, 12});
  document.style.coordinate = Scalar::float32;
  CHECK(Vtp(write_mesh(document).bytes).array("Points", "Points").type == "Float32");
}

TEST_CASE("vtp: all columns in their types, in the names of VTK") {
  Document document = vtp_document();
  Columns& vertices = document.mesh.vertex_columns;
  for (const char* name : {"nx", "ny", "nz"}) vertices.get(name, Scalar::float32, 4);
  vertices.find("nz")->values = {1, 2, 3, 4};
  for (const char* name : {"red", "green", "blue", "alpha"}) vertices.get(name, Scalar::uint8, 4);
  vertices.find("alpha")->values = {0, 1, 128, 255};
  vertices.get("a<&>\"b", Scalar::float64, 4).values = {0.1, 0, 0, -1e300};
  vertices.columns.push_back({"ring", Scalar::int16, {1, 2, 3}, Scalar::uint8, {0, 1, 1, 2, 3}});
  Columns& faces = document.mesh.face_columns;
  faces.get("label", Scalar::int32, 4).values = {-1, 2, 3, 4};
  faces.columns.push_back(
      {"pair", Scalar::uint16, {1, 2, 3, 4, 5, 6, 7, 8}, Scalar::uint8, {0, 2, 4, 6, 8}});
  document.style.comments = {"tm-shape 0.1.0 box", "made by hand"};

  const WriteResult result = write_mesh(document);
  CHECK(result.notes ==
        std::vector<std::string>{"vtp: vertex property 'ring' cannot be stored in VTP, dropped",
                                 "vtp: 1 comment cannot be stored in VTP, dropped"});
  const Vtp vtp(result.bytes);
  CHECK(vtp.piece.get<std::string>("PointData.<xmlattr>.Normals") == "Normals");
  CHECK(vtp.array("PointData", "Normals").values<float>() ==
        std::vector<double>{0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4});
  CHECK(vtp.array("PointData", "RGBA").components == 4);
  CHECK(vtp.array("PointData", "RGBA").values<std::uint8_t>()[11] == 128);
  CHECK(vtp.array("PointData", "a<&>\"b").values<double>() ==
        std::vector<double>{0.1, 0, 0, -1e300});
  CHECK(vtp.array("CellData", "label").type == "Int32");
  CHECK(vtp.array("CellData", "label").values<std::int32_t>() == std::vector<double>{-1, 2, 3, 4});
  CHECK(vtp.array("CellData", "pair").components == 2);
  CHECK(vtp.array("CellData", "pair").values<std::uint16_t>()[7] == 8);
}

TEST_CASE("vtp: points without faces are cells, and nothing is a file too") {
  Document document = vtp_document();
  document.mesh.faces.clear();
  document.mesh.face_columns.get("label", Scalar::int32, 0);
  const Vtp points(write_mesh(document).bytes);
  CHECK(points.count("Verts") == 4);
  CHECK(points.array("Verts", "connectivity").values<std::int64_t>() ==
        std::vector<double>{0, 1, 2, 3});
  CHECK(points.piece.count("CellData") == 0);
  document.mesh.positions.clear();
  CHECK(Vtp(write_mesh(document).bytes).array("Points", "Points").values<double>().empty());
}
