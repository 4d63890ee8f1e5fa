#include <zlib.h>

#include "io/formats/vtp.h"
#include "lib/io/bytes.h"
#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::string vtp(const std::string& attributes, const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" " + attributes + "><PolyData>" +
         content + "</PolyData></VTKFile>";
}

std::string array(const std::string& type, const std::string& name, int components,
                  const std::string& text, const std::string& format = "ascii") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"" + format + "\">" + text + "</DataArray>";
}

const std::string cells = "<Polys>" + array("Int64", "connectivity", 1, "0 1 2") +
                          array("Int64", "offsets", 1, "3") + "</Polys>";
const std::string text_piece =
    "<Piece><Points>" + array("Float64", "p", 3, "0 0 0 1 0 0 0 1 0.1") + "</Points>" + cells;

Bytes three_floats_and_size(bool is_big) {
  Bytes bytes(is_big);
  bytes.u32(36);
  for (const int x : {0, 0, 0, 1, 0, 0, 0, 1, 5}) bytes.f32(static_cast<float>(x));
  return bytes;
}

}  // namespace

TEST_CASE("vtp: text, roles of arrays, and pieces") {
  const std::string data = "<PointData Normals=\"up\" Scalars=\"c\">" +
                           array("Float32", "up", 3, "0 0 1 0 0 1 0 0 1") +
                           array("UInt8", "c", 4, "1 2 3 4 5 6 7 8 9 10 11 12") + "</PointData>";
  const ReadResult result =
      read_mesh(vtp("", text_piece + data + "</Piece>" + text_piece + data + "</Piece>"), "input");
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.positions[5] == Vec3(0, 1, 0.1));
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 4, 5}});
  CHECK(column(mesh.vertex_columns, "nz").values[4] == 1);
  CHECK(column(mesh.vertex_columns, "alpha").values[2] == 12);
  CHECK(has_note(result.notes, "vtk: 2 pieces read as one mesh"));
}

TEST_CASE("vtp: base64 in both byte orders, and appended to the XML as bytes") {
  for (const bool is_big : {false, true}) {
    const std::string order =
        std::string("byte_order=\"") + (is_big ? "BigEndian" : "LittleEndian") + "\"";
    const Bytes bytes = three_floats_and_size(is_big);
    const std::string inside = vtp(
        order, "<Piece><Points>" +
                   array("Float32", "p", 3, "\n " + base64_by_bits(bytes.str()) + "\n", "binary") +
                   "</Points>" + cells + "</Piece>");
    CHECK(read_document(inside).mesh.positions[2] == Vec3(0, 1, 5));
    std::string appended =
        vtp(order,
            "<Piece><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
            "format=\"appended\" offset=\"2\"/></Points>" +
                cells + "</Piece>");
    const std::string data =
        "<AppendedData encoding=\"raw\">\n  _xx" + bytes.str() + "\n</AppendedData>";
    appended.insert(appended.find("</VTKFile>"), data);
    CHECK(read_document(appended).mesh.positions[2] == Vec3(0, 1, 5));
    CHECK(contains(read_error(appended.substr(0, appended.find("</AppendedData>") - 3)),
                   "announces 36 bytes, but there are 34"));
  }
}

TEST_CASE("vtp: blocks compressed by zlib") {
  const std::string plain = three_floats_and_size(false).str().substr(4);
  std::string data;
  std::vector<std::size_t> sizes;
  for (const std::size_t first : {0U, 20U}) {
    const std::string part = plain.substr(first, 20);
    std::string stored(100, '\0');
    uLongf size = stored.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(stored.data()), &size,
                     reinterpret_cast<const Bytef*>(part.data()), part.size()) == Z_OK);
    sizes.push_back(size);
    data += stored.substr(0, size);
  }
  const auto file_with = [&](std::size_t last) {
    Bytes header;
    header.u32(2).u32(20).u32(last).u32(sizes[0]).u32(sizes[1]);
    return vtp("compressor=\"vtkZLibDataCompressor\"",
               "<Piece><Points>" +
                   array("Float32", "p", 3, base64_by_bits(header.str()) + base64_by_bits(data),
                         "binary") +
                   "</Points>" + cells + "</Piece>");
  };
  CHECK(read_document(file_with(16)).mesh.positions[2] == Vec3(0, 1, 5));
  CHECK(contains(read_error(file_with(15)), "expands to more than 15 bytes"));
  CHECK(contains(read_error(file_with(17)), "differs from the announced one"));
  CHECK(
      contains(read_error(vtp("compressor=\"vtkLZ4DataCompressor\"", "")), "vtkLZ4DataCompressor"));
}

TEST_CASE("vtp: what is wrong is named") {
  CHECK(contains(read_error("<VTKFile type=\"ImageData\"/>"),
                 "'ImageData' is not supported as a surface"));
  CHECK(contains(read_error("<VTKFile type=\"PolyData\">"), "not well-formed"));
  const auto error_with = [](const std::string& points) {
    return read_error(vtp("", "<Piece><Points>" + points + "</Points>" + cells + "</Piece>"));
  };
  CHECK(
      contains(error_with(array("Float32", "p", 3, "0 0 x")), "number 2 of the array 'p' is 'x'"));
  CHECK(contains(error_with(array("Float32", "p", 3, "0 0")), "not a multiple of 3"));
  CHECK(contains(error_with(array("String", "p", 3, "")), "the type 'String'"));
  CHECK(contains(error_with(array("Float32", "p", 3, "", "hex")), "the unknown format 'hex'"));
  CHECK(contains(error_with(array("Float32", "p", 3, "?", "binary")), "no base64"));
  CHECK(contains(error_with(array("Float32", "p", 3, "0 0 0")), "cell 0 has point index 1"));
}
