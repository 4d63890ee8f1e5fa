/// The frame around every program: the only place that touches argv, the standard streams, signals
/// and exit codes. A program declares its options, hands over one function, and returns what the
/// frame returns. CLI.md is the contract that the frame keeps for all of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tm/io/document.h"
#include "tm/support/length.h"
#include "tm/support/progress.h"

namespace transformesh::tool {

/// What a program's function may ask for and say while it runs.
class Run {
 public:
  virtual ~Run() = default;
  /// Input units. 1% is of the diagonal of the mesh read (or of `set_basis`), 0.7x of the reference
  /// edge: the tm:reference-edge comment, else the mean edge, which is then written as that
  /// comment.
  virtual double length(const Length& length) = 0;
  /// The mean edge length that `x` refers to.
  virtual double reference_edge() = 0;
  /// For programs that make a mesh: what 1% refers to.
  virtual void set_basis(double diagonal) = 0;

  /// Reads a further mesh named by an option.
  virtual Document read(const std::string& path) = 0;
  /// Reads a further file as bytes.
  virtual std::string read_bytes(const std::string& path) = 0;
  /// Writes a further file, complete or not at all, once the program has succeeded.
  virtual void write(const std::string& path, std::string bytes) = 0;
  /// The same in a folder, which is made where it is missing.
  virtual void write_into(const std::string& folder, const std::string& name,
                          std::string bytes) = 0;

  /// One line on stderr unless -q.
  virtual void note(const std::string& message) = 0;
  /// One line on stderr with -v.
  virtual void detail(const std::string& message) = 0;

  /// Entries of --report (and of stdout for predicates), in this order. Names are lower case with
  /// underscores. Points are three numbers.
  virtual void report(const std::string& key, double value) = 0;
  virtual void report(const std::string& key, long value) = 0;
  virtual void report(const std::string& key, bool value) = 0;
  virtual void report(const std::string& key, const std::string& value) = 0;
  virtual void report(const std::string& key, const std::vector<double>& values) = 0;
  void report(const std::string& key, std::size_t value) { report(key, static_cast<long>(value)); }
  void report(const std::string& key, int value) { report(key, static_cast<long>(value)); }
  void report(const std::string& key, const char* value) { report(key, std::string(value)); }

  /// Hand this to the library; phases are timed for the report.
  virtual const Progress& progress() = 0;
};

/// A program's name, description and options. Options are named without dashes and bound to
/// variables, whose values are the defaults that --help shows. Declaration order is the order of
/// the help text; help is a phrase without capital and full stop.
class Program {
 public:
  /// `summary` is one line without full stop; `synopsis` the usage without the program's name.
  Program(std::string name, std::string synopsis, std::string summary);
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

  /// Each runs the program and returns the exit code.
  /// One mesh in, the same document out as changed by `body`.
  int filter(int argc, char** argv, const std::function<void(Document&, Run&)>& body);
  /// No mesh in.
  int source(int argc, char** argv, const std::function<Document(Run&)>& body);
  /// Any number of meshes in (stdin where none is named), one out.
  int combine(int argc, char** argv,
              const std::function<Document(std::vector<Document>, Run&)>& body);
  /// One mesh in, the report on stdout as `key: value` lines, or JSON with --json; exit 0 for true
  /// and 1 for false.
  int predicate(int argc, char** argv, const std::function<bool(Document&, Run&)>& body);
  /// The same without an answer: exit 0.
  int description(int argc, char** argv, const std::function<void(Document&, Run&)>& body);
  /// A filter that becomes a predicate while *is_predicate holds after parsing. As a filter it
  /// writes no mesh and exits with 1 where the body returns false.
  int filter_or_predicate(int argc, char** argv, const bool* is_predicate,
                          const std::function<bool(Document&, Run&)>& body);
  /// The same, a filter while *is_filter holds after parsing.
  int predicate_or_filter(int argc, char** argv, const bool* is_filter,
                          const std::function<bool(Document&, Run&)>& body);
  /// Any number of meshes in (stdin where none is named), bytes that are not a mesh out.
  int picture(int argc, char** argv,
              const std::function<std::string(std::vector<Document>, Run&)>& body);
  /// A file that is no mesh in: what the user named, or `-` for stdin; bytes out.
  int converter(int argc, char** argv,
                const std::function<std::string(const std::string& input, Run&)>& body);

  /// The same with a mesh out, which is written as a program without input writes it.
  int maker(int argc, char** argv,
            const std::function<Document(const std::string& input, Run&)>& body);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace transformesh::tool
