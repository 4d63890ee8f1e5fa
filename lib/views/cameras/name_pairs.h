/// Pairs files of two lists by their names, such as images and masks.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

/// A list of files, such as all images, with the words that describe them in messages.
struct NamedFiles {
  std::string kind;   ///< singular noun, such as `image` or `silhouette`
  std::string where;  ///< the file, folder or pattern as the user wrote it
  /// Paths of the files; only their stems (names without folder and extension) are compared.
  std::vector<std::string> paths;
  /// If `paths` are names that were read from a file: that file and the line of each name.
  /// Otherwise empty.
  std::vector<std::string> places;
  std::string root = {};  ///< the folder to which all paths belong, if there is one
};

/// Returns the stems of the paths. If two stems are equal, as for `left/0001` and `right/0001`,
/// returns all stems with their folders, relative to `files.root`.
std::vector<std::string> distinct_stems(const NamedFiles& files);

/// Indices of files without a partner in the other list, ascending.
struct Unpaired {
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
  bool has_pairs = false;  ///< true if at least one file has a partner
};

/// Finds files without a partner by the first two rules of pair_by_name().
Unpaired find_unpaired(const NamedFiles& first, const NamedFiles& second);

/// Returns for each file of `first` the index of its partner in `second`. Applies these rules, in
/// this order:
/// 1. Files with the same stem are partners. If both lists have repeated stems, distinct_stems()
///    are compared.
/// 2. If no file has a partner, suffixes that all stems of a list have, such as -mask or _P, are
///    ignored.
/// 3. If still no file has a partner, files are paired in their order, unless `names_must_agree`.
///
/// Throws InputError if the numbers of files differ, if two names of a list are equal, or if only
/// some names have a partner. The reason for the last condition is that one list may be numbered
/// from 0 and the other one from 1. Pairs by order would then assign a wrong image to every camera.
std::vector<std::size_t> pair_by_name(const NamedFiles& first, const NamedFiles& second,
                                      bool names_must_agree);

}  // namespace transformesh
