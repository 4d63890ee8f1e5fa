/// Inputs of a run: the meshes and files that it reads, and the lengths that refer to them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "entries/entries.h"
#include "frame/messages.h"
#include "frame/report.h"
#include "io/document/unit.h"
#include "io/length_basis.h"
#include "io/streams/output_target.h"
#include "io/streams/streams.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {

class Inputs {
 public:
  Inputs(const Program& program, Messages& messages, Phases& phases);

  /// Returns the file names on the command line; `-` is stdin. If the program takes words instead
  /// of files (Reads::words), returns these words.
  const std::vector<std::string>& names() const { return program_.inputs; }
  const std::string& name() const { return names().at(0); }

  /// Returns the first mesh. Programs whose output is a mesh change this document and then write
  /// it. The document is empty if no mesh was read.
  Document& document() { return documents_.front(); }
  std::vector<Document>& documents() { return documents_; }
  /// Reads the meshes that are named as inputs.
  void read_all();
  /// Makes length() measure percentages and factors such as 0.7x relative to the first mesh.
  void refer_to_mesh();
  /// Replaces the first mesh by the last mesh of an earlier run that is continued. The comments of
  /// this mesh state the reference edge.
  void continue_from(Document document);

  /// Reads another mesh or file that an option names. Stdin can be read only once.
  Document read(const std::string& path);
  /// Prints a note if the first mesh and another mesh have different units.
  void note_unit(const Unit* other) const;
  std::string read_bytes(const std::string& path) { return std::string(read_once(path).view()); }
  /// Returns the options for reading a file, as --strict and --keep-polygons set them.
  ReadOptions reading(const std::string& path) const {
    return {program_.common.strict, input_folder(path), program_.common.keep_polygons};
  }

  /// True if the path leads to a file that the command line names as an input, or to one read so
  /// far.
  bool contains(const std::string& path) const { return places_.contains(place_of(path)); }

  /// Returns a length in input units. Percentages refer to the bounding box diagonal of the first
  /// mesh, or to the diagonal given to set_basis(). Factors such as 0.7x refer to the reference
  /// edge: the length in the tm:reference-edge comment, or else the mean edge, which is then stored
  /// as this comment.
  double length(const Length& length) { return basis_.resolve(length); }
  double reference_edge() { return basis_.reference_edge(); }
  void set_basis(double diagonal) { basis_.set_diagonal(diagonal); }
  /// Must be called before the program changes the mesh. Afterwards, lengths are no longer measured
  /// relative to the mesh.
  void end_reading() { basis_.set_document(nullptr); }
  /// Returns the reference edge if a length referred to it.
  std::optional<double> used_reference_edge();
  /// Returns the value of a length option in input units. Returns nothing for other options, and if
  /// there is no mesh to which the length can refer.
  std::optional<double> resolved(const Option& option);

  /// Return the bytes and the format of the last mesh file, if InputRules::keeps_bytes is set. The
  /// bytes are empty if the reader left out or changed data of the file.
  const std::string& bytes() const { return bytes_; }
  Format format() const { return format_; }

  /// Returns the numbers of vertices and faces of all inputs; empty if no mesh was read.
  const Entries& counts() const { return counts_; }
  /// Returns the number of vertices that were merged while reading, because they had equal
  /// positions. Programs request this by the rule Soups::joined.
  std::size_t joined_vertices() const { return joined_vertices_; }

 private:
  Bytes read_once(const std::string& path);
  Document read_document(const std::string& path);
  void keep_bytes(std::string_view bytes, const ReadResult& result);
  /// check_tile() refuses a tile of a larger mesh or prints a note about it. treat_soup() treats a
  /// mesh whose faces touch without sharing vertices (a soup). Depending on InputRules::soups, it
  /// merges equal positions or prints a note. `is_noted` is true if the reader has already noted
  /// the soup.
  void check_tile(const Document& document, const std::string& name);
  void treat_soup(Mesh& mesh, const std::string& name, bool is_noted);

  const Program& program_;
  Messages& messages_;
  Phases& phases_;
  LengthBasis basis_;
  std::vector<Document> documents_ = std::vector<Document>(1);
  Entries counts_;
  std::size_t joined_vertices_ = 0;
  std::string bytes_;
  Format format_ = Format::ply_little;
  bool stdin_is_read_ = false;
  std::set<std::string> places_;  ///< all input files (place_of)
};

/// Returns the total numbers of vertices and faces.
Entries counts_of(const std::vector<Document>& documents);
/// Returns a text such as "PLY, 12 vertices, 20 faces".
std::string described(const Document& document);

}  // namespace transformesh::tool
