/// Hash table that maps points to numbers, with open addressing. The key is the definition of the
/// point: the mesh vertices, edges and faces that determine it. Tables of fewer than 24 entries are
/// searched linearly.
#pragma once

#include <bit>
#include <vector>

#include "geometry/numbers/point_definition.h"

namespace transformesh {

class DefinitionTable {
 public:
  /// Returns the number that was inserted with an equal definition, or no_index.
  Index find(const PointDefinition& definition) const {
    if (slots_.empty()) {
      for (const Entry& entry : entries_)
        if (entry.definition == definition) return entry.number;
      return no_index;
    }
    const Index entry = slots_[slot_of(definition)];
    return entry == no_index ? no_index : entries_[entry].number;
  }

  /// Inserts a definition. An equal definition must not be in the table.
  void insert(const PointDefinition& definition, Index number) {
    entries_.push_back({definition, number});
    if (entries_.size() < few) return;
    if (2 * entries_.size() > slots_.size()) return grow();
    slots_[slot_of(definition)] = static_cast<Index>(entries_.size() - 1);
  }

 private:
  struct Entry {
    PointDefinition definition;
    Index number;
  };
  /// Tables with fewer entries are searched linearly; affects time only.
  static constexpr std::size_t few = 24;

  /// Returns the slot that refers to an equal definition, or the empty slot into which the
  /// definition has to be inserted.
  std::size_t slot_of(const PointDefinition& definition) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = PointDefinitionHash()(definition) & mask;
    while (slots_[slot] != no_index && entries_[slots_[slot]].definition != definition)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    slots_.assign(std::bit_ceil(4 * entries_.size()), no_index);
    for (Index i = 0; i < entries_.size(); ++i) slots_[slot_of(entries_[i].definition)] = i;
  }

  std::vector<Entry> entries_;
  std::vector<Index> slots_;  ///< indices into `entries_`, or no_index; the size is a power of two
};

}  // namespace transformesh
