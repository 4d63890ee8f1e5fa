// A test program, not installed. Damages solids (damage.h), repairs them, and prints a table by
// kinds of damage.
//
//   repair_grid [--seeds N] [--faults] [KIND...]     default 8 seeds, all kinds
//   repair_grid --write KIND SOLID SEED FILE         writes one damaged solid
//
// The columns are cases, results that are solids, results that are correct, and seconds of the
// slowest case. A solid is correct if its volume is. If the damage does not determine the volume,
// the inside of the solid must be the region in which the generalized winding number of the input
// is above 1/2. Exit code 1 if less than 90 % of a kind are correct.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "corpus/repair/damage.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "transformesh/repair.h"

using namespace transformesh;
using namespace transformesh::corpus;

namespace {

struct Row {
  int cases = 0, solids = 0, right = 0;
  double slowest = 0;
};

constexpr double least_right = 0.9;
constexpr int samples = 200;
constexpr double least_agreement = 0.99;

/// Returns the fraction of random points in the box at which both agree on inside and outside.
double agreement(const Mesh& input, const Mesh& repaired) {
  test::Random random(1);
  Eigen::AlignedBox3d box;
  for (const Vec3& point : input.positions) box.extend(point);
  int same = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec3 point = box.min() + box.sizes().cwiseProduct(random.point(0, 1));
    same +=
        (test::winding_number(input, point) > 0.5) == (test::winding_number(repaired, point) > 0.5);
  }
  return static_cast<double>(same) / samples;
}

std::string judge(const Damage& damage, const Solid& solid, const Mesh& input, Row& row) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const Mesh repaired = repair(input).mesh;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    row.slowest = std::max(row.slowest, seconds.count());
    std::string fault = fault_of(repaired, 0);
    if (!fault.empty()) return fault;
    ++row.solids;
    fault = fault_of(repaired, damage.volume * solid.volume);
    if (fault.empty() && damage.volume == 0 && agreement(input, repaired) < least_agreement)
      fault = "agrees with the winding numbers at " + std::to_string(agreement(input, repaired));
    return fault;
  } catch (const Error& error) {
    return error.what();
  }
}

bool run(const Damage& damage, std::uint64_t seeds, bool shows_faults) {
  Row row;
  for (const Solid& solid : solids())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      ++row.cases;
      const std::string fault = judge(damage, solid, damage.apply(solid.mesh, seed), row);
      row.right += fault.empty();
      if (shows_faults && !fault.empty())
        std::printf("  %s %s %lu: %s\n", damage.name.c_str(), solid.name.c_str(), seed,
                    fault.c_str());
    }
  std::printf("%-18s %5d %6d %6d %8.3f\n", damage.name.c_str(), row.cases, row.solids, row.right,
              row.slowest);
  return row.right >= least_right * row.cases;
}

int write(const char* const* words) {
  for (const Damage& damage : damages())
    for (const Solid& solid : solids())
      if (damage.name == words[0] && solid.name == words[1])
        write_mesh_file(words[3], damage.apply(solid.mesh, std::strtoul(words[2], nullptr, 10)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> kinds;
  std::uint64_t seeds = 8;
  bool shows_faults = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--write" && i + 4 < argc) return write(argv + i + 1);
    if (word == "--seeds" && i + 1 < argc) {
      seeds = std::strtoul(argv[++i], nullptr, 10);
    } else if (word == "--faults") {
      shows_faults = true;
    } else {
      kinds.push_back(word);
    }
  }
  std::printf("%-18s %5s %6s %6s %8s\n", "damage", "cases", "solids", "right", "slowest");
  bool is_right = true;
  for (const Damage& damage : damages())
    if (kinds.empty() || std::ranges::find(kinds, damage.name) != kinds.end())
      is_right = run(damage, seeds, shows_faults) && is_right;
  return is_right ? 0 : 1;
}
