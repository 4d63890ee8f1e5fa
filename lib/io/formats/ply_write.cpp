#include <algorithm>
#include <map>
#include <unordered_set>

#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/ply.h"
#include "io/streams/text_buffer.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// One property to be written: one number or one list for each row.
struct OutProperty {
  std::string name;
  Scalar type = Scalar::float64;
  std::optional<Scalar> count_type;
  const double* values = nullptr;  ///< values of rows, `step` apart; or all lists, concatenated
  std::size_t step = 1;
  const std::size_t* offsets = nullptr;  ///< for each row, the index in `values` of its list
  const Face* faces = nullptr;  ///< faces whose corners are the lists, used instead of `values`
};

struct OutElement {
  std::string name;
  std::size_t rows = 0;
  std::vector<OutProperty> properties;
};

/// Returns the type of list lengths of the column, or a wider type if a list is too long for it.
Scalar count_type_of(const Column& column) {
  std::uint64_t longest = 0;
  for (std::size_t row = 0; row + 1 < column.list_offsets.size(); ++row) {
    longest =
        std::max<std::uint64_t>(longest, column.list_offsets[row + 1] - column.list_offsets[row]);
  }
  return widened(*column.list_count_type, longest);
}

void add_columns(const Columns& columns, std::size_t first, std::size_t last, OutElement& element) {
  for (std::size_t i = first; i < last; ++i) {
    const Column& column = columns.columns[i];
    OutProperty& property = element.properties.emplace_back();
    property.name = column.name;
    property.type = column.type;
    property.values = column.values.data();
    if (!column.list_count_type) continue;
    property.count_type = count_type_of(column);
    property.offsets = column.list_offsets.data();
  }
}

OutElement vertex_element(const Document& document) {
  const Mesh& mesh = document.mesh;
  const std::size_t column_count = mesh.vertex_columns.columns.size();
  const std::size_t before = std::min(document.style.position_column, column_count);
  OutElement element{"vertex", mesh.positions.size(), {}};
  add_columns(mesh.vertex_columns, 0, before, element);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    OutProperty& property = element.properties.emplace_back();
    property.name = std::string(1, "xyz"[axis]);
    property.type = document.style.coordinate;
    property.values = mesh.positions.empty() ? nullptr : mesh.positions[0].data() + axis;
    property.step = 3;
  }
  add_columns(mesh.vertex_columns, before, column_count, element);
  return element;
}

OutElement face_element(const Document& document, const Column* outlines) {
  const Mesh& mesh = document.mesh;
  const Style& style = document.style;
  const std::size_t column_count = mesh.face_columns.columns.size();
  const std::size_t before = std::min(style.face_list_column, column_count);
  OutElement element{"face", mesh.faces.size(), {}};
  add_columns(mesh.face_columns, 0, before, element);
  OutProperty& corners = element.properties.emplace_back();
  corners.name = style.face_list;
  corners.count_type = style.face_list_count;
  corners.type =
      widened(style.face_list_index, std::max<std::size_t>(mesh.positions.size(), 1) - 1);
  if (outlines == nullptr) {
    corners.faces = mesh.faces.data();
  } else {
    corners.count_type = count_type_of(*outlines);
    corners.values = outlines->values.data();
    corners.offsets = outlines->list_offsets.data();
  }
  add_columns(mesh.face_columns, before, column_count, element);
  return element;
}

OutElement other_element(const OtherElement& other) {
  OutElement element{other.name, other.rows, {}};
  add_columns(other.columns, 0, other.columns.columns.size(), element);
  return element;
}

/// Returns the names of all elements, in the order in which they are written to the file.
std::vector<std::string> element_names(const Document& document) {
  std::vector<std::string> names = document.style.element_order;
  std::unordered_set<std::string> known(names.begin(), names.end());
  const auto missing = [&](const std::string& name) { return known.insert(name).second; };
  if (missing("vertex")) names.insert(names.begin(), "vertex");
  const bool is_point_cloud = !document.style.element_order.empty() && document.mesh.faces.empty();
  if (!is_point_cloud && missing("face")) {
    names.insert(std::find(names.begin(), names.end(), "vertex") + 1, "face");
  }
  for (const OtherElement& other : document.other_elements) {
    if (missing(other.name)) names.push_back(other.name);
  }
  return names;
}

std::vector<OutElement> out_elements(const Document& document, const Column* outlines) {
  std::multimap<std::string_view, const OtherElement*> others;
  for (const OtherElement& other : document.other_elements) others.emplace(other.name, &other);
  std::vector<OutElement> elements;
  for (const std::string& name : element_names(document)) {
    if (name == "vertex") {
      elements.push_back(vertex_element(document));
    } else if (name == "face") {
      elements.push_back(face_element(document, outlines));
    } else {
      const auto [first, last] = others.equal_range(name);
      for (auto other = first; other != last; ++other)
        elements.push_back(other_element(*other->second));
    }
  }
  return elements;
}

std::string header_of(const Style& style, const std::vector<OutElement>& elements) {
  std::vector<PlyElement> described;
  for (const OutElement& element : elements) {
    PlyElement& one = described.emplace_back(PlyElement{element.name, element.rows, {}});
    for (const OutProperty& property : element.properties)
      one.properties.push_back({property.name, property.type, property.count_type});
  }
  return ply_header_text(style, described);
}

void add_text_value(Scalar type, double value, TextBuffer& text) {
  if (type == Scalar::float64) {
    text.add_number(value);
  } else if (type == Scalar::float32) {
    text.add_number(static_cast<float>(value));
  } else {
    with_scalar(type, [&](auto zero) {
      text.add_number(static_cast<std::int64_t>(to_scalar<decltype(zero)>(value)));
    });
  }
}

void add_text_property(const OutProperty& property, std::size_t row, TextBuffer& text) {
  if (property.faces) {
    text.add('3');
    for (const Index corner : property.faces[row]) {
      text.add(' ');
      text.add_number(corner);
    }
  } else if (property.offsets) {
    const std::size_t first = property.offsets[row];
    const std::size_t last = property.offsets[row + 1];
    text.add_number(last - first);
    for (std::size_t i = first; i < last; ++i) {
      text.add(' ');
      add_text_value(property.type, property.values[i], text);
    }
  } else {
    add_text_value(property.type, property.values[row * property.step], text);
  }
}

void add_text_rows(const OutElement& element, TextBuffer& text) {
  if (element.properties.empty()) return;
  for (std::size_t row = 0; row < element.rows; ++row) {
    for (const OutProperty& property : element.properties) {
      if (&property != &element.properties.front()) text.add(' ');
      add_text_property(property, row, text);
    }
    text.add('\n');
  }
}

constexpr std::size_t rows_per_task = 8192;  ///< affects time only

/// Stores one value of type T for each row, `stride` bytes apart.
template <class T, class ValueOfRow>
void store_rows(char* to, std::size_t stride, std::size_t rows, bool swapped,
                const ValueOfRow& value_of_row) {
  parallel_for(rows, rows_per_task, [&](std::size_t first, std::size_t last) {
    char* place = to + first * stride;
    for (std::size_t row = first; row < last; ++row, place += stride)
      store_scalar(place, to_scalar<T>(value_of_row(row)), swapped);
  });
}

void store_constant(Scalar type, double value, char* to, bool swapped) {
  with_scalar(type,
              [&](auto zero) { store_scalar(to, to_scalar<decltype(zero)>(value), swapped); });
}

std::size_t fixed_size(const OutProperty& property) {
  if (!property.faces) return byte_size(property.type);
  return byte_size(*property.count_type) + 3 * byte_size(property.type);
}

void store_faces(const OutProperty& property, char* to, std::size_t stride, std::size_t rows,
                 bool swapped) {
  const std::size_t count_size = byte_size(*property.count_type);
  with_scalar(property.type, [&](auto zero) {
    using T = decltype(zero);
    parallel_for(rows, rows_per_task, [&](std::size_t first, std::size_t last) {
      char* place = to + first * stride;
      for (std::size_t row = first; row < last; ++row, place += stride) {
        store_constant(*property.count_type, 3, place, swapped);
        char* corner = place + count_size;
        for (const Index index : property.faces[row]) {
          store_scalar(corner, static_cast<T>(index), swapped);
          corner += sizeof(T);
        }
      }
    });
  });
}

/// Returns the size of a row in bytes; only an estimate if a list is not that of three corners.
std::size_t row_size(const OutElement& element) {
  std::size_t size = 0;
  for (const OutProperty& property : element.properties) size += fixed_size(property);
  return size;
}

/// Writes the rows of an element whose rows have equal sizes, by one loop for each property.
void add_fixed_rows(const OutElement& element, bool swapped, std::string& bytes) {
  const std::size_t stride = row_size(element);
  const std::size_t start = bytes.size();
  bytes.resize(start + stride * element.rows);
  char* to = bytes.data() + start;
  for (const OutProperty& property : element.properties) {
    if (property.faces) {
      store_faces(property, to, stride, element.rows, swapped);
    } else {
      with_scalar(property.type, [&](auto zero) {
        store_rows<decltype(zero)>(to, stride, element.rows, swapped, [&](std::size_t row) {
          return property.values[row * property.step];
        });
      });
    }
    to += fixed_size(property);
  }
}

void add_value(Scalar type, double value, bool swapped, std::string& bytes) {
  bytes.resize(bytes.size() + byte_size(type));
  store_constant(type, value, bytes.data() + bytes.size() - byte_size(type), swapped);
}

void add_listed_row(const OutElement& element, std::size_t row, bool swapped, std::string& bytes) {
  for (const OutProperty& property : element.properties) {
    if (property.faces) {
      const std::size_t start = bytes.size();
      bytes.resize(start + fixed_size(property));
      OutProperty one = property;
      one.faces += row;
      store_faces(one, bytes.data() + start, 0, 1, swapped);
    } else if (property.offsets) {
      const std::size_t first = property.offsets[row];
      const std::size_t last = property.offsets[row + 1];
      add_value(*property.count_type, static_cast<double>(last - first), swapped, bytes);
      for (std::size_t i = first; i < last; ++i) {
        add_value(property.type, property.values[i], swapped, bytes);
      }
    } else {
      add_value(property.type, property.values[row * property.step], swapped, bytes);
    }
  }
}

void add_binary_rows(const OutElement& element, bool swapped, std::string& bytes) {
  const bool has_list =
      std::any_of(element.properties.begin(), element.properties.end(),
                  [](const OutProperty& property) { return property.offsets != nullptr; });
  if (!has_list) return add_fixed_rows(element, swapped, bytes);
  for (std::size_t row = 0; row < element.rows; ++row) {
    add_listed_row(element, row, swapped, bytes);
  }
}

}  // namespace

WriteResult write_ply(const Document& document, const Column* outlines) {
  const std::vector<OutElement> elements = out_elements(document, outlines);
  const std::string header = header_of(document.style, elements);
  if (document.style.format == Format::ply_ascii) {
    TextBuffer text;
    text.add(header);
    for (const OutElement& element : elements) add_text_rows(element, text);
    return {text.take(), {}};
  }
  const bool swapped = (document.style.format == Format::ply_little) != host_is_little;
  std::size_t size = header.size();
  for (const OutElement& element : elements) size += element.rows * row_size(element);
  std::string bytes;
  bytes.reserve(size);
  bytes += header;
  for (const OutElement& element : elements) add_binary_rows(element, swapped, bytes);
  return {std::move(bytes), {}};
}

}  // namespace transformesh
