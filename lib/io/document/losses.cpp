#include "io/document/losses.h"

#include <algorithm>
#include <cmath>

#include "io/streams/source.h"
#include "support/counted.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

class Losses {
 public:
  explicit Losses(const std::string& format) : format_(lower_case(format)) {
    ending_ = " cannot be stored in " + format + ", dropped";
  }

  void add(const std::string& what) { notes_.push_back(format_ + ": " + what + ending_); }

  void add_columns(const Columns& columns, const std::vector<std::string_view>& kept,
                   const std::string& element) {
    for (const Column& column : columns.columns) {
      const bool is_kept = std::find(kept.begin(), kept.end(), column.name) != kept.end();
      if (!is_kept) add(element + " property " + in_quotes(column.name));
    }
  }

  std::vector<std::string> take() { return std::move(notes_); }

 private:
  std::string format_;
  std::string ending_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> losses(const Document& document, const Keeps& keeps) {
  Losses losses(keeps.format);
  losses.add_columns(document.mesh.vertex_columns, keeps.vertex_columns, "vertex");
  losses.add_columns(document.mesh.face_columns, keeps.face_columns, "face");
  for (const OtherElement& other : document.other_elements) {
    losses.add("element " + in_quotes(other.name));
  }
  const std::vector<std::string>& comments = document.style.comments;
  const auto own = std::count_if(comments.begin(), comments.end(), is_own_comment);
  const std::size_t others = comments.size() - static_cast<std::size_t>(own);
  if (others > keeps.comments) losses.add(counted(others - keeps.comments, "comment"));
  if (!document.style.obj_info.empty()) losses.add("obj_info");
  return losses.take();
}

bool is_own_comment(const std::string& comment) {
  return comment.rfind("tm-", 0) == 0 || comment.rfind("tm:", 0) == 0;
}

bool has_columns(const Columns& columns, std::initializer_list<std::string_view> names) {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
    const Column* column = columns.find(name);
    return column && !column->list_count_type &&
           std::all_of(column->values.begin(), column->values.end(),
                       [](double value) { return std::isfinite(value); });
  });
}

}  // namespace transformesh
