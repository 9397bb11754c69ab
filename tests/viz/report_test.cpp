// SPDX-License-Identifier: BSD-3-Clause
// The report: everything is in it, and it asks for nothing from anywhere. And the script for ParaView.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <set>

#include "file_text.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Report : public VizTest {
 protected:
  Result write_report(const char* target = nullptr) {
    return result_of(hfrac_viz_write_report(folder().c_str(), target));
  }

  void draw_everything() {
    options.width = 640;
    options.movie_width = 320;
    ASSERT_EQ(render_run().status, HFRAC_OK);
    hfrac_viz_chart_options charts;
    hfrac_viz_chart_options_init(&charts, sizeof charts);
    charts.formats = HFRAC_VIZ_SVG;
    ASSERT_EQ(hfrac_viz_render_charts(folder().c_str(), &charts, nullptr, nullptr), HFRAC_OK);
  }
};

// Without the data addresses, whose letters could spell anything.
std::string without_data(const std::string& page) {
  std::string rest;
  std::size_t from = 0;
  for (std::size_t at = page.find("data:"); at != std::string::npos; at = page.find("data:", from)) {
    rest += page.substr(from, at - from) + "DATA";
    from = page.find('"', at);
  }
  return rest + page.substr(from);
}

TEST_F(Report, HoldsEverythingAndRefersToNothingOutside) {
  write_run(folder(), run);
  draw_everything();
  const Result result = write_report();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const std::string page = file_text(file("report.html"));
  for (const char* part :
       {"<!DOCTYPE html>", "Synthetic run", "data:image/png;base64,iVBOR", "data:video/mp4;base64,",
        "id=\"pictures\"", "id=\"movie\"", "id=\"curves\"", "id=\"fractures\"", "5.75", "id=\"wells\"",
        "id=\"balances\"", "id=\"reproduce\"", "hfrac run case.toml", "0123456789abcdef", "id=\"case\"",
        "[model]", "prefers-color-scheme", "</html>"}) {
    EXPECT_TRUE(holds(page, part)) << part;
  }
  const std::string text = without_data(page);
  const std::regex drawing("<svg ");
  EXPECT_EQ(std::distance(std::sregex_iterator(text.begin(), text.end(), drawing), {}), 5);
  for (const char* forbidden :
       {"http://", "https://", "src=\"//", "@import", "<script", "<link", "<iframe", "file://"}) {
    EXPECT_FALSE(holds(text, forbidden)) << forbidden;
  }
  // Every url(...) and every href is a name inside the page.
  for (const char* reference : {"url\\(([^)]*)\\)", "href=\"([^\"]*)\""}) {
    const std::regex pattern(reference);
    for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found) {
      const std::string target = (*found)[1];
      ASSERT_EQ(target.substr(0, 1), "#") << target;
      EXPECT_TRUE(holds(text, "id=\"" + target.substr(1) + "\"")) << target;
    }
  }
}

TEST_F(Report, NoTwoPartsShareAName) {
  write_run(folder(), run);
  draw_everything();
  ASSERT_EQ(write_report().status, HFRAC_OK);
  const std::string text = without_data(file_text(file("report.html")));
  std::set<std::string> names;
  const std::regex pattern(" id=\"([^\"]*)\"");
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found) {
    EXPECT_TRUE(names.insert((*found)[1]).second) << (*found)[1];
  }
  EXPECT_GE(names.size(), 8U);
}

TEST_F(Report, WorksWithoutPicturesAndEscapesText) {
  run.title = "a <b>bold</b> & \\\"quoted\\\" <script>title</script>";
  write_run(folder(), run);
  const Result result = write_report(file("elsewhere.html").c_str());
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const std::string page = file_text(file("elsewhere.html"));
  EXPECT_FALSE(holds(page, "<script"));
  EXPECT_TRUE(holds(page, "a &lt;b&gt;bold&lt;/b&gt; &amp; &quot;quoted&quot;"));
  EXPECT_FALSE(holds(page, "<video"));
}

TEST_F(Report, NeedsASummary) {
  write_run(folder(), run);
  std::filesystem::remove(file("summary.json"));
  EXPECT_EQ(write_report().status, HFRAC_VIZ_ERR_READ);
  std::ofstream(file("summary.json")) << "{ broken";
  EXPECT_EQ(write_report().status, HFRAC_VIZ_ERR_READ);
  EXPECT_FALSE(std::filesystem::exists(file("report.html")));
}

TEST_F(Report, ParaviewScriptIsWrittenAndNamesNoPlace) {
  write_run(folder(), run);
  ASSERT_EQ(hfrac_viz_write_paraview_script(folder().c_str()), HFRAC_OK) << last_error();
  const std::string script = file_text(file("paraview_state.py"));
  EXPECT_TRUE(holds(script, "PVDReader"));
  EXPECT_TRUE(holds(script, "WIDTH, HEIGHT = 12, 12"));
  EXPECT_FALSE(holds(script, folder().string()));
}

}  // namespace
}  // namespace hfrac::viz_test
