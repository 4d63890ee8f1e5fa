#include "mesh/connected_minima.h"

#include <doctest/doctest.h>

#include <numeric>

#include "transformesh/control.h"

using namespace transformesh;

namespace {

using Graph = std::vector<std::vector<Index>>;

void connect(Graph& graph, Index a, Index b) {
  graph[a].push_back(b);
  graph[b].push_back(a);
}

/// Returns the smallest connected elements by repeated passes over all edges.
std::vector<Index> minima_by_passes(const Graph& graph) {
  std::vector<Index> minima(graph.size());
  std::iota(minima.begin(), minima.end(), Index{0});
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (Index i = 0; i < graph.size(); ++i)
      for (const Index k : graph[i])
        if (minima[k] < minima[i]) {
          minima[i] = minima[k];
          is_changed = true;
        }
  }
  return minima;
}

std::vector<Index> minima_of(const Graph& graph) {
  const auto minima = connected_minima(graph.size(), [&](Index i, const auto& visit) {
    for (const Index k : graph[i]) visit(k);
  });
  return {minima.begin(), minima.end()};
}

}  // namespace

TEST_CASE("components of random graphs have their smallest elements, for any number of threads") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Graph graph(30'000);
    unsigned state = seed;
    const auto next = [&] {
      state = state * 1664525U + 1013904223U;
      return static_cast<Index>((state >> 8) % graph.size());
    };
    for (std::size_t edge = 0; edge < graph.size() / 2 + 1000 * seed; ++edge)
      connect(graph, next(), next());
    const std::vector<Index> expected = minima_by_passes(graph);
    for (const int threads : {1, 4}) {
      CAPTURE(seed);
      CAPTURE(threads);
      const ThreadLimit limit(threads);
      CHECK(minima_of(graph) == expected);
    }
  }
}

TEST_CASE("a long path in an order that alternates is one component") {
  Graph graph(50'000);
  for (Index i = 0; i + 1 < graph.size(); ++i) {
    const auto place = [&](Index k) {
      return k % 2 == 0 ? k : static_cast<Index>(graph.size()) - k;
    };
    connect(graph, place(i), place(i + 1));
  }
  const ThreadLimit limit(4);
  CHECK(minima_of(graph) == std::vector<Index>(graph.size(), 0));
}

TEST_CASE("components are numbered in the order of their smallest elements") {
  RawVector<Index> minima{0, 1, 0, 3, 1, 5};
  const RawVector<Index> smallest = number_components(minima, [](Index i) { return i != 3; });
  CHECK(smallest == RawVector<Index>{0, 1, 5});
  CHECK(minima == RawVector<Index>{0, 1, 0, no_index, 1, 2});
}
