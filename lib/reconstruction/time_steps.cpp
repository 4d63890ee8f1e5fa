#include "reconstruction/time_steps.h"

#include <fstream>
#include <set>

#include "io/streams/file_list.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    if (line.find_first_not_of(' ') != std::string::npos) lines.push_back(line);
  return lines;
}

std::string last_part(std::string text) {
  if (text.ends_with('/')) text.pop_back();
  return text.substr(text.rfind('/') + 1);
}

}  // namespace

std::vector<TimeStep> time_steps(const std::string& where) {
  const std::string prefix = "'" + where + "': ";
  std::vector<TimeStep> steps;
  std::set<std::string> names;
  for (const std::string& text : is_file(where) ? lines_of(where) : folders_at(where)) {
    steps.push_back({text, last_part(text)});
    if (!names.insert(steps.back().name).second)
      throw UsageError(prefix + "two time steps are called '" + steps.back().name + "'");
  }
  if (steps.empty()) throw InputError(prefix + "there is no time step");
  return steps;
}

std::string place_of(std::string where, const TimeStep& step) {
  for (std::size_t at = where.find("{}"); at != std::string::npos;
       at = where.find("{}", at + step.text.size()))
    where.replace(at, 2, step.text);
  return where;
}

}  // namespace transformesh
