#include <algorithm>
#include <numeric>

#include "io/formats/column_groups.h"
#include "io/formats/vtk_xml.h"
#include "io/formats/vtp.h"
#include "io/formats/vtp_arrays.h"
#include "support/counted.h"

namespace transformesh {
namespace {

class VtpReader {
 public:
  explicit VtpReader(const Source& source) : source_(source), budget_(source) {}

  ReadResult read() {
    const VtkXml xml = parse_vtk_xml(source_);
    const pugi::xml_node root = xml.root();
    const std::string_view type = root.attribute("type").value();
    if (type != "PolyData")
      source_.fail("VTK data of type " + in_quotes(type) +
                   " is not supported as a surface: only PolyData is");
    encoding_ = xml.encoding(source_);
    ReadResult result;
    result.document.style.format = Format::vtp;
    std::size_t pieces = 0;
    for (const pugi::xml_node& piece : root.child("PolyData").children("Piece"))
      add(mesh_of_vtk(source_, read_piece(piece)), pieces++, result);
    if (pieces > 1)
      result.notes.push_back("vtk: " + counted(pieces, "piece") + " read as one mesh");
    return result;
  }

 private:
  static void add(ReadResult part, std::size_t number, ReadResult& all) {
    all.notes.insert(all.notes.end(), part.notes.begin(), part.notes.end());
    if (number == 0) {
      all.document = std::move(part.document);
      return;
    }
    for (const std::string& line : append(all.document, part.document))
      all.notes.push_back("vtk: " + line);
  }

  VtkPiece read_piece(const pugi::xml_node& node) const {
    const VtpArrays arrays(source_, encoding_, budget_);
    VtkPiece piece;
    if (const pugi::xml_node points = node.child("Points").child("DataArray"))
      piece.points = arrays.read(points);
    if (piece.points.values.size() % 3 != 0)
      source_.fail("the VTP points have " + counted(piece.points.values.size(), "number") +
                   ", which is not a multiple of 3");
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

  static VtkCells read_cells(const pugi::xml_node& node, const VtpArrays& arrays) {
    VtkCells cells;
    for (const pugi::xml_node& element : node.children("DataArray")) {
      const std::string_view name = element.attribute("Name").value();
      if (name == "connectivity") cells.connectivity = arrays.indices(element);
      if (name != "offsets") continue;
      const std::vector<std::uint64_t> ends = arrays.indices(element);
      cells.offsets.insert(cells.offsets.end(), ends.begin(), ends.end());
    }
    return cells;
  }

  static std::vector<VtkArray> read_arrays(const pugi::xml_node& node, const VtpArrays& arrays) {
    std::vector<VtkArray> result;
    for (const pugi::xml_node& element : node.children("DataArray")) {
      result.push_back(arrays.read(element));
      for (const char* role : {"Normals", "TCoords", "Scalars"})
        if (result.back().name == node.attribute(role).value()) result.back().role = role;
    }
    return result;
  }

  const Source& source_;
  mutable ExpansionBudget budget_;
  VtpEncoding encoding_;
};

}  // namespace

ReadResult read_vtp(const Source& source) { return VtpReader(source).read(); }

}  // namespace transformesh
