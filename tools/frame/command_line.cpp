// From a command line to the values of a program's options, and back to its provenance.
#include <algorithm>
#include <boost/program_options.hpp>
#include <cctype>

#include "frame/program.h"
#include "tm/support/error.h"
#include "tm/support/suggestion.h"

namespace transformesh::tool {
namespace {

namespace po = boost::program_options;

[[noreturn]] void throw_unknown(const std::string& token, const std::deque<Option>& options) {
  if (token.size() > 1 && (std::isdigit(static_cast<unsigned char>(token[1])) || token[1] == '.')) {
    throw UsageError("unknown option '" + token + "'; if it is no option, write -- before it");
  }
  std::string word = token.substr(0, token.find('='));
  word.erase(0, word.find_first_not_of('-'));
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name());
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

std::vector<po::option> split(const std::vector<std::string>& arguments,
                              const std::deque<Option>& options) {
  const int style = po::command_line_style::unix_style ^ po::command_line_style::allow_guessing;
  po::options_description known;
  for (const Option& option : options)
    known.add_options()(option.names.c_str(), new po::untyped_value(option.is_flag()));
  try {
    po::command_line_parser parser(arguments);
    return parser.options(known).style(style).allow_unregistered().run().options;
  } catch (const po::error_with_option_name& error) {
    rethrow_in_words(error);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
}

// Common options say how to write and what to tell; these three also say what.
bool is_in_provenance(const Option& option) {
  for (const char* file : {"FILE", "FOLDER", "WHERE"})
    if (option.placeholder.find(file) != std::string::npos) return false;
  const std::string name = option.name();
  const bool says_what = name == "float" || name == "double" || name == "reference-edge";
  return option.is_given && option.affects_result && (!option.is_common || says_what);
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

Option* Program::find(const std::string& option) {
  const std::size_t begin = std::min(option.find_first_not_of('-'), option.size());
  const auto found = std::find_if(options.begin(), options.end(), [&](const Option& candidate) {
    return candidate.name() == option.substr(begin);
  });
  return found == options.end() ? nullptr : &*found;
}

std::vector<std::string> Program::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> others;
  for (const po::option& parsed : split(arguments, options)) {
    if (parsed.unregistered) throw_unknown(parsed.original_tokens.at(0), options);
    if (parsed.string_key.empty()) {
      others.insert(others.end(), parsed.value.begin(), parsed.value.end());
      continue;
    }
    Option& option = *find(parsed.string_key);
    const std::string text = parsed.value.empty() ? "" : parsed.value[0];
    // `--output --quiet`: the value was forgotten.
    if (text.starts_with("--") && find(text) != nullptr) throw_missing(option.name());
    try {
      option.assign(text);
    } catch (const UsageError& error) {
      throw UsageError("--" + option.name() + ": " + error.what());
    }
    option.is_given = true;
  }
  return others;
}

std::string provenance(const Program& program) {
  std::string line = program.name + " " TM_VERSION;
  if (program.reads == Reads::words)
    for (const std::string& word : program.inputs) line += ' ' + quoted(word);
  for (const Option& option : program.options) {
    if (!is_in_provenance(option)) continue;
    line += " --" + option.name();
    if (!option.is_flag()) line += ' ' + quoted(option.text());
  }
  return line;
}

}  // namespace transformesh::tool
