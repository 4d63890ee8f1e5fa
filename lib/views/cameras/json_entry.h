/// Values of JSON files (RFC 8259) of cameras. Each value knows its path in the file, such as
/// `frames[3].fl_x`, for messages.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "raster/camera_record.h"

namespace transformesh {

/// Parses an object. Skips its members `structure` and `control_points`, which hold points and are
/// large. Throws InputError with the byte if the text is malformed.
nlohmann::json parse_camera_json(const Source& source);

/// Returns the JSON as one line. Throws InputError, naming `record`, if text in it is not UTF-8.
std::string json_text(const nlohmann::ordered_json& json, const CameraRecord& record);

/// A value in a JSON file. The parsed JSON and its source must outlive the object. All members
/// throw InputError, naming the file and the path, if the value is of another kind.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& value, const Source& source, std::string path = {})
      : value_(&value), source_(&source), path_(std::move(path)) {}

  bool has(const char* key) const;
  JsonEntry at(const char* key) const;
  JsonEntry at(std::size_t index) const;
  /// Returns the elements of an array. Empty text counts as an empty array, because Meshroom writes
  /// it so.
  std::vector<JsonEntry> elements() const;

  /// Returns a finite number. Meshroom writes numbers as text.
  double number() const;
  double number(const char* key, double otherwise) const;
  /// Returns a list of `count` numbers.
  std::vector<double> numbers(std::size_t count) const;
  /// Returns text; a number is converted to text, so that identifiers can be either.
  std::string text() const;
  std::string text(const char* key, const std::string& otherwise) const;
  bool is_list() const { return value_->is_array(); }
  bool is_true() const { return value_->is_boolean() && value_->get<bool>(); }
  /// Returns a whole number of 1 to 1e9, such as the width of an image.
  int side() const;

  /// Returns the name of the file and the path.
  std::string place() const { return source_->name + ' ' + path_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const nlohmann::json* value_;
  const Source* source_;
  std::string path_;
};

}  // namespace transformesh
