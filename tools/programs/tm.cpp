/// tm: lists the programs of the suite, and opens their man pages.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "frame/run.h"
#include "options/jobs.h"
#include "program_list.h"
#include "support/suggestion.h"
#include "transformesh/errors.h"

namespace {

using namespace transformesh;
namespace fs = std::filesystem;

std::string list_text() {
  std::string text;
  for (const auto& [name, does] : tool::program_list) {
    std::string line = name;
    line.resize(18, ' ');
    text += line + does + '\n';
  }
  return tool::list_of_jobs() + '\n' + text +
         "\n`tm NAME` shows a page, `tm tm` what all programs share.\n";
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& program : tool::program_list) names.emplace_back(program.first);
  return names;
}

/// Returns the man page for a name such as `clean` or `tm-clean`. The name `tm` gives the page of
/// the suite.
std::string page_named(const std::string& word) {
  std::vector<std::string> names = all_names();
  names.emplace_back("tm");
  for (const std::string& name : {word, "tm-" + word})
    if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  const std::string nearest = nearest_name("tm-" + word, names);
  const bool is_meant = is_near(word, nearest.starts_with("tm-") ? nearest.substr(3) : nearest);
  throw UsageError("there is no program '" + word + "'; " +
                   (is_meant ? "did you mean '" + nearest + "'?" : "list all programs with tm"));
}

/// Replaces this process by the first of several commands that is installed.
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
  // Man pages have the same path relative to the programs in the build folder and in the
  // installation.
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  const std::string page = name == "tm" ? "man7/tm.7" : "man1/" + name + ".1";
  std::vector<std::vector<std::string>> commands;
  if (const fs::path file = here / "../share/man" / page; fs::exists(file)) {
    commands.push_back({"man", file.string()});
  } else if (fs::exists(file.string() + ".gz")) {
    commands.push_back({"man", file.string() + ".gz"});
  }
  commands.push_back({(here / name).string(), "--help"});
  run_first_of(std::move(commands));
  throw GoalError("neither man nor " + name + " can be run");
}

}  // namespace

int main(int argc, char** argv) {
  tool::Program program{"tm",
                        "[OPTION]... [NAME]",
                        "Lists the programs of the suite, or shows the man page of one",
                        {tool::Reads::words},
                        {tool::Writes::text}};
  program.words = {"NAME", "name of a program, with or without tm-; tm: what all programs share"};
  program.words.choices = all_names();
  program.example = "tm clean";
  return program.run(argc, argv, [](tool::Run& run) {
    const std::vector<std::string>& words = run.in().names();
    if (words.size() > 1)
      throw UsageError("at most one NAME can be given, but '" + words[1] + "' is a second one");
    const tool::Alias* alias = words.empty() ? nullptr : tool::alias_of(words[0]);
    if (alias != nullptr) run.note(words[0] + ": " + std::string(alias->command));
    if (!words.empty())
      open_page(alias != nullptr ? std::string(alias->program) : page_named(words[0]));
    run.out().set_bytes(list_text());
  });
}
