// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "integral_invariant/parameters.h"
#include "registry.h"

namespace integral_invariant::filter {
namespace {

std::string refusal(const ParameterSpec& spec, double value)
{
  Request request;
  try {
    store(spec, value, request);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

const ParameterSpec& row(const std::string& name)
{
  const ParameterSpec* spec = find_parameter(curvature_filter().parameters, name);
  if (!spec) throw std::runtime_error("no parameter " + name);
  return *spec;
}

class ParameterTables : public testing::TestWithParam<const Filter*> {};

INSTANTIATE_TEST_SUITE_P(Filters, ParameterTables, testing::ValuesIn(all_filters()),
                         [](const auto& tested) { return std::string(tested.param->python_name); });

TEST(ParameterTable, HasThePromisedNames)
{
  for (const char* name : {"radius_choice", "scales", "r_min", "r_max", "radius", "alpha", "step", "max_iterations",
                           "tolerance", "smooth_radius", "smoothing_passes", "engine", "fft_cells_per_radius",
                           "quality", "colorize", "color_percentile", "export_file"})
    EXPECT_NE(find_parameter(curvature_filter().parameters, name), nullptr) << name;
  EXPECT_EQ(find_parameter(curvature_filter().parameters, "no_such"), nullptr);
}

TEST_P(ParameterTables, NamesAreUniqueAndLowerSnakeCase)
{
  std::set<std::string> names;
  for (const ParameterSpec& spec : GetParam()->parameters) {
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
    EXPECT_EQ(std::string(spec.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << spec.name;
    EXPECT_LE(std::string(spec.label).size(), 32u) << spec.name;
    EXPECT_FALSE(std::string(spec.tip).empty()) << spec.name;
  }
}

TEST_P(ParameterTables, EveryDefaultIsPermittedAndTheCoreAgrees)
{
  Request request;
  for (const ParameterSpec& spec : GetParam()->parameters)
    if (spec.set) { EXPECT_NO_THROW(store(spec, default_value(spec), request)) << spec.name; }
  EXPECT_NO_THROW(validate(request.part<Parameters>()));
}

TEST_P(ParameterTables, EveryValueLandsWhereItIsReadFrom)
{
  for (const ParameterSpec& spec : GetParam()->parameters) {
    if (!spec.set) continue;
    Request request;
    const double other = spec.kind == Kind::real ? spec.minimum + 0.25 * (spec.maximum - spec.minimum)
                                                 : (default_value(spec) == 1 ? 0 : 1);
    const double value = std::max(other, spec.minimum);
    store(spec, value, request);
    EXPECT_DOUBLE_EQ(spec.get(request), value) << spec.name;
  }
}

TEST_P(ParameterTables, EveryRangeIsEnforcedByNameValueAndRange)
{
  for (const ParameterSpec& spec : GetParam()->parameters) {
    if (!spec.set) continue;
    std::vector<double> bad{std::nan(""), std::numeric_limits<double>::infinity(), spec.minimum - 1};
    if (std::isfinite(spec.maximum)) bad.push_back(2 * spec.maximum + 1);
    if (spec.above_minimum) bad.push_back(spec.minimum);
    if (spec.kind == Kind::integer || spec.kind == Kind::choice) bad.push_back(spec.minimum + 0.5);
    for (const double value : bad) {
      const std::string sentence = refusal(spec, value);
      EXPECT_NE(sentence.find(spec.name), std::string::npos) << spec.name << ' ' << value;
      EXPECT_NE(sentence.find(number_text(value)), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(range_text(spec)), std::string::npos) << sentence;
    }
  }
}

/// The core must refuse what the table refuses and take the ends of every range.
TEST(ParameterTable, TheCoreHoldsTheSameRanges)
{
  for (const ParameterSpec& spec : curvature_filter().parameters) {
    if (!spec.set || spec.kind == Kind::boolean) continue;
    Request at_end, outside;
    spec.set(at_end, std::isfinite(spec.maximum) ? spec.maximum : 1e30);
    EXPECT_NO_THROW(validate(at_end.part<Parameters>())) << spec.name;
    const bool of_the_core =
        spec.get(at_end) != default_value(spec) &&
        std::string("quality colorize color_percentile memory_limit_mb").find(spec.name) == std::string::npos;
    if (!of_the_core) continue;
    spec.set(outside, spec.minimum - 1);
    EXPECT_THROW(validate(outside.part<Parameters>()), ParameterError) << spec.name;
  }
}

TEST(ParameterTable, ReadsText)
{
  Request request;
  store_from_text(row("alpha"), "1.5", request);
  store_from_text(row("radius_choice"), "fixed", request);
  store_from_text(row("engine"), "1", request);
  store_from_text(row("smooth_radius"), "False", request);
  store_from_text(row("quality"), "Shape index", request);
  store_from_text(row("export_file"), "a folder/Out.PLY", request);
  EXPECT_DOUBLE_EQ(request.part<Parameters>().alpha, 1.5);
  EXPECT_EQ(request.part<Parameters>().radius_choice, RadiusChoice::fixed);
  EXPECT_EQ(request.part<Parameters>().engine, EngineKind::surface_integral);
  EXPECT_FALSE(request.part<Parameters>().smooth_radius);
  EXPECT_EQ(request.part<OutputOptions>().quality, Quantity::shape_index);
  EXPECT_EQ(request.part<OutputOptions>().export_file, "a folder/Out.PLY");
}

TEST(ParameterTable, RefusesTextThatIsNoValue)
{
  Request request;
  for (const char* text : {"", "x", "1x", "nan", "1,5", "5%", " 1"})
    EXPECT_THROW(store_from_text(row("alpha"), text, request), ParameterError) << text;
  EXPECT_THROW(store_from_text(row("scales"), "2.5", request), ParameterError);
  EXPECT_THROW(store_from_text(row("smooth_radius"), "maybe", request), ParameterError);
  EXPECT_THROW(store_from_text(row("export_file"), "out.obj", request), ParameterError);
  for (const char* no_script_holds : {"a\xc4"
                                      "b.ply",
                                      "a\x01"
                                      "b.ply",
                                      "a\nb.ply"})
    EXPECT_THROW(store_from_text(row("export_file"), no_script_holds, request), ParameterError);
}

TEST(ParameterTable, SinglePrecisionIsReadAsTyped)
{
  for (const double typed : {0.9, 0.1, 1e-3, 0.05, 123.456, 1e-20, 0.0})
    EXPECT_EQ(undo_float_rounding(float(typed)), typed);
  EXPECT_TRUE(std::isnan(undo_float_rounding(std::numeric_limits<float>::quiet_NaN())));
  for (const double typed : {0.9, 0.1, 123.456}) {
    EXPECT_EQ(undo_float_rounding(typed), typed);
    EXPECT_EQ(undo_float_rounding(double(float(typed))), typed);
  }
}

}  // namespace
}  // namespace integral_invariant::filter
