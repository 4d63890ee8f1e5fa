/// Inputs of a run: the meshes and files that it reads, and the lengths that refer to them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "entries/entries.h"
#include "frame/messages.h"
#include "frame/report.h"
#include "io/length_basis.h"
#include "io/streams/streams.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {

class Inputs {
 public:
  Inputs(const Program& program, Messages& messages, Phases& phases);

  /// File names as on the command line, with `-` for stdin; the words of Reads::words.
  const std::vector<std::string>& names() const { return program_.inputs; }
  const std::string& name() const { return names().at(0); }

  /// The first mesh, which a program that writes a mesh changes. Empty if none was read.
  Document& document() { return documents_.front(); }
  std::vector<Document>& documents() { return documents_; }
  /// Reads the meshes that are named as inputs.
  void read_all();
  /// Relative lengths refer to the first mesh from then on.
  void refer_to_mesh();
  /// Continues an earlier run with a mesh whose comments hold the reference edge.
  void continue_from(Document document);

  /// Reads a further mesh or file, which an option names. Stdin can be read once.
  Document read(const std::string& path);
  std::string read_bytes(const std::string& path) { return std::string(read_once(path).view()); }
  /// Returns the options for reading a file that --strict and --keep-polygons set.
  ReadOptions reading(const std::string& path) const {
    return {program_.common.strict, input_folder(path), program_.common.keep_polygons};
  }

  /// Returns a length in input units. 1% is of the diagonal of the first mesh (or of `set_basis`),
  /// 0.7x of the reference edge: the tm:reference-edge comment, or else the mean edge, which is
  /// then written as that comment.
  double length(const Length& length) { return basis_.resolve(length); }
  double reference_edge() { return basis_.reference_edge(); }
  void set_basis(double diagonal) { basis_.set_diagonal(diagonal); }
  /// Lengths that are asked for later do not refer to the document, which the body has changed.
  void end_reading() { basis_.set_document(nullptr); }
  /// The reference edge, if any length referred to it.
  std::optional<double> used_reference_edge();
  /// The value of a length option in input units. Empty for other options, and if there is no mesh
  /// that the length could refer to.
  std::optional<double> resolved(const Option& option);

  /// The bytes of the mesh that was read last, and their format, with InputRules::keeps_bytes.
  /// Empty if something in them was left out or changed while reading.
  const std::string& bytes() const { return bytes_; }
  Format format() const { return format_; }

  /// Vertices and faces of all inputs; empty if no mesh was read.
  const Entries& counts() const { return counts_; }
  /// Vertices that Soups::joined joined with others.
  std::size_t joined_vertices() const { return joined_vertices_; }

 private:
  Bytes read_once(const std::string& path);
  void keep_bytes(std::string_view bytes, const ReadResult& result);
  /// Joins a soup or notes it, by the rules of the program. `is_noted`: the reader has noted it.
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
};

/// Vertices and faces of these documents together.
Entries counts_of(const std::vector<Document>& documents);
/// Returns "PLY, 12 vertices, 20 faces".
std::string described(const Document& document);

}  // namespace transformesh::tool
