#include "io/document/scalar.h"

#include <array>

namespace transformesh {
namespace {

struct ScalarNames {
  Scalar type;
  std::string_view plain;
  std::string_view sized;
};

constexpr std::array<ScalarNames, 8> all_scalars{{
    {Scalar::int8, "char", "int8"},
    {Scalar::uint8, "uchar", "uint8"},
    {Scalar::int16, "short", "int16"},
    {Scalar::uint16, "ushort", "uint16"},
    {Scalar::int32, "int", "int32"},
    {Scalar::uint32, "uint", "uint32"},
    {Scalar::float32, "float", "float32"},
    {Scalar::float64, "double", "float64"},
}};

bool holds(Scalar type, std::uint64_t largest) {
  return with_scalar(type, [&](auto zero) {
    using T = decltype(zero);
    return static_cast<double>(std::numeric_limits<T>::max()) >= static_cast<double>(largest);
  });
}

}  // namespace

std::string_view scalar_name(Scalar type, bool sized) {
  for (const ScalarNames& names : all_scalars) {
    if (names.type == type) return sized ? names.sized : names.plain;
  }
  return {};
}

std::optional<Scalar> scalar_of_name(std::string_view name) {
  for (const ScalarNames& names : all_scalars) {
    if (name == names.plain || name == names.sized) return names.type;
  }
  return {};
}

Scalar widened(Scalar type, std::uint64_t largest) {
  if (holds(type, largest)) return type;
  for (const Scalar wider : {Scalar::uint8, Scalar::int16, Scalar::uint16, Scalar::int32}) {
    if (byte_size(wider) > byte_size(type) && holds(wider, largest)) return wider;
  }
  return Scalar::uint32;
}

}  // namespace transformesh
