#include "corpus/chains/steps.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace chains {
namespace {

using Words = std::vector<std::string>;

struct Choice {
  double weight;
  Step (*make)(const Situation&, Random&);
};

std::string text_of(double x) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

/// Returns a percentage with one decimal.
std::string percent(double low, double high, Random& random) {
  return text_of(std::round(10 * random.uniform(low, high)) / 10) + "%";
}

Step step(const std::string& program, const Words& arguments = {}) {
  return {program, arguments, {}};
}

std::string comma_separated(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ",") + text_of(x);
  return text;
}

double rounded(double x) { return std::round(x * 1000) / 1000; }

/// Returns true if the solids overlap substantially and there is no cutter, so that their
/// intersection is worth computing.
bool can_intersect(const Situation& now) {
  return now.is_raw && now.body.cutter.faces.empty() &&
         now.body.volume_in_two > 0.05 * now.body.volume;
}

Step clean(const Situation& now, Random& random) {
  if (can_intersect(now) && random.chance(0.3)) return step("clean", {"--level", "2"});
  switch (random.integer(0, 15)) {
    case 0:
      return step("clean", {"--outermost"});
    case 1:
      return step("clean", {"--separate", "0.1%"});
    case 2:
      return step("clean", {"--source"});
    default:
      return step("clean");
  }
}

Step plain_clean(const Situation&, Random&) { return step("clean"); }

Step fine_remesh(const Situation&, Random& random) {
  Step result = step("remesh", {"--reference-edge", "2%"});
  if (random.chance(0.5))
    result.arguments.insert(result.arguments.end(), {"--feature-angle", "40"});
  result.keeps_measures = true;
  return result;
}

Step remesh(const Situation& now, Random& random) {
  if (random.chance(0.18)) return fine_remesh(now, random);
  Words words;
  if (random.chance(0.75)) words = {"--reference-edge", percent(2.5, 10, random)};
  const std::vector<Words> options = {{},
                                      {},
                                      {},
                                      {"--iterations", "3"},
                                      {"--feature-angle", "40"},
                                      {"--iterations", "3", "--feature-angle", "40"},
                                      {"--smooth", "0.1"},
                                      {"--flip", "angle"},
                                      {"--smooth", "none"},
                                      {"--smooth2", "0.1,-0.2"},
                                      {"--only", "smooth", "--smooth", "0.3", "--iterations", "3"},
                                      {"--flip", "none", "--iterations", "5"},
                                      {"--project"},
                                      {"--adaptive", "1%", "--min-edge", "2%"},
                                      {"--source"},
                                      {"--min-edge", "0.35x", "--max-edge", "0.75x"}};
  const Words& more = random.pick(options);
  words.insert(words.end(), more.begin(), more.end());
  return step("remesh", words);
}

Step decimate(const Situation& now, Random& random) {
  const auto faces = static_cast<double>(now.facts.faces);
  const double least = 12 * static_cast<double>(now.facts.components);
  const double share = faces > 200 ? random.uniform(0.3, 0.9) : random.uniform(0.8, 0.95);
  const double wanted = std::max(least, std::round(faces * share));
  Words words = {"--faces", text_of(wanted)};
  if (random.chance(0.3)) words.insert(words.end(), {"--feature-angle", "40"});
  return step("remesh", words);
}

Step offset(const Situation&, Random& random) {
  const std::string sign = random.chance(0.7) ? "" : "-";
  return step("offset", {"--distance=" + sign + percent(2, 4, random), "--edge", "4%"});
}

Step handles(const Situation&, Random& random) {
  return step("handles", {"--max-length", random.pick(Words{"5x", "30%", "100%"})});
}

Step displace(const Situation& now, Random& random) {
  const Words speeds = {"0.1x", "-0.1x", "1%", "-1%"};
  Words words = {"--normal-speed=" + random.pick(speeds)};
  if (random.chance(0.3)) words.insert(words.end(), {"--alpha", "2"});
  if (random.chance(0.2))
    words = {"--curvature-speed", text_of(1e-4 * diagonal(now.mesh) * diagonal(now.mesh))};
  return step("displace", words);
}

Step transform(const Situation&, Random& random) {
  const auto numbers = [&](int n, double low, double high) {
    std::vector<double> list(static_cast<std::size_t>(n));
    for (double& x : list) x = rounded(random.uniform(low, high));
    return list;
  };
  Step result = step("transform");
  const int kind = random.integer(0, 9);
  if (kind < 6) {
    std::vector<double> axis = numbers(3, 0.1, 1);
    axis.push_back(random.integer(1, 359));
    result.arguments = {"--rotate", comma_separated(axis)};
  } else if (kind == 6) {
    result.arguments = {"--translate=" + comma_separated(numbers(3, -3, 3))};
  } else if (kind == 7) {
    const std::vector<double> factors = numbers(3, 0.5, 2);
    result.volume_factor = factors[0] * factors[1] * factors[2];
    result.arguments = {"--scale-axes", comma_separated(factors)};
  } else if (kind == 8) {
    const double factor = rounded(random.uniform(0.5, 2));
    result.volume_factor = factor * factor * factor;
    result.arguments = {"--scale=" + text_of(-factor)};
  } else {
    result.arguments = {"--mirror", "x"};
  }
  return result;
}

Step convert(const Situation&, Random& random) {
  const std::vector<Words> options = {{"--float"},         {"--float"},
                                      {"--double"},        {"--format", "off"},
                                      {"--format", "stl"}, {"--format", "ply-ascii"},
                                      {"--format", "stl"}, {"--format", "ply-be"}};
  return step("convert", random.pick(options));
}

Step stitch(const Situation&, Random&) { return step("stitch"); }
Step intersect(const Situation&, Random&) { return step("intersect"); }
Step fill(const Situation&, Random&) { return step("fill"); }
Step check(const Situation&, Random&) {
  return step("checkmanifold", {"--closed", "--intersections", "--pass"});
}
Step largest(const Situation&, Random&) {
  return step("select", {"--largest", "1", "--by", "volume"});
}

/// Removes the faces in a box around one or a few faces.
Step open(const Situation& now, Random& random) {
  const TriangleMesh& mesh = now.mesh;
  const Triangle& face = random.pick(mesh.faces);
  const double margin = random.chance(0.5) ? 1e-3 : 0.05 * diagonal(mesh);
  Point low = mesh.points[face[0]], high = low;
  for (const std::uint32_t v : face)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], mesh.points[v][k]);
      high[k] = std::max(high[k], mesh.points[v][k]);
    }
  std::vector<double> box;
  for (const double x : low) box.push_back(x - margin);
  for (const double x : high) box.push_back(x + margin);
  return step("select", {"--invert", "--box=" + comma_separated(box)});
}

Step cat_cutter(const Situation& now, Random&) {
  Step result = step("cat", {"-", "cutter.ply"});
  result.files["cutter.ply"] = write_ply(now.body.cutter);
  return result;
}

/// Returns the solids of a second body, moved to overlap the mesh and scaled to `share` of its
/// size.
TriangleMesh other_solids(Body body, const Situation& now, double share, Random& random) {
  TriangleMesh& other = body.solids;
  const double scale = share * diagonal(now.mesh) / diagonal(other);
  const Point from = other.points.front(), to = random.pick(now.mesh.points);
  for (Point& p : other.points)
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = to[k] + scale * (p[k] - from[k]);
      if (other.type == Type::float32) p[k] = rounded_to_float(p[k]);
    }
  return other;
}

/// Returns a body of a single solid: a target that does not intersect itself.
Body random_solid(Random& random) {
  for (;;) {
    Body body = random_body(random);
    if (body.is_single_solid) return body;
  }
}

Step cat(const Situation& now, Random& random) {
  Step result = step("cat", {"-", "other.ply"});
  result.files["other.ply"] = write_ply(other_solids(random_body(random), now, 1, random));
  return result;
}

Step morph_step(const Situation& now, Random& random) {
  Step result = step("morph-step", {"--target", "target.ply"});
  result.files["target.ply"] = write_ply(other_solids(random_solid(random), now, 0.7, random));
  return result;
}

Step carry(const Situation& now, Random&) {
  Step result = step("carry", {"--from", "before.ply"});
  result.files["before.ply"] = now.before_last;
  return result;
}

Step sample(const Situation&, Random& random) {
  return step("sample", {"--distance", percent(2, 4, random)});
}

Step wrap(const Situation&, Random&) { return step("wrap"); }

Step evolve(const Situation& now, Random&) {
  const double speed = 1e-4 * diagonal(now.mesh) * diagonal(now.mesh);
  return step("evolve",
              {"--step", "tm-displace --curvature-speed " + text_of(speed), "--iterations", "2"});
}

Step morph(const Situation& now, Random& random) {
  // a coarse mesh would vanish before it reaches the target
  if (now.facts.faces < 300) return remesh(now, random);
  Step result = step("morph", {"--target", "target.ply", "--iterations", "2"});
  result.files["target.ply"] = write_ply(other_solids(random_solid(random), now, 0.7, random));
  return result;
}

Step choose(const std::vector<Choice>& choices, const Situation& now, Random& random) {
  double sum = 0;
  for (const Choice& choice : choices) sum += choice.weight;
  double at = random.uniform(0, sum);
  for (const Choice& choice : choices)
    if ((at -= choice.weight) < 0) return choice.make(now, random);
  return choices.back().make(now, random);
}

const std::vector<Choice> after_self_intersection = {
    {8, clean}, {2, transform}, {1.5, convert}, {0.5, stitch}, {0.5, intersect}};
const std::vector<Choice> after_sound = {
    {9, remesh},   {1.5, decimate}, {0.7, offset},  {1, handles}, {2, displace},
    {1, cat},      {1, morph_step}, {1, transform}, {1, convert}, {1, clean},
    {0.7, open},   {0.4, largest},  {0.7, stitch},  {0.3, check}, {0.3, intersect},
    {0.3, evolve}, {0.3, morph}};
const std::vector<Choice> after_open = {{5, fill}, {1.5, remesh}, {1.5, clean}, {0.5, stitch}};

}  // namespace

std::string Step::label() const {
  const auto has = [&](const std::string& word) {
    return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
  };
  for (const std::string option :
       {"--faces", "--float", "--outermost", "--separate", "--source", "--level", "--invert"})
    if (has(option)) return program + ' ' + option;
  if (has("stl")) return program + " stl";
  return program;
}

std::string Step::command() const {
  std::string text = "tm-" + program;
  for (const std::string& word : arguments)
    text += word.find(' ') == std::string::npos ? ' ' + word : " '" + word + '\'';
  return text;
}

Step next_step(const Situation& now, Random& random) {
  const bool is_last = now.steps_left == 1;
  if (now.previous == "sample") return wrap(now, random);
  if (now.previous.ends_with(" --source") && now.bytes.find(" source_u\n") != std::string::npos &&
      random.chance(0.6))
    return carry(now, random);
  if (now.is_soup)
    return random.chance(is_last ? 0 : 0.5) ? stitch(now, random) : clean(now, random);
  if (!now.facts.is_sound())
    return is_last ? plain_clean(now, random) : choose(after_self_intersection, now, random);
  if (!now.facts.is_closed()) return choose(after_open, now, random);
  if (!now.is_cut && !is_last && now.previous.starts_with("clean")) return cat_cutter(now, random);
  // The first program of a chain is one that the body requires.
  if (now.previous == "cat") return choose(after_self_intersection, now, random);
  if (!is_last && random.chance(0.02)) return sample(now, random);
  return choose(after_sound, now, random);
}

}  // namespace chains
