// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/surface_noise.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "integral_invariant/support/pi.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

double gauss(NoisyMesh& m) { return std::normal_distribution<double>()(*m.generator); }

/// A Gaussian random field of variance 1 as a sum of waves whose wavenumbers have the field's spectrum.
class RandomField {
 public:
  RandomField(double length, NoisyMesh& m)
  {
    constexpr int count = 400;  // the field's kurtosis then differs from a Gaussian's by 1.5 / count
    std::uniform_real_distribution<double> phase(0, 2 * pi);
    for (int i = 0; i < count; ++i)
      waves_.push_back({Vec3{gauss(m), gauss(m), gauss(m)} * (1 / length), phase(*m.generator)});
  }
  double operator()(const Vec3& p) const
  {
    double sum = 0;
    for (const Wave& w : waves_) sum += std::cos(dot(w.k, p) + w.phase);
    return sum * std::sqrt(2 / double(waves_.size()));
  }

 private:
  struct Wave {
    Vec3 k;
    double phase;
  };
  std::vector<Wave> waves_;
};

}  // namespace

void add_white(NoisyMesh& m, double level)
{
  for (std::size_t v = 0; v < m.normal.size(); ++v) m.mesh.positions[v] += m.normal[v] * (gauss(m) * level * m.edge);
}

void add_correlated(NoisyMesh& m, double level, double length)
{
  const RandomField field(length * m.edge, m);
  for (std::size_t v = 0; v < m.normal.size(); ++v)
    m.mesh.positions[v] += m.normal[v] * (field(m.mesh.positions[v]) * level * m.edge);
}

void add_varying(NoisyMesh& m, double least_level, double range)
{
  Box box;
  for (const Vec3& p : m.mesh.positions) box.add(p);
  for (std::size_t v = 0; v < m.normal.size(); ++v) {
    Vec3& p = m.mesh.positions[v];
    const double along = (p.x - box.low.x) / (box.high.x - box.low.x);
    p += m.normal[v] * (gauss(m) * least_level * std::pow(range, along) * m.edge);
  }
}

void add_spikes(NoisyMesh& m, double share, double height)
{
  std::uniform_real_distribution<double> drawn(0, 1);
  for (std::size_t v = 0; v < m.normal.size(); ++v) {
    if (drawn(*m.generator) >= share) continue;
    const double side = drawn(*m.generator) < 0.5 ? -1 : 1;
    m.mesh.positions[v] += m.normal[v] * (side * height * m.edge);
  }
}

void add_jitter(NoisyMesh& m, double level)
{
  for (Vec3& p : m.mesh.positions) {
    const double x = gauss(m), y = gauss(m), z = gauss(m);
    p += Vec3{x, y, z} * (level * m.edge);
  }
}

void add_line_offsets(NoisyMesh& m, double level)
{
  std::map<double, double> offsets;
  for (std::size_t v = 0; v < m.normal.size(); ++v) {
    const auto [it, is_new] = offsets.try_emplace(m.mesh.positions[v].y);
    if (is_new) it->second = gauss(m) * level * m.edge;
    m.mesh.positions[v].z += it->second;
  }
}

void round_coordinates(TriangleMesh& mesh, double step)
{
  for (Vec3& p : mesh.positions)
    p = {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
}

void round_heights(TriangleMesh& mesh, double step)
{
  for (Vec3& p : mesh.positions) p.z = std::round(p.z / step) * step;
}

}  // namespace accuracy
