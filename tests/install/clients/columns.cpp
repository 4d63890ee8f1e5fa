// Makes a column of numbers, selects, blends and concatenates rows, and checks every value.
#include <transformesh/columns.h>

using namespace transformesh;

int main() {
  Columns table;
  table.get("height", Scalar::float64, 3).values = {1, 2, 4};
  const std::vector<std::uint32_t> rows{2, 0, 2};
  if (table.select(rows).find("height")->values != std::vector<double>{4, 1, 4}) return 1;
  const std::vector<RowBlend> middle{{{0, 2, 0}, {0.5, 0.5, 0}}};
  if (table.blend(middle).find("height")->values != std::vector<double>{2.5}) return 1;
  table.append({{1, 0, 0}, {1, 0, 0}});
  if (table.find("height")->values != std::vector<double>{1, 2, 4, 2}) return 1;
  Columns other;
  other.get("width", Scalar::int32, 1).values = {7};
  if (!table.concatenate(other, 4, 1).empty() || table.columns.size() != 2) return 1;
  if (table.find("height")->values != std::vector<double>{1, 2, 4, 2, 0}) return 1;
  if (table.find("width")->values != std::vector<double>{0, 0, 0, 0, 7}) return 1;
  table.erase("height");
  return table.find("height") == nullptr && table.columns.size() == 1 ? 0 : 1;
}
