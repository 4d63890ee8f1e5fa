#include "io/comments.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"

namespace transformesh {
namespace {

/// Number of lines that add_provenance() keeps. Without a limit, the header of a mesh would grow in
/// a loop of programs.
constexpr std::size_t provenance_lines_kept = 20;
constexpr std::string_view reference_edge_key = "tm:reference-edge";
constexpr std::string_view planarity_key = "tm:planarity";

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// True for lines such as `tm-name 1.2.3`, optionally followed by a space and more text.
bool is_provenance(const std::string& comment) {
  if (!comment.starts_with("tm-")) return false;
  const std::size_t name_end = comment.find(' ');
  if (name_end == std::string::npos) return false;
  const std::size_t version_end = std::min(comment.find(' ', name_end + 1), comment.size());
  const std::string version = comment.substr(name_end + 1, version_end - name_end - 1);
  const auto dots = std::count(version.begin(), version.end(), '.');
  const auto digits = std::count_if(version.begin(), version.end(), is_digit);
  return dots == 2 && digits >= 3 && dots + digits == static_cast<long>(version.size());
}

bool has_key(const std::string& comment, std::string_view key) {
  return comment == key || comment.starts_with(std::string(key) + ' ');
}

bool is_reference_edge(const std::string& comment) { return has_key(comment, reference_edge_key); }

bool is_planarity(const std::string& comment) { return has_key(comment, planarity_key); }

std::optional<double> length_in(const std::string& comment, std::string_view key) {
  const std::string text = comment.substr(std::min(comment.size(), key.size() + 1));
  const auto length = number_in<double>(text);
  return length && std::isfinite(*length) && *length > 0 ? length : std::nullopt;
}

}  // namespace

void add_provenance(std::vector<std::string>& comments, const std::string& line) {
  comments.push_back(line);
  const auto count = std::count_if(comments.begin(), comments.end(), is_provenance);
  auto surplus = count - static_cast<long>(provenance_lines_kept);
  const auto drop = [&surplus](const std::string& comment) {
    return surplus > 0 && is_provenance(comment) && surplus-- > 0;
  };
  std::vector<std::string> kept;
  for (std::string& comment : comments) {
    if (!drop(comment)) kept.push_back(std::move(comment));
  }
  comments = std::move(kept);
}

std::optional<double> reference_edge_of(const std::vector<std::string>& comments) {
  const auto last = std::find_if(comments.rbegin(), comments.rend(), is_reference_edge);
  if (last == comments.rend()) return std::nullopt;
  if (const auto length = length_in(*last, reference_edge_key)) return length;
  throw InputError(ErrorKind::bad_reference_edge,
                   "the comment '" + *last + "' does not hold a positive length");
}

std::size_t drop_bad_reference_edges(std::vector<std::string>& comments) {
  return std::erase_if(comments, [](const std::string& comment) {
    return is_reference_edge(comment) && !length_in(comment, reference_edge_key);
  });
}

void set_reference_edge(std::vector<std::string>& comments, double length) {
  const std::string line = std::string(reference_edge_key) + ' ' + shortest_text(length);
  const auto first = std::find_if(comments.begin(), comments.end(), is_reference_edge);
  if (first == comments.end()) {
    comments.push_back(line);
    return;
  }
  *first = line;
  comments.erase(std::remove_if(first + 1, comments.end(), is_reference_edge), comments.end());
}

double planarity_of(const std::vector<std::string>& comments) {
  double largest = 0;
  for (const std::string& comment : comments)
    if (is_planarity(comment))
      largest = std::max(largest, length_in(comment, planarity_key).value_or(0));
  return largest;
}

void add_planarity(std::vector<std::string>& comments, double movement) {
  const double sum = planarity_of(comments) + movement;
  std::erase_if(comments, is_planarity);
  if (sum > 0) comments.push_back(std::string(planarity_key) + ' ' + shortest_text(sum));
}

void scale_lengths(std::vector<std::string>& comments, double factor) {
  if (const auto edge = reference_edge_of(comments)) set_reference_edge(comments, *edge * factor);
  if (const double planarity = planarity_of(comments); planarity > 0) {
    std::erase_if(comments, is_planarity);
    add_planarity(comments, planarity * factor);
  }
}

}  // namespace transformesh
