// Plots: an SVG that XML readers take, marks where the data says, and whatever numbers come.
#include "image/plot.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <regex>
#include <set>

namespace ajar::test {

namespace {

// Every tag closed in order, attributes quoted, no stray < or &. Enough of XML for what the writer may emit.
bool well_formed(const std::string& text) {
    static const std::regex tag(R"(<(/?)([a-zA-Z]+)((?:\s+[a-zA-Z:-]+="[^"<]*")*)\s*(/?)>)");
    static const std::regex content(R"(([^<>&]|&(amp|lt|gt|quot);)*)");
    std::vector<std::string> open;
    std::string::const_iterator at = text.begin();
    for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
        if (!std::regex_match(std::string(at, (*it)[0].first), content)) return false;
        at = (*it)[0].second;
        const std::string name = (*it)[2], attributes = (*it)[3];
        if (!std::regex_match(attributes, content)) return false;
        if ((*it)[1].length() > 0) {
            if (open.empty() || open.back() != name) return false;
            open.pop_back();
        } else if ((*it)[4].length() == 0)
            open.push_back(name);
    }
    return open.empty() && std::string(at, text.end()) == "\n";
}

std::vector<PlotPoint> marks(const std::string& svg) {
    static const std::regex mark(R"re(class="mark" transform="translate\(([-0-9.]+),([-0-9.]+)\)")re");
    std::vector<PlotPoint> places;
    for (std::sregex_iterator it(svg.begin(), svg.end(), mark), end; it != end; ++it)
        places.push_back({std::stod((*it)[1]), std::stod((*it)[2])});
    return places;
}

std::string plot_of(std::vector<PlotPoint> points) {
    LogPlot plot{"title", "samples", "error", {}, -0.5};
    plot.lines.push_back({"line", std::move(points)});
    return log_log_svg(plot);
}

} // namespace

TEST(Plot, IsWellFormed) {
    EXPECT_TRUE(well_formed(plot_of({{1, 1}, {2, 0.7}, {4, 0.5}})));
    EXPECT_FALSE(well_formed("<a><b></a>\n")) << "this test no longer finds broken XML";
    EXPECT_FALSE(well_formed("<a>x & y</a>\n"));
}

TEST(Plot, PutsAPowerLawOntoALineOfItsSlope) {
    std::vector<PlotPoint> points;
    for (int i = 0; i < 8; ++i) points.push_back({std::exp2(i), 0.3 * std::exp2(-0.5 * i)});
    const auto at = marks(plot_of(points));
    ASSERT_EQ(at.size(), points.size());
    for (std::size_t i = 2; i < at.size(); ++i) {
        EXPECT_NEAR(at[i].x - at[i - 1].x, at[1].x - at[0].x, 0.02) << "equal factors, equal steps";
        EXPECT_NEAR(at[i].y - at[i - 1].y, at[1].y - at[0].y, 0.02);
    }
    EXPECT_GT(at[1].x, at[0].x);
    EXPECT_GT(at[1].y, at[0].y) << "y goes downwards in SVG: a smaller error is lower";
}

TEST(Plot, DecadesMeetTheirGridLines) {
    const std::string svg = plot_of({{1, 0.01}, {10, 0.1}, {100, 1}});
    for (const PlotPoint& p : marks(svg)) {
        char vertical[64], horizontal[64];
        std::snprintf(vertical, sizeof vertical, "M%.1f,", p.x);
        std::snprintf(horizontal, sizeof horizontal, ",%.1fL", p.y);
        EXPECT_NE(svg.find(vertical), std::string::npos) << vertical;
        EXPECT_NE(svg.find(horizontal), std::string::npos) << horizontal;
    }
    for (const char* label : {">0.01<", ">0.1<", ">1<", ">10<", ">100<"})
        EXPECT_NE(svg.find(label), std::string::npos) << label;
}

TEST(Plot, LeavesOutWhatALogarithmCannotShow) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    const std::string svg =
        plot_of({{1, 0}, {2, -1}, {0, 1}, {4, nan}, {nan, 1}, {infinite, 1}, {8, infinite}, {16, 0.5}});
    EXPECT_TRUE(well_formed(svg));
    EXPECT_EQ(marks(svg).size(), 1u);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Plot, OfNothingSaysSo) {
    EXPECT_NE(plot_of({}).find("nothing to show"), std::string::npos);
    EXPECT_TRUE(well_formed(plot_of({})));
    EXPECT_TRUE(well_formed(log_log_svg({})));
    EXPECT_EQ(plot_of({{3, 3}}).find("nothing to show"), std::string::npos);
}

TEST(Plot, BearsTheLargestAndSmallestNumbers) {
    const std::string svg = plot_of({{5e-324, 5e-324}, {1, 1}, {1.7e308, 1.7e308}});
    EXPECT_TRUE(well_formed(svg));
    EXPECT_LT(svg.size(), 100000u);
    for (const PlotPoint& p : marks(svg)) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(Plot, TextMayHoldAnything) {
    LogPlot plot{"a < b & \"c\"", "<x>", "]]>", {}, {}};
    plot.lines.push_back({"bell \a, half a letter \xc3", {{1, 1}}});
    plot.lines.push_back({"ä – 日本", {{1, 2}}});
    const std::string svg = log_log_svg(plot);
    EXPECT_TRUE(well_formed(svg));
    EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_NE(svg.find("half a letter ?"), std::string::npos);
    EXPECT_NE(svg.find("日本"), std::string::npos);
}

TEST(Plot, ManyLinesDifferByColourDashOrMark) {
    LogPlot plot{"", "", "", {}, {}};
    for (int i = 0; i < 20; ++i) plot.lines.push_back({std::to_string(i), {{1.0, i + 1.0}, {2.0, i + 1.0}}});
    const std::string svg = log_log_svg(plot);
    EXPECT_TRUE(well_formed(svg));
    static const std::regex way(R"re(fill="none" (stroke=[^/]*)/>)re");
    std::set<std::string> strokes;
    for (std::sregex_iterator it(svg.begin(), svg.end(), way), end; it != end; ++it) strokes.insert((*it)[1]);
    EXPECT_GE(strokes.size(), 20u);
}

} // namespace ajar::test
