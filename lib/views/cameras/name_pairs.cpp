#include "views/cameras/name_pairs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "io/streams/file_list.h"
#include "io/streams/source.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

using Stems = std::vector<std::string>;

Stems plain_stems(const NamedFiles& files) {
  Stems stems;
  for (const std::string& path : files.paths) stems.push_back(stem_of(path));
  return stems;
}

/// Returns the stem with its folder relative to `root`, or the stem alone if the file is not in
/// `root`.
std::string stem_with_folder(std::string_view path, const std::string& root) {
  namespace fs = std::filesystem;
  if (!root.empty() && path.starts_with(root)) path.remove_prefix(root.size());
  path.remove_prefix(root.empty() ? 0 : std::min(path.find_first_not_of('/'), path.size()));
  const fs::path folder = fs::path(path).parent_path().lexically_normal();
  const bool leads_out = folder.is_absolute() || (!folder.empty() && *folder.begin() == "..");
  return leads_out ? stem_of(path) : (folder / stem_of(path)).string();
}

bool has_repeats(const Stems& stems) {
  return std::set<std::string>(stems.begin(), stems.end()).size() < stems.size();
}

Stems stems_with_folders(const NamedFiles& files) {
  Stems stems;
  for (const std::string& path : files.paths) stems.push_back(stem_with_folder(path, files.root));
  return stems;
}

/// Returns the last separator and the text after it, such as `-mask` of `dinoR0000-mask`. Returns
/// "" if that text contains a digit.
std::string_view suffix_of(std::string_view stem) {
  const std::size_t separator = stem.find_last_of("-_. ");
  if (separator == std::string_view::npos || separator == 0) return {};
  const std::string_view suffix = stem.substr(separator);
  return suffix.find_first_of("0123456789") == std::string_view::npos ? suffix : std::string_view();
}

Stems without_shared_suffix(Stems stems) {
  const std::string suffix(suffix_of(stems.front()));
  const bool is_shared = std::all_of(stems.begin(), stems.end(), [&](const std::string& stem) {
    return suffix_of(stem) == suffix;
  });
  if (!is_shared) return stems;
  for (std::string& stem : stems) stem.resize(stem.size() - suffix.size());
  return stems;
}

std::string label(const NamedFiles& files, std::size_t i) {
  return files.paths[i] + (files.places.empty() ? "" : " (" + files.places[i] + ")");
}

std::map<std::string, std::size_t> indices_of(const Stems& stems, const NamedFiles& files) {
  std::map<std::string, std::size_t> indices;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto [found, is_new] = indices.emplace(stems[i], i);
    if (is_new) continue;
    throw InputError(files.where + ": two " + files.kind + "s have the same name: " +
                     label(files, found->second) + " and " + label(files, i));
  }
  return indices;
}

std::string counts_text(const NamedFiles& first, const NamedFiles& second) {
  return counted(first.paths.size(), first.kind) + ", but " +
         counted(second.paths.size(), second.kind);
}

[[noreturn]] void fail_lonely(const NamedFiles& files, std::size_t i, const NamedFiles& others) {
  const bool is_count_equal = files.paths.size() == others.paths.size();
  throw InputError(
      label(files, i) + ": there is no " + others.kind + " of this name in " + others.where + ": " +
      (is_count_equal ? "either all names must agree, or none" : counts_text(files, others)));
}

/// Returns for each of `stems` the index of the equal stem in `second_stems`. Returns nothing if no
/// stem has an equal one. Throws InputError if only some have.
std::optional<std::vector<std::size_t>> pair_equal(const Stems& stems, const Stems& second_stems,
                                                   const NamedFiles& first,
                                                   const NamedFiles& second) {
  const auto first_indices = indices_of(stems, first);
  const auto second_indices = indices_of(second_stems, second);
  std::vector<std::size_t> partners;
  std::optional<std::size_t> lonely;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto found = second_indices.find(stems[i]);
    if (found != second_indices.end()) partners.push_back(found->second);
    if (found == second_indices.end() && !lonely) lonely = i;
  }
  if (partners.empty()) return {};
  if (lonely) fail_lonely(first, *lonely, second);
  for (std::size_t i = 0; i < second_stems.size(); ++i) {
    if (!first_indices.contains(second_stems[i])) fail_lonely(second, i, first);
  }
  return partners;
}

/// Returns the stems (file names without extension) of both lists. If each list contains the same
/// stem several times, all stems include their folders.
std::pair<Stems, Stems> comparable_stems(const NamedFiles& first, const NamedFiles& second) {
  const bool have_folders = has_repeats(plain_stems(first)) && has_repeats(plain_stems(second));
  return have_folders ? std::pair(stems_with_folders(first), stems_with_folders(second))
                      : std::pair(plain_stems(first), plain_stems(second));
}

/// Returns the indices of stems that are not in `others`, ascending.
std::vector<std::size_t> lonely_stems(const Stems& stems, const Stems& others) {
  const std::set<std::string> partners(others.begin(), others.end());
  std::vector<std::size_t> lonely;
  for (std::size_t i = 0; i < stems.size(); ++i)
    if (!partners.contains(stems[i])) lonely.push_back(i);
  return lonely;
}

Unpaired unpaired_of(const Stems& stems, const Stems& second_stems) {
  Unpaired unpaired{lonely_stems(stems, second_stems), lonely_stems(second_stems, stems)};
  unpaired.has_pairs = unpaired.first.size() < stems.size();
  return unpaired;
}

}  // namespace

std::vector<std::string> distinct_stems(const NamedFiles& files) {
  Stems stems = plain_stems(files);
  return has_repeats(stems) ? stems_with_folders(files) : stems;
}

Unpaired find_unpaired(const NamedFiles& first, const NamedFiles& second) {
  auto [stems, second_stems] = comparable_stems(first, second);
  if (stems.empty() || second_stems.empty()) return {};
  Unpaired unpaired = unpaired_of(stems, second_stems);
  if (unpaired.has_pairs) return unpaired;
  return unpaired_of(without_shared_suffix(stems), without_shared_suffix(second_stems));
}

std::vector<std::size_t> pair_by_name(const NamedFiles& first, const NamedFiles& second,
                                      bool names_must_agree) {
  const auto [stems, second_stems] = comparable_stems(first, second);
  if (stems.empty() || second_stems.empty()) throw InputError(counts_text(first, second));
  if (const auto pairs = pair_equal(stems, second_stems, first, second)) return *pairs;
  const auto short_pairs =
      pair_equal(without_shared_suffix(stems), without_shared_suffix(second_stems), first, second);
  if (short_pairs) return *short_pairs;
  if (names_must_agree) fail_lonely(first, 0, second);

  if (stems.size() != second_stems.size()) {
    throw InputError("there are " + counts_text(first, second) + " (" + first.where + ", " +
                     second.where + ")");
  }
  std::vector<std::size_t> in_order(stems.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  return in_order;
}

}  // namespace transformesh
