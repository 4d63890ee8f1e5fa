/// Reads values of JSON files (RFC 8259) that describe cameras. Each value stores its path in the
/// file, such as `frames[3].fl_x`, for error messages.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "raster/camera_record.h"

namespace transformesh {

/// Parses a JSON file. Skips the members `structure` and `control_points`, which contain points and
/// are large. Throws InputError, with the position of the error in bytes, if the text is malformed.
nlohmann::json parse_camera_json(const Source& source);

/// JSON to be written, whose members keep their order.
using OrderedJson = nlohmann::ordered_json;

/// Returns the JSON as one line of text. Throws InputError, with the name of `record`, if a string
/// in it is not UTF-8.
std::string json_text(const OrderedJson& json, const CameraRecord& record);

/// A value in a JSON file. The parsed JSON and its source must outlive the object. All members
/// throw InputError, with the file and the path, if the value has another type than they return.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& value, const Source& source, std::string path = {})
      : value_(&value), source_(&source), path_(std::move(path)) {}

  bool has(const char* key) const;
  JsonEntry at(const char* key) const;
  JsonEntry at(std::size_t index) const;
  /// Returns the elements of an array. An empty string counts as an empty array, because Meshroom
  /// writes it instead of an array.
  std::vector<JsonEntry> elements() const;

  /// Returns a finite number. Also converts a string to a number, because Meshroom writes numbers
  /// as strings.
  double number() const;
  double number(const char* key, double otherwise) const;
  /// Returns the numbers of an array, which must have `count` elements.
  std::vector<double> numbers(std::size_t count) const;
  /// Returns a string. Converts a number to a string, because identifiers may be strings or
  /// numbers.
  std::string text() const;
  std::string text(const char* key, const std::string& otherwise) const;
  bool is_list() const { return value_->is_array(); }
  bool is_true() const { return value_->is_boolean() && value_->get<bool>(); }
  /// Returns an integer between 1 and 1e9, such as the width of an image.
  int side() const;

  /// Returns the name of the file and the path of the value in the file.
  std::string place() const { return source_->name + ' ' + path_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const nlohmann::json* value_;
  const Source* source_;
  std::string path_;
};

}  // namespace transformesh
