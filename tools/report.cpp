#include "report.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>

#include "tm/support/length.h"

namespace transformesh::tool {

std::string text_of(const Json& value, const std::string& separator) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return shortest_text(value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& part : value) text += (text.empty() ? "" : separator) + text_of(part);
  return text;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void Phases::begin(std::string_view name) {
  if (name == current_ && !name.empty()) return;
  const double passed = phase_.lap();
  if (!current_.empty()) seconds_[current_] = seconds_.value(current_, 0.0) + passed;
  current_ = name;
  std::replace(current_.begin(), current_.end(), ' ', '_');
}

Json Phases::seconds() const {
  Json all = seconds_;
  all["total"] = total_.seconds();
  return all;
}

long peak_memory_bytes() {
  // getrusage would also count what the process held before it became this program.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

}  // namespace transformesh::tool
