/// Access to optional values and variants in results of CGAL. Their types are those of the standard
/// library since CGAL 6, and those of Boost before.
#pragma once

#include <CGAL/version.h>

#include <boost/optional.hpp>
#include <boost/variant.hpp>
#include <optional>
#include <type_traits>
#include <variant>

namespace transformesh::test {

template <class T>
using CgalOptional =
    std::conditional_t<(CGAL_VERSION_NR < 1060000000), boost::optional<T>, std::optional<T>>;

/// Returns a pointer to the T in the variant. Returns null if the variant holds another type.
template <class T, class... Types>
const T* alternative(const boost::variant<Types...>& result) {
  return boost::get<T>(&result);
}
template <class T, class... Types>
const T* alternative(const std::variant<Types...>& result) {
  return std::get_if<T>(&result);
}

}  // namespace transformesh::test
