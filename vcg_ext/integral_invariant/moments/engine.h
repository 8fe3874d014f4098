// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1: ball moments at all vertices and scales. The interface that both engines stand behind.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/support/symmetric3.h"

namespace integral_invariant {

/// Moments of the solid D inside the ball B_r(p) about its centre p, in normalised coordinates.
struct BallMoments {
  double volume = 0;      ///< V = ∫ 1, unit L^3
  Vec3 first;             ///< m = ∫ y, L^4
  Symmetric3 second;      ///< M = ∫ y yᵀ, L^5; y = x − p over x in D ∩ B_r(p)
  double confidence = 1;  ///< how much of the ball's surface was there and consistently oriented, 0 to 1
};

/// Takes the moments of one vertex at one scale. Called once for each referenced vertex and scale, in no particular
/// order, from several threads at once, so it must only write what belongs to (vertex, scale).
using MomentSink = std::function<void(std::size_t vertex, int scale, const BallMoments& moments)>;

/// Computes ball moments for one surface: prepare once (in the constructor), evaluate many times.
/// evaluate() is const and may run on several threads, each with an Execution of its own.
class MomentEngine {
 public:
  virtual ~MomentEngine() = default;

  /// Moments of every referenced vertex at each of `radii` (increasing, normalised unit), handed to `sink`.
  /// \throw MemoryError before anything large is allocated; Cancelled
  virtual void evaluate(const std::vector<double>& radii, const MomentSink& sink, Execution& execution) const = 0;

  /// One line for the log: what is used to evaluate these radii, such as grid, tiles and number of transforms.
  virtual std::string description(const std::vector<double>& radii, Execution& execution) const = 0;
};

/// The engine that `parameters` ask for, prepared for `surface`, which must outlive it.
/// \throw InputError where the engine cannot work on this surface (it says why and what to do); Cancelled
std::unique_ptr<MomentEngine> make_moment_engine(const Surface& surface, const Parameters& parameters,
                                                 Execution& execution);

}  // namespace integral_invariant
