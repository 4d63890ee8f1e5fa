/// The options of a program: declaration, help and parsing come from the same objects.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "entries/entries.h"

namespace transformesh::tool {

/// An option bound to a variable, whose value is the default until the command line is parsed.
struct Option {
  std::string names;        ///< `output,o` or `output`
  std::string placeholder;  ///< empty for a flag; FILE, FOLDER or WHERE is not for the provenance
  std::string help;         ///< a phrase without capital and full stop
  /// Throws UsageError with a phrase that completes `--name: `.
  std::function<void(const std::string& text)> assign;
  std::function<Value()> value;  ///< empty text for an optional one that has none
  std::string default_text;
  bool is_needed = false;      ///< a usage error names the purpose if the option is missing
  bool affects_result = true;  ///< belongs into the provenance, and to the settings of a run
  bool is_common = false;      ///< shared by all programs, in its own section of the help
  bool is_listed = true;       ///< in the help
  bool is_given = false;

  std::string name() const { return names.substr(0, names.find(',')); }
  bool is_flag() const { return placeholder.empty(); }
  /// Returns the value as on a command line.
  std::string text() const;
};

/// Options in the order of their declaration, which is the order of the help text.
class OptionSet {
 public:
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
  /// One of the words; any other is a usage error that names the nearest one.
  Option& choice(const std::string& names, std::string* value,
                 const std::vector<std::string>& words, const std::string& help);
  /// Numbers separated by commas, as many as the placeholder has: `X,Y,Z`. Empty: no default.
  Option& numbers(const std::string& names, std::vector<double>* value,
                  const std::string& placeholder, const std::string& help);
  /// --seed, the same in all programs.
  Option& seed(long* value);
  /// --reference-edge, `auto` or a length, with this help.
  Option& reference_edge(std::string* value, const std::string& help);

  /// Checks and assigns values in the order of the arguments, and returns the words that are no
  /// options. Throws UsageError. Touches no file.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);
  /// Finds an option by name, with or without dashes. Returns null if there is none.
  Option* find(const std::string& option);
  const Option* find(const std::string& option) const;

  auto begin() { return options_.begin(); }
  auto end() { return options_.end(); }
  auto begin() const { return options_.begin(); }
  auto end() const { return options_.end(); }
  std::size_t size() const { return options_.size(); }
  Option& operator[](std::size_t i) { return options_[i]; }
  const Option& operator[](std::size_t i) const { return options_[i]; }

 private:
  std::deque<Option> options_;
};

}  // namespace transformesh::tool
