#include "frame/completion.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace transformesh::tool {
namespace {

/// Candidates for a value: words, files or folders.
struct Candidates {
  std::string words;  ///< literal words, separated by blanks
  bool are_files = false;
  bool are_folders = false;
};

// Returns the candidates of a placeholder such as `auto|LENGTH`. Parts in lower case are literal
// words.
Candidates candidates_of(const Option& option) {
  Candidates candidates;
  std::istringstream parts(option.placeholder);
  for (std::string part; std::getline(parts, part, '|');) {
    if (part == "FILE" || part == "WHERE") candidates.are_files = true;
    if (part == "FOLDER") candidates.are_folders = true;
    const bool is_word = std::none_of(part.begin(), part.end(), [](unsigned char character) {
      return std::isupper(character) != 0 || character == ':';
    });
    if (is_word) candidates.words += (candidates.words.empty() ? "" : " ") + part;
  }
  return candidates;
}

std::string letter_of(const Option& option) {
  return option.names == option.name() ? "" : std::string(1, option.names.back());
}

std::string replaced(std::string text, const std::string& characters, const std::string& before) {
  for (std::size_t i = 0; (i = text.find_first_of(characters, i)) != std::string::npos;
       i += before.size() + 1)
    text.insert(i, before);
  return text;
}

std::string in_shell_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text)
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  return quoted + "'";
}

std::string words_of(const Program& program) {
  std::string words;
  for (const std::string& word : program.words.choices) words += (words.empty() ? "" : " ") + word;
  return words;
}

std::string function_name(std::string program) {
  std::replace(program.begin(), program.end(), '-', '_');
  return "_" + program;
}

// --- bash ----------------------------------------------------------------------------------------

std::string bash_values(const Option& option) {
  const Candidates candidates = candidates_of(option);
  const std::string letter = letter_of(option);
  std::string line = "    " + (letter.empty() ? "" : "-" + letter + " | ") + "--" + option.name();
  std::string kinds = candidates.are_files ? " -f" : candidates.are_folders ? " -d" : "";
  if (!candidates.words.empty()) kinds += " -W " + in_shell_quotes(candidates.words);
  if (kinds.empty()) return line + ") return ;;\n";
  return line + ") _tm_offer" + kinds + " -- \"$word\"; return ;;\n";
}

std::string bash_arguments(const Program& program) {
  if (program.reads_mesh()) {
    std::string text =
        program.has_command()
            ? "  _tm_offer -W " + in_shell_quotes(words_of(program)) + " -- \"$word\"\n"
            : "";
    for (const char* ending : {"ply", "off", "obj", "stl"})
      text += std::string("  _tm_offer -f -X '!*.") + ending + "' -- \"$word\"\n";
    return text + "  _tm_offer -d -- \"$word\"\n";
  }
  if (!program.words.choices.empty())
    return "  _tm_offer -W " + in_shell_quotes(words_of(program)) + " -- \"$word\"\n";
  if (program.words.are_folders) return "  _tm_offer -d -- \"$word\"\n";
  return program.reads_input() ? "  _tm_offer -f -- \"$word\"\n" : "";
}

std::string bash(const Program& program) {
  std::string names;
  std::string values;
  for (const Option& option : program.options) {
    if (!option.is_listed) continue;
    names += (names.empty() ? "--" : " --") + option.name();
    if (!option.is_flag()) values += bash_values(option);
  }
  const std::string function = function_name(program.name);
  return "# bash completion of " + program.name + "\n" + function +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  COMPREPLY=()\n"
         "  _tm_offer() {\n"
         "    local found\n"
         "    while IFS= read -r found; do COMPREPLY+=(\"$found\"); done < <(compgen \"$@\")\n"
         "  }\n"
         "  compopt -o filenames 2>/dev/null\n"
         "  case $before in\n" +
         values +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    _tm_offer -W " +
         in_shell_quotes(names) +
         " -- \"$word\"\n"
         "    return\n"
         "  fi\n" +
         bash_arguments(program) + "}\ncomplete -F " + function + " " + program.name + "\n";
}

// --- zsh -----------------------------------------------------------------------------------------

std::string zsh_action(const Candidates& candidates) {
  if (candidates.are_files) return "_files";
  if (candidates.are_folders) return "_files -/";
  return candidates.words.empty() ? " " : "(" + candidates.words + ")";
}

std::string zsh_option(const Option& option) {
  const std::string letter = letter_of(option);
  const std::string name = "--" + option.name();
  std::string rest = "[";
  rest += replaced(option.help, "[]:\\", "\\") + "]";
  if (!option.is_flag()) {
    rest += ":";
    rest += replaced(option.placeholder, ":\\", "\\") + ":" + zsh_action(candidates_of(option));
  }
  if (letter.empty()) return "  " + in_shell_quotes(name + rest) + " \\\n";
  return "  '(-" + letter + " " + name + ")'{-" + letter + "," + name + "}" +
         in_shell_quotes(rest) + " \\\n";
}

std::string zsh(const Program& program) {
  std::string text = "#compdef " + program.name + "\n_arguments -s -S \\\n";
  for (const Option& option : program.options)
    if (option.is_listed) text += zsh_option(option);
  if (program.has_command()) text += "  '1:command:(" + words_of(program) + ")' \\\n";
  if (program.reads_mesh()) return text + "  '*:mesh:_files -g \"*.(ply|off|obj|stl)(-.)\"'\n";
  if (!program.words.choices.empty()) return text + "  '*:word:(" + words_of(program) + ")'\n";
  if (program.words.are_folders) return text + "  '*:folder:_files -/'\n";
  return text + (program.reads_input() ? "  '*:file:_files'\n" : "  && return\n");
}

// --- fish ----------------------------------------------------------------------------------------

std::string fish_option(const Program& program, const Option& option) {
  const Candidates candidates = candidates_of(option);
  const std::string letter = letter_of(option);
  std::string line = "complete -c " + program.name + " -l " + option.name();
  if (!letter.empty()) line += " -s " + letter;
  if (!option.is_flag()) line += candidates.are_files || candidates.are_folders ? " -rF" : " -x";
  if (candidates.are_folders) line += " -a '(__fish_complete_directories)'";
  if (!candidates.words.empty()) line += " -a " + in_shell_quotes(candidates.words);
  return line + " -d " + in_shell_quotes(replaced(option.help, "\\", "\\")) + "\n";
}

std::string fish(const Program& program) {
  const std::string start = "complete -c " + program.name + " ";
  std::string text = "# fish completion of " + program.name + "\n" + start + "-f\n";
  if (program.reads_mesh()) {
    if (program.has_command()) text += start + "-a " + in_shell_quotes(words_of(program)) + "\n";
    text += start + "-ka '(__fish_complete_suffix .ply .off .obj .stl)'\n";
  } else if (!program.words.choices.empty()) {
    text += start + "-a " + in_shell_quotes(words_of(program)) + "\n";
  } else if (program.words.are_folders) {
    text += start + "-a '(__fish_complete_directories)'\n";
  } else if (program.reads_input()) {
    text += start + "-F\n";
  }
  for (const Option& option : program.options)
    if (option.is_listed) text += fish_option(program, option);
  return text;
}

}  // namespace

std::string completion(const Program& program, const std::string& shell) {
  if (shell == "zsh") return zsh(program);
  return shell == "fish" ? fish(program) : bash(program);
}

}  // namespace transformesh::tool
