#include "tm/views/name_pairs.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "tm/io/source.h"
#include "tm/support/error.h"
#include "tm/views/file_list.h"

namespace transformesh {
namespace {

std::vector<std::string> stems_of(const NamedFiles& files) {
  std::vector<std::string> stems;
  for (const std::string& path : files.paths) stems.push_back(stem_of(path));
  return stems;
}

// `-mask` of `dinoR0000-mask`: from the last separator, unless it holds a digit.
std::string_view suffix_of(std::string_view stem) {
  const std::size_t separator = stem.find_last_of("-_. ");
  if (separator == std::string_view::npos || separator == 0) return {};
  const std::string_view suffix = stem.substr(separator);
  return suffix.find_first_of("0123456789") == std::string_view::npos ? suffix : std::string_view();
}

std::vector<std::string> without_shared_suffix(std::vector<std::string> stems) {
  const std::string suffix(suffix_of(stems.front()));
  const bool is_shared = std::all_of(stems.begin(), stems.end(), [&](const std::string& stem) {
    return suffix_of(stem) == suffix;
  });
  if (!is_shared) return stems;
  for (std::string& stem : stems) stem.resize(stem.size() - suffix.size());
  return stems;
}

std::map<std::string, std::size_t> indices_of(const std::vector<std::string>& stems,
                                              const NamedFiles& files) {
  std::map<std::string, std::size_t> indices;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto [found, is_new] = indices.emplace(stems[i], i);
    if (is_new) continue;
    throw InputError(files.where + ": two " + files.kind + "s have the same name: " +
                     files.paths[found->second] + " and " + files.paths[i]);
  }
  return indices;
}

[[noreturn]] void fail_without_partner(const std::string& path, const NamedFiles& files) {
  throw InputError(path + ": there is no " + files.kind + " of this name in " + files.where +
                   ": names have to agree, or to have nothing in common");
}

/// Pairs of equal names; none where no name has a partner.
std::optional<std::vector<std::size_t>> pair_equal(const std::vector<std::string>& stems,
                                                   const std::vector<std::string>& second_stems,
                                                   const NamedFiles& first,
                                                   const NamedFiles& second) {
  indices_of(stems, first);
  const auto indices = indices_of(second_stems, second);
  std::vector<std::size_t> partners;
  std::optional<std::size_t> lonely;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto found = indices.find(stems[i]);
    if (found != indices.end()) partners.push_back(found->second);
    if (found == indices.end() && !lonely) lonely = i;
  }
  if (partners.empty()) return {};
  if (lonely) fail_without_partner(first.paths[*lonely], second);
  return partners;
}

}  // namespace

std::vector<std::size_t> pair_by_name(const NamedFiles& first, const NamedFiles& second,
                                      bool names_must_agree) {
  if (first.paths.size() != second.paths.size()) {
    throw InputError("the counts differ: " + counted(first.paths.size(), first.kind) + " in " +
                     first.where + ", but " + counted(second.paths.size(), second.kind) + " in " +
                     second.where);
  }
  if (first.paths.empty()) return {};
  const auto stems = stems_of(first);
  const auto second_stems = stems_of(second);
  if (const auto pairs = pair_equal(stems, second_stems, first, second)) return *pairs;
  const auto short_pairs =
      pair_equal(without_shared_suffix(stems), without_shared_suffix(second_stems), first, second);
  if (short_pairs) return *short_pairs;
  if (names_must_agree) fail_without_partner(first.paths.front(), second);
  std::vector<std::size_t> in_order(first.paths.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  return in_order;
}

}  // namespace transformesh
