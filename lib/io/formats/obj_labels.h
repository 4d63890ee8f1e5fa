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

/// True if OBJ expresses the comment as a statement.
bool is_obj_comment(const std::string& comment);

/// Collects one kind of label while a file is read.
class ObjLabelReader {
 public:
  /// Sets the label of the rows from `row` on.
  void set(std::uint32_t row, std::string_view name);
  /// Adds the column and the comments if any row has a label.
  void move_into(const ObjLabelKind& kind, std::uint32_t rows, Document& document);

 private:
  /// First row with a label, and index of the label's name.
  std::vector<std::pair<std::uint32_t, std::size_t>> starts_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// Returns the names, as stated in the comments, of the numbers in the column of `kind`.
std::map<long, std::string> obj_label_names(const ObjLabelKind& kind,
                                            const std::vector<std::string>& comments);

/// Renumbers the labels of `other` before it is appended to `all`. Equal names get equal numbers; a
/// number that has another name in `all` is replaced by a free number.
void separate_obj_labels(const Document& all, Document& other);
/// True if separate_obj_labels() is needed: both documents have labels of one kind, and some labels
/// have names.
bool have_obj_labels(const Document& all, const Document& other);

}  // namespace transformesh
