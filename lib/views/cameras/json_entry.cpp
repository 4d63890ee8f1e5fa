#include "views/cameras/json_entry.h"

#include <algorithm>
#include <cmath>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {

using Json = nlohmann::json;

Json parse_camera_json(const Source& source) {
  const auto keeps = [](int depth, Json::parse_event_t event, const Json& parsed) {
    const bool is_key = event == Json::parse_event_t::key && depth == 1;
    return !is_key || (parsed != "structure" && parsed != "control_points");
  };
  try {
    Json json = Json::parse(source.bytes, keeps);
    if (!json.is_object()) source.fail("the JSON is not an object");
    return json;
  } catch (const Json::exception& error) {
    const auto* const parse_error = dynamic_cast<const Json::parse_error*>(&error);
    const std::size_t byte = parse_error == nullptr ? 0 : parse_error->byte;
    const std::size_t at = std::min(byte, source.bytes.size());
    const bool is_cut_off = byte > source.bytes.size();
    source.fail_at_byte(source.begin() + (at > 0 ? at - 1 : 0),
                        is_cut_off ? "the JSON ends too early" : "the JSON is malformed");
  }
}

std::string json_text(const nlohmann::ordered_json& json, const CameraRecord& record) {
  try {
    return json.dump();
  } catch (const Json::exception&) {
    throw InputError("JSON cannot hold the name " + in_quotes(record.name) + " (" + record.place +
                     "), which is not UTF-8: rename the image");
  }
}

bool JsonEntry::has(const char* key) const {
  if (!value_->is_object()) fail("is not an object");
  return value_->contains(key);
}

JsonEntry JsonEntry::at(const char* key) const {
  if (!has(key)) fail(std::string("has no ") + key);
  return {(*value_)[key], *source_, path_ + (path_.empty() ? "" : ".") + key};
}

JsonEntry JsonEntry::at(std::size_t index) const {
  if (!value_->is_array() || index >= value_->size())
    fail("has no element " + std::to_string(index));
  return {(*value_)[index], *source_, path_ + '[' + std::to_string(index) + ']'};
}

std::vector<JsonEntry> JsonEntry::elements() const {
  if (value_->is_string() && value_->get_ref<const std::string&>().empty()) return {};
  if (!value_->is_array()) fail("is not a list");
  std::vector<JsonEntry> elements;
  for (std::size_t i = 0; i < value_->size(); ++i) elements.push_back(at(i));
  return elements;
}

double JsonEntry::number() const {
  std::optional<double> number;
  if (value_->is_number()) number = value_->get<double>();
  if (value_->is_string()) number = number_in<double>(value_->get_ref<const std::string&>());
  if (!number || !std::isfinite(*number)) fail("is not a finite number");
  return *number;
}

double JsonEntry::number(const char* key, double otherwise) const {
  return has(key) ? at(key).number() : otherwise;
}

std::vector<double> JsonEntry::numbers(std::size_t count) const {
  const std::vector<JsonEntry> entries = elements();
  if (entries.size() != count)
    fail("has " + std::to_string(entries.size()) + " elements instead of " + std::to_string(count));
  std::vector<double> numbers;
  for (const JsonEntry& entry : entries) numbers.push_back(entry.number());
  return numbers;
}

std::string JsonEntry::text() const {
  if (value_->is_string()) return value_->get<std::string>();
  if (!value_->is_number()) fail("is not a string");
  return value_->dump();
}

std::string JsonEntry::text(const char* key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
}

int JsonEntry::side() const {
  const double value = number();
  if (!(value >= 1 && value <= 1e9 && value == std::floor(value)))
    fail("is not a whole number of 1 or more");
  return static_cast<int>(value);
}

void JsonEntry::fail(const std::string& what) const {
  source_->fail((path_.empty() ? "the file" : path_) + ' ' + what);
}

}  // namespace transformesh
