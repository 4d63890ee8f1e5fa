#include "corpus/chains/chain.h"

#include <algorithm>
#include <array>
#include <optional>

#include "corpus/chains/steps.h"
#include "corpus/chains/verdict.h"
#include "corpus/chains/work_folder.h"

namespace chains {
namespace {

class Chain {
 public:
  Chain(std::uint64_t seed, const ChainOptions& options)
      : options_(options), folder_(options.folder), random_(seed), body_(random_body(random_)) {
    record_.seed = seed;
  }

  ChainRecord run() {
    begin();
    record_.programs = random_.pick(std::array{2, 2, 3, 3, 3, 4, 4, 5, 6});
    for (int i = 0; i < record_.programs; ++i) {
      const Situation now = {.body = body_,
                             .mesh = mesh_,
                             .facts = facts_,
                             .before_last = before_last_,
                             .bytes = bytes_,
                             .previous = previous_,
                             .is_soup = is_soup_,
                             .is_raw = i == 0,
                             .is_cut = is_cut_,
                             .steps_left = record_.programs - i};
      if (!take(next_step(now, random_))) break;
    }
    if (folder_.is_kept()) folder_.write("chain.sh", record_.commands + '\n');
    return record_;
  }

 private:
  void begin() {
    mesh_ = body_.solids;
    is_cut_ = body_.cutter.faces.empty();
    true_volume_ = body_.volume_of_solids;
    if (body_.is_single_solid && !is_cut_) {
      append(mesh_, body_.cutter);
      is_cut_ = true;
      true_volume_ = body_.volume;
    }
    coarsest_ = mesh_.type;
    bytes_ = write_ply(mesh_);
    facts_ = judge(mesh_);
    record_.is_rotated_with_contact = body_.is_rotated && body_.has_coplanar_contact;
    record_.commands = "cat body.ply";
    if (folder_.is_kept()) folder_.write("body.ply", bytes_);
  }

  void note(const std::string& kind, const std::string& text) {
    record_.faults.push_back({kind, record_.pairs.back(), text});
  }

  /// Runs one program on the current mesh of the chain, and judges its output. Returns false if the
  /// chain ends here.
  bool take(const Step& step) {
    record_.pairs.push_back(previous_ + '|' + step.label());
    record_.commands += " | " + step.command();
    const ProgramResult result = run(step);
    if (!is_done(step, result)) return false;
    TriangleMesh output;
    try {
      output = read_mesh(result.output);
    } catch (const std::exception& error) {
      note("unreadable", error.what());
      return false;
    }
    if (folder_.is_kept())
      folder_.write("after-" + std::to_string(record_.pairs.size()) + ".ply", result.output);
    return accept(step, output, result.output);
  }

  ProgramResult run(const Step& step) {
    for (const auto& [name, bytes] : step.files) folder_.write(name, bytes);
    std::vector<std::string> words = step.arguments;
    for (std::string& word : words)
      if (step.files.contains(word)) word = folder_ / word;
    words.insert(words.end(), {"--threads", "1", "--report", folder_ / "report.json"});
    ProgramResult result =
        run_program(options_.bin + "/tm-" + step.program, words, bytes_, options_.limits);
    record_.cpu_seconds += result.cpu_seconds;
    record_.most_seconds = std::max(record_.most_seconds, result.cpu_seconds);
    return result;
  }

  bool is_done(const Step& step, const ProgramResult& result) {
    if (result.exit_code == 0) return true;
    const bool is_refusal = result.exit_code == 3 || result.exit_code == 4;
    note(result.is_hung                    ? "hang"
         : is_refusal                      ? "refused"
         : step.program == "checkmanifold" ? "disagrees"
                                           : "crash",
         "exit code " + std::to_string(result.exit_code) + ": " + in_one_line(result.messages));
    return false;
  }

  bool accept(const Step& step, const TriangleMesh& output, const std::string& bytes) {
    if (output.type == Type::float32 || step.label() == "convert --float")
      coarsest_ = Type::float32;
    const MeshFacts after = judge(output);
    const std::string report = folder_.read("report.json");
    const std::vector<Finding> findings = find_faults({.step = step,
                                                       .input = mesh_,
                                                       .before = facts_,
                                                       .output = output,
                                                       .after = after,
                                                       .report = report,
                                                       .volume = expected_volume(step),
                                                       .coarsest = coarsest_,
                                                       .was_cleaned = was_cleaned_,
                                                       .is_flat = body_.is_flat && is_polyhedral_});
    for (const Finding& finding : findings) note(finding.kind, finding.text);
    follow(step, after);
    before_last_ = std::move(bytes_);
    mesh_ = output;
    facts_ = after;
    bytes_ = bytes;
    previous_ = step.label();
    return findings.empty() && (after.faces > 0 || step.program == "sample");
  }

  /// Returns the volume of the program's output, if it is known.
  std::optional<double> expected_volume(const Step& step) const {
    if (step.label() == "clean --level") return body_.volume_in_two;
    if (step.program == "clean")
      return step.arguments.empty() || step.arguments.front() == "--source" ? true_volume_
                                                                            : std::nullopt;
    if (!facts_.is_sound() || !facts_.is_closed()) return {};
    if (step.program == "transform") return facts_.volume * step.volume_factor;
    if (step.program == "convert" || step.program == "stitch" || step.program == "intersect")
      return facts_.volume;
    return {};
  }

  /// Updates the known volume of the region that the mesh encloses.
  void follow(const Step& step, const MeshFacts& after) {
    const std::string& name = step.program;
    // A surface that moves inwards may turn a small component inside out without an intersection.
    const bool may_turn = name == "cat" || name == "displace" || name == "morph-step";
    was_cleaned_ = name == "clean" || (was_cleaned_ && !may_turn);
    is_soup_ = name == "convert" && step.command().ends_with("stl");
    if (step.files.contains("cutter.ply")) {
      true_volume_ = body_.volume;
      is_cut_ = true;
      return;
    }
    // The cutter fits only solids that have not moved.
    if (name != "clean" && name != "stitch" && name != "intersect") is_cut_ = true;
    if (step.label() == "clean --separate") is_cut_ = true;
    if (name == "transform" && true_volume_) *true_volume_ *= step.volume_factor;
    const bool keeps_body = name == "clean" || name == "stitch" || name == "intersect" ||
                            name == "transform" || name == "convert" || name == "checkmanifold" ||
                            name == "carry";
    is_polyhedral_ = is_polyhedral_ && keeps_body && step.volume_factor == 1;
    if (after.is_sound() && after.is_closed() && was_cleaned_)
      true_volume_ = after.volume;
    else if (!keeps_body)
      true_volume_.reset();
  }

  const ChainOptions& options_;
  WorkFolder folder_;
  Random random_;
  Body body_;
  ChainRecord record_;

  TriangleMesh mesh_;
  std::string bytes_;        ///< file of mesh_, as the last program wrote it
  std::string before_last_;  ///< input of the last program
  MeshFacts facts_;
  std::string previous_ = "cat";
  bool is_soup_ = false, is_cut_ = false, was_cleaned_ = false;
  bool is_polyhedral_ = true;  ///< no program so far has curved flat sides
  // volume of the points with a winding number of at least 1, if known
  std::optional<double> true_volume_;
  Type coarsest_ = Type::float64;
};

}  // namespace

ChainRecord run_chain(std::uint64_t seed, const ChainOptions& options) {
  return Chain(seed, options).run();
}

}  // namespace chains
