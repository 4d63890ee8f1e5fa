/// The frame around every program: the only place that touches argv, the standard streams, signals
/// and exit codes. A program says what it reads and writes, declares its options, and hands over
/// one function. CLI.md is the contract that the frame keeps for all of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run.h"
#include "tm/support/length.h"

namespace transformesh::tool {

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

/// What the words are that are no options.
enum class Reads {
  nothing,
  mesh,    ///< one at most, and stdin where none is named
  meshes,  ///< any number, likewise
  file,    ///< one file at most, likewise, which the body reads
  files    ///< any number, likewise
};

/// What goes to -o, which is stdout by default.
enum class Writes {
  mesh,
  evolved_mesh,  ///< the end of an evolution: PLY, whatever the format of the input
  picture,       ///< bytes that are nothing for a terminal
  text,
  report,  ///< `key: value` lines, or JSON with --json
  answer   ///< the same, and the exit code is 1 for a no
};

/// A program's name, description and options. Options are named without dashes, `name,n` with a
/// short name, and bound to variables, whose values are the defaults that --help shows. Declaration
/// order is the order of the help text; help is a phrase without capital and full stop.
class Program {
 public:
  /// `summary` is one line without full stop; `synopsis` the usage without the program's name.
  Program(std::string name, std::string synopsis, std::string summary, Reads reads = Reads::mesh,
          Writes writes = Writes::mesh);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void flag(const std::string& option, bool* value, const std::string& help);
  void number(const std::string& option, double* value, double minimum, double maximum,
              const std::string& help);
  /// An int, a long, a std::size_t or a std::optional<long>.
  template <typename Integer>
  void integer(const std::string& option, Integer* value, long minimum, long maximum,
               const std::string& help);
  /// A Length or a std::optional<Length>, which must be >= 0 unless `may_be_negative`.
  template <typename LengthOrNone>
  void length(const std::string& option, LengthOrNone* value, const std::string& help,
              bool may_be_negative = false);
  /// A placeholder FILE, FOLDER or WHERE keeps the value out of the provenance comment.
  void text(const std::string& option, std::string* value, const std::string& placeholder,
            const std::string& help);
  /// One of the names given; anything else is a usage error that names the nearest.
  void choice(const std::string& option, std::string* value, const std::vector<std::string>& names,
              const std::string& help);
  /// As many numbers as the placeholder has, comma separated: `X,Y,Z`. No default where empty.
  void numbers(const std::string& option, std::vector<double>* value,
               const std::string& placeholder, const std::string& help);
  /// --seed, one spelling everywhere.
  void seed(long* value);
  /// --reference-edge as an option of an evolution's own: `value` is auto or a length.
  void reference_edge(const std::string& value, const std::string& help);
  /// Positional words before the input (tm-shape KIND PARAMETERS...): all words are these.
  void words(std::vector<std::string>* values, const std::string& placeholder,
             const std::string& help);

  /// Options affect the result, and so go into the provenance comment, unless named here.
  void keep_out_of_provenance(const std::string& option);
  /// The option must be given; otherwise a usage error says what it is for.
  void require(const std::string& option);
  /// While *key is not empty after parsing, only that entry of the report is printed.
  void print_only(const std::string* key);
  /// While this holds after parsing, a mesh is written and not the answer.
  void write_mesh_if(std::function<bool()> condition);
  /// Paragraphs shown after the options by --help: examples, formulas.
  void epilog(std::string text);

  /// Runs the program and returns its exit code.
  int run(int argc, char** argv, const std::function<void(Run&)>& body);
  /// As it was declared.
  Command& command() { return *command_; }

 private:
  template <typename Value>
  void add(const std::string& option, const std::string& placeholder, const std::string& help,
           Value* value, std::function<Value(const std::string&)> read);
  void declare_common();
  int run_unguarded(const std::vector<std::string>& arguments,
                    const std::function<void(Run&)>& body);

  std::unique_ptr<Command> command_;
  Terminal terminal_;
};

}  // namespace transformesh::tool
