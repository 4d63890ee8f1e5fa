// The kinds of options: what each reads, checks and shows.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "command.h"
#include "report.h"
#include "tm/support/error.h"
#include "tm/support/suggestion.h"

namespace transformesh::tool {
namespace {

template <typename Value>
Json json_of(const Value& value) {
  return value;
}
Json json_of(const Length& length) { return length.text(); }
template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json("");
}

template <typename Value>
const Length* length_of(const Value&) {
  return nullptr;
}
const Length* length_of(const Length& length) { return &length; }
const Length* length_of(const std::optional<Length>& length) { return length ? &*length : nullptr; }

template <typename Value>
class Bound : public Option {
 public:
  /// Throws UsageError with a phrase that completes `--name: `.
  using Read = std::function<Value(const std::string& text)>;

  Bound(Value* value, Read read, const auto&... description)
      : Option(description...), value_(value), read_(std::move(read)) {}

  Json value() const override { return json_of(*value_); }
  const Length* length() const override { return length_of(*value_); }
  void parse(boost::any& parsed, const std::vector<std::string>& words, bool) const override {
    try {
      parsed = read_(words.empty() ? "" : words[0]);
    } catch (const UsageError& error) {
      throw UsageError("--" + name() + ": " + error.what());
    }
  }
  void notify(const boost::any& parsed) const override {
    *value_ = boost::any_cast<const Value&>(parsed);
  }

 private:
  Value* value_;
  Read read_;
};

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

template <typename Number>
Number in_range(Number number, const std::string& text, Number minimum, Number maximum) {
  if (number < minimum)
    throw UsageError(quoted(text) + " is too small: at least " + text_of(minimum));
  if (number > maximum)
    throw UsageError(quoted(text) + " is too large: at most " + text_of(maximum));
  return number;
}

std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    numbers.push_back(parse_number(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return numbers;
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : separator) + word;
  return joined;
}

}  // namespace

template <typename Value>
void Program::add(const std::string& option, const std::string& placeholder,
                  const std::string& help, Value* value,
                  std::function<Value(const std::string&)> read) {
  command_->add(std::make_unique<Bound<Value>>(value, std::move(read), option, placeholder, help));
}

void Program::flag(const std::string& option, bool* value, const std::string& help) {
  add<bool>(option, "", help, value, [](const std::string&) { return true; });
}

void Program::number(const std::string& option, double* value, double minimum, double maximum,
                     const std::string& help) {
  add<double>(option, "NUMBER", help, value, [=](const std::string& text) {
    return in_range(parse_number(text), text, minimum, maximum);
  });
}

template <typename Integer>
void Program::integer(const std::string& option, Integer* value, long minimum, long maximum,
                      const std::string& help) {
  add<Integer>(option, "N", help, value, [=](const std::string& text) {
    const auto number = parse_whole<long>(text, "a whole number");
    return static_cast<Integer>(in_range(number, text, minimum, maximum));
  });
}
template void Program::integer(const std::string&, int*, long, long, const std::string&);
template void Program::integer(const std::string&, long*, long, long, const std::string&);
template void Program::integer(const std::string&, std::size_t*, long, long, const std::string&);
template void Program::integer(const std::string&, std::optional<long>*, long, long,
                               const std::string&);

template <typename LengthOrNone>
void Program::length(const std::string& option, LengthOrNone* value, const std::string& help,
                     bool may_be_negative) {
  add<LengthOrNone>(option, "LENGTH", help, value, [=](const std::string& text) {
    const Length length = parse_length(text);
    if (length.value < 0 && !may_be_negative)
      throw UsageError(quoted(text) + " is too small: a length of at least 0");
    return length;
  });
}
template void Program::length(const std::string&, Length*, const std::string&, bool);
template void Program::length(const std::string&, std::optional<Length>*, const std::string&, bool);

void Program::text(const std::string& option, std::string* value, const std::string& placeholder,
                   const std::string& help) {
  add<std::string>(option, placeholder, help, value, [](const std::string& text) { return text; });
}

void Program::choice(const std::string& option, std::string* value,
                     const std::vector<std::string>& names, const std::string& help) {
  add<std::string>(option, join(names, "|"), help, value, [=](const std::string& text) {
    if (std::find(names.begin(), names.end(), text) != names.end()) return text;
    throw UsageError(quoted(text) + " is not known; did you mean " +
                     quoted(nearest_name(text, names)) + "? (" + join(names, ", ") + ")");
  });
}

void Program::numbers(const std::string& option, std::vector<double>* value,
                      const std::string& placeholder, const std::string& help) {
  const auto commas = std::count(placeholder.begin(), placeholder.end(), ',');
  const auto count = static_cast<std::size_t>(commas) + 1;
  add<std::vector<double>>(option, placeholder, help, value, [=](const std::string& text) {
    std::vector<double> numbers = parse_numbers(text);
    if (numbers.size() == count) return numbers;
    throw UsageError(quoted(text) + " is not " + std::to_string(count) + " numbers with commas");
  });
}

void Program::seed(long* value) {
  integer("seed", value, 0, std::numeric_limits<long>::max(), "seed of the random numbers");
}

void Program::reference_edge(const std::string& value, const std::string& help) {
  command_->common.reference_edge = value;
  add<std::string>("reference-edge", "auto|LENGTH", help, &command_->common.reference_edge,
                   [](const std::string& text) {
                     if (text == "auto" || parse_length(text).value > 0) return text;
                     throw UsageError(quoted(text) + " must be positive, or auto to measure it");
                   });
}

}  // namespace transformesh::tool
