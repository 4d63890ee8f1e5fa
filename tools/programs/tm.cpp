/// tm: the programs of the suite, and their man pages.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "frame/run.h"
#include "program_list.h"
#include "support/suggestion.h"
#include "transformesh/errors.h"

namespace {

using namespace transformesh;
namespace fs = std::filesystem;

std::string lines_of(const auto& list) {
  std::string text;
  for (const auto& [name, does] : list) {
    std::string line = name;
    line.resize(18, ' ');
    text += line + does + '\n';
  }
  return text;
}

std::string list_text() {
  return lines_of(tool::program_list) + '\n' + lines_of(tool::page_list) +
         "\n`tm NAME` shows a page, `tm tm` what all programs share.\n";
}

/// Those of section 7; tm(7) is about the suite itself.
bool is_no_program(const std::string& name) {
  return name == "tm" || std::any_of(std::begin(tool::page_list), std::end(tool::page_list),
                                     [&](const auto& page) { return page.first == name; });
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& program : tool::program_list) names.emplace_back(program.first);
  for (const auto& page : tool::page_list) names.emplace_back(page.first);
  return names;
}

/// `clean` or `tm-clean`; `tm` is the suite itself.
std::string page_named(const std::string& word) {
  std::vector<std::string> names = all_names();
  names.emplace_back("tm");
  for (const std::string& name : {word, "tm-" + word})
    if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  const std::string nearest = nearest_name("tm-" + word, names);
  const bool is_meant = is_near(word, nearest.starts_with("tm-") ? nearest.substr(3) : nearest);
  throw UsageError(
      "there is no program '" + word + "'; " +
      (is_meant ? "did you mean '" + nearest + "'?" : "tm lists those that there are"));
}

/// Replaces this process by one of the commands, the first that is there.
void run_first_of(std::vector<std::vector<std::string>> commands) {
  for (std::vector<std::string>& words : commands) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
  }
}

void open_page(const std::string& name) {
  // Pages lie beside the programs, where these were built and where they are installed.
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  const bool is_program = !is_no_program(name);
  const std::string page = is_program ? "man1/" + name + ".1" : "man7/" + name + ".7";
  std::vector<std::vector<std::string>> commands;
  if (const fs::path file = here / "../share/man" / page; fs::exists(file)) {
    commands.push_back({"man", file.string()});
  } else if (fs::exists(file.string() + ".gz")) {
    commands.push_back({"man", file.string() + ".gz"});
  }
  if (is_program || name == "tm") commands.push_back({(here / name).string(), "--help"});
  run_first_of(std::move(commands));
  throw GoalError(is_program ? "neither man nor " + name + " can be run"
                             : "the page " + name +
                                   "(7) cannot be shown: man or the page itself is "
                                   "not installed");
}

}  // namespace

int main(int argc, char** argv) {
  tool::Program program{"tm",
                        "[OPTION]... [NAME]",
                        "Lists the programs of the suite, or shows the man page of one",
                        {tool::Reads::words},
                        {tool::Writes::text}};
  program.words = {"NAME", "of a program or page, with or without tm-; tm: what all share"};
  program.words.choices = all_names();
  return program.run(argc, argv, [](tool::Run& run) {
    const std::vector<std::string>& words = run.in().names();
    if (words.size() > 1)
      throw UsageError("one NAME at most, but '" + words[1] + "' is a second one");
    if (!words.empty()) open_page(page_named(words[0]));
    run.out().set_bytes(list_text());
  });
}
