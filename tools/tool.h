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

struct Command;

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

/// A program's name, description and options. Options are named without dashes and bound to
/// variables, whose values are the defaults that --help shows. Declaration order is the order of
/// the help text; help is a phrase without capital and full stop.
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
  void integer(const std::string& option, long* value, long minimum, long maximum,
               const std::string& help);
  void integer(const std::string& option, std::optional<long>* value, long minimum, long maximum,
               const std::string& help);
  /// A length must be >= 0 unless `may_be_negative`.
  void length(const std::string& option, Length* value, const std::string& help,
              bool may_be_negative = false);
  void length(const std::string& option, std::optional<Length>* value, const std::string& help,
              bool may_be_negative = false);
  /// A placeholder that contains FILE keeps the value out of the provenance comment.
  void text(const std::string& option, std::string* value, const std::string& placeholder,
            const std::string& help);
  /// One of the names given; anything else is a usage error that names the nearest.
  void choice(const std::string& option, std::string* value, std::vector<std::string> names,
              const std::string& help);
  /// As many numbers as the placeholder has, comma separated: `X,Y,Z`. No default where empty.
  void numbers(const std::string& option, std::vector<double>* value,
               const std::string& placeholder, const std::string& help);
  /// Positional words before the input (tm-shape KIND PARAMETERS...): all words are these.
  void words(std::vector<std::string>* values, const std::string& placeholder,
             const std::string& help);
  /// --reference-edge as an option of an evolution's own: `value` is auto or a length.
  void reference_edge(const std::string& value, const std::string& help);
  /// --seed, one spelling everywhere.
  void seed(long* value);

  /// Options affect the result, and so go into the provenance comment, unless named here.
  void keep_out_of_provenance(const std::string& option);
  /// The option must be given; otherwise a usage error says what it is for.
  void require(const std::string& option);
  /// While *key is not empty after parsing, a predicate prints only that entry's value.
  void print_only(const std::string* key);
  /// Paragraphs shown after the options by --help: examples, formulas.
  void epilog(std::string text);

  /// While this holds after parsing, a mesh is written and not the answer.
  void write_mesh_if(std::function<bool()> condition);

  /// Runs the program and returns its exit code.
  int run(int argc, char** argv, const std::function<void(Run&)>& body);

 private:
  int run_unguarded(const std::vector<std::string>& arguments,
                    const std::function<void(Run&)>& body);

  std::unique_ptr<Command> command_;
  Terminal terminal_;
};

}  // namespace transformesh::tool
