/// Outputs of a run: the main output (-o) and further files. Files are written under temporary
/// names. All files are renamed together after the program has succeeded.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frame/inputs.h"
#include "io/streams/atomic_file.h"

namespace transformesh::tool {

class Outputs {
 public:
  Outputs(Program& program, Inputs& inputs, Messages& messages)
      : program_(program), inputs_(inputs), messages_(messages) {}

  /// Returns the name of the main output file, which follows -o; `-` is stdout.
  const std::string& name() const { return program_.common.output; }
  bool is_terminal() const;

  /// Sets the bytes of the main output, for a program that writes no mesh.
  void set_bytes(std::string bytes) { bytes_ = std::move(bytes); }
  /// Makes the program write no main output, only further files.
  void write_nothing() { writes_nothing_ = true; }
  bool has_main() const { return !writes_nothing_; }
  /// Adds another output file.
  void write(const std::string& path, std::string bytes);
  /// Adds an output file with a mesh and with the provenance: the comment that states the program
  /// and its options. Its format follows from the name as with -o, and from --format and --float if
  /// the program has them.
  void write_mesh_file(const std::string& path, Document document);
  /// Adds a file in a folder. Missing folders are created, also those in `name`.
  void write_into(const std::string& folder, const std::string& name, std::string bytes);
  /// Prints a line on stdout at once, for a program that then runs until a signal ends it.
  static void print_line(const std::string& text);

  /// Throws UsageError for a name that cannot be an output of the program.
  void check_name() const;
  /// Throws UsageError if two options name the same output file, or if an output would replace an
  /// input. Only a main output of the same kind may replace the input. Throws OutputError if a file
  /// cannot be written. The main output is not checked if it is a folder.
  void check_files(bool is_main_folder = false) const;
  /// Throws UsageError if the path leads to an input.
  void check_is_no_input(const std::string& path) const;
  /// Sets a document's format and type of coordinates to those of -o.
  void set_style(Document& document);
  /// Adds the reference edge and the provenance (program and options) to the comments of a mesh. A
  /// loop calls this once at its beginning, so that all meshes of the run have the same comments.
  void stamp(Document& document);
  void set_stamped() { is_stamped_ = true; }

  /// Called after a failure: makes write_kept() write the current mesh to -o. A second error
  /// message then states "`stopped`; 'OUT' holds `content`", or "`stopped`; 'OUT' is not written".
  void keep(const std::string& stopped, const std::string& content) { kept_ = {stopped, content}; }
  void write_kept();
  /// Sets a function that is called when the program has succeeded and all output files have their
  /// final names.
  void when_written(std::function<void()> hook) { when_written_ = std::move(hook); }

  /// Writes the main output and the further files under temporary names.
  void stage_all();
  /// Writes another file under a temporary name.
  void stage(const std::string& path, std::string bytes);
  /// Renames all temporary files to their final names.
  void commit();
  /// Returns the numbers of vertices and faces of the written mesh. Empty if no mesh is written.
  const Entries& counts() const { return counts_; }

 private:
  void set_style_of(Document& document, const std::string& path);
  void add_comments(Document& document);
  /// Prints a note about pairs of faces that intersect only after rounding to floats, at most once
  /// in a run.
  void note_rounding_intersections(std::size_t pairs);
  void stage_mesh();

  Program& program_;
  Inputs& inputs_;
  Messages& messages_;
  Entries counts_;
  std::string bytes_;
  std::vector<std::pair<std::string, std::string>> further_files_;
  std::vector<AtomicFile> staged_;
  std::set<std::string> staged_places_;
  std::optional<std::pair<std::string, std::string>> kept_;
  std::function<void()> when_written_;
  bool is_stamped_ = false;
  bool are_intersections_noted_ = false;
  bool writes_nothing_ = false;
};

}  // namespace transformesh::tool
