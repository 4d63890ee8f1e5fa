#include "io/formats/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "io/document/scalar_bytes.h"
#include "support/counted.h"

namespace transformesh {
namespace {

/// Calls f with a zero of the C++ type for a component type (a number) of the glTF standard.
/// Returns false for numbers that are no component type.
template <class Function>
bool with_component(std::size_t type, const Function& f) {
  switch (type) {
    case 5120:
      return f(std::int8_t{}), true;
    case 5121:
      return f(std::uint8_t{}), true;
    case 5122:
      return f(std::int16_t{}), true;
    case 5123:
      return f(std::uint16_t{}), true;
    case 5125:
      return f(std::uint32_t{}), true;
    case 5126:
      return f(float{}), true;
    default:
      return false;
  }
}

/// Converts a component to double. Normalized integers are converted as in section 3.6.2.2 of the
/// standard: the least and the second least value of a signed type both become -1.
template <class T>
double value_of(T stored, bool is_normalized) {
  const auto value = static_cast<double>(stored);
  if (std::is_floating_point_v<T> || !is_normalized) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

class AccessorReader {
 public:
  AccessorReader(const GltfFile& file, std::size_t number, std::size_t most)
      : file_(file),
        entry_(file.element("accessors", number)),
        name_("accessor " + std::to_string(number)) {
    count_ = file_.whole(entry_, "count", name_);
    if (count_ > most) file_.fail(name_ + " has " + counted(count_, "element") + ", too many");
    numbers_.width = width();
    type_ = file_.whole(entry_, "componentType", name_);
    const auto normalized = entry_.find("normalized");
    is_normalized_ = normalized != entry_.end() && normalized->is_boolean() && *normalized;
    numbers_.is_byte = type_ == 5121;
    numbers_.is_floating = type_ == 5126;
    with_component(type_, [&](auto zero) {
      using T = decltype(zero);
      if (std::is_integral_v<T> && !is_normalized_)
        numbers_.one = static_cast<double>(std::numeric_limits<T>::max());
    });
  }

  GltfNumbers read() {
    numbers_.values.resize(count_ * numbers_.width);
    if (entry_.contains("bufferView")) read_dense();
    if (const auto sparse = entry_.find("sparse"); sparse != entry_.end()) read_sparse(*sparse);
    return std::move(numbers_);
  }

 private:
  std::size_t width() const {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 4> widths{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
    const auto type = entry_.find("type");
    const std::string text =
        type != entry_.end() && type->is_string() ? type->get<std::string>() : "";
    for (const auto& [name, width] : widths)
      if (name == text) return width;
    file_.fail(name_ + " has the type " + in_quotes(text) + ", not a scalar or a vector");
  }

  void read_dense() {
    const std::size_t view = file_.whole(entry_, "bufferView", name_);
    const std::size_t start = file_.whole(entry_, "byteOffset", name_, 0);
    const GltfJson& view_entry = file_.element("bufferViews", view);
    const std::size_t stride = file_.whole(view_entry, "byteStride", name_, 0);
    const auto keep = [&](std::size_t i, std::size_t c, double value) {
      numbers_.values[i * numbers_.width + c] = value;
    };
    load(file_.view(view), start, stride, count_, type_, numbers_.width, is_normalized_, keep);
  }

  void read_sparse(const GltfJson& sparse) {
    const auto part = [&](const char* key) -> const GltfJson& {
      const auto found = sparse.find(key);
      if (found == sparse.end() || !found->is_object())
        file_.fail("the sparse part of " + name_ + " has no " + key);
      return *found;
    };
    if (!sparse.is_object()) file_.fail("the sparse part of " + name_ + " is not an object");
    const std::size_t count = file_.whole(sparse, "count", name_);
    if (count > count_) file_.fail("the sparse part of " + name_ + " is larger than the whole");
    std::vector<std::size_t> places(count);
    const GltfJson& indices = part("indices");
    load(file_.view(file_.whole(indices, "bufferView", name_)),
         file_.whole(indices, "byteOffset", name_, 0), 0, count,
         file_.whole(indices, "componentType", name_), 1, false,
         [&](std::size_t i, std::size_t, double value) {
           if (!(value >= 0 && value < static_cast<double>(count_)))
             file_.fail("the sparse part of " + name_ + " has an index out of range");
           places[i] = static_cast<std::size_t>(value);
         });
    const GltfJson& values = part("values");
    load(file_.view(file_.whole(values, "bufferView", name_)),
         file_.whole(values, "byteOffset", name_, 0), 0, count, type_, numbers_.width,
         is_normalized_, [&](std::size_t i, std::size_t c, double value) {
           numbers_.values[places[i] * numbers_.width + c] = value;
         });
  }

  /// Calls keep(element, component, value) for all numbers of an accessor. `stride` is the distance
  /// of elements in bytes; 0 means that elements are tightly packed.
  template <class Keep>
  void load(std::string_view bytes, std::size_t start, std::size_t stride, std::size_t count,
            std::size_t type, std::size_t width, bool is_normalized, const Keep& keep) const {
    const bool is_known = with_component(type, [&](auto zero) {
      using T = decltype(zero);
      const std::size_t size = sizeof(T) * width;
      const std::size_t step = stride == 0 ? size : stride;
      check_range(bytes, start, step, size, count);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < width; ++c) {
          const char* from = bytes.data() + start + i * step + c * sizeof(T);
          keep(i, c, value_of(load_scalar<T>(from, !host_is_little), is_normalized));
        }
    });
    if (!is_known) file_.fail(name_ + " has numbers of the unknown type " + std::to_string(type));
  }

  void check_range(std::string_view bytes, std::size_t start, std::size_t step, std::size_t size,
                   std::size_t count) const {
    if (count == 0) return;
    const bool fits = start <= bytes.size() && size <= bytes.size() - start && step >= size &&
                      (count - 1) <= (bytes.size() - start - size) / step;
    if (!fits)
      file_.fail(name_ + " of " + counted(count, "element") +
                 " reaches beyond its buffer view of " + counted(bytes.size(), "byte"));
  }

  const GltfFile& file_;
  const GltfJson& entry_;
  std::string name_;
  std::size_t count_ = 0;
  std::size_t type_ = 0;
  bool is_normalized_ = false;
  GltfNumbers numbers_;
};

}  // namespace

GltfNumbers gltf_numbers(const GltfFile& file, std::size_t accessor, std::size_t most) {
  return AccessorReader(file, accessor, most).read();
}

}  // namespace transformesh
