/// The options of a program. Help text and parsing use the same objects.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "entries/entries.h"
#include "transformesh/measure.h"

namespace transformesh::tool {

/// An option bound to a variable. Before parsing, the variable has the default value.
struct Option {
  std::string names;  ///< long name, or long and short name: `output` or `output,o`
  /// Name of the value in the help, such as LENGTH; empty for a flag. Options whose placeholder
  /// contains FILE, FOLDER or WHERE are left out of the provenance, the comment in output files
  /// that states the program and its options.
  std::string placeholder;
  std::string help;  ///< description: a phrase without capital and full stop
  /// Assigns a value. Throws UsageError with a phrase that continues `--name: `.
  std::function<void(const std::string& text)> assign;
  /// Returns the value of the variable, or an empty text if it is an empty std::optional.
  std::function<Value()> value;
  std::string default_text;
  /// True: the option is required. If it is missing, the error message contains `help`.
  bool is_needed = false;
  /// True: the option can change the output. It is stated in the provenance comment of output
  /// files, and a run can be continued only with the same value.
  bool affects_result = true;
  /// True: all programs have the option. The help lists it in a separate section.
  bool is_common = false;
  bool is_listed = true;   ///< true: the help lists the option
  bool is_output = false;  ///< true: the value is the name of a file that the program writes
  std::vector<std::string> endings;  ///< endings that its name may have; if empty, any
  bool is_given = false;

  std::string name() const { return names.substr(0, names.find(',')); }
  bool is_flag() const { return placeholder.empty(); }
  /// Returns the value as it would be written on a command line.
  std::string text() const;
};

/// Options in the order of their declaration, which is the order of the help text.
class OptionSet {
 public:
  Option& flag(const std::string& names, bool* value, const std::string& help);
  Option& number(const std::string& names, double* value, double minimum, double maximum,
                 const std::string& help);
  using Integer =
      std::variant<int*, long*, std::size_t*, std::optional<long>*, std::optional<std::size_t>*>;
  Option& integer(const std::string& names, Integer value, long minimum, long maximum,
                  const std::string& help);
  /// Adds an option whose value is a length, >= 0 unless `may_be_negative` is set.
  using LengthOrNone = std::variant<Length*, std::optional<Length>*>;
  Option& length(const std::string& names, LengthOrNone value, const std::string& help,
                 bool may_be_negative = false);
  Option& text(const std::string& names, std::string* value, const std::string& placeholder,
               const std::string& help);
  /// Adds an option whose value is the name of a file that the program writes.
  Option& output_file(const std::string& names, std::string* value, const std::string& help);
  /// Adds an option whose value is one of several words. For any other word, the usage error
  /// suggests the nearest word.
  Option& choice(const std::string& names, std::string* value,
                 const std::vector<std::string>& words, const std::string& help);
  /// Adds an option with a fixed set of values, such as the values of an enum. Each is written as a
  /// word on the command line.
  template <typename T>
  Option& named(const std::string& names, T* value,
                const std::vector<std::pair<std::string, std::type_identity_t<T>>>& values,
                const std::string& help) {
    std::vector<std::string> words;
    for (const auto& [word, named_value] : values) words.push_back(word);
    using Named = std::pair<std::string, T>;
    return choice(
        names, words, help,
        [=](const std::string& word) {
          *value = std::ranges::find(values, word, &Named::first)->second;
        },
        [=] { return Value(std::ranges::find(values, *value, &Named::second)->first); });
  }
  /// Adds an option whose value is a list of numbers separated by commas. The placeholder, such as
  /// `X,Y,Z`, states how many numbers are needed. An empty vector means that there is no default.
  Option& numbers(const std::string& names, std::vector<double>* value,
                  const std::string& placeholder, const std::string& help);
  /// point() adds an option whose value is a point. box() adds an option whose value is a box,
  /// given by two opposite corners.
  using PointOrNone = std::variant<Vec3*, std::optional<Vec3>*>;
  Option& point(const std::string& names, PointOrNone value, const std::string& help);
  Option& box(const std::string& names, std::optional<Box>* value, const std::string& placeholder,
              const std::string& help);
  /// Adds --seed, which is the same in all programs.
  Option& seed(std::uint64_t* value);
  /// Adds --reference-edge, whose value is `auto` or a length.
  Option& reference_edge(std::string* value, const std::string& help);

  /// Checks and assigns values in the order of the arguments. Returns the words that are not
  /// options. Throws UsageError. Does no input or output.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);
  /// Finds an option by name, with or without dashes. Returns null if there is no such option.
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
  using Assign = std::function<void(const std::string& text)>;
  Option& choice(const std::string& names, const std::vector<std::string>& words,
                 const std::string& help, const Assign& assign,
                 const std::function<Value()>& value);

  std::deque<Option> options_;
};

}  // namespace transformesh::tool
