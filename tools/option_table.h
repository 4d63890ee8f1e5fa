/// The table of a program's options, from which parsing, help, provenance and report all come.
/// Parsing touches no file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tm/support/length.h"

namespace transformesh::tool {

/// The variable that an option sets.
using OptionTarget = std::variant<bool*, double*, long*, std::optional<long>*, std::string*,
                                  Length*, std::optional<Length>*, std::vector<double>*>;

struct Option {
  std::string name;  ///< without dashes
  char short_name = 0;
  std::string placeholder;  ///< empty for a flag
  std::string help;
  OptionTarget target;
  /// Reads a value into the target; throws UsageError with a phrase that completes `--name `.
  std::function<void(const std::string&)> assign;
  std::string default_text = {};  ///< as --help shows it; empty for nothing
  bool is_common = false;         ///< shared by all programs, in its own section of the help
  bool affects_result = true;     ///< belongs into the provenance comment
  bool given = false;

  bool is_flag() const { return placeholder.empty(); }
  /// The present value as it would be written on a command line.
  std::string value_text() const;
};

class OptionTable {
 public:
  /// Takes a name with or without dashes. Completes default_text from the target where empty.
  Option& add(Option option);
  Option* find(const std::string& name);
  const std::vector<Option>& options() const { return options_; }
  bool has_lengths() const;

  /// Assigns the values given and returns the other words. Throws UsageError.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);

 private:
  std::vector<Option> options_;
};

/// Options of each type; `assign` checks what tool.h promises.
Option flag_option(const std::string& name, bool* value, const std::string& help);
Option number_option(const std::string& name, double* value, double minimum, double maximum,
                     const std::string& help);
Option integer_option(const std::string& name, long* value, long minimum, long maximum,
                      const std::string& help);
Option integer_option(const std::string& name, std::optional<long>* value, long minimum,
                      long maximum, const std::string& help);
Option length_option(const std::string& name, Length* value, const std::string& help,
                     bool may_be_negative);
Option length_option(const std::string& name, std::optional<Length>* value, const std::string& help,
                     bool may_be_negative);
Option text_option(const std::string& name, std::string* value, const std::string& placeholder,
                   const std::string& help);
Option choice_option(const std::string& name, std::string* value, std::vector<std::string> names,
                     const std::string& help);
/// `auto` or a positive length.
Option reference_edge_option(std::string* value, const std::string& help);
Option numbers_option(const std::string& name, std::vector<double>* value,
                      const std::string& placeholder, const std::string& help);

}  // namespace transformesh::tool
