/// Names what a format cannot hold, once each.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "tm/io/document.h"

namespace transformesh {

/// What a format other than PLY keeps of a document.
struct Keeps {
  std::string format;  ///< as messages call it: OFF
  std::vector<std::string_view> vertex_columns;
  std::vector<std::string_view> face_columns;
  bool comments = true;
};

std::vector<std::string> losses(const Document& document, const Keeps& keeps);

/// Whether all of these columns are there with one value per row.
bool has_columns(const Columns& columns, std::initializer_list<std::string_view> names);

}  // namespace transformesh
