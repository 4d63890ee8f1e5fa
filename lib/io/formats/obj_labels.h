/// What statements of OBJ call the faces behind them, as numbers in face columns and, for names
/// that are no numbers, comments such as `tm:group 1 wing`.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

struct ObjLabelKind {
  std::string_view keyword, column, none;
};
inline constexpr std::array<ObjLabelKind, 3> obj_label_kinds{
    {{"o", "object", "0"}, {"g", "group", "default"}, {"usemtl", "material", "0"}}};
inline constexpr std::string_view obj_library_comment = "tm:mtllib ";

/// Without what would end the name or the line.
std::string as_obj_name(std::string_view text);

/// Whether the comment is one of those that OBJ has statements for.
bool is_obj_comment(const std::string& comment);

/// Gathers one kind of label while a file is read.
class ObjLabelReader {
 public:
  /// The label of the rows from this one on.
  void set(std::uint32_t row, std::string_view name);
  /// Adds the column and the comments, where a row has a label.
  void move_into(const ObjLabelKind& kind, std::uint32_t rows, Document& document);

 private:
  std::vector<std::pair<std::uint32_t, std::size_t>> starts_;  ///< a row, and the name's place
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// The names of the numbers in that column, from the comments.
std::map<long, std::string> obj_label_names(const ObjLabelKind& kind,
                                            const std::vector<std::string>& comments);

/// Before `other` is appended to `all`: gives its labels the numbers that `all` has for their
/// names, and others that `all` calls otherwise numbers that are free.
void separate_obj_labels(const Document& all, Document& other);
/// Whether that is needed: both have labels of a kind, and some have names.
bool have_obj_labels(const Document& all, const Document& other);

}  // namespace transformesh
