// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_script.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "registry.h"

namespace integral_invariant::filter {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(FilterScript, NamesTheFilterAndEveryParameter)
{
  const std::string xml = filter_script(curvature_filter(), {});
  EXPECT_TRUE(contains(xml, std::string("<filter name=\"") + curvature_filter().name + "\">"));
  for (const ParameterSpec& spec : curvature_filter().parameters)
    EXPECT_TRUE(contains(xml, std::string(" name=\"") + spec.name + "\"")) << spec.name;
}

TEST(FilterScript, HasWhatMeshLabAsksOfEachType)
{
  Request request;
  store_assignment(curvature_filter(), "r_max=2.5", request);
  store_assignment(curvature_filter(), "colorize=false", request);
  const std::string xml = filter_script(curvature_filter(), request);
  EXPECT_TRUE(contains(xml, "<Param type=\"RichAbsPerc\" name=\"r_max\" value=\"2.5\" min=\"0\" max=\"2.5\"/>"));
  EXPECT_TRUE(contains(xml, "<Param type=\"RichBool\" name=\"colorize\" value=\"false\"/>"));
  EXPECT_TRUE(contains(xml, "name=\"radius_choice\" value=\"2\" enum_cardinality=\"3\""));
  EXPECT_TRUE(contains(xml, "<Param type=\"RichFloat\" name=\"alpha\" value=\"0.9\"/>"));
  EXPECT_TRUE(contains(xml, "<Param type=\"RichSaveFile\" name=\"export_file\" value=\"\" ext=\"*.ply\"/>"));
}

TEST(FilterScript, IsWrittenForEveryFilterUnderEitherOfItsNames)
{
  for (const Filter* filter : all_filters()) {
    EXPECT_EQ(&find_filter(filter->name), filter);
    EXPECT_EQ(&find_filter(filter->python_name), filter);
    const std::string xml = filter_script(*filter, {});
    EXPECT_TRUE(contains(xml, std::string("<filter name=\"") + filter->name + "\">"));
    for (const ParameterSpec& spec : filter->parameters)
      EXPECT_TRUE(contains(xml, std::string(" name=\"") + spec.name + "\"")) << spec.name;
  }
  EXPECT_THROW(find_filter("no such filter"), ParameterError);
}

TEST(FilterScript, EscapesFileNames)
{
  Request request;
  store_assignment(curvature_filter(), "export_file=a&b<\"c\">=.ply", request);
  EXPECT_TRUE(contains(filter_script(curvature_filter(), request), "value=\"a&amp;b&lt;&quot;c&quot;&gt;=.ply\""));
}

TEST(FilterScript, RefusesWhatItDoesNotKnow)
{
  Request request;
  EXPECT_THROW(store_assignment(curvature_filter(), "no_such=1", request), ParameterError);
  EXPECT_THROW(store_assignment(curvature_filter(), "alpha", request), ParameterError);
  EXPECT_THROW(store_assignment(curvature_filter(), "alpha=100", request), ParameterError);
}

/// What single precision cannot hold is not written: MeshLab 2020.09 aborts on it.
TEST(FilterScript, RefusesValuesBeyondSinglePrecisionByName)
{
  for (const char* assignment : {"radius=1e39", "noise=1e-50", "r_max=4e38", "r_min=1e-38"}) {
    Request request;
    store_assignment(curvature_filter(), assignment, request);
    try {
      filter_script(curvature_filter(), request);
      FAIL() << assignment;
    } catch (const ParameterError& error) {
      const std::string name(assignment, std::string(assignment).find('='));
      EXPECT_TRUE(contains(error.what(), "'" + name + "'")) << error.what();
    }
  }
  Request request;
  for (const char* assignment : {"radius=3e38", "noise=1.3e-38", "r_max=0"})
    store_assignment(curvature_filter(), assignment, request);
  EXPECT_TRUE(contains(filter_script(curvature_filter(), request), "value=\"3e+38\""));
}

TEST(FilterScript, DocumentationHasARowForEveryParameter)
{
  const std::string text = parameter_documentation(curvature_filter());
  EXPECT_EQ(std::size_t(std::count(text.begin(), text.end(), '\n')), curvature_filter().parameters.size() + 2);
  EXPECT_TRUE(contains(text, "| `r_min` | 0 (automatic) |"));
  EXPECT_TRUE(contains(parameter_defaults(curvature_filter()), "scales=7\n"));
}

}  // namespace
}  // namespace integral_invariant::filter
