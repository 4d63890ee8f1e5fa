/// Finds points by their definitions: a hash table, which is searched in full while it is small.
#pragma once

#include <unordered_map>
#include <vector>

#include "tm/geometry/point_definition.h"

namespace transformesh {

class DefinitionTable {
 public:
  /// The number that was filed with an equal definition, or no_index.
  Index find(const PointDefinition& definition) const {
    if (!numbers_.empty()) {
      const auto found = numbers_.find(definition);
      return found == numbers_.end() ? no_index : found->second;
    }
    for (const auto& [other, number] : few_)
      if (other == definition) return number;
    return no_index;
  }

  void insert(const PointDefinition& definition, Index number) {
    if (numbers_.empty()) few_.emplace_back(definition, number);
    if (few_.size() < most_few) return;
    if (numbers_.empty()) numbers_.insert(few_.begin(), few_.end());
    numbers_.emplace(definition, number);
  }

 private:
  static constexpr std::size_t most_few = 24;
  std::vector<std::pair<PointDefinition, Index>> few_;
  std::unordered_map<PointDefinition, Index, PointDefinitionHash> numbers_;
};

}  // namespace transformesh
