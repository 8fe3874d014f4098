// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/invariants.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fuzz {

namespace {

using integral_invariant::Result;
using integral_invariant::Vec3;

template <class Value>
void require_all_finite(const std::vector<Value>& values, const char* sentence)
{
  require(std::all_of(values.begin(), values.end(), [](Value value) { return std::isfinite(value); }), sentence);
}

void require_unit(const std::vector<Vec3>& vectors, std::size_t vertices)
{
  constexpr double tolerance = 1e-6;
  require(vectors.size() == vertices, "one vector a vertex");
  for (const Vec3& v : vectors) require(std::abs(norm(v) - 1) < tolerance, "directions and normals are unit vectors");
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

}  // namespace

void require_finite(const std::vector<double>& values, const char* sentence) { require_all_finite(values, sentence); }
void require_finite(const std::vector<float>& values, const char* sentence) { require_all_finite(values, sentence); }

void require_sound(const Result& r, std::size_t vertices)
{
  for (const auto* values : {&r.kappa_max, &r.kappa_min, &r.radius, &r.standard_error}) {
    require(values->size() == vertices, "one value a vertex");
    require_finite(*values, "curvatures, radii and errors are finite");
  }
  require(r.confidence.size() == vertices, "one confidence a vertex");
  for (std::size_t v = 0; v < vertices; ++v) {
    require(r.kappa_max[v] >= r.kappa_min[v], "kappa_max >= kappa_min");
    require(r.radius[v] >= 0 && r.standard_error[v] >= 0, "radii and errors are not negative");
    require(r.confidence[v] >= 0 && r.confidence[v] <= 1, "confidence is from 0 to 1");
  }
  for (const auto* vectors : {&r.dir_max, &r.dir_min, &r.normal}) require_unit(*vectors, vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    require(std::abs(dot(r.dir_max[v], r.dir_min[v])) < 1e-6 && std::abs(dot(r.dir_max[v], r.normal[v])) < 1e-6,
            "directions and normal are orthogonal");
  require_finite(r.scales, "scales are finite");
  require(std::isfinite(r.average_edge) && std::isfinite(r.diagonal) && std::isfinite(r.noise), "lengths are finite");
  require(std::isfinite(r.mean_iterations) && r.converged <= vertices, "convergence is counted");
}

void require_equal(const Result& a, const Result& b)
{
  require(same_bits(a.kappa_max, b.kappa_max) && same_bits(a.kappa_min, b.kappa_min) && same_bits(a.radius, b.radius) &&
              same_bits(a.standard_error, b.standard_error) && same_bits(a.confidence, b.confidence) &&
              same_bits(a.dir_max, b.dir_max) && same_bits(a.dir_min, b.dir_min) && same_bits(a.normal, b.normal),
          "any number of threads gives the same bits");
}

void require_sentence(const std::exception& error)
{
  require(std::strlen(error.what()) > 10, "an error says what is wrong");
}

}  // namespace fuzz
