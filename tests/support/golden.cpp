// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/golden.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "integral_invariant/curvature.h"
#include "support/shapes.h"

namespace test_support {

namespace {

using namespace integral_invariant;

std::vector<double> summary(std::vector<double> values)
{
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  std::sort(values.begin(), values.end());
  const double n = double(values.size());
  const auto at = [&](double part) { return values[std::size_t(part * (n - 1))]; };
  return {sum / n, std::sqrt(squares / n), at(0.05), at(0.5), at(0.95)};
}

void add_run(const std::string& name, const TriangleMesh& mesh, const Parameters& parameters, GoldenValues& values)
{
  const Result r = compute_curvature(mesh, parameters, {});
  values[name + " kappa_max"] = summary(r.kappa_max);
  values[name + " kappa_min"] = summary(r.kappa_min);
  values[name + " radius"] = summary(r.radius);
  values[name + " standard_error"] = summary(r.standard_error);
  values[name + " confidence"] = summary({r.confidence.begin(), r.confidence.end()});
}

TriangleMesh half_torus()
{
  TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 100, 30), 0.005);
  mesh.triangles.resize(mesh.triangles.size() / 2);
  return mesh;
}

}  // namespace

GoldenValues golden_values()
{
  const std::pair<const char*, TriangleMesh> meshes[] = {
      {"sphere", icosphere(4)},
      {"noisy_torus", with_normal_noise(torus(2, 0.6, 100, 30), 0.005)},
      {"box", with_tangential_jitter(box(2, 1.5, 1, 0.1), 0.01)},
      {"half_torus", half_torus()},
  };
  GoldenValues values;
  for (const auto& [name, mesh] : meshes)
    for (const EngineKind engine : {EngineKind::surface_integral, EngineKind::volume_fft}) {
      if (engine == EngineKind::volume_fft && !Surface(mesh).is_closed()) continue;
      const std::string run = std::string(name) + (engine == EngineKind::volume_fft ? " fft" : " surface");
      Parameters p, published = published_method();
      p.engine = published.engine = engine;
      add_run(run + " default", mesh, p, values);
      add_run(run + " published", mesh, published, values);
    }
  return values;
}

std::string golden_text(const GoldenValues& values)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const auto& [name, numbers] : values) {
    text << name;
    for (const double number : numbers) text << ' ' << number;
    text << '\n';
  }
  return text.str();
}

GoldenValues read_golden_values(const std::string& file)
{
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file);
  GoldenValues values;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string mesh, engine, method, quantity;
    words >> mesh >> engine >> method >> quantity;
    std::vector<double>& numbers = values[mesh + ' ' + engine + ' ' + method + ' ' + quantity];
    for (double number; words >> number;) numbers.push_back(number);
  }
  return values;
}

double largest_golden_difference(const GoldenValues& a, const GoldenValues& b, std::string& where)
{
  double largest = 0;
  for (const auto& [name, numbers] : a) {
    const auto other = b.find(name);
    if (other == b.end() || other->second.size() != numbers.size() || a.size() != b.size()) {
      where = name;
      return std::numeric_limits<double>::infinity();
    }
    const double scale = std::max(numbers[1], other->second[1]);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double difference = std::abs(numbers[i] - other->second[i]);
      const double relative = difference > 0 ? difference / scale : 0;
      if (relative <= largest) continue;
      largest = relative;
      where = name;
    }
  }
  return largest;
}

}  // namespace test_support
