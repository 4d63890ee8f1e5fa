/// Labels of faces by the OBJ statements `g`, `o` and `usemtl`, which apply to the following faces.
/// Labels are numbers in face columns. Comments such as `tm:group 1 wing` store names that are not
/// numbers.
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

/// Replaces characters that would end the name or the line in OBJ, and removes surrounding blanks.
std::string as_obj_name(std::string_view text);

/// True if OBJ files express the comment as a statement, such as `mtllib` or `g`.
bool is_obj_comment(const std::string& comment);

/// Collects the labels of one kind (such as groups) while an OBJ file is read.
class ObjLabelReader {
 public:
  /// Sets the label of faces (rows) from `row` on.
  void set(std::uint32_t row, std::string_view name);
  /// Adds the face column of this kind of label, and comments with names, if any row has a label.
  void move_into(const ObjLabelKind& kind, std::uint32_t rows, Document& document);

 private:
  /// For each label statement, the first row to which it applies and the index of the label's name
  /// in `names_`.
  std::vector<std::pair<std::uint32_t, std::size_t>> starts_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

/// Returns the names of label numbers of this kind, as stated in the comments.
std::map<long, std::string> obj_label_names(const ObjLabelKind& kind,
                                            const std::vector<std::string>& comments);

/// Renumbers the labels of `other` before it is appended to `all`. Labels with equal names get
/// equal numbers. A number that has another name in `all` is replaced by a free number.
void separate_obj_labels(const Document& all, Document& other);
/// True if separate_obj_labels() must be called: both documents have labels of the same kind, and
/// some of these labels have names.
bool have_obj_labels(const Document& all, const Document& other);

}  // namespace transformesh
