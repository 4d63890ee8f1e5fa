#include "frame/option_set.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

#include "frame/command_words.h"
#include "frame/other_programs.h"
#include "frame/report.h"
#include "support/error_prefix.h"
#include "support/number.h"
#include "support/suggestion.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

Value value_of(const auto& variable) { return variable; }
Value value_of(const Vec3& point) { return std::vector<double>(point.begin(), point.end()); }
Value value_of(const Box& box) {
  std::vector<double> numbers(box.min().begin(), box.min().end());
  numbers.insert(numbers.end(), box.max().begin(), box.max().end());
  return numbers;
}
template <typename Held>
Value value_of(const std::optional<Held>& variable) {
  if (variable) return value_of(*variable);
  if constexpr (std::is_same_v<Held, Vec3> || std::is_same_v<Held, Box>)
    return std::vector<double>{};
  else
    return "";
}

auto* found_in(auto& options, const std::string& option) {
  const std::size_t begin = std::min(option.find_first_not_of('-'), option.size());
  const auto found = std::ranges::find(options, option.substr(begin), &Option::name);
  return found == options.end() ? nullptr : &*found;
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

template <typename Number>
Number parse_whole(const std::string& text, const char* kind) {
  if (const auto number = number_in<Number>(text)) return *number;
  throw UsageError(quoted(text) + " is not " + kind);
}

double parse_finite(const std::string& text) {
  const auto number = parse_whole<double>(text, "a number");
  if (!std::isfinite(number)) throw UsageError(quoted(text) + " is not a finite number");
  return number;
}

template <typename Number>
Number in_range(Number number, const std::string& text, Number minimum, Number maximum) {
  if (number >= minimum && number <= maximum) return number;
  throw UsageError(quoted(text) + (number < minimum
                                       ? " is too small: at least " + text_of(minimum)
                                       : " is too large: at most " + text_of(maximum)));
}

auto whole_number_reader(long minimum, long maximum) {
  return [=](const std::string& text) {
    return in_range(parse_whole<long>(text, "a whole number"), text, minimum, maximum);
  };
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : separator) + word;
  return joined;
}

Option& add_option(std::deque<Option>& options, const std::string& names,
                   const std::string& placeholder, const std::string& help,
                   std::function<void(const std::string&)> assign, std::function<Value()> value) {
  Option& option = options.emplace_back();
  option.names = names;
  option.placeholder = placeholder;
  option.help = help;
  option.assign = std::move(assign);
  option.value = std::move(value);
  option.default_text = option.text();
  return option;
}

// Adds an option. `read` converts the text of its value to the type of the variable, or throws.
Option& add(std::deque<Option>& options, const std::string& names, const std::string& placeholder,
            const std::string& help, auto* variable, auto read) {
  return add_option(
      options, names, placeholder, help,
      [=](const std::string& text) {
        *variable = static_cast<std::decay_t<decltype(*variable)>>(read(text));
      },
      [=] { return value_of(*variable); });
}

std::vector<double> parse_numbers(const std::string& text, std::ptrdiff_t count) {
  std::vector<double> numbers;
  std::istringstream words(text + ',');
  for (std::string word; std::getline(words, word, ',');) numbers.push_back(parse_finite(word));
  if (std::ssize(numbers) == count) return numbers;
  throw UsageError(quoted(text) + " is not " + std::to_string(count) +
                   " numbers separated by commas");
}

[[noreturn]] void throw_unknown(const std::string& token, const std::deque<Option>& options) {
  if (token.size() > 1 && (std::isdigit(static_cast<unsigned char>(token[1])) || token[1] == '.')) {
    throw UsageError("unknown option '" + token + "'; write -- before it if it is a file name");
  }
  std::string word = token.substr(0, token.find('='));
  word.erase(0, word.find_first_not_of('-'));
  std::vector<std::string> names;
  names.reserve(options.size());
  for (const Option& option : options) names.push_back(option.name());
  const std::string nearest = nearest_name(word, names);
  const std::string other = command_with(word);
  throw UsageError("unknown option '" + token + "'; " +
                   (is_near(word, nearest) ? "did you mean '--" + nearest + "'?"
                    : other.empty()        ? "list all options with --help"
                                           : "see " + other));
}

}  // namespace

std::string Option::text() const { return text_of(value(), ","); }

// --- Kinds of options ----------------------------------------------------------------------------

Option& OptionSet::flag(const std::string& names, bool* value, const std::string& help) {
  return add(options_, names, "", help, value, [](const std::string&) { return true; });
}

Option& OptionSet::number(const std::string& names, double* value, double minimum, double maximum,
                          const std::string& help) {
  return add(options_, names, "NUMBER", help, value, [=](const std::string& text) {
    return in_range(parse_finite(text), text, minimum, maximum);
  });
}

Option& OptionSet::integer(const std::string& names, Integer value, long minimum, long maximum,
                           const std::string& help) {
  const auto read = whole_number_reader(minimum, maximum);
  return std::visit(
      [&](auto* variable) -> Option& { return add(options_, names, "N", help, variable, read); },
      value);
}

Option& OptionSet::length(const std::string& names, LengthOrNone value, const std::string& help,
                          bool may_be_negative) {
  const auto read = [=](const std::string& text) {
    const Length length = parse_length(text);
    if (length.value >= 0 || may_be_negative) return length;
    throw UsageError(quoted(text) + " is too small: a length must be at least 0");
  };
  return std::visit(
      [&](auto* variable) -> Option& {
        return add(options_, names, "LENGTH", help, variable, read);
      },
      value);
}

Option& OptionSet::text(const std::string& names, std::string* value,
                        const std::string& placeholder, const std::string& help) {
  return add(options_, names, placeholder, help, value,
             [](const std::string& text) { return text; });
}

Option& OptionSet::output_file(const std::string& names, std::string* value,
                               const std::string& help) {
  Option& option = text(names, value, "FILE", help);
  option.is_output = true;
  return option;
}

Option& OptionSet::choice(const std::string& names, std::string* value,
                          const std::vector<std::string>& words, const std::string& help) {
  return choice(
      names, words, help, [=](const std::string& text) { *value = text; }, [=] { return *value; });
}

Option& OptionSet::choice(const std::string& names, const std::vector<std::string>& words,
                          const std::string& help, const Assign& assign,
                          const std::function<Value()>& value) {
  const auto check = [=](const std::string& text) {
    if (std::ranges::find(words, text) != words.end()) return assign(text);
    throw UsageError(quoted(text) + " is not known; did you mean " +
                     quoted(nearest_name(text, words)) + "? (" + join(words, ", ") + ")");
  };
  return add_option(options_, names, join(words, "|"), help, check, value);
}

Option& OptionSet::numbers(const std::string& names, std::vector<double>* value,
                           const std::string& placeholder, const std::string& help) {
  const auto count = std::count(placeholder.begin(), placeholder.end(), ',') + 1;
  return add(options_, names, placeholder, help, value,
             [=](const std::string& text) { return parse_numbers(text, count); });
}

Option& OptionSet::point(const std::string& names, PointOrNone value, const std::string& help) {
  const auto read = [](const std::string& text) { return Vec3(parse_numbers(text, 3).data()); };
  return std::visit(
      [&](auto* variable) -> Option& {
        return add(options_, names, "X,Y,Z", help, variable, read);
      },
      value);
}

Option& OptionSet::box(const std::string& names, std::optional<Box>* value,
                       const std::string& placeholder, const std::string& help) {
  return add(options_, names, placeholder, help, value, [](const std::string& text) {
    const std::vector<double> corners = parse_numbers(text, 6);
    return Box(Vec3(corners.data()), Vec3(corners.data() + 3));
  });
}

// NOLINTNEXTLINE(readability-non-const-parameter): the option writes to it
Option& OptionSet::seed(std::uint64_t* value) {
  const auto read = whole_number_reader(0, std::numeric_limits<long>::max());
  return add_option(
      options_, "seed", "N", "seed of the random numbers",
      [=](const std::string& text) { *value = static_cast<std::uint64_t>(read(text)); },
      [=] { return Value(static_cast<long>(*value)); });
}

Option& OptionSet::reference_edge(std::string* value, const std::string& help) {
  return add(options_, "reference-edge", "auto|LENGTH", help, value, [](const std::string& text) {
    if (text == "auto" || parse_length(text).value > 0) return text;
    throw UsageError(quoted(text) +
                     " is not a positive length; give one, or auto to measure the mean edge");
  });
}

// --- The command line ----------------------------------------------------------------------------

const Option* OptionSet::find(const std::string& option) const {
  return found_in(options_, option);
}

Option* OptionSet::find(const std::string& option) { return found_in(options_, option); }

std::vector<std::string> OptionSet::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> others;
  for (const CommandWord& word : split_command(arguments, *this)) {
    if (word.is_unknown) throw_unknown(word.text, options_);
    if (word.option == nullptr) {
      others.push_back(word.text);
      continue;
    }
    Option& option = *find(word.option->name());
    // A word that is itself an option is no value: in `--output --quiet` the value is missing.
    if (word.text.starts_with("--") && find(word.text) != nullptr)
      throw UsageError("--" + option.name() + " needs a value");
    try {
      option.assign(word.text);
    } catch (const UsageError&) {
      rethrow_with_prefix("--" + option.name() + ": ");
    }
    option.is_given = true;
  }
  return others;
}

}  // namespace transformesh::tool
