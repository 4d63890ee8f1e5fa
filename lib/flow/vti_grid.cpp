#include <array>
#include <cmath>

#include "flow/grid_files.h"
#include "io/formats/vtk_xml.h"
#include "io/formats/xml_elements.h"
#include "support/counted.h"

namespace transformesh {
namespace {

using Node = pugi::xml_node;

/// Largest number of nodes along an axis, so that no product of three sizes overflows 64 bits.
constexpr double most_nodes = 2097151;

class VtiReader {
 public:
  VtiReader(const Source& source, std::size_t components)
      : source_(source), components_(components), budget_(source), xml_(parse_vtk_xml(source)) {}

  FlowGrid read() const {
    const std::string type = xml_.root().attribute("type").value();
    if (type != "ImageData")
      source_.fail("VTK data of type " + in_quotes(type) +
                   " is not supported as a grid: only ImageData is");
    const Node image = xml_.root().child("ImageData");
    const Node piece = only_piece(image);
    const VtpArrays arrays(source_, xml_.encoding(source_), budget_);
    FlowGrid grid = frame_of(image, piece);
    grid.components = components_;
    const Node points = array_in(piece.child("PointData"));
    const Node cells = points ? Node() : array_in(piece.child("CellData"));
    if (!points && !cells) source_.fail("the grid has no array of " + wanted());
    if (cells) move_to_cells(grid);
    grid.values = arrays.read(points ? points : cells).values;
    const std::size_t nodes = grid.size[0] * grid.size[1] * grid.size[2];
    if (grid.values.size() != nodes * components_)
      source_.fail("the grid has " + counted(nodes, "node") + ", and its array " +
                   counted(grid.values.size(), "number"));
    grid.time = time_in(arrays, image);
    return grid;
  }

 private:
  std::string wanted() const { return components_ == 3 ? "vectors" : "scalars"; }

  Node only_piece(const Node& image) const {
    const Node piece = image.child("Piece");
    if (!piece) source_.fail("the grid has no piece with values");
    if (piece.next_sibling("Piece")) source_.fail("a grid in several pieces is not supported");
    return piece;
  }

  template <std::size_t count>
  std::array<double, count> numbers(const Node& node, const char* name,
                                    const std::array<double, count>& otherwise) const {
    const auto text = xml_attribute(node, name);
    if (!text) return otherwise;
    const std::vector<double> values = xml_numbers(*text, name, source_);
    if (values.size() != count)
      source_.fail(std::string(name) + " of the grid has " + counted(values.size(), "number") +
                   ", not " + std::to_string(count));
    std::array<double, count> result{};
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }

  /// Returns a grid without values, with origin, spacing and size from the XML. Extents are ranges
  /// of node indices; node 0 is at the origin.
  FlowGrid frame_of(const Node& image, const Node& piece) const {
    const auto whole = numbers<6>(image, "WholeExtent", {});
    const auto extent = numbers<6>(piece, "Extent", whole);
    const auto origin = numbers<3>(image, "Origin", {0, 0, 0});
    const auto spacing = numbers<3>(image, "Spacing", {1, 1, 1});
    const std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (numbers<9>(image, "Direction", identity) != identity)
      source_.fail("a grid with axes other than x, y and z is not supported");
    FlowGrid grid;
    for (std::size_t i = 0; i < 3; ++i) {
      const double first = extent[2 * i], nodes = extent[2 * i + 1] - first + 1;
      if (!(nodes >= 1 && nodes <= most_nodes) || nodes != std::floor(nodes))
        source_.fail("each axis of the grid must have a whole number of nodes, from 1 to 1048576");
      const auto axis = static_cast<Eigen::Index>(i);
      grid.size[i] = static_cast<std::size_t>(nodes);
      grid.spacing[axis] = spacing[i];
      grid.origin[axis] = origin[i] + first * spacing[i];
    }
    return grid;
  }

  /// Returns the data array to read, which must have `components_` components. This is the active
  /// array if `data` names one and the array exists. If the named array does not exist, returns the
  /// last array with this number of components. If `data` names none, returns the only one, and
  /// fails if there are several.
  Node array_in(const Node& data) const {
    const std::string active = data.attribute(components_ == 3 ? "Vectors" : "Scalars").value();
    Node found;
    for (const Node& array : data.children("DataArray")) {
      if (array.attribute("NumberOfComponents").as_uint(1) != components_) continue;
      if (!active.empty() && array.attribute("Name").value() == active) return array;
      if (found && active.empty())
        source_.fail("the grid has several arrays of " + wanted() +
                     ", and none of them is the active one");
      found = array;
    }
    return found;
  }

  static void move_to_cells(FlowGrid& grid) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (grid.size[i] == 1) continue;
      const auto axis = static_cast<Eigen::Index>(i);
      grid.origin[axis] += grid.spacing[axis] / 2;
      --grid.size[i];
    }
  }

  std::optional<double> time_in(const VtpArrays& arrays, const Node& image) const {
    for (const Node& data : {xml_.root().child("FieldData"), image.child("FieldData")})
      for (const Node& array : data.children("DataArray"))
        if (std::string_view(array.attribute("Name").value()) == "TimeValue") {
          const std::vector<double> values = arrays.read(array).values;
          if (values.size() != 1 || !std::isfinite(values[0]))
            source_.fail("TimeValue of the grid is not one finite number");
          return values[0];
        }
    return std::nullopt;
  }

  const Source& source_;
  std::size_t components_;
  mutable ExpansionBudget budget_;
  VtkXml xml_;
};

}  // namespace

FlowGrid read_vti_grid(const Source& source, std::size_t components) {
  return VtiReader(source, components).read();
}

}  // namespace transformesh
