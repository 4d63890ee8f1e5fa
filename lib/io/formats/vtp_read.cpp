#include <algorithm>
#include <cstring>
#include <numeric>

#include "io/formats/column_groups.h"
#include "io/formats/vtp.h"
#include "io/formats/vtp_arrays.h"
#include "io/formats/xml_elements.h"
#include "support/counted.h"

namespace transformesh {
namespace {

using Node = pugi::xml_node;

/// The XML of a file, and the data appended to it, which is no XML.
struct VtpParts {
  std::string xml;
  std::string_view appended;
  bool is_appended_text = false;
};

/// Appended data starts behind an underscore in its element.
VtpParts parts_of(const Source& source) {
  const std::string_view bytes = source.bytes;
  const std::size_t start = bytes.find("<AppendedData");
  if (start == std::string_view::npos) return {std::string(bytes), {}, false};
  const std::size_t end = bytes.find('>', start);
  const std::size_t mark = end == std::string_view::npos ? end : bytes.find('_', end);
  if (mark == std::string_view::npos)
    source.fail_at_byte(source.begin() + start, "the appended data of VTP does not start with '_'");
  const bool is_text = bytes.substr(start, end - start).find("base64") != std::string_view::npos;
  std::string_view appended = bytes.substr(mark + 1);
  if (is_text) appended = appended.substr(0, appended.find('<'));
  return {std::string(bytes.substr(0, start)) + "</VTKFile>", appended, is_text};
}

class VtpReader {
 public:
  explicit VtpReader(const Source& source)
      : source_(source), budget_(source), parts_(parts_of(source)) {}

  ReadResult read() {
    const pugi::xml_document document = parse_xml({parts_.xml, source_.name});
    const Node root = document.child("VTKFile");
    const std::string_view type = root.attribute("type").value();
    if (type != "PolyData")
      source_.fail("VTK data of the kind " + quoted(type) + " is no surface: PolyData is read");
    set_encoding(root);
    ReadResult result;
    result.document.style.format = Format::vtp;
    std::size_t pieces = 0;
    for (const Node& piece : root.child("PolyData").children("Piece"))
      add(mesh_of_vtk(source_, read_piece(piece)), pieces++, result);
    if (pieces > 1)
      result.notes.push_back("vtk: " + counted(pieces, "piece") + " read as one mesh");
    return result;
  }

 private:
  void set_encoding(const Node& root) {
    encoding_.is_big_endian = std::string_view(root.attribute("byte_order").value()) == "BigEndian";
    encoding_.has_wide_headers =
        std::string_view(root.attribute("header_type").value()) == "UInt64";
    const std::string_view compressor = root.attribute("compressor").value();
    encoding_.is_compressed = !compressor.empty();
    if (encoding_.is_compressed && compressor != "vtkZLibDataCompressor")
      source_.fail("the data is compressed by " + quoted(compressor) +
                   ", which is not read: vtkZLibDataCompressor is");
    encoding_.appended = parts_.appended;
    encoding_.is_appended_text = parts_.is_appended_text;
  }

  static void add(ReadResult part, std::size_t number, ReadResult& all) {
    all.notes.insert(all.notes.end(), part.notes.begin(), part.notes.end());
    if (number == 0) {
      all.document = std::move(part.document);
      return;
    }
    for (const std::string& line : append(all.document, part.document))
      all.notes.push_back("vtk: " + line);
  }

  VtkPiece read_piece(const Node& node) const {
    const VtpArrays arrays(source_, encoding_, budget_);
    VtkPiece piece;
    if (const Node points = node.child("Points").child("DataArray"))
      piece.points = arrays.read(points);
    if (piece.points.values.size() % 3 != 0)
      source_.fail("the points of VTP have " + counted(piece.points.values.size(), "number") +
                   ", which is no multiple of 3");
    const std::size_t vertices = read_cells(node.child("Verts"), arrays).size();
    piece.other_cells = read_cells(node.child("Lines"), arrays).size();
    piece.polygons = read_cells(node.child("Polys"), arrays);
    piece.strips = read_cells(node.child("Strips"), arrays);
    std::size_t row = vertices + piece.other_cells;
    for (VtkCells* cells : {&piece.polygons, &piece.strips}) {
      cells->rows.resize(cells->size());
      std::iota(cells->rows.begin(), cells->rows.end(), row);
      row += cells->size();
    }
    piece.cells = row;
    piece.point_arrays = read_arrays(node.child("PointData"), arrays);
    piece.cell_arrays = read_arrays(node.child("CellData"), arrays);
    return piece;
  }

  static VtkCells read_cells(const Node& node, const VtpArrays& arrays) {
    VtkCells cells;
    for (const Node& element : node.children("DataArray")) {
      const std::string_view name = element.attribute("Name").value();
      if (name == "connectivity") cells.connectivity = arrays.indices(element);
      if (name != "offsets") continue;
      const std::vector<std::uint64_t> ends = arrays.indices(element);
      cells.offsets.insert(cells.offsets.end(), ends.begin(), ends.end());
    }
    return cells;
  }

  static std::vector<VtkArray> read_arrays(const Node& node, const VtpArrays& arrays) {
    std::vector<VtkArray> result;
    for (const Node& element : node.children("DataArray")) {
      result.push_back(arrays.read(element));
      for (const char* role : {"Normals", "TCoords", "Scalars"})
        if (result.back().name == node.attribute(role).value()) result.back().role = role;
    }
    return result;
  }

  const Source& source_;
  mutable ExpansionBudget budget_;
  VtpParts parts_;
  VtpEncoding encoding_;
};

}  // namespace

bool is_vtk_xml(std::string_view bytes) {
  constexpr std::size_t searched = 1024;  // an XML declaration and comments may come first
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '<' &&
         bytes.substr(0, searched).find("<VTKFile") != std::string_view::npos;
}

ReadResult read_vtp(const Source& source) { return VtpReader(source).read(); }

}  // namespace transformesh
