/// A program as it was declared. Boost.ProgramOptions reads, checks and assigns its options; help,
/// settings, provenance and report come from the same objects. Parsing touches no file.
#pragma once

#include <boost/program_options.hpp>
#include <nlohmann/json_fwd.hpp>

#include "tool.h"

namespace transformesh::tool {

/// An option bound to a variable, which holds the default until it is assigned.
class Option : public boost::program_options::value_semantic {
 public:
  /// `names` is `output,o` or `output`.
  Option(std::string its_names, std::string its_placeholder, std::string its_help)
      : names(std::move(its_names)),
        placeholder(std::move(its_placeholder)),
        help(std::move(its_help)) {}

  /// The variable's value. That of a length is its text, and so is that of an empty optional.
  virtual nlohmann::ordered_json value() const = 0;
  /// Null for what is no length.
  virtual const Length* length() const = 0;
  /// As it would be written on a command line.
  std::string text() const;
  bool is_flag() const { return placeholder.empty(); }

  std::string name() const override { return names.substr(0, names.find(',')); }
  unsigned min_tokens() const override { return is_flag() ? 0 : 1; }
  unsigned max_tokens() const override { return min_tokens(); }
  bool is_composing() const override { return false; }
  bool is_required() const override { return is_needed; }
  bool apply_default(boost::any&) const override { return false; }

  const std::string names;
  const std::string placeholder;  ///< empty for a flag
  const std::string help;
  bool is_common = false;  ///< shared by all programs, in its own section of the help
  bool is_needed = false;
  bool affects_result = true;  ///< belongs into the provenance comment
};

/// The values of the options that programs share.
struct CommonValues {
  std::string output = "-";
  std::string format, reference_edge, report;
  long threads = 0;
  bool as_float = false, as_double = false, no_provenance = false, json = false;
  bool progress = false, no_progress = false, quiet = false, verbose = false;
  bool help = false, version = false;
};

struct Command {
  std::string name, synopsis, summary;
  Reads reads = Reads::mesh;
  Writes writes = Writes::mesh;
  std::string words_placeholder, words_help;
  std::vector<std::string>* words = nullptr;
  std::vector<std::string> epilogs;
  std::function<bool()> writes_mesh_if;
  const std::string* only_key = nullptr;

  CommonValues common;
  bool declares_common = false;
  std::vector<Option*> options;  ///< in their order; `known` owns them
  boost::program_options::options_description known;
  boost::program_options::variables_map given;
  std::vector<std::string> inputs;

  void add(std::unique_ptr<Option> option);
  /// Takes a name with or without dashes; null where there is none.
  Option* find(const std::string& name) const;
  bool is_given(const std::string& option) const { return given.count(option) > 0; }
  /// Checks the values and returns the words that are no options. Throws UsageError.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);
  /// Assigns the values. Throws UsageError where one that is needed was not given.
  void assign();

  bool is_evolution() const { return writes == Writes::evolved_mesh; }
  bool reads_mesh() const { return reads == Reads::mesh || reads == Reads::meshes; }
  bool may_write_mesh() const { return writes == Writes::mesh || is_evolution() || writes_mesh_if; }
  bool may_print_report() const { return writes == Writes::report || writes == Writes::answer; }
  bool writes_mesh() const { return writes_mesh_if ? writes_mesh_if() : may_write_mesh(); }
};

/// The whole help: usage, summary, own options, common options, epilogs, exit codes.
std::string help_text(const Command& command);
/// Usage, summary and where to find more: for a user who typed only the program's name.
std::string short_help_text(const Command& command);
/// `tm-remesh 0.1.0 --min-edge 0.7x`: the words and options given that affect the result.
std::string provenance(const Command& command);

}  // namespace transformesh::tool
