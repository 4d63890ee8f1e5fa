/// Labels that OBJ statements (`g`, `o`, `usemtl`) give to the following faces: numbers in face
/// columns, and comments such as `tm:group 1 wing` for names that are not numbers.
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

/// Removes characters that would end the name or the line.
std::string as_obj_name(std::string_view text);

/// True if the comment is one that OBJ expresses as a statement.
bool is_obj_comment(const std::string& comment);

/// Collects one kind of label while a file is read.
class ObjLabelReader {
 public:
  /// Sets the label of the rows from `row` on.
  void set(std::uint32_t row, std::string_view name);
  /// Adds the column and the comments if any row has a label.
  void move_into(const ObjLabelKind& kind, std::uint32_t rows, Document& document);

 private:
  std::vector<std::pair<std::uint32_t, std::size_t>> starts_;  ///< first row, and index of its name
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// Returns the names of the numbers in that column, from the comments.
std::map<long, std::string> obj_label_names(const ObjLabelKind& kind,
                                            const std::vector<std::string>& comments);

/// Renumbers the labels of `other` before it is appended to `all`. Equal names get equal numbers; a
/// number that has another name in `all` is replaced by a free one.
void separate_obj_labels(const Document& all, Document& other);
/// True if separate_obj_labels() is needed: both have labels of a kind, and some have names.
bool have_obj_labels(const Document& all, const Document& other);

}  // namespace transformesh
