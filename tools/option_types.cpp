#include <algorithm>
#include <charconv>
#include <cmath>

#include "option_table.h"
#include "suggestion.h"
#include "tm/support/error.h"

namespace transformesh::tool {
namespace {

std::string quoted(const std::string& text) { return "'" + text + "'"; }

template <typename Number>
Number parse_whole(const std::string& text, const char* kind) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && rest == end) return number;
  throw UsageError(quoted(text) + " is not " + kind);
}

double parse_number(const std::string& text) {
  const auto number = parse_whole<double>(text, "a number");
  if (!std::isfinite(number)) throw UsageError(quoted(text) + " is not a finite number");
  return number;
}

std::string text_of(double number) { return shortest_text(number); }
std::string text_of(long number) { return std::to_string(number); }

template <typename Number>
void check_range(Number number, const std::string& text, Number minimum, Number maximum) {
  if (number < minimum)
    throw UsageError(quoted(text) + " is too small: at least " + text_of(minimum));
  if (number > maximum)
    throw UsageError(quoted(text) + " is too large: at most " + text_of(maximum));
}

long parse_integer(const std::string& text, long minimum, long maximum) {
  const auto number = parse_whole<long>(text, "a whole number");
  check_range(number, text, minimum, maximum);
  return number;
}

Length parse_checked_length(const std::string& text, bool may_be_negative) {
  const Length length = parse_length(text);
  if (length.value < 0 && !may_be_negative) {
    throw UsageError(quoted(text) + " is too small: a length of at least 0");
  }
  return length;
}

std::vector<double> parse_numbers(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    numbers.push_back(parse_number(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (numbers.size() == count) return numbers;
  throw UsageError(quoted(text) + " is not " + std::to_string(count) + " numbers with commas");
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : separator) + word;
  return joined;
}

}  // namespace

Option flag_option(const std::string& name, bool* value, const std::string& help) {
  return {name, 0, "", help, value, [value](const std::string&) { *value = true; }};
}

Option number_option(const std::string& name, double* value, double minimum, double maximum,
                     const std::string& help) {
  return {name, 0, "NUMBER", help, value, [=](const std::string& text) {
            const double number = parse_number(text);
            check_range(number, text, minimum, maximum);
            *value = number;
          }};
}

Option integer_option(const std::string& name, long* value, long minimum, long maximum,
                      const std::string& help) {
  return {name,  0,
          "N",   help,
          value, [=](const std::string& text) {
            *value = parse_integer(text, minimum, maximum); }};
}

Option integer_option(const std::string& name, std::optional<long>* value, long minimum,
                      long maximum, const std::string& help) {
  return {name,  0,
          "N",   help,
          value, [=](const std::string& text) {
            *value = parse_integer(text, minimum, maximum); }};
}

Option length_option(const std::string& name, Length* value, const std::string& help,
                     bool may_be_negative) {
  return {name,
          0,
          "LENGTH",
          help,
          value,
          [=](const std::string& text) {
            *value = parse_checked_length(text, may_be_negative); }};
}

Option length_option(const std::string& name, std::optional<Length>* value, const std::string& help,
                     bool may_be_negative) {
  return {name,
          0,
          "LENGTH",
          help,
          value,
          [=](const std::string& text) {
            *value = parse_checked_length(text, may_be_negative); }};
}

Option text_option(const std::string& name, std::string* value, const std::string& placeholder,
                   const std::string& help) {
  Option option{name, 0,     placeholder,
                help, value, [value](const std::string& text) { *value = text; }};
  // File names never enter the provenance comment: they would differ between equal results.
  option.affects_result = placeholder.find("FILE") == std::string::npos;
  return option;
}

Option choice_option(const std::string& name, std::string* value, std::vector<std::string> names,
                     const std::string& help) {
  const std::string placeholder = join(names, "|");
  return {
      name, 0, placeholder, help, value, [=, names = std::move(names)](const std::string& text) {
        for (const std::string& candidate : names) {
          if (candidate == text) {
            *value = text;
            return;
          }
        }
        throw UsageError(quoted(text) + " is not known; did you mean " +
                         quoted(nearest_name(text, names)) + "? (" + join(names, ", ") + ")");
      }};
}

Option reference_edge_option(std::string* value, const std::string& help) {
  return {"reference-edge", 0, "auto|LENGTH", help, value, [value](const std::string& text) {
            if (text != "auto" && parse_length(text).value <= 0)
              throw UsageError(quoted(text) + " must be positive, or auto to measure it");
            *value = text;
          }};
}

Option numbers_option(const std::string& name, std::vector<double>* value,
                      const std::string& placeholder, const std::string& help) {
  const auto commas = std::count(placeholder.begin(), placeholder.end(), ',');
  const auto count = static_cast<std::size_t>(commas) + 1;
  return {name, 0,     placeholder,
          help, value, [=](const std::string& text) { *value = parse_numbers(text, count); }};
}

}  // namespace transformesh::tool
