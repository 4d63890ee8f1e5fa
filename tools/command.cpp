#include "command.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "report.h"
#include "tm/support/error.h"
#include "tm/support/suggestion.h"

namespace transformesh::tool {
namespace {

namespace po = boost::program_options;

// Common options say how to write and what to tell; these three also say what.
bool does_affect_result(const Option& option) {
  for (const char* file : {"FILE", "FOLDER", "WHERE"})
    if (option.placeholder.find(file) != std::string::npos) return false;
  const std::string name = option.name();
  return !option.is_common || name == "float" || name == "double" || name == "reference-edge";
}

[[noreturn]] void throw_unknown(const std::string& token, const std::vector<Option*>& options) {
  if (token.size() > 1 && (std::isdigit(static_cast<unsigned char>(token[1])) || token[1] == '.')) {
    throw UsageError("unknown option '" + token + "'; if it is no option, write -- before it");
  }
  std::string word = token.substr(0, token.find('='));
  word.erase(0, word.find_first_not_of('-'));
  std::vector<std::string> names;
  for (const Option* option : options) names.push_back(option->name());
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
  if (syntax != nullptr && syntax->kind() == po::invalid_syntax::extra_parameter)
    throw UsageError("--" + name + " takes no value");
  throw_missing(name);
}

po::parsed_options split(const std::vector<std::string>& arguments,
                         const po::options_description& known) {
  const int style = po::command_line_style::unix_style ^ po::command_line_style::allow_guessing;
  try {
    return po::command_line_parser(arguments)
        .options(known)
        .style(style)
        .allow_unregistered()
        .run();
  } catch (const po::error_with_option_name& error) {
    rethrow_in_words(error);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
}

// A word as a shell would need it; control characters could end the comment's line.
std::string quoted(std::string word) {
  for (char& character : word) {
    if (static_cast<unsigned char>(character) < ' ' || character == '\x7f') character = '?';
  }
  const bool is_plain = !word.empty() && word.find_first_of(" '\"\\$`*?") == std::string::npos;
  return is_plain ? word : "'" + word + "'";
}

}  // namespace

std::string Option::text() const { return text_of(value(), ","); }

void Command::add(std::unique_ptr<Option> option) {
  option->is_common = declares_common;
  option->affects_result = does_affect_result(*option);
  options.push_back(option.get());
  const std::string names = option->names;
  known.add_options()(names.c_str(), option.release());
}

Option* Command::find(const std::string& option) const {
  const std::size_t begin = std::min(option.find_first_not_of('-'), option.size());
  const auto found = std::find_if(options.begin(), options.end(), [&](const Option* candidate) {
    return candidate->name() == option.substr(begin);
  });
  return found == options.end() ? nullptr : *found;
}

std::vector<std::string> Command::parse(const std::vector<std::string>& arguments) {
  const po::parsed_options parsed = split(arguments, known);
  std::vector<std::string> others;
  for (const po::option& option : parsed.options) {
    if (option.unregistered) throw_unknown(option.original_tokens.at(0), options);
    if (option.string_key.empty()) {
      others.insert(others.end(), option.value.begin(), option.value.end());
    } else if (!option.value.empty() && option.value[0].starts_with("--") &&
               find(option.value[0]) != nullptr) {
      // `--output --quiet`: the value was forgotten.
      throw_missing(find(option.string_key)->name());
    }
  }
  po::store(parsed, given);
  return others;
}

void Command::assign() {
  try {
    po::notify(given);
  } catch (const po::required_option& error) {
    const Option& option = *find(error.get_option_name());
    throw UsageError("--" + option.name() + " " + option.placeholder +
                     " is needed: " + option.help);
  }
}

std::string provenance(const Command& command) {
  std::string line = command.name + " " TM_VERSION;
  if (command.words != nullptr)
    for (const std::string& word : *command.words) line += ' ' + quoted(word);
  for (const Option* option : command.options) {
    if (!option->affects_result || !command.is_given(option->name())) continue;
    line += " --" + option->name();
    if (!option->is_flag()) line += ' ' + quoted(option->text());
  }
  return line;
}

}  // namespace transformesh::tool
