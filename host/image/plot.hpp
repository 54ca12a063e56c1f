// Curves on two logarithmic axes as an SVG document: what `ajar lab` draws convergence with. White
// background, decade grid, the palette of Okabe and Ito (2008), which colour-blind readers can tell apart;
// lines differ by their marks and dashes too.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ajar {

struct PlotPoint {
    double x = 0, y = 0;
};

struct PlotLine {
    std::string name; // in the legend and in each mark's tooltip
    std::vector<PlotPoint> points;
};

struct LogPlot {
    std::string title;
    std::string x_label, y_label;
    std::vector<PlotLine> lines;
    // Exponent of a dashed guide through the middle of the lines' first points, such as -0.5.
    std::optional<double> guide_exponent;
};

// A whole document. Points that a logarithm cannot show (zero, negative, not finite) are left out; text may
// hold anything. The same plot gives the same bytes.
std::string log_log_svg(const LogPlot& plot);

} // namespace ajar
