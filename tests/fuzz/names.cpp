// File names: their natural order, and which names pair up. The input has one name per line; the
// first half are cameras, the rest images.
#include <algorithm>

#include "fuzz/fuzz.h"
#include "io/streams/file_list.h"
#include "transformesh/errors.h"
#include "views/cameras/name_pairs.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

constexpr std::size_t most_names = 12;

std::vector<std::string> lines_of(std::string_view bytes) {
  std::vector<std::string> lines;
  while (!bytes.empty() && lines.size() < most_names) {
    const std::size_t length = std::min(bytes.find('\n'), bytes.size());
    lines.emplace_back(bytes.substr(0, length));
    bytes.remove_prefix(std::min(length + 1, bytes.size()));
  }
  return lines;
}

/// Checks for a strict weak order. Incomparable names may differ only in spelling.
void check_order(const std::vector<std::string>& names) {
  for (const std::string& a : names) {
    demand(!is_natural_less(a, a), "a name is less than itself");
    for (const std::string& b : names) {
      demand(!(is_natural_less(a, b) && is_natural_less(b, a)), "each is less than the other");
      for (const std::string& c : names)
        demand(!(is_natural_less(a, b) && is_natural_less(b, c)) || is_natural_less(a, c),
               "the order is not transitive");
    }
  }
}

void check_pairs(const std::vector<std::string>& names, bool names_must_agree) {
  const auto middle = names.begin() + static_cast<std::ptrdiff_t>(names.size() / 2);
  const NamedFiles first{"camera", "cameras", {names.begin(), middle}, {}};
  const NamedFiles second{"image", "images", {middle, names.end()}, {}};
  std::vector<std::size_t> partners;
  try {
    partners = pair_by_name(first, second, names_must_agree);
  } catch (const InputError&) {
    return;
  }
  demand(partners.size() == first.paths.size(), "a name without a partner");
  std::sort(partners.begin(), partners.end());
  for (std::size_t i = 0; i < partners.size(); ++i)
    demand(partners[i] == i, "two names with one partner");
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  const std::vector<std::string> names = lines_of(bytes);
  check_order(names);
  for (const bool names_must_agree : {false, true}) check_pairs(names, names_must_agree);
}
