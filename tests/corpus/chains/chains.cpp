// A test program, not installed. Runs chains of the suite's programs on random CAD-like bodies,
// judges the output of every program, and prints the faults and a summary.
// Usage:
//   chains --seeds A..B [--bin FOLDER] [--jobs N] [--seconds S]
//   chains --write SEED FOLDER [--bin FOLDER]
//     keeps the body, the output of every program, and the commands in chain.sh
//   chains --pipelines [--seeds A..B] [--write SEED FOLDER] ...
//     runs the pipelines of docs/recipes.md on 50 bodies instead; --list prints their commands
//   chains --judge FILE...
//     prints the facts about each mesh; exit code 1 unless all are closed, manifold, free of
//     intersections and of faces without area
// Exit code 1 if a chain has a fault or more than 2 % of the chains are refused; 2 for wrong usage.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>

#include "corpus/chains/chain.h"
#include "corpus/chains/mesh_facts.h"
#include "corpus/chains/readme.h"

using namespace chains;

namespace {

struct Options {
  std::uint64_t first = 1, last = 200;
  unsigned jobs = 1;
  bool is_readme = false, is_list = false;
  ChainOptions chain;
};

/// Counts chains, faults and refusals for the summary.
class Tally {
 public:
  void add(const ChainRecord& record);
  bool print(double percent_refused) const;

 private:
  int chains_ = 0, rotated_ = 0, long_ = 0, programs_ = 0, failed_ = 0, refused_ = 0;
  double cpu_seconds_ = 0, most_seconds_ = 0;
  std::map<std::string, int> kinds_, pairs_, pair_runs_;
};

void Tally::add(const ChainRecord& record) {
  ++chains_;
  rotated_ += record.is_rotated_with_contact ? 1 : 0;
  const int ran = static_cast<int>(record.pairs.size());
  long_ += record.programs >= 3 ? 1 : 0;
  programs_ += ran;
  cpu_seconds_ += record.cpu_seconds;
  most_seconds_ = std::max(most_seconds_, record.most_seconds);
  for (const std::string& pair : record.pairs) ++pair_runs_[pair];
  bool is_failed = false, is_refused = false;
  for (const Fault& fault : record.faults) {
    ++kinds_[fault.kind];
    ++pairs_[fault.pair + ' ' + fault.kind];
    (fault.kind == "refused" ? is_refused : is_failed) = true;
    std::cout << (fault.kind == "refused" ? "REFUSED " : "FAILED ") << record.seed << ' '
              << fault.kind << " in " << fault.pair << ": " << fault.text << " [chains "
              << record.mode << "--write " << record.seed << " FOLDER] " << record.commands << '\n';
  }
  failed_ += is_failed ? 1 : 0;
  refused_ += is_refused && !is_failed ? 1 : 0;
  std::cout << std::flush;
}

bool Tally::print(double percent_refused) const {
  const auto percent = [&](int count) { return 100.0 * count / std::max(chains_, 1); };
  for (const auto& [pair, count] : pair_runs_) {
    std::string faults;
    for (const auto& [kind, number] : kinds_) {
      const auto found = pairs_.find(pair + ' ' + kind);
      if (found != pairs_.end()) (faults += ' ' + kind).append(' ' + std::to_string(found->second));
    }
    std::printf("pair %-36s %5d runs%s\n", pair.c_str(), count, faults.c_str());
  }
  for (const auto& [kind, count] : kinds_) std::printf("kind %-16s %d\n", kind.c_str(), count);
  std::printf(
      "%d chains on %d bodies, %d programs, %.1f %% rotated with coplanar contact, "
      "%.1f %% of three programs or more, %.0f s of CPU, at most %.1f s in one program\n",
      chains_, chains_, programs_, percent(rotated_), percent(long_), cpu_seconds_, most_seconds_);
  std::printf("%d passed, %d failed, %d refused\n", chains_ - failed_ - refused_, failed_,
              refused_);
  return failed_ == 0 && percent(refused_) <= percent_refused;
}

/// Runs all seeds on several threads. Prints results in the order of the seeds.
bool run_all(const Options& options) {
  Tally tally;
  std::map<std::uint64_t, ChainRecord> done;
  std::mutex mutex;
  std::atomic<std::uint64_t> next = options.first;
  std::uint64_t to_print = options.first;
  const auto work = [&] {
    for (std::uint64_t seed = next++; seed <= options.last; seed = next++) {
      ChainRecord record =
          options.is_readme ? run_readme(seed, options.chain) : run_chain(seed, options.chain);
      const std::lock_guard lock(mutex);
      done[seed] = std::move(record);
      for (; done.contains(to_print); ++to_print) {
        tally.add(done[to_print]);
        done.erase(to_print);
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < options.jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  return tally.print(2);
}

bool print_facts(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const MeshFacts facts = judge(read_mesh(bytes));
  std::printf(
      "%s: faces %zu bad_indices %zu open_edges %zu bad_edges %zu bad_vertices %zu "
      "no_area %zu intersections %zu components %zu area %.17g volume %.17g\n",
      name.c_str(), facts.faces, facts.bad_indices + facts.bad_coordinates, facts.open_edges,
      facts.bad_edges, facts.bad_vertices, facts.no_area, facts.intersections, facts.components,
      facts.area, facts.volume);
  return facts.is_sound() && facts.is_closed();
}

std::uint64_t number_of(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument("no number: " + text);
  return number;
}

void set_seeds(const std::string& text, Options& options) {
  const std::size_t dots = text.find("..");
  options.first = number_of(text.substr(0, dots));
  options.last = dots == std::string::npos ? options.first : number_of(text.substr(dots + 2));
}

Options read_options(const std::vector<std::string>& words) {
  Options options;
  std::size_t i = 0;
  const auto value = [&]() -> const std::string& {
    if (++i >= words.size()) throw std::invalid_argument("a value is missing");
    return words[i];
  };
  for (; i < words.size(); ++i) {
    if (words[i] == "--seeds") {
      set_seeds(value(), options);
    } else if (words[i] == "--bin") {
      options.chain.bin = value();
    } else if (words[i] == "--jobs") {
      options.jobs = static_cast<unsigned>(number_of(value()));
    } else if (words[i] == "--seconds") {
      options.chain.limits.cpu_seconds = static_cast<double>(number_of(value()));
    } else if (words[i] == "--pipelines") {
      options.is_readme = true;
      options.last = 50;
      options.chain.limits.cpu_seconds = 60;
    } else if (words[i] == "--list") {
      options.is_list = true;
    } else if (words[i] == "--write") {
      set_seeds(value(), options);
      options.chain.folder = value();
    } else {
      throw std::invalid_argument("unknown option " + words[i]);
    }
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words.front() == "--judge")
      return std::count_if(words.begin() + 1, words.end(), print_facts) == argc - 2 ? 0 : 1;
    Options options = read_options(words);
    if (options.is_list) {
      for (const std::string& command : readme_commands()) std::cout << command << '\n';
      return 0;
    }
    if (options.chain.bin.empty())
      options.chain.bin =
          std::filesystem::canonical("/proc/self/exe").parent_path().parent_path() / "bin";
    // Loops start other programs of the suite by name.
    const char* path = std::getenv("PATH");
    setenv("PATH", (options.chain.bin + ':' + (path != nullptr ? path : "")).c_str(), 1);
    std::signal(SIGPIPE, SIG_IGN);
    return run_all(options) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "chains: " << error.what() << '\n';
    return 2;
  }
}
