#include <algorithm>
#include <sstream>

#include "command.h"

namespace transformesh::tool {
namespace {

constexpr std::size_t line_width = 79;
constexpr std::size_t help_column = 26;

// Breaks text into lines at spaces; the first line begins at `column`, later ones at `indent`.
std::string wrapped(const std::string& text, std::size_t column, std::size_t indent) {
  std::string lines;
  std::istringstream words(text);
  bool line_is_empty = true;
  for (std::string word; words >> word;) {
    if (!line_is_empty && column + 1 + word.size() > line_width) {
      lines += '\n' + std::string(indent, ' ');
      column = indent;
      line_is_empty = true;
    }
    if (!line_is_empty) ++column;
    lines += (line_is_empty ? "" : " ") + word;
    column += word.size();
    line_is_empty = false;
  }
  return lines + '\n';
}

// `  left   help`, with the help on its own line where the left part is too wide.
std::string entry(const std::string& left, const std::string& help) {
  std::string line = "  " + left;
  if (line.size() + 2 > help_column) {
    line += '\n' + std::string(help_column, ' ');
  } else {
    line.resize(help_column, ' ');
  }
  return line + wrapped(help, help_column, help_column);
}

std::string option_entry(const Option& option) {
  const std::string name = option.name();
  const bool has_short_name = name != option.names;
  const std::string left = (has_short_name ? std::string("-") + option.names.back() + ", " : "") +
                           "--" + name + (option.is_flag() ? "" : ' ' + option.placeholder);
  const std::string value = option.is_flag() ? "" : option.text();
  return entry(left, option.help + (value.empty() ? "" : " (default " + value + ")"));
}

std::string option_entries(const Command& command, bool is_common) {
  std::string entries;
  for (const Option* option : command.options)
    if (option->is_common == is_common) entries += option_entry(*option);
  return entries;
}

std::string exit_code_lines(const Command& command) {
  const std::string answers = command.writes == Writes::answer ? "done or yes, 1 no"
                              : command.is_evolution()
                                  ? "done, 1 not converged where that is required"
                                  : "done";
  return wrapped("Exit codes: 0 " + answers +
                     ", 2 usage, 3 bad input, 4 goal not reached, 5 output failed, 6 out of "
                     "memory.",
                 0, 12);
}

bool has_lengths(const Command& command) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [](const Option* option) { return option->placeholder == "LENGTH"; });
}

// A program that reads no mesh has no reference edge.
std::string length_lines(bool has_reference_edge) {
  const std::string rest =
      has_reference_edge ? ", 1% (of the bounding box's diagonal) or 0.7x (of the reference edge)."
                         : " or 1% (of the bounding box's diagonal).";
  return wrapped("A LENGTH is 0.02 (input units)" + rest, 0, 0);
}

std::string usage_line(const Command& command) {
  return wrapped("Usage: " + command.name + " " + command.synopsis, 0, 8 + command.name.size());
}

}  // namespace

std::string help_text(const Command& command) {
  std::string text = usage_line(command) + '\n' + wrapped(command.summary + '.', 0, 0);
  if (!command.words_placeholder.empty()) {
    text += "\nArguments:\n" + entry(command.words_placeholder, command.words_help);
  }
  const std::string own = option_entries(command, false);
  if (!own.empty()) text += "\nOptions:\n" + own;
  text += "\nCommon options:\n" + option_entries(command, true);
  if (has_lengths(command)) text += '\n' + length_lines(command.reads != Reads::nothing);
  for (const std::string& epilog : command.epilogs) text += '\n' + epilog + '\n';
  return text + '\n' + exit_code_lines(command);
}

std::string short_help_text(const Command& command) {
  return usage_line(command) + wrapped(command.summary + '.', 0, 0) + "Try '" + command.name +
         " --help'.\n";
}

}  // namespace transformesh::tool
