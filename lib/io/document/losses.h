/// Names what a format cannot hold, once each.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

/// What a format other than PLY keeps of a document.
struct Keeps {
  std::string format;  ///< as messages call it: OFF
  std::vector<std::string_view> vertex_columns;
  std::vector<std::string_view> face_columns;
  std::size_t comments = static_cast<std::size_t>(-1);  ///< how many it can hold
};

std::vector<std::string> losses(const Document& document, const Keeps& keeps);

/// Whether a program of this suite wrote the comment: options and the reference edge. Every file
/// gets them anew, and nobody misses them.
bool is_own_comment(const std::string& comment);

/// Whether all of these columns are there and no lists, and all their numbers finite: formats other
/// than PLY have no others.
bool has_columns(const Columns& columns, std::initializer_list<std::string_view> names);

}  // namespace transformesh
