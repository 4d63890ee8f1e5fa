/// One run of a program, as its body sees it: what was read, what relative lengths amount to, what
/// to say, and what to write.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frame/program.h"
#include "frame/terminal.h"
#include "io/length_basis.h"
#include "io/streams/atomic_file.h"
#include "io/streams/streams.h"
#include "transformesh/control.h"
#include "transformesh/document.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {

class Run {
 public:
  Run(Program& program, Terminal& terminal);
  ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// As it was declared, with the values of the command line.
  const Program& program() const { return program_; }
  /// What the user named, or `-` for stdin; the words of Reads::words.
  const std::vector<std::string>& inputs() const { return program_.inputs; }
  const std::string& input() const { return inputs().at(0); }
  static std::string version();
  bool writes_to_terminal() const;
  const std::string& output() const { return program_.common.output; }
  /// The mesh read, which a program that writes a mesh changes; empty where none was read.
  Document& document() { return documents_.front(); }
  std::vector<Document>& documents() { return documents_; }
  /// Reads a further mesh or file named by an option.
  Document read(const std::string& path);
  std::string read_bytes(const std::string& path) { return std::string(read_once(path).view()); }
  /// Returns the options for reading that --strict sets.
  ReadOptions reading() const { return {program_.common.strict}; }

  /// Input units. 1% is of the diagonal of the mesh read (or of `set_basis`), 0.7x of the reference
  /// edge: the tm:reference-edge comment, else the mean edge, which is then written as that
  /// comment.
  double length(const Length& length) { return basis_.resolve(length); }
  /// The mean edge length that `x` refers to.
  double reference_edge() { return basis_.reference_edge(); }
  /// For programs that read no mesh: what 1% refers to.
  void set_basis(double diagonal) { basis_.set_diagonal(diagonal); }

  /// One line on stderr unless -q.
  void note(const std::string& message) { terminal_.note(message); }
  /// One line each; warnings with the remedies that this program offers.
  void note_all(const std::vector<std::string>& lines);
  void note_all(const std::vector<Problem>& warnings);
  /// One line on stderr with -v.
  void detail(const std::string& message) { terminal_.detail(message); }
  /// Hand this to the library; phases are timed for the report.
  const Progress& progress() const { return progress_; }

  /// An entry of --report (and of stdout for predicates), in this order. Names are lower case with
  /// underscores. Points are three numbers.
  void report(const std::string& key, const Value& value);
  void report(const Entries& entries) { append(result_, entries); }
  /// Whether anyone will see the entries of a program that writes a mesh.
  bool shows_report() const { return terminal_.is_verbose() || !program_.common.report.empty(); }
  /// A no is exit code 1.
  void answer(bool is_yes) { answer_ = is_yes; }

  /// At once, on standard output: for a program that then goes on until it is ended.
  static void print_line(const std::string& text);
  /// What goes to -o of a program that writes no mesh.
  void write_output(std::string bytes) { bytes_ = std::move(bytes); }
  /// Nothing goes to -o.
  void write_nothing() { writes_nothing_ = true; }
  /// Writes a further file, complete or not at all, once the program has succeeded.
  void write(const std::string& path, std::string bytes);
  /// The same for a mesh, with the provenance, in the format of the name as with -o; --format and
  /// --float count where the program has them.
  void write_mesh_file(const std::string& path, Document document);
  /// The same in a folder, which is made where it is missing, as are folders of the name.
  void write_into(const std::string& folder, const std::string& name, std::string bytes);

  /// For an evolution, which may run for hours and be continued:
  /// Throws UsageError where two of these options (names without dashes) name the same file, and
  /// OutputError where one of the files cannot be written.
  void check_outputs(const std::vector<std::string>& options);
  /// The mesh named as input, to be changed; relative lengths refer to it from now on.
  Document& read_input();
  /// Instead: a mesh whose comments hold the reference edge and the provenance already.
  Document& continue_from(Document document);
  /// Adds the comments that the output will have, so that all meshes on the way have the same.
  void stamp(Document& document);
  /// Shown in the place of the progress bar, or as a line of its own with --progress.
  void progress_line(const std::string& text) { terminal_.progress_line(text); }
  /// The failure that the body is about to throw leaves something: document() is written to -o all
  /// the same. After its message comes `stopped; 'OUT' holds what`, or `is not written`.
  void keep(const std::string& stopped, const std::string& what) { kept_ = {stopped, what}; }
  /// Called when all outputs have their names. The body has ended by then.
  void when_written(std::function<void()> hook) { when_written_ = std::move(hook); }

  /// What the frame does before the body, and after it; returns the exit code.
  void start();
  int finish();
  /// After a failure: writes what the body has kept, if anything.
  void write_kept();

 private:
  Bytes read_once(const std::string& path);
  /// Joins or tells, as the program says; `is_told` if reading has said that it is a soup.
  void treat_soup(Mesh& mesh, const std::string& name, bool is_reported);
  void refer_to(const Document& document);
  /// Throws UsageError for an output whose name promises a format that is not written.
  void check_ending() const;
  /// In input units, where the option is a length and there is what it refers to.
  std::optional<double> resolved(const Option& option);
  void show_settings();
  /// Makes the document what is written to that path.
  void set_style(Document& document, const std::string& path);
  void set_output_style(Document& document);
  void add_comments(Document& document);
  /// Notes of writing, each one once: several files may have the same.
  void note_once(const std::vector<std::string>& lines);
  /// Says once how many pairs of faces intersect only because coordinates are floats.
  void note_rounding_intersections(std::size_t pairs);
  void write_mesh();
  std::string report_text() const;
  std::string full_report();
  /// Writes a file that gets its name with all others at the end.
  void stage(const std::string& path, std::string bytes);
  void commit();

  Program& program_;
  Terminal& terminal_;
  LengthBasis basis_;
  Progress progress_;
  Phases phases_;
  std::vector<Document> documents_ = std::vector<Document>(1);
  Entries input_counts_, output_counts_, result_;
  std::string bytes_;
  std::vector<std::pair<std::string, std::string>> further_files_;
  std::vector<AtomicFile> staged_;
  std::set<std::string> staged_places_, reported_;
  std::optional<std::pair<std::string, std::string>> kept_;
  std::function<void()> when_written_;
  std::size_t joined_vertices_ = 0;
  bool stdin_is_read_ = false;
  bool settings_are_shown_ = false;
  bool is_stamped_ = false;
  bool are_self_intersections_reported_ = false;
  bool writes_nothing_ = false;
  bool answer_ = true;
};

}  // namespace transformesh::tool
