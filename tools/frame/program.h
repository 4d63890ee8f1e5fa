/// The frame: code that all command-line programs share. Only the frame uses argv, the standard
/// streams, signals and exit codes. A program declares its inputs, outputs and options, and passes
/// one function, its body, which does the work. man/tm.7.md specifies the behavior of the frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/option_set.h"

namespace transformesh::tool {

class Run;

/// The exit codes of all programs. A signal gives 128 plus its number. The codes 124 to 127 and 137
/// are not used, because `timeout` and the shell use them.
enum ExitCode {
  exit_done = 0,  ///< success; for a program that answers a question: yes
  /// The answer is no, or an evolution did not converge although --require-convergence is given.
  exit_no = 1,
  exit_usage = 2,
  exit_input = 3,
  exit_goal = 4,
  exit_output = 5,
  exit_memory = 6
};

/// Kinds of arguments that are not options.
enum class Reads {
  nothing,  ///< no arguments
  words,    ///< any number of words; the frame reads no input file
  mesh,     ///< at most one mesh; stdin if no mesh is named
  meshes,   ///< any number of meshes; stdin if no mesh is named
  file,     ///< at most one file, read by the program's own code; stdin if no file is named
  files     ///< any number of files, read by the program's own code; stdin if no file is named
};

/// Treatment of soups: meshes whose faces meet but share no vertices (touching_borders.h).
enum class Soups {
  kept,  ///< the mesh is read as it is; a note advises tm-stitch if the file is STL
  own,   ///< the mesh is read as it is, without a note: the program itself merges equal positions
  /// Equal positions are merged when a mesh is read; the report states how many vertices are
  /// merged.
  joined,
  /// The mesh is read as it is; a note advises tm-stitch, whatever the format of the file.
  reported
};

struct InputRules {
  Reads reads = Reads::mesh;
  Soups soups = Soups::kept;
  bool may_keep_polygons = false;  ///< true: the program has --keep-polygons
  /// True: the bytes of the input file stay in memory, for programs that may copy them unchanged to
  /// the output (Inputs::bytes).
  bool keeps_bytes = false;
  /// True: the program accepts tiles, parts of a larger mesh that tm-tile cuts.
  bool takes_tiles = false;
  /// True: the input file contains cameras instead of a mesh or points.
  bool are_cameras = false;
  /// Called after parsing; returns true if the given options make reading unnecessary.
  std::function<bool()> is_absent = {};
};

/// Arguments that the frame does not read as input files, for help and completion. They are all
/// arguments (Reads::words), or a command such as `union` before the names of meshes.
struct WordRules {
  std::string placeholder = {}, help = {};
  std::vector<std::string> choices = {};  ///< commands, one of which is the first word
  bool are_folders = false;
};

/// Kinds of the main output (-o), which is stdout by default.
enum class Writes {
  mesh,
  evolved_mesh,  ///< result of an evolution: always PLY, whatever the input's format
  picture,       ///< binary data, which are not written to a terminal
  page,          ///< an HTML page
  text,
  report,  ///< `key: value` lines, or JSON with --json
  answer   ///< a report; exit code 1 means a negative answer
};

struct OutputRules {
  Writes writes = Writes::mesh;
  bool is_clean = false;  ///< true: the output has no self-intersection after rounding
  std::vector<std::string> picture_endings = {".png"};
  /// Called after parsing; returns true if the given options request a mesh.
  std::function<bool()> is_mesh = {};
  /// For programs with an option of their own that selects one entry of the report. Points to the
  /// key of this entry, or to an empty text to print all entries. Null: use the common option
  /// --get.
  const std::string* only_key = nullptr;
};

/// Values of the options that programs have in common.
struct CommonValues {
  std::string output = "-";
  std::string format, reference_edge, report, get;
  int threads = 0;
  std::string max_memory, completion;
  double max_time = 0;
  bool as_float = false, as_double = false, no_provenance = false, json = false, strict = false;
  bool keep_polygons = false;
  bool progress = false, no_progress = false, quiet = false, verbose = false;
  bool help = false, version = false;
};

/// Declaration of a command-line program. Parsing, help, provenance and report all use the same
/// option objects.
struct Program {
  const std::string name;
  const std::string synopsis;  ///< usage without the program's name
  const std::string summary;   ///< one line without full stop
  InputRules input = {};
  OutputRules output = {};
  WordRules words = {};
  /// How to write a LENGTH, for the help of programs that read no input.
  std::string lengths = {};
  std::string epilog = {};   ///< shown after the options: formulas, pipelines
  std::string example = {};  ///< a complete command, shown at the end of the help
  OptionSet options = {};
  CommonValues common = CommonValues();  // explicit, because GCC 12 warns about {}
  /// Called after parsing, to derive some options from others. May throw UsageError.
  std::function<void()> settle = {};
  std::string word = {};  ///< first word of the arguments if it is a command; may be empty
  /// Names of input files; the words if the program reads words.
  std::vector<std::string> inputs = {};
  std::vector<std::string> command = {};  ///< the whole command line

  /// Declares the option --reference-edge. It is called automatically for programs that read and
  /// write meshes, except for evolutions, which declare it among their own options.
  Option& reference_edge();

  /// Runs the program and returns its exit code.
  int run(int argc, char** argv, const std::function<void(Run&)>& body);

  bool is_evolution() const { return output.writes == Writes::evolved_mesh; }
  bool reads_mesh() const {
    return reads_input() && (input.reads == Reads::mesh || input.reads == Reads::meshes);
  }
  bool reads_input() const {
    return input.reads != Reads::nothing && input.reads != Reads::words &&
           !(input.is_absent && input.is_absent());
  }
  bool has_command() const { return reads_mesh() && !words.choices.empty(); }
  bool reads_points() const { return reads_input() && !input.are_cameras; }
  bool may_write_mesh() const {
    return output.writes == Writes::mesh || is_evolution() || output.is_mesh;
  }
  bool may_print_report() const {
    return output.writes == Writes::report || output.writes == Writes::answer;
  }
  bool writes_mesh() const { return output.is_mesh ? output.is_mesh() : may_write_mesh(); }
};

/// Throws UsageError, with a suggestion, unless the first of the words is a command of the program.
void check_command(const Program& program, const std::vector<std::string>& words);

/// Returns the full help: usage, summary, own options, common options, epilog, exit codes.
std::string help_text(const Program& program);
/// Returns usage, summary and a reference to the help, for a user who typed only the program's
/// name.
std::string short_help_text(const Program& program);
/// Returns name, version, and the given words and options that affect the result, such as
/// `tm-remesh 0.1.0 --min-edge 0.7x`.
std::string provenance(const Program& program);

}  // namespace transformesh::tool
