#include "io/formats/obj_labels.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "io/document/scalar.h"

namespace transformesh {
namespace {

/// Returns the number that a label name denotes, or nothing if the name is not a number. Returns
/// nothing for names such as `007`, which would be written as `7`.
std::optional<std::int32_t> number_named(std::string_view name) {
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = error == std::errc() && end == name.data() + name.size();
  return is_number && std::to_string(number) == name ? std::optional(number) : std::nullopt;
}

std::string comment_start(const ObjLabelKind& kind) {
  return "tm:" + std::string(kind.column) + ' ';
}

std::string comment_of(const ObjLabelKind& kind, long number, const std::string& name) {
  return comment_start(kind) + std::to_string(number) + ' ' + name;
}

/// Generates the numbers from 1 that are not in a given set, in ascending order.
class FreeNumbers {
 public:
  explicit FreeNumbers(std::set<long> taken) : taken_(std::move(taken)) {}
  long take() {
    while (taken_.contains(next_)) ++next_;
    return next_++;
  }

 private:
  std::set<long> taken_;
  long next_ = 1;
};

std::vector<long> label_numbers(const std::vector<std::string>& names, std::string_view none) {
  std::set<long> taken;
  for (const std::string& name : names)
    if (const auto number = number_named(name)) taken.insert(*number);
  FreeNumbers free(std::move(taken));
  std::vector<long> numbers;
  for (const std::string& name : names) {
    const auto number = number_named(name);
    numbers.push_back(name.empty() || name == none ? 0 : number ? *number : free.take());
  }
  return numbers;
}

const Column* labels_in(const Document& document, const ObjLabelKind& kind) {
  const Column* column = document.mesh.face_columns.find(kind.column);
  const bool are_numbers =
      column != nullptr && !column->list_count_type && !is_floating(column->type);
  return are_numbers ? column : nullptr;
}

/// Parses a label comment, such as `tm:group 1 wing`, into number and name. Returns nothing for
/// other comments, and if the name is itself a number.
std::optional<std::pair<long, std::string>> label_in(const std::string& comment,
                                                     const ObjLabelKind& kind) {
  const std::string start = comment_start(kind);
  if (!comment.starts_with(start)) return std::nullopt;
  const std::size_t end = std::min(comment.find(' ', start.size()), comment.size());
  const auto number =
      number_named(std::string_view(comment).substr(start.size(), end - start.size()));
  std::string name = as_obj_name(std::string_view(comment).substr(end));
  const bool is_name = !name.empty() && name != kind.none && !number_named(name);
  if (!number || *number == 0 || !is_name) return std::nullopt;
  return std::pair(long{*number}, std::move(name));
}

/// Returns all label numbers of a document with their names. A label without a name has its number
/// as name.
std::map<long, std::string> called(const Document& document, const ObjLabelKind& kind) {
  std::map<long, std::string> names = obj_label_names(kind, document.style.comments);
  for (const double value : labels_in(document, kind)->values)
    names.emplace(static_cast<long>(value), std::to_string(static_cast<long>(value)));
  return names;
}

/// Returns new numbers for the labels of a later document, by their old numbers. A later label with
/// the name of an earlier label gets the earlier number. If the number of a later label has another
/// name in the earlier document, the label gets a free number.
std::map<long, long> changes_between(const std::map<long, std::string>& earlier,
                                     const std::map<long, std::string>& later) {
  std::map<std::string, long> numbers;
  std::set<long> taken;
  for (const auto& [number, name] : earlier) numbers.emplace(name, number);
  for (const auto* labels : {&earlier, &later})
    for (const auto& [number, name] : *labels) taken.insert(number);
  FreeNumbers free(std::move(taken));
  std::map<long, long> changes;
  for (const auto& [number, name] : later) {
    const auto same = numbers.find(name);
    if (same != numbers.end()) {
      changes[number] = same->second;
    } else if (earlier.contains(number)) {
      changes[number] = free.take();
    }
  }
  return changes;
}

}  // namespace

std::string as_obj_name(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (c == '#' || c == '\\') c = '_';
    if ((c >= '\0' && c < ' ')) c = ' ';
  }
  const std::size_t first = std::min(name.find_first_not_of(' '), name.size());
  return name.substr(first, name.find_last_not_of(' ') + 1 - first);
}

bool is_obj_comment(const std::string& comment) {
  return comment.starts_with(obj_library_comment) ||
         std::any_of(obj_label_kinds.begin(), obj_label_kinds.end(), [&](const ObjLabelKind& kind) {
           return comment.starts_with(comment_start(kind));
         });
}

void ObjLabelReader::set(std::uint32_t row, std::string_view name) {
  const auto [place, is_new] = places_.emplace(as_obj_name(name), names_.size());
  if (is_new) names_.push_back(place->first);
  if (!starts_.empty() && starts_.back().first == row) starts_.pop_back();
  starts_.emplace_back(row, place->second);
}

void ObjLabelReader::move_into(const ObjLabelKind& kind, std::uint32_t rows, Document& document) {
  std::erase_if(starts_, [&](const auto& start) { return start.first >= rows; });
  const std::vector<long> numbers = label_numbers(names_, kind.none);
  if (std::none_of(starts_.begin(), starts_.end(),
                   [&](const auto& start) { return numbers[start.second] != 0; }))
    return;
  Column& column = document.mesh.face_columns.get(kind.column, Scalar::int32, rows);
  std::set<std::size_t> used;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const auto [first, name] = starts_[i];
    const std::uint32_t last = i + 1 < starts_.size() ? starts_[i + 1].first : rows;
    const auto values = column.values.begin();
    std::fill(values + first, values + last, static_cast<double>(numbers[name]));
    used.insert(name);
  }
  for (const std::size_t name : used)
    if (numbers[name] != 0 && !number_named(names_[name]))
      document.style.comments.push_back(comment_of(kind, numbers[name], names_[name]));
}

std::map<long, std::string> obj_label_names(const ObjLabelKind& kind,
                                            const std::vector<std::string>& comments) {
  std::map<long, std::string> names;
  for (const std::string& comment : comments)
    if (const auto label = label_in(comment, kind)) names.insert(*label);
  return names;
}

bool have_obj_labels(const Document& all, const Document& other) {
  const auto has_names = [](const Document& document) {
    return std::any_of(document.style.comments.begin(), document.style.comments.end(),
                       is_obj_comment);
  };
  const bool share_a_column =
      std::any_of(obj_label_kinds.begin(), obj_label_kinds.end(), [&](const ObjLabelKind& kind) {
        return labels_in(all, kind) != nullptr && labels_in(other, kind) != nullptr;
      });
  return share_a_column && (has_names(all) || has_names(other));
}

void separate_obj_labels(const Document& all, Document& other) {
  for (const ObjLabelKind& kind : obj_label_kinds) {
    if (labels_in(all, kind) == nullptr || labels_in(other, kind) == nullptr) continue;
    const std::map<long, long> changes = changes_between(called(all, kind), called(other, kind));
    for (double& value : other.mesh.face_columns.find(kind.column)->values)
      if (const auto to = changes.find(static_cast<long>(value)); to != changes.end())
        value = static_cast<double>(to->second);
    for (std::string& comment : other.style.comments) {
      const auto label = label_in(comment, kind);
      if (!label) continue;
      const auto to = changes.find(label->first);
      if (to != changes.end()) comment = comment_of(kind, to->second, label->second);
    }
  }
}

}  // namespace transformesh
