// The kinds of options: what each reads, checks and shows.
#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/program.h"
#include "tm/support/error.h"
#include "tm/support/number.h"
#include "tm/support/suggestion.h"

namespace transformesh::tool {
namespace {

Value value_of(const auto& variable) { return variable; }
template <typename Held>
Value value_of(const std::optional<Held>& variable) {
  return variable ? Value(*variable) : Value("");
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
  if (number < minimum)
    throw UsageError(quoted(text) + " is too small: at least " + text_of(minimum));
  if (number > maximum)
    throw UsageError(quoted(text) + " is too large: at most " + text_of(maximum));
  return number;
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : separator) + word;
  return joined;
}

}  // namespace

Option& Program::add(const std::string& names, const std::string& placeholder,
                     const std::string& help, auto* variable, auto read) {
  Option& option = options.emplace_back();
  option.names = names;
  option.placeholder = placeholder;
  option.help = help;
  option.assign = [=](const std::string& text) {
    *variable = static_cast<std::decay_t<decltype(*variable)>>(read(text));
  };
  option.value = [=] { return value_of(*variable); };
  option.default_text = option.text();
  return option;
}

Option& Program::flag(const std::string& names, bool* value, const std::string& help) {
  return add(names, "", help, value, [](const std::string&) { return true; });
}

Option& Program::number(const std::string& names, double* value, double minimum, double maximum,
                        const std::string& help) {
  return add(names, "NUMBER", help, value, [=](const std::string& text) {
    return in_range(parse_finite(text), text, minimum, maximum);
  });
}

Option& Program::integer(const std::string& names, Integer value, long minimum, long maximum,
                         const std::string& help) {
  const auto read = [=](const std::string& text) {
    return in_range(parse_whole<long>(text, "a whole number"), text, minimum, maximum);
  };
  return std::visit(
      [&](auto* variable) -> Option& { return add(names, "N", help, variable, read); }, value);
}

Option& Program::length(const std::string& names, LengthOrNone value, const std::string& help,
                        bool may_be_negative) {
  const auto read = [=](const std::string& text) {
    const Length length = parse_length(text);
    if (length.value >= 0 || may_be_negative) return length;
    throw UsageError(quoted(text) + " is too small: a length of at least 0");
  };
  return std::visit(
      [&](auto* variable) -> Option& { return add(names, "LENGTH", help, variable, read); }, value);
}

Option& Program::text(const std::string& names, std::string* value, const std::string& placeholder,
                      const std::string& help) {
  return add(names, placeholder, help, value, [](const std::string& text) { return text; });
}

Option& Program::choice(const std::string& names, std::string* value,
                        const std::vector<std::string>& words, const std::string& help) {
  return add(names, join(words, "|"), help, value, [=](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) != words.end()) return text;
    throw UsageError(quoted(text) + " is not known; did you mean " +
                     quoted(nearest_name(text, words)) + "? (" + join(words, ", ") + ")");
  });
}

Option& Program::numbers(const std::string& names, std::vector<double>* value,
                         const std::string& placeholder, const std::string& help) {
  const auto count = std::count(placeholder.begin(), placeholder.end(), ',') + 1;
  return add(names, placeholder, help, value, [=](const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      numbers.push_back(parse_finite(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (std::ssize(numbers) == count) return numbers;
    throw UsageError(quoted(text) + " is not " + std::to_string(count) + " numbers with commas");
  });
}

Option& Program::seed(long* value) {
  return integer("seed", value, 0, std::numeric_limits<long>::max(), "seed of the random numbers");
}

Option& Program::reference_edge() {
  const std::string help =
      is_evolution()
          ? "length that x refers to; auto: the source's mean edge (default: that of its "
            "tm:reference-edge comment, else auto)"
          : "length that x refers to: measured anew, or set (default: the mesh's "
            "tm:reference-edge comment, else measured)";
  return add("reference-edge", "auto|LENGTH", help, &common.reference_edge,
             [](const std::string& text) {
               if (text == "auto" || parse_length(text).value > 0) return text;
               throw UsageError(quoted(text) + " must be positive, or auto to measure it");
             });
}

}  // namespace transformesh::tool
