/// What a run found and did: named values in order, as `key: value` lines or as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace transformesh::tool {

using ReportValue = std::variant<double, long, bool, std::string, std::vector<double>>;

class Report {
 public:
  /// A key that is there already gets the new value.
  void set(const std::string& key, ReportValue value);
  const ReportValue* find(const std::string& key) const;
  std::vector<std::string> keys() const;

  /// One `key: value` line each.
  std::string lines() const;
  nlohmann::ordered_json json() const;

 private:
  std::vector<std::pair<std::string, ReportValue>> entries_;
};

/// true or false, shortest numbers, the numbers of a list separated by spaces.
std::string text_of(const ReportValue& value);

/// Indented, with a line end; bytes that are not UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace transformesh::tool
