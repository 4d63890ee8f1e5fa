/// Which files belong together, by their names.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

/// Files of one kind, with the words that messages have for them.
struct NamedFiles {
  std::string kind;                 ///< `image`, `silhouette`: with an s for several
  std::string where;                ///< as the user wrote it
  std::vector<std::string> paths;   ///< compared by their stems
  std::vector<std::string> places;  ///< of each, where names are read from a file; or empty
  std::string root = {};            ///< the folder in which paths begin, if they begin in one
};

/// The stems of the paths; where two are the same, as `left/0001` and `right/0001` of cameras that
/// share a numbering, all with their folders below the root.
std::vector<std::string> distinct_stems(const NamedFiles& files);

/// For each of `first` the index of its partner among `second`: that of the same stem, or
/// distinct stem where stems are the same on both sides. A suffix
/// that all names of a side share, such as -mask or _P, counts only where no name has a partner
/// with it. Where none has a partner at all, both are taken as they are, in order, unless names
/// must agree.
///
/// Throws InputError where the numbers of files differ, where only some names have a partner (they
/// might be numbered from another start, which would silently shift every camera), and where two
/// names of a side are the same.
std::vector<std::size_t> pair_by_name(const NamedFiles& first, const NamedFiles& second,
                                      bool names_must_agree);

}  // namespace transformesh
