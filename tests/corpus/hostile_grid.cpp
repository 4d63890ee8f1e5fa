// A test program, not installed. Cleans hostile meshes (hostile_shapes.h), judges the results,
// and prints a table.
//   hostile_grid [--seeds N] [--first N] [--jobs N] [--seconds S] [--megabytes M] [FAMILY...]
//   hostile_grid --write FAMILY SEED double|float
//     writes one of the meshes as PLY
// A mesh passes if the result is a closed oriented manifold without self-intersections and faces
// without area. Its winding numbers must be correct at every sample (hostile_oracle.h), and time
// and memory must stay below the limits. A mesh also passes if nothing is enclosed. Exit code 1 if
// a mesh fails.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>

#include "corpus/hostile_oracle.h"
#include "corpus/hostile_shapes.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::corpus;

namespace {

struct Options {
  std::uint64_t first = 1;
  std::uint64_t seeds = 8;
  std::size_t jobs = 1;
  double seconds = 2;
  double megabytes = 200;
  double hang = 20;      ///< seconds after which the run of a mesh is ended
  double spacings = 64;  ///< distance by which a surface may move, in spacings
  std::vector<std::string> families;
};

constexpr double seconds_to_judge = 600;

struct Trial {
  const HostileFamily* family;
  std::uint64_t seed;
  Scalar type;
};

std::string name_of(Scalar type) { return type == Scalar::float32 ? "float" : "double"; }

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

bool is_enclosed_nothing(const std::string& message) {
  return message.find("inside out") != std::string::npos ||
         message.find("faces enclose") != std::string::npos ||
         message.find("winding number") != std::string::npos;
}

std::string problem_of(const Mesh& input, const Mesh& output, const Trial& trial, double spacings) {
  const std::string manifold = manifold_problem(output, check_manifold(output), true).sentence;
  if (!manifold.empty()) return "WRONG " + manifold;
  const std::size_t pairs = find_intersections(output).size();
  if (pairs > 0) return "WRONG " + std::to_string(pairs) + " crossings";
  for (const Vec3& p : output.positions)
    for (const double x : p)
      if (trial.type == Scalar::float32 && static_cast<double>(static_cast<float>(x)) != x)
        return "WRONG not a float";
  const LocalSamples samples = sample_locally(
      input, output, trial.type, output.faces.size() > 5000 ? 40 : 300, spacings, trial.seed);
  if (samples.wrong > 0)
    return "WRONG " + std::to_string(samples.wrong) + " of " + std::to_string(samples.tested) +
           ": " + samples.first_wrong;
  return {};
}

void limit_seconds(double seconds) {
  const rlimit cpu = {static_cast<rlim_t>(seconds), RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &cpu);
}

/// Returns the verdict on one mesh, in the words that the table counts. Cleans in a process of its
/// own.
std::string run(const Trial& trial, const Options& options) {
  const Mesh input = hostile_mesh(*trial.family, trial.seed, trial.type);
  CleanOptions how;
  how.coordinate = trial.type;
  const double before = cpu_seconds();
  CleanResult result;
  std::string message;
  try {
    result = clean(input, how);
  } catch (const std::exception& error) {
    message = error.what();
  }
  const double seconds = cpu_seconds() - before, megabytes = peak_megabytes();
  limit_seconds(options.hang + seconds_to_judge);
  std::ostringstream text;
  text << seconds << ' ' << megabytes << ' ' << input.faces.size() << ' ' << result.rounding_repairs
       << ' ' << result.rounding_spacings << ' ';
  if (!message.empty())
    text << (is_enclosed_nothing(message) ? "empty " : "REFUSED ") << message;
  else
    text << problem_of(input, result.mesh, trial, options.spacings);
  return text.str();
}

struct Running {
  Trial trial;
  int pipe;
};

void start(const Trial& trial, const Options& options, std::map<pid_t, Running>& running) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const rlimit space = {rlim_t{3} << 30, rlim_t{3} << 30};
    limit_seconds(options.hang);
    setrlimit(RLIMIT_AS, &space);
    std::string text = run(trial, options).substr(0, 4000);
    const bool is_written = write(ends[1], text.data(), text.size()) >= 0;
    _exit(is_written ? 0 : 1);
  }
  close(ends[1]);
  running[child] = {trial, ends[0]};
}

struct Tally {
  int all = 0, passed = 0, wrong = 0, refused = 0, slow = 0, big = 0, hung = 0;
  double most_seconds = 0, most_megabytes = 0, most_seconds_a_face = 0, sum = 0;
};

class Grid {
 public:
  explicit Grid(const Options& options) : options_(options) {}
  void note(const Trial& trial, const std::string& text);
  int print() const;

 private:
  const Options& options_;
  std::map<std::string, Tally> tallies_;
};

void Grid::note(const Trial& trial, const std::string& text) {
  std::istringstream words(text);
  double seconds = options_.hang, megabytes = 0, faces = 1, repairs = 0, steps = 0;
  words >> seconds >> megabytes >> faces >> repairs >> steps;
  std::string outcome;
  std::getline(words, outcome);
  Tally& tally = tallies_[trial.family->name];
  ++tally.all;
  tally.most_seconds = std::max(tally.most_seconds, seconds);
  tally.most_megabytes = std::max(tally.most_megabytes, megabytes);
  tally.most_seconds_a_face = std::max(tally.most_seconds_a_face, seconds / faces);
  tally.sum += seconds;
  const bool is_hung = text.empty();
  const bool is_wrong = outcome.find("WRONG") != std::string::npos;
  const bool is_refused = outcome.find("REFUSED") != std::string::npos;
  const bool is_slow = seconds > options_.seconds, is_big = megabytes > options_.megabytes;
  tally.hung += is_hung, tally.wrong += is_wrong, tally.refused += is_refused;
  tally.slow += is_slow && !is_hung, tally.big += is_big;
  const bool is_passed = !is_hung && !is_wrong && !is_refused && !is_slow && !is_big;
  tally.passed += is_passed;
  if (is_passed) return;
  std::cout << "FAILED " << trial.family->name << ' ' << trial.seed << ' ' << name_of(trial.type)
            << " (" << faces << " faces, " << seconds << " s, " << megabytes << " MB, " << repairs
            << " repairs, " << steps << " steps)"
            << (is_hung ? " ended without an answer" : outcome) << std::endl;
}

int Grid::print() const {
  Tally sum;
  std::printf("%-26s %5s %6s %5s %7s %4s %4s %4s %7s %7s %8s %6s\n", "family", "all", "passed",
              "wrong", "refused", "slow", "big", "hung", "most s", "mean s", "ms/face", "MB");
  const auto row = [](const std::string& name, const Tally& t) {
    std::printf("%-26s %5d %6d %5d %7d %4d %4d %4d %7.2f %7.3f %8.2f %6.0f\n", name.c_str(), t.all,
                t.passed, t.wrong, t.refused, t.slow, t.big, t.hung, t.most_seconds, t.sum / t.all,
                1000 * t.most_seconds_a_face, t.most_megabytes);
  };
  for (const auto& [name, t] : tallies_) {
    row(name, t);
    sum.all += t.all, sum.passed += t.passed, sum.wrong += t.wrong, sum.refused += t.refused;
    sum.slow += t.slow, sum.big += t.big, sum.hung += t.hung, sum.sum += t.sum;
    sum.most_seconds = std::max(sum.most_seconds, t.most_seconds);
    sum.most_megabytes = std::max(sum.most_megabytes, t.most_megabytes);
    sum.most_seconds_a_face = std::max(sum.most_seconds_a_face, t.most_seconds_a_face);
  }
  if (sum.all > 0) row("all", sum);
  return sum.all == sum.passed && sum.all > 0 ? 0 : 1;
}

std::string all_of(int pipe) {
  std::string text;
  char block[4096];
  for (ssize_t n = 0; (n = read(pipe, block, sizeof block)) > 0;)
    text.append(block, static_cast<std::size_t>(n));
  close(pipe);
  return text;
}

int run_grid(const Options& options) {
  std::vector<Trial> trials;
  for (const HostileFamily& family : hostile_families()) {
    const auto& wanted = options.families;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), family.name) == wanted.end())
      continue;
    for (std::uint64_t seed = options.first; seed < options.first + options.seeds; ++seed)
      for (const Scalar type : {Scalar::float64, Scalar::float32})
        trials.push_back({&family, seed, type});
  }
  Grid grid(options);
  std::map<pid_t, Running> running;
  const auto wait_for_one = [&] {
    int status = 0;
    const pid_t child = wait(&status);
    const Running done = running.at(child);
    running.erase(child);
    grid.note(done.trial, all_of(done.pipe));
  };
  for (const Trial& trial : trials) {
    if (running.size() == options.jobs) wait_for_one();
    start(trial, options, running);
  }
  while (!running.empty()) wait_for_one();
  return grid.print();
}

int write_one(const std::string& family, const std::string& seed, const std::string& type) {
  for (const HostileFamily& one : hostile_families()) {
    if (one.name != family) continue;
    Document document;
    document.style.coordinate = type == "float" ? Scalar::float32 : Scalar::float64;
    document.style.format = Format::ply_little;
    document.mesh =
        hostile_mesh(one, std::strtoull(seed.c_str(), nullptr, 10), document.style.coordinate);
    std::cout << write_mesh(document).bytes;
    return 0;
  }
  std::cerr << "hostile_grid: no family is named '" << family << "'\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const ThreadLimit one_thread(1);
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 4 && words[0] == "--write") return write_one(words[1], words[2], words[3]);
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] { return ++i < words.size() ? std::atof(words[i].c_str()) : 0.0; };
    if (words[i] == "--seeds")
      options.seeds = static_cast<std::uint64_t>(value());
    else if (words[i] == "--first")
      options.first = static_cast<std::uint64_t>(value());
    else if (words[i] == "--jobs")
      options.jobs = static_cast<std::size_t>(value());
    else if (words[i] == "--seconds")
      options.seconds = value();
    else if (words[i] == "--hang")
      options.hang = value();
    else if (words[i] == "--megabytes")
      options.megabytes = value();
    else if (words[i] == "--spacings")
      options.spacings = value();
    else
      options.families.push_back(words[i]);
  }
  return run_grid(options);
}
