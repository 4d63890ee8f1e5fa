#include "option_table.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cctype>

#include "suggestion.h"
#include "tm/support/error.h"

namespace transformesh::tool {
namespace {

namespace po = boost::program_options;

struct ValueText {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const double* value) const { return shortest_text(*value); }
  std::string operator()(const long* value) const { return std::to_string(*value); }
  std::string operator()(const std::optional<long>* value) const {
    return *value ? std::to_string(**value) : "";
  }
  std::string operator()(const std::string* value) const { return *value; }
  std::string operator()(const Length* value) const { return value->text(); }
  std::string operator()(const std::optional<Length>* value) const {
    return *value ? (*value)->text() : "";
  }
  std::string operator()(const std::vector<double>* values) const {
    std::string text;
    for (const double value : *values) text += (text.empty() ? "" : ",") + shortest_text(value);
    return text;
  }
};

po::options_description description(const std::vector<Option>& options) {
  po::options_description all;
  for (const Option& option : options) {
    std::string names = option.name;
    if (option.short_name != 0) names += std::string(",") + option.short_name;
    if (option.is_flag()) {
      all.add_options()(names.c_str(), "");
    } else {
      all.add_options()(names.c_str(), po::value<std::string>(), "");
    }
  }
  return all;
}

[[noreturn]] void throw_unknown(const std::string& token, const std::vector<Option>& options) {
  if (token.size() > 1 && (std::isdigit(static_cast<unsigned char>(token[1])) || token[1] == '.')) {
    throw UsageError("unknown option '" + token + "'; if it is no option, write -- before it");
  }
  std::string word = token.substr(0, token.find('='));
  word.erase(0, word.find_first_not_of('-'));
  std::vector<std::string> names(options.size());
  std::transform(options.begin(), options.end(), names.begin(),
                 [](const Option& option) { return option.name; });
  throw UsageError("unknown option '" + token + "'; did you mean '--" + nearest_name(word, names) +
                   "'?");
}

[[noreturn]] void throw_missing(const std::string& name) {
  throw UsageError((name.size() == 1 ? "-" : "--") + name + " needs a value");
}

// Boost's own messages name the option in several ways; ours is always `--name`.
[[noreturn]] void rethrow_in_words(const po::error_with_option_name& error) {
  std::string name = error.get_option_name();
  name.erase(0, name.find_first_not_of('-'));
  const auto* syntax = dynamic_cast<const po::invalid_syntax*>(&error);
  if (syntax != nullptr && syntax->kind() == po::invalid_syntax::extra_parameter) {
    throw UsageError("--" + name + " takes no value");
  }
  throw_missing(name);
}

std::vector<po::option> split(const std::vector<std::string>& arguments,
                              const std::vector<Option>& options) {
  const po::options_description known = description(options);
  const int style = po::command_line_style::unix_style ^ po::command_line_style::allow_guessing;
  try {
    po::command_line_parser parser(arguments);
    return parser.options(known).style(style).allow_unregistered().run().options;
  } catch (const po::error_with_option_name& error) {
    rethrow_in_words(error);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

std::string Option::value_text() const { return std::visit(ValueText(), target); }

Option& OptionTable::add(Option option) {
  option.name.erase(0, option.name.find_first_not_of('-'));
  if (option.default_text.empty() && !option.is_flag()) option.default_text = option.value_text();
  options_.push_back(std::move(option));
  return options_.back();
}

Option* OptionTable::find(const std::string& name) {
  const std::size_t begin = std::min(name.find_first_not_of('-'), name.size());
  const auto found = std::find_if(options_.begin(), options_.end(), [&](const Option& option) {
    return option.name == name.substr(begin);
  });
  return found == options_.end() ? nullptr : &*found;
}

bool OptionTable::has_lengths() const {
  return std::any_of(options_.begin(), options_.end(),
                     [](const Option& option) { return option.placeholder == "LENGTH"; });
}

std::vector<std::string> OptionTable::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  for (const po::option& parsed : split(arguments, options_)) {
    if (parsed.unregistered) throw_unknown(parsed.original_tokens.at(0), options_);
    if (parsed.string_key.empty()) {
      words.insert(words.end(), parsed.value.begin(), parsed.value.end());
      continue;
    }
    Option* option = find(parsed.string_key);
    const std::string value = parsed.value.empty() ? "" : parsed.value[0];
    // `--output --quiet`: the value was forgotten.
    if (value.starts_with("--") && find(value) != nullptr) throw_missing(option->name);
    try {
      option->assign(value);
    } catch (const UsageError& error) {
      throw UsageError("--" + option->name + ": " + error.what());
    }
    option->given = true;
  }
  return words;
}

}  // namespace transformesh::tool
