/// The frame around every program: the only place that touches argv, the standard streams, signals
/// and exit codes. A program says what it reads and writes, declares its options, and hands over
/// one function. man/tm.7.md is the contract that the frame keeps.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "frame/report.h"

namespace transformesh::tool {

class Run;

/// The exit codes of every program; a signal's is 128 and its number. 124 to 127 and 137 stay free
/// for timeout and the shell.
enum ExitCode {
  exit_done = 0,  ///< for a predicate: yes
  exit_no = 1,    ///< predicates, and evolutions that must converge
  exit_usage = 2,
  exit_input = 3,
  exit_goal = 4,
  exit_output = 5,
  exit_memory = 6
};

/// What the arguments are that are no options.
enum class Reads {
  nothing,  ///< there are none
  words,    ///< any number, and no input
  mesh,     ///< one at most, and stdin where none is named
  meshes,   ///< any number, likewise
  file,     ///< one file at most, likewise, which the body reads
  files     ///< any number, likewise
};

/// The treatment of faces that meet but share no vertices, as in a soup of triangles
/// (touching_borders.h).
enum class Soups {
  kept,     ///< the mesh is read as it is; only of STL it is said that tm-stitch joins them
  own,      ///< the same, and nobody is told to use tm-stitch: the program joins them itself
  joined,   ///< equal places are joined when a mesh is read, which is reported
  reported  ///< the mesh is read as it is, and of any file it is said that tm-stitch joins them
};

/// What goes to -o, which is stdout by default.
enum class Writes {
  mesh,
  evolved_mesh,  ///< the end of an evolution: PLY, whatever the format of the input
  picture,       ///< bytes that are nothing for a terminal
  page,          ///< HTML
  text,
  report,  ///< `key: value` lines, or JSON with --json
  answer   ///< the same, and the exit code is 1 for a no
};

/// An option bound to a variable, whose value is the default until the command line is parsed.
struct Option {
  std::string names;        ///< `output,o` or `output`
  std::string placeholder;  ///< empty for a flag; FILE, FOLDER or WHERE is not for the provenance
  std::string help;         ///< a phrase without capital and full stop
  /// Throws UsageError with a phrase that completes `--name: `.
  std::function<void(const std::string& text)> assign;
  std::function<Value()> value;  ///< empty text for an optional one that has none
  std::string default_text;
  bool is_needed = false;      ///< a usage error says what it is for where it is not given
  bool affects_result = true;  ///< belongs into the provenance, and to what a run continues with
  bool is_common = false;      ///< shared by all programs, in its own section of the help
  bool is_listed = true;       ///< in the help
  bool is_given = false;

  std::string name() const { return names.substr(0, names.find(',')); }
  bool is_flag() const { return placeholder.empty(); }
  /// As it would be written on a command line.
  std::string text() const { return text_of(value(), ","); }
};

/// The values of the options that programs share.
struct CommonValues {
  std::string output = "-";
  std::string format, reference_edge, report;
  int threads = 0;
  std::string max_memory, completion;
  double max_time = 0;
  bool as_float = false, as_double = false, no_provenance = false, json = false, strict = false;
  bool progress = false, no_progress = false, quiet = false, verbose = false;
  bool help = false, version = false;
};

/// A program as it was declared: help, settings, provenance and report come from the same options
/// as parsing, which touches no file. Declaration order is the order of the help text.
struct Program {
  const std::string name;
  const std::string synopsis;  ///< the usage without the program's name
  const std::string summary;   ///< one line without full stop
  const Reads reads = Reads::mesh;
  const Writes writes = Writes::mesh;
  std::pair<std::string, std::string> words_entry = {};  ///< placeholder and help of Reads::words
  std::vector<std::string> word_choices = {};  ///< the first word is one of these, for completion
  std::string epilog = {};                     ///< shown after the options: examples, formulas
  std::vector<std::string> picture_endings = {".png"};  ///< of -o, where a picture is written
  std::function<bool()> writes_mesh_if = {};  ///< where this holds, a mesh is written, no report
  bool words_are_folders = false;
  std::function<bool()> reads_nothing_if = {};  ///< where this holds, there is no input
  bool reads_cameras = false;                   ///< the file read is no mesh and no points
  bool cleans = false;  ///< the output has no self-intersection after rounding
  Soups soups = Soups::kept;
  const std::string* only_key = nullptr;  ///< prints this entry of the report alone, if not empty
  CommonValues common = CommonValues();   // {} would make GCC 12 warn
  std::deque<Option> options = {};
  /// Called once all options have their values, to derive some from others; may throw UsageError.
  std::function<void()> settle = {};
  std::vector<std::string> inputs = {};   ///< or words
  std::vector<std::string> command = {};  ///< the whole command line

  Option& flag(const std::string& names, bool* value, const std::string& help);
  Option& number(const std::string& names, double* value, double minimum, double maximum,
                 const std::string& help);
  using Integer = std::variant<int*, long*, std::size_t*, std::optional<long>*>;
  Option& integer(const std::string& names, Integer value, long minimum, long maximum,
                  const std::string& help);
  /// At least 0 unless `may_be_negative`.
  using LengthOrNone = std::variant<Length*, std::optional<Length>*>;
  Option& length(const std::string& names, LengthOrNone value, const std::string& help,
                 bool may_be_negative = false);
  Option& text(const std::string& names, std::string* value, const std::string& placeholder,
               const std::string& help);
  /// One of the words given; anything else is a usage error that names the nearest.
  Option& choice(const std::string& names, std::string* value,
                 const std::vector<std::string>& words, const std::string& help);
  /// As many numbers as the placeholder has, comma separated: `X,Y,Z`. No default where empty.
  Option& numbers(const std::string& names, std::vector<double>* value,
                  const std::string& placeholder, const std::string& help);
  /// --seed, one spelling everywhere.
  Option& seed(long* value);
  /// --reference-edge, which programs have that read and write meshes; an evolution says where
  /// among its own options.
  Option& reference_edge();

  /// Runs the program and returns its exit code.
  int run(int argc, char** argv, const std::function<void(Run&)>& body);

  /// Checks and assigns values in the order of the arguments, and returns the words that are no
  /// options. Throws UsageError.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);
  /// Takes a name with or without dashes; null where there is none.
  Option* find(const std::string& option);
  const Option* find(const std::string& option) const;

  bool is_evolution() const { return writes == Writes::evolved_mesh; }
  bool reads_mesh() const {
    return reads_input() && (reads == Reads::mesh || reads == Reads::meshes);
  }
  bool reads_input() const {
    return reads != Reads::nothing && reads != Reads::words &&
           !(reads_nothing_if && reads_nothing_if());
  }
  bool reads_points() const { return reads_input() && !reads_cameras; }
  bool may_write_mesh() const { return writes == Writes::mesh || is_evolution() || writes_mesh_if; }
  bool may_print_report() const { return writes == Writes::report || writes == Writes::answer; }
  bool writes_mesh() const { return writes_mesh_if ? writes_mesh_if() : may_write_mesh(); }
};

/// The whole help: usage, summary, own options, common options, epilog, exit codes.
std::string help_text(const Program& program);
/// Usage, summary and where to find more: for a user who typed only the program's name.
std::string short_help_text(const Program& program);
/// `tm-remesh 0.1.0 --min-edge 0.7x`: the words and options given that affect the result.
std::string provenance(const Program& program);

}  // namespace transformesh::tool
