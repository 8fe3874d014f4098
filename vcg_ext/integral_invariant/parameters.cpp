// SPDX-License-Identifier: GPL-3.0-or-later
// The ranges of all parameters, held in one place for every caller.
#include "integral_invariant/parameters.h"

#include <cmath>
#include <sstream>
#include <string>

#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

template <class Value>
[[noreturn]] void reject(const char* name, Value value, const std::string& range)
{
  std::ostringstream text;
  text << "The parameter '" << name << "' is " << value << ", but must be " << range << '.';
  throw ParameterError(text.str());
}

template <class Value>
std::string from_to(Value low, Value high)
{
  std::ostringstream text;
  text << "from " << low << " to " << high;
  return text.str();
}

void require_whole(const char* name, int value, int low, int high)
{
  if (value < low || value > high) reject(name, value, from_to(low, high));
}

void require_real(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high)) reject(name, value, from_to(low, high));
}

void require_above_zero(const char* name, double value, double high)
{
  std::ostringstream range;
  range << "above 0 and at most " << high;
  if (!(value > 0 && value <= high)) reject(name, value, range.str());
}

void require_length(const char* name, double value)
{
  if (!(value >= 0) || !std::isfinite(value)) reject(name, value, "a length above 0, or 0 for automatic");
}

template <class Enum>
void require_choice(const char* name, Enum value, Enum last)
{
  require_whole(name, int(value), 0, int(last));
}

}  // namespace

Parameters published_method()
{
  Parameters p;
  p.radius_choice = RadiusChoice::feature_adapted;
  p.estimator = Estimator::yang06;
  p.scales = 8;
  return p;
}

void validate(const Parameters& p)
{
  require_choice("radius_choice", p.radius_choice, RadiusChoice::statistical);
  require_choice("estimator", p.estimator, Estimator::bias_free);
  require_length("noise", p.noise);
  require_choice("engine", p.engine, EngineKind::surface_integral);
  require_whole("scales", p.scales, 1, limits::max_scales);
  require_choice("scale_spacing", p.spacing, ScaleSpacing::geometric);
  require_length("r_min", p.r_min);
  require_length("r_max", p.r_max);
  require_length("radius", p.radius);
  require_above_zero("alpha", p.alpha, limits::max_alpha);
  require_above_zero("step", p.step, 1);
  require_choice("start_radius", p.start_radius, StartRadius::middle);
  require_whole("max_iterations", p.max_iterations, 0, limits::max_iterations);
  require_above_zero("tolerance", p.tolerance, limits::max_tolerance);
  require_whole("smoothing_passes", p.smoothing_passes, 0, limits::max_smoothing_passes);
  require_real("fft_cells_per_radius", p.fft_cells_per_radius, limits::min_cells_per_radius,
               limits::max_cells_per_radius);
  require_choice("exactness", p.exactness, Exactness::exact);
  require_whole("threads", p.threads, 0, limits::max_threads);
  if (p.radius_choice == RadiusChoice::statistical && p.estimator == Estimator::yang06)
    throw ParameterError(
        "A statistical radius weighs the scales by their noise, which the estimator of [Yang06] does not "
        "allow: set 'estimator' to 1 (offset-free) or 2 (bias removed).");
  if (p.radius_choice == RadiusChoice::statistical && p.scales < 3)
    throw ParameterError("A statistical radius compares scales: set 'scales' to 3 or more.");
}

}  // namespace integral_invariant
