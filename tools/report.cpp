#include "report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tm/support/length.h"

namespace transformesh::tool {
namespace {

struct TextOf {
  std::string operator()(double value) const { return shortest_text(value); }
  std::string operator()(long value) const { return std::to_string(value); }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const std::vector<double>& values) const {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + shortest_text(value);
    return text;
  }
};

}  // namespace

std::string text_of(const ReportValue& value) { return std::visit(TextOf(), value); }

void Report::set(const std::string& key, ReportValue value) {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const auto& candidate) { return candidate.first == key; });
  if (entry != entries_.end()) {
    entry->second = std::move(value);
  } else {
    entries_.emplace_back(key, std::move(value));
  }
}

const ReportValue* Report::find(const std::string& key) const {
  for (const auto& [name, value] : entries_) {
    if (name == key) return &value;
  }
  return nullptr;
}

std::vector<std::string> Report::keys() const {
  std::vector<std::string> names;
  for (const auto& entry : entries_) names.push_back(entry.first);
  return names;
}

std::string Report::lines() const {
  std::string text;
  for (const auto& [key, value] : entries_) text += key + ": " + text_of(value) + '\n';
  return text;
}

nlohmann::ordered_json Report::json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [key, value] : entries_) {
    std::visit([&json, &name = key](const auto& typed) { json[name] = typed; }, value);
  }
  return json;
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace transformesh::tool
