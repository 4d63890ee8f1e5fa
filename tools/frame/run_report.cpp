#include "frame/run_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

void RunReport::add(const std::string& key, const Value& value) {
  result_.emplace_back(key, value);
}

void RunReport::show_settings() {
  if (settings_are_shown_ || !messages_.are_detailed()) return;
  settings_are_shown_ = true;
  for (const Option& option : program_.options) {
    const std::string value = option.text();
    if (option.is_common || value.empty() || value == "false") continue;
    const auto absolute = inputs_.resolved(option);
    messages_.detail("--" + option.name() + (option.is_flag() ? "" : " " + value) +
                     (absolute ? " = " + significant(*absolute, 6) : ""));
  }
  if (const auto edge = inputs_.used_reference_edge())
    messages_.detail("reference edge " + significant(*edge, 6));
}

void RunReport::show_entries() const {
  for (const auto& [key, value] : result_) messages_.detail(key + ": " + text_of(value));
}

std::string RunReport::text_of_key(const std::string& only) const {
  std::string keys;
  for (const auto& [key, value] : result_) {
    if (key == only) return text_of(value) + '\n';
    keys += (keys.empty() ? "" : ", ") + key;
  }
  throw UsageError("--get: the report has no key '" + only + "'; its keys are " + keys);
}

std::string RunReport::text() const {
  const std::string* own = program_.output.only_key;
  const std::string& only = own != nullptr ? *own : program_.common.get;
  if (!only.empty()) return text_of_key(only);
  if (program_.common.json) return json_text(object_of(result_));
  std::string lines;
  for (const auto& [key, value] : result_) lines += key + ": " + text_of(value) + '\n';
  return lines;
}

std::string RunReport::full(const Entries& output_counts, const Phases& phases) {
  Json report = {{"tool", program_.name}, {"version", TM_VERSION}, {"options", Json::object()}};
  for (const Option& option : program_.options) {
    if (option.is_common && !option.is_given) continue;
    std::string key = option.name();
    std::replace(key.begin(), key.end(), '-', '_');
    const auto absolute = inputs_.resolved(option);
    report["options"][key] = absolute ? Json(*absolute) : json_of(option.value());
  }
  if (!inputs_.counts().empty()) report["input"] = object_of(inputs_.counts());
  if (!output_counts.empty()) report["output"] = object_of(output_counts);
  report["result"] = object_of(result_);
  report["timings"] = phases.seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  return json_text(report);
}

}  // namespace transformesh::tool
