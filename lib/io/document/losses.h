/// Lists the columns and comments that a file format cannot store, once each.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

/// The parts of a document that a file format other than PLY stores.
struct Keeps {
  std::string format;  ///< name of the format in messages, such as OFF
  std::vector<std::string_view> vertex_columns;
  std::vector<std::string_view> face_columns;
  /// Largest number of comments that the format stores.
  std::size_t comments = static_cast<std::size_t>(-1);
};

std::vector<std::string> losses(const Document& document, const Keeps& keeps);

/// True if a program of this suite wrote the comment (command line, reference edge). Every output
/// gets new comments of this kind, so dropping such a comment needs no note.
bool is_own_comment(const std::string& comment);

/// True if all columns with these names exist, are not lists, and contain finite numbers only.
/// Formats other than PLY store no other columns.
bool has_columns(const Columns& columns, std::initializer_list<std::string_view> names);

}  // namespace transformesh
