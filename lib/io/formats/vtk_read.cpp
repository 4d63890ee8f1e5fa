#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/formats/vtk.h"
#include "io/formats/vtk_stream.h"
#include "support/counted.h"

namespace transformesh {
namespace {

constexpr std::string_view first_line = "# vtk DataFile Version ";

// Numbers of cell types, as in vtkCellType.h.
constexpr std::uint64_t triangle_cell = 5;
constexpr std::uint64_t triangle_strip_cell = 6;
constexpr std::uint64_t polygon_cell = 7;
constexpr std::uint64_t quadrilateral_cell = 9;

class VtkReader {
 public:
  explicit VtkReader(const Source& source) : source_(source), stream_(source) {}

  ReadResult read() {
    read_header();
    for (std::string word = stream_.word(); !word.empty(); word = stream_.word())
      read_section(word);
    gather_cells();
    ReadResult result = mesh_of_vtk(source_, std::move(piece_));
    if (!title_.empty()) result.document.style.comments.push_back(title_);
    return result;
  }

 private:
  void read_header() {
    stream_.line();
    title_ = stream_.line();
    const std::string encoding = stream_.word();
    if (encoding != "ascii" && encoding != "binary")
      stream_.fail("the third line of a VTK file is ASCII or BINARY, not " + in_quotes(encoding));
    stream_.set_binary(encoding == "binary");
    if (stream_.word() != "dataset") stream_.fail("the word DATASET is missing");
    const std::string kind = stream_.word();
    is_grid_ = kind == "unstructured_grid";
    if (kind != "polydata" && !is_grid_)
      stream_.fail("VTK data of type " + in_quotes(kind) +
                   " is not supported as a surface: only POLYDATA is");
  }

  void read_section(const std::string& word) {
    if (word == "points") return read_points();
    if (word == "polygons") return read_cells(polygons_);
    if (word == "triangle_strips") return read_cells(strips_);
    if (word == "vertices") return read_cells(vertices_);
    if (word == "lines") return read_cells(lines_);
    if (word == "cells" && is_grid_) return read_cells(grid_);
    if (word == "cell_types" && is_grid_) return read_types();
    if (word == "field") return read_field();
    if (word == "metadata") return skip_metadata();
    if (word == "point_data") return begin_data(piece_.point_arrays);
    if (word == "cell_data") return begin_data(piece_.cell_arrays);
    if (arrays_ == nullptr || !read_attribute(word))
      stream_.fail("the VTK file has the unknown word " + in_quotes(word));
  }

  void read_points() {
    const std::uint64_t count = checked(stream_.count("the number of points"));
    piece_.points.name = "points";
    piece_.points.components = 3;
    piece_.points.values.clear();
    const std::string type = stream_.word();
    stream_.numbers(type, 3 * count, piece_.points);
    if (type != "float") piece_.points.type = Scalar::float64;
  }

  /// Returns the count. Throws InputError if it is so large that products of counts could overflow.
  std::uint64_t checked(std::uint64_t count) const {
    if (count > source_.bytes.size())
      stream_.fail(std::to_string(count) + " elements are announced, but there are only " +
                   counted(source_.bytes.size(), "byte"));
    return count;
  }

  // --- Cells -------------------------------------------------------------------------------------

  /// Reads the cells of one kind. Files of versions up to 4 have one list of counts and indices;
  /// from version 5 there are two arrays, offsets and connectivity.
  void read_cells(VtkCells& cells) {
    const std::uint64_t count = checked(stream_.count("the number of cells"));
    const std::uint64_t size = checked(stream_.count("the size of the cells"));
    cells = {};
    VtkStream ahead = stream_;
    if (ahead.word() == "offsets") return read_offsets(count, size, cells);
    const auto list = stream_.indices("int", size, "the cells");
    for (std::size_t i = 0; i < list.size(); i += 1 + list[i]) {
      if (list[i] >= list.size() - i) stream_.fail("a cell reaches beyond the list of cells");
      const auto first = list.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      cells.connectivity.insert(cells.connectivity.end(), first,
                                first + static_cast<std::ptrdiff_t>(list[i]));
      cells.offsets.push_back(cells.connectivity.size());
    }
    if (cells.size() != count)
      stream_.fail(counted(count, "cell") + " are announced, but " +
                   there_are(cells.size(), "cell"));
  }

  void read_offsets(std::uint64_t count, std::uint64_t size, VtkCells& cells) {
    stream_.word();
    cells.offsets = stream_.indices(stream_.word(), count, "the offsets");
    if (cells.offsets.empty()) cells.offsets = {0};
    if (stream_.word() != "connectivity") stream_.fail("the word CONNECTIVITY is missing");
    cells.connectivity = stream_.indices(stream_.word(), size, "the connectivity");
  }

  void read_types() {
    const std::uint64_t count = checked(stream_.count("the number of cell types"));
    types_ = stream_.indices("int", count, "the cell types");
  }

  /// Collects the cells of all kinds in the order of cell data: vertices, lines, polygons, strips.
  void gather_cells() {
    if (is_grid_) return sort_grid();
    piece_.other_cells = lines_.size();
    std::size_t row = vertices_.size() + lines_.size();
    for (VtkCells* cells : {&polygons_, &strips_}) {
      cells->rows.resize(cells->size());
      std::iota(cells->rows.begin(), cells->rows.end(), row);
      row += cells->size();
    }
    piece_.cells = row;
    piece_.polygons = std::move(polygons_);
    piece_.strips = std::move(strips_);
  }

  void sort_grid() {
    piece_.cells = grid_.size();
    if (types_.size() != grid_.size())
      source_.fail("the VTK file has " + counted(grid_.size(), "cell") + ", but " +
                   counted(types_.size(), "cell type"));
    for (std::size_t i = 0; i < types_.size(); ++i) {
      const bool is_strip = types_[i] == triangle_strip_cell;
      const bool is_face = types_[i] == triangle_cell || types_[i] == polygon_cell ||
                           types_[i] == quadrilateral_cell;
      if (!is_face && !is_strip) {
        ++piece_.other_cells;
        continue;
      }
      add_cell(i, is_strip ? piece_.strips : piece_.polygons);
    }
  }

  void add_cell(std::size_t i, VtkCells& to) const {
    const std::uint64_t first = grid_.offsets[i], last = grid_.offsets[i + 1];
    if (first > last || last > grid_.connectivity.size())
      source_.fail("the offsets of cell " + std::to_string(i) + " are out of range");
    const auto begin = grid_.connectivity.begin();
    to.connectivity.insert(to.connectivity.end(), begin + static_cast<std::ptrdiff_t>(first),
                           begin + static_cast<std::ptrdiff_t>(last));
    to.offsets.push_back(to.connectivity.size());
    to.rows.push_back(i);
  }

  // --- Arrays ------------------------------------------------------------------------------------

  void begin_data(std::vector<VtkArray>& arrays) {
    arrays_ = &arrays;
    rows_ = checked(stream_.count("the number of rows"));
  }

  bool read_attribute(const std::string& word) {
    if (word == "scalars") return read_scalars(), true;
    if (word == "color_scalars") return read_color_scalars(), true;
    if (word == "lookup_table") return skip_lookup_table(), true;
    if (word == "normals") return read_array("Normals", 3), true;
    if (word == "vectors") return read_array("", 3), true;
    if (word == "tensors") return read_array("", 9), true;
    if (word == "tensors6") return read_array("", 6), true;
    if (word == "global_ids" || word == "pedigree_ids") return read_array("", 1), true;
    if (word == "texture_coordinates") return read_texture(), true;
    return false;
  }

  void read_array(const std::string& role, std::size_t components) {
    VtkArray array{std::string(stream_.raw_word()), role, {}, components, {}};
    stream_.numbers(stream_.word(), rows_ * components, array);
    arrays_->push_back(std::move(array));
  }

  void read_scalars() {
    VtkArray array{std::string(stream_.raw_word()), "Scalars", {}, 1, {}};
    const std::string type = stream_.word();
    if (stream_.has_word_in_line()) array.components = checked_components();
    VtkStream ahead = stream_;
    if (ahead.word() == "lookup_table") {
      ahead.raw_word();
      stream_ = ahead;
    }
    stream_.numbers(type, rows_ * array.components, array);
    arrays_->push_back(std::move(array));
  }

  std::uint64_t checked_components() {
    const std::uint64_t components = stream_.count("the number of components");
    if (components == 0 || components > 255)
      stream_.fail("an array has " + counted(components, "component") + ", not 1 to 255");
    return components;
  }

  /// Reads color scalars: bytes in binary files, numbers from 0 to 1 in text files.
  void read_color_scalars() {
    VtkArray array{std::string(stream_.raw_word()), "Scalars", {}, 1, {}};
    array.components = checked_components();
    stream_.numbers(stream_.is_binary() ? "unsigned_char" : "float", rows_ * array.components,
                    array);
    if (!stream_.is_binary())
      for (double& value : array.values)
        value = std::isnan(value) ? 0 : std::round(255 * std::clamp(value, 0.0, 1.0));
    array.type = Scalar::uint8;
    arrays_->push_back(std::move(array));
  }

  void skip_lookup_table() {
    stream_.raw_word();
    VtkArray table;
    table.name = "lookup table";
    const std::uint64_t size = checked(stream_.count("the size of a lookup table"));
    stream_.numbers(stream_.is_binary() ? "unsigned_char" : "float", 4 * size, table);
  }

  void read_texture() {
    VtkArray array{std::string(stream_.raw_word()), "TCoords", {}, 1, {}};
    array.components = checked_components();
    stream_.numbers(stream_.word(), rows_ * array.components, array);
    arrays_->push_back(std::move(array));
  }

  /// Reads the arrays of a FIELD. An array belongs to points or cells if it has a row for each of
  /// them. Arrays that precede the points belong to the whole file and are ignored.
  void read_field() {
    stream_.raw_word();
    const std::uint64_t count = checked(stream_.count("the number of arrays"));
    for (std::uint64_t i = 0; i < count; ++i) {
      VtkArray array;
      array.name = stream_.raw_word();
      if (array.name == "METADATA") {
        skip_metadata();
        array.name = stream_.raw_word();
      }
      array.components = checked_components();
      const std::uint64_t rows = checked(stream_.count("the number of rows"));
      const std::string type = stream_.word();
      if (type == "string" || type == "bit" || type == "variant")
        stream_.fail("the array " + in_quotes(array.name) + " has the type " + in_quotes(type) +
                     ", which is not supported");
      stream_.numbers(type, rows * array.components, array);
      if (arrays_ != nullptr) arrays_->push_back(std::move(array));
    }
  }

  /// Skips a block of metadata, which ends with an empty line.
  void skip_metadata() {
    stream_.line();
    while (!stream_.line().empty()) {
    }
  }

  const Source& source_;
  VtkStream stream_;
  std::string title_;
  bool is_grid_ = false;
  VtkCells vertices_, lines_, polygons_, strips_, grid_;
  std::vector<std::uint64_t> types_;
  /// Arrays to which data is currently added: those of points or of cells.
  std::vector<VtkArray>* arrays_ = nullptr;
  std::uint64_t rows_ = 0;  ///< number of rows that the current arrays must have
  VtkPiece piece_;
};

}  // namespace

bool is_vtk(std::string_view bytes) { return bytes.starts_with(first_line); }

std::string unlike_vtk(std::string text) {
  if (is_vtk(text)) text.insert(0, 1, '\n');
  return text;
}

ReadResult read_vtk(const Source& source) { return VtkReader(source).read(); }

}  // namespace transformesh
