#include "frame/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/number.h"

namespace transformesh::tool {
namespace {

Json converted(const auto& held) { return held; }
Json converted(const Length& length) { return length.text(); }

}  // namespace

std::string text_of(const Value& value, const std::string& separator) {
  if (const auto* number = std::get_if<double>(&value)) return shortest_text(*number);
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers == nullptr) {
    const Json json = json_of(value);
    return json.is_string() ? json.get<std::string>() : json.dump();
  }
  std::string text;
  for (const double number : *numbers)
    text += (text.empty() ? "" : separator) + shortest_text(number);
  return text;
}

Json json_of(const Value& value) {
  return std::visit([](const auto& held) { return converted(held); }, value);
}

Json object_of(const Entries& entries) {
  Json json = Json::object();
  for (const auto& [name, value] : entries) json[name] = json_of(value);
  return json;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void Phases::begin(std::string_view name) {
  if (name == current_ && !name.empty()) return;
  const double passed = phase_.lap();
  const auto known = std::ranges::find(seconds_, current_, &decltype(seconds_)::value_type::first);
  if (known != seconds_.end()) {
    known->second += passed;
  } else if (!current_.empty()) {
    seconds_.emplace_back(current_, passed);
  }
  current_ = name;
  std::replace(current_.begin(), current_.end(), ' ', '_');
}

Json Phases::seconds() const {
  Json all = Json::object();
  for (const auto& [name, seconds] : seconds_) all[name] = seconds;
  all["total"] = total_.seconds();
  return all;
}

long peak_memory_bytes() {
  // Read the file, because the peak of getrusage() would include memory that the process used
  // before it called exec().
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
