// Parses lengths in all three units, resolves them, writes them again and rejects other text.
#include <transformesh/length.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Length percent = parse_length("1%"), edges = parse_length("0.7x");
  if (percent.value != 0.01 || percent.unit != Length::Unit::diagonal) return 1;
  if (std::abs(percent.resolve(50, 0) - 0.5) > 1e-12) return 1;
  if (std::abs(edges.resolve(0, 2) - 1.4) > 1e-12) return 1;
  if (parse_length("-0.02").resolve(50, 2) != -0.02) return 1;
  if (parse_length(edges.text()).unit != Length::Unit::reference_edge) return 1;
  if (parse_length(percent.text()).value != percent.value) return 1;
  for (const char* text : {"", "x", "1y", "inf"}) {
    try {
      parse_length(text);
      return 1;
    } catch (const UsageError&) {
    }
  }
  return 0;
}
