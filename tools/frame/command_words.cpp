#include "frame/command_words.h"

#include <boost/program_options.hpp>

#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

namespace po = boost::program_options;

// Converts an error of Boost.ProgramOptions to a UsageError that names the option uniformly, such
// as `--name`. Boost's own messages name options in several ways.
[[noreturn]] void rethrow_in_words(const po::error_with_option_name& error) {
  std::string name = error.get_option_name();
  name.erase(0, name.find_first_not_of('-'));
  const auto* syntax = dynamic_cast<const po::invalid_syntax*>(&error);
  if (syntax != nullptr && syntax->kind() == po::invalid_syntax::extra_parameter)
    throw UsageError("--" + name + " takes no value");
  throw UsageError((name.size() == 1 ? "-" : "--") + name + " needs a value");
}

std::vector<po::option> split(const std::vector<std::string>& arguments, const OptionSet& options) {
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

}  // namespace

std::vector<CommandWord> split_command(const std::vector<std::string>& arguments,
                                       const OptionSet& options) {
  std::vector<CommandWord> words;
  for (const po::option& parsed : split(arguments, options)) {
    if (parsed.unregistered) {
      words.push_back({nullptr, parsed.original_tokens.at(0), true});
    } else if (parsed.string_key.empty()) {
      for (const std::string& word : parsed.value) words.push_back({nullptr, word});
    } else {
      words.push_back({options.find(parsed.string_key),
                       parsed.value.empty() ? std::string() : parsed.value[0]});
    }
  }
  return words;
}

}  // namespace transformesh::tool
