#include "frame/limits.h"

#ifndef TM_WITHOUT_GMP
#include <gmp.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>

#include "frame/program.h"
#include "frame/terminal.h"
#include "support/elementary/exponential.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

constexpr std::string_view unit_letters = "KMGT";
constexpr double unit_step = 1024;

// Sanitizers map terabytes of address space, which would count towards the limit.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_shadow_memory = true;
#else
constexpr bool has_shadow_memory = false;
#endif

// Message for lack of memory. It is allocated in advance and never freed.
const std::string* memory_message = nullptr;

[[noreturn]] void end_without_memory() { end_process_with(*memory_message, exit_memory); }

#ifdef TM_WITHOUT_GMP
void let_gmp_end_without_memory() {}
#else
// Allocates memory for GMP. Ends the process with a message at a failure, at which GMP would abort.
void* allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) end_without_memory();
  return memory;
}
void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
  void* memory = std::realloc(old, size);
  if (memory == nullptr) end_without_memory();
  return memory;
}
void release(void* memory, std::size_t /*size*/) { std::free(memory); }

void let_gmp_end_without_memory() { mp_set_memory_functions(allocate, reallocate, release); }
#endif

// Handler for exceptions that leave a noexcept function. Only std::bad_alloc is known to do so.
[[noreturn]] void end_by_exception() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
  }
  end_process_with("internal error: please report it together with the input\n", exit_goal);
}

std::optional<std::uint64_t> number_in_file(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  if (!(file >> word)) return std::nullopt;
  return number_in<std::uint64_t>(word);
}

// Returns the least limit of a control group and all groups above it. Version 2 of control groups
// has a single tree; version 1 has a separate tree for memory.
std::uint64_t group_limit(const std::string& root, std::string group, const std::string& name) {
  std::uint64_t limit = UINT64_MAX;
  while (true) {
    limit = std::min(limit, number_in_file(std::string(root).append(group).append("/").append(name))
                                .value_or(UINT64_MAX));
    if (group.empty()) return limit;
    group.erase(group.rfind('/'));
  }
}

std::uint64_t control_group_limit() {
  std::uint64_t limit = UINT64_MAX;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos || line.substr(second + 1, 1) != "/") continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::string group = line.substr(second + 1) == "/" ? "" : line.substr(second + 1);
    if (controllers.empty())
      limit = std::min(limit, group_limit("/sys/fs/cgroup", group, "memory.max"));
    if (controllers == "memory")
      limit = std::min(limit, group_limit("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
  }
  return limit;
}

std::uint64_t soft_limit(auto resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

}  // namespace

std::uint64_t parse_size(const std::string& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789.e+"), text.size());
  const auto number = number_in<double>(text.substr(0, end));
  std::string unit = text.substr(end);
  if (unit.ends_with("iB")) unit.resize(unit.size() - 2);
  if (unit.ends_with('B')) unit.pop_back();
  const std::size_t power = unit.empty() ? 0 : 1 + unit_letters.find(unit[0]);
  const double bytes = number.value_or(-1) * elementary::pow(unit_step, static_cast<double>(power));
  const bool is_unit = unit.empty() || (unit.size() == 1 && power > 0);
  if (!is_unit || !(bytes >= 1 && bytes < 1e18))
    throw UsageError("'" + text + "' is not a size such as 500M or 2G");
  return static_cast<std::uint64_t>(bytes);
}

std::string size_text(std::uint64_t bytes) {
  auto number = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; number >= unit_step && unit < unit_letters.size(); ++unit) number /= unit_step;
  std::ostringstream text;
  text.precision(number < 1000 ? 3 : 4);
  text << number;
  return text.str() + (unit == 0 ? " bytes" : std::string(1, unit_letters[unit - 1]));
}

std::uint64_t available_memory() {
  const auto pages = static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 0L));
  const auto page = static_cast<std::uint64_t>(std::max(sysconf(_SC_PAGESIZE), 0L));
  return std::min(pages * page, control_group_limit());
}

std::string limit_memory(const std::string& program, std::optional<std::uint64_t> limit) {
  const std::uint64_t wanted = limit.value_or(available_memory());
  const std::uint64_t inherited = std::min(soft_limit(RLIMIT_AS), soft_limit(RLIMIT_DATA));
  const std::uint64_t most = std::min(wanted, inherited);
  rlimit data{};
  getrlimit(RLIMIT_DATA, &data);
  data.rlim_cur = std::min<rlim_t>(most, data.rlim_cur);
  if (!has_shadow_memory) setrlimit(RLIMIT_DATA, &data);
  if (limit && !has_shadow_memory && soft_limit(RLIMIT_DATA) > most)
    throw UsageError("--max-memory: this system cannot limit the memory of a program");
  const std::string source = inherited < wanted ? "ulimit allows"
                             : limit            ? "--max-memory allows"
                                                : "there are";
  std::string reason =
      "out of memory: more is needed than the " + size_text(most) + " that " + source;
  memory_message = new std::string(program + ": " + reason + '\n');
  let_gmp_end_without_memory();
  std::set_terminate(end_by_exception);
  return reason;
}

}  // namespace transformesh::tool
