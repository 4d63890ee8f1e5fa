/// VTK PolyData while it is read into a mesh, for the legacy and the XML format.
#pragma once

#include <string>
#include <vector>

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

struct VtkArray {
  std::string name;
  /// Role of the array: Normals, TCoords or Scalars; empty if the file states none.
  std::string role;
  Scalar type = Scalar::float32;
  std::size_t components = 1;
  std::vector<double> values;
  bool has_long_integers = false;  ///< true if the file has integers of 64 bits
};

/// Cells of one kind, such as polygons. The vertex indices of cell i are from offsets[i] to
/// offsets[i + 1] in the connectivity.
struct VtkCells {
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint64_t> connectivity;
  std::vector<std::size_t> rows;  ///< for each cell, its row in the arrays of cell data

  std::size_t size() const { return offsets.size() - 1; }
};

struct VtkPiece {
  VtkArray points;  ///< array of positions, with three components
  VtkCells polygons;
  VtkCells strips;
  /// Number of cells of all kinds (polygons, strips and cells that are not read).
  std::size_t cells = 0;
  std::size_t other_cells = 0;  ///< number of lines and volume cells, which are not read
  std::vector<VtkArray> point_arrays;
  std::vector<VtkArray> cell_arrays;
};

/// Returns the mesh of a piece. Arrays become columns: Normals become nx ny nz, and TCoords become
/// s t. The first array of three or four bytes, or of any type and named RGB or RGBA, becomes red
/// green blue alpha. Any other array of several components becomes a list. Throws InputError for an
/// index out of range and for an array of wrong length.
ReadResult mesh_of_vtk(const Source& source, VtkPiece piece);

/// Sets the type of an array from a VTK type with a size of `bytes`. Numbers are rounded to float
/// if the type is float. If a type has 64-bit integers, or integers in text exceed their type, the
/// type becomes int32 if all numbers fit, else double.
void set_type(bool is_floating, bool is_signed, std::size_t bytes, VtkArray& array);

}  // namespace transformesh
