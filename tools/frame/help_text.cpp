#include <algorithm>
#include <sstream>

#include "frame/program.h"

namespace transformesh::tool {
namespace {

constexpr std::size_t line_width = 79;
constexpr std::size_t help_column = 26;

// Breaks text into lines at spaces. The first line begins at `column`, later lines at `indent`.
std::string wrapped(const std::string& text, std::size_t column, std::size_t indent) {
  std::string lines;
  std::istringstream words(text);
  std::string space;
  for (std::string word; words >> word; space = " ") {
    column += space.size();
    if (!space.empty() && column + word.size() > line_width) {
      space = '\n' + std::string(indent, ' ');
      column = indent;
    }
    lines += space + word;
    column += word.size();
  }
  return lines + '\n';
}

// Returns `  left   help`. The help is on its own line if the left part is too wide.
std::string entry(const std::string& left, const std::string& help) {
  std::string line = "  " + left;
  if (line.size() + 2 > help_column) line += '\n' + std::string(help_column, ' ');
  line.resize(std::max(line.size(), help_column), ' ');
  return line + wrapped(help, help_column, help_column);
}

std::string option_entry(const Option& option) {
  const bool has_letter = option.names != option.name();
  const std::string letter = has_letter ? std::string("-") + option.names.back() + ", " : "";
  const std::string left = letter + "--" + option.name();
  if (option.is_flag()) return entry(left, option.help);
  const std::string& value = option.default_text;
  const bool is_stated = value.empty() || option.help.find("(default") != std::string::npos;
  return entry(left + ' ' + option.placeholder,
               option.help + (is_stated ? "" : " (default " + value + ")"));
}

std::string option_entries(const Program& program, bool is_common) {
  std::string entries;
  for (const Option& option : program.options)
    if (option.is_common == is_common && option.is_listed) entries += option_entry(option);
  return entries;
}

std::string exit_code_lines(const Program& program) {
  std::string done = "done";
  if (program.output.writes == Writes::answer) done = "done or passed, 1 not passed";
  if (program.is_evolution()) done = "done, 1 not converged with --require-convergence";
  return wrapped("Exit codes: 0 " + done +
                     ", 2 usage, 3 bad input, 4 goal not reached, "
                     "5 output failed, 6 out of memory.",
                 0, 12);
}

// Returns the lines of the help that explain how lengths are written. Programs that read no input
// have their own text, because they have neither a bounding box of the input nor a reference edge.
std::string length_lines(const Program& program) {
  const auto is_length = [](const Option& option) { return option.placeholder == "LENGTH"; };
  if (std::none_of(program.options.begin(), program.options.end(), is_length)) return {};
  return '\n' + wrapped(program.reads_input()
                            ? "A LENGTH is 0.02 (input units), 1% (of the bounding box's diagonal) "
                              "or 0.7x (of the reference edge)."
                            : program.lengths,
                        0, 0);
}

std::string usage_lines(const Program& program) {
  return wrapped("Usage: " + program.name + " " + program.synopsis, 0, 8 + program.name.size());
}

}  // namespace

std::string help_text(const Program& program) {
  std::string text = usage_lines(program) + '\n' + wrapped(program.summary + '.', 0, 0);
  const WordRules& words = program.words;
  if (!words.placeholder.empty()) text += "\nArguments:\n" + entry(words.placeholder, words.help);
  const std::string own = option_entries(program, false);
  if (!own.empty()) text += "\nOptions:\n" + own;
  text += "\nCommon options:\n" + option_entries(program, true) + length_lines(program);
  if (!program.epilog.empty()) text += '\n' + program.epilog + '\n';
  text += '\n' + exit_code_lines(program);
  return program.example.empty() ? text : text + "\nExample:\n  " + program.example + '\n';
}

std::string short_help_text(const Program& program) {
  return usage_lines(program) + wrapped(program.summary + '.', 0, 0) + "Try '" + program.name +
         " --help'.\n";
}

}  // namespace transformesh::tool
