#include "image/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace ajar {
namespace {

constexpr double LEFT = 84, TOP = 52, WIDTH = 560, HEIGHT = 400, BOTTOM = 64; // pixels
constexpr double LEGEND_ROW = 22, LEGEND_GAP = 26, LEGEND_KEY = 34;
constexpr double CHARACTER = 7; // mean advance of 13 pixel sans serif

constexpr std::array PALETTE{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#222222"};
constexpr std::array MARKS{"M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z", "M-3.7,-3.7h7.4v7.4h-7.4z",
                           "M0,-4.8l4.6,8h-9.2z", "M0,-5l5,5l-5,5l-5,-5z"};
constexpr std::array DASHES{"", "7 3", "2 3"};

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            out += c;
        else
            out += ' '; // XML 1.0 knows no control characters
    }
    return out;
}

// Bytes that are no UTF-8 would make the document invalid.
std::string valid_utf8(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80                   ? 1
                                   : lead >= 0xc2 && lead < 0xe0 ? 2
                                   : lead >= 0xe0 && lead < 0xf0 ? 3
                                                                 : 0;
        bool good = length > 0 && i + length <= text.size();
        for (std::size_t k = 1; good && k < length; ++k)
            good = (static_cast<unsigned char>(text[i + k]) & 0xc0u) == 0x80u;
        // Overlong forms and surrogates of three bytes, and the two that XML excludes.
        if (good && length == 3) {
            const unsigned code = (lead & 0xfu) << 12 |
                                  (static_cast<unsigned char>(text[i + 1]) & 0x3fu) << 6 |
                                  (static_cast<unsigned char>(text[i + 2]) & 0x3fu);
            good = code >= 0x800 && (code < 0xd800 || code > 0xdfff) && code < 0xfffe;
        }
        out += good ? text.substr(i, length) : "?";
        i += good ? length : 1;
    }
    return out;
}

std::string plain(const std::string& text) { return escaped(valid_utf8(text)); }

bool showable(const PlotPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y) && p.x > 0 && p.y > 0; }

// One axis: decimal logarithms from `low` to `high`, shown from pixel `from` to pixel `to`.
struct Axis {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    double from = 0, to = 1;

    void include(double value) {
        low = std::min(low, std::log10(value));
        high = std::max(high, std::log10(value));
    }
    // Room at both ends, at least one decade, and at most what doubles can name.
    void settle() {
        if (!(low <= high)) low = -1, high = 1;
        const double spare = std::max(0.04 * (high - low), (1 - (high - low)) / 2);
        low = std::max(low - spare, -307.0);
        high = std::min(high + spare, 308.0);
    }
    double at(double log_value) const { return from + (log_value - low) / (high - low) * (to - from); }
};

std::string superscript(int number) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = number < 0 ? "⁻" : "";
    for (const char c : fmt::format("{}", std::abs(number))) out += digits[static_cast<std::size_t>(c - '0')];
    return out;
}

std::string tick_label(int digit, int exponent) {
    if (exponent >= -3 && exponent <= 4) return fmt::format("{:g}", digit * std::pow(10.0, exponent));
    return digit == 1 ? fmt::format("10{}", superscript(exponent))
                      : fmt::format("{}·10{}", digit, superscript(exponent));
}

// Calls line(log value, is a decade) and label(log value, text).
template <class Line, class Label> void for_ticks(const Axis& axis, Line line, Label label) {
    const double span = axis.high - axis.low;
    const int step = std::max(1, static_cast<int>(std::ceil(span / 9))); // decades from label to label
    for (int decade = static_cast<int>(std::floor(axis.low)); decade <= axis.high; ++decade)
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = decade + std::log10(digit);
            if (value < axis.low || value > axis.high) continue;
            const bool between = digit == 2 || digit == 5;
            if (digit == 1 ? decade % step == 0 : span < 4) line(value, digit == 1);
            if (digit == 1 ? decade % step == 0 : between && span < 2.5)
                label(value, tick_label(digit, decade));
        }
}

void add_axes(std::string& svg, const LogPlot& plot, const Axis& x, const Axis& y) {
    const auto grid = [&](double x1, double y1, double x2, double y2, bool decade) {
        svg += fmt::format("<path d=\"M{:.1f},{:.1f}L{:.1f},{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2,
                           decade ? "#c8c8c8" : "#ececec");
    };
    const auto text = [&](double px, double py, const char* anchor, const std::string& label) {
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", px, py, anchor,
                           label);
    };
    for_ticks(
        x, [&](double v, bool decade) { grid(x.at(v), TOP, x.at(v), TOP + HEIGHT, decade); },
        [&](double v, const std::string& label) { text(x.at(v), TOP + HEIGHT + 19, "middle", label); });
    for_ticks(
        y, [&](double v, bool decade) { grid(LEFT, y.at(v), LEFT + WIDTH, y.at(v), decade); },
        [&](double v, const std::string& label) { text(LEFT - 8, y.at(v) + 4.5, "end", label); });
    svg +=
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#555555\"/>\n",
                    LEFT, TOP, WIDTH, HEIGHT);
    text(LEFT + WIDTH / 2, TOP + HEIGHT + 46, "middle", plain(plot.x_label));
    svg += fmt::format("<text transform=\"translate(22,{}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       TOP + HEIGHT / 2, plain(plot.y_label));
    svg += fmt::format("<text x=\"{}\" y=\"30\" font-size=\"16\" font-weight=\"600\">{}</text>\n", LEFT,
                       plain(plot.title));
}

struct Style {
    const char* color;
    const char* mark;
    const char* dash;
};

Style style(std::size_t line) {
    const std::size_t round =
        line / PALETTE.size(); // colours come again with other dashes, and mostly other marks
    return {PALETTE[line % PALETTE.size()], MARKS[line % MARKS.size()], DASHES[round % DASHES.size()]};
}

std::string stroke(const Style& s) {
    return fmt::format("stroke=\"{}\" stroke-width=\"2\"{}", s.color,
                       *s.dash ? fmt::format(" stroke-dasharray=\"{}\"", s.dash) : "");
}

std::string mark_at(const Style& s, double x, double y, const std::string& tooltip) {
    return fmt::format("<path class=\"mark\" transform=\"translate({:.2f},{:.2f})\" d=\"{}\" fill=\"{}\" "
                       "stroke=\"white\">{}</path>\n",
                       x, y, s.mark, s.color, tooltip);
}

void add_line(std::string& svg, const PlotLine& line, const Style& s, const Axis& x, const Axis& y) {
    std::string way, marks;
    for (const PlotPoint& p : line.points) {
        if (!showable(p)) continue;
        const double px = x.at(std::log10(p.x)), py = y.at(std::log10(p.y));
        way += fmt::format("{}{:.2f},{:.2f}", way.empty() ? "M" : "L", px, py);
        marks +=
            mark_at(s, px, py, fmt::format("<title>{}: {:.4g}, {:.4g}</title>", plain(line.name), p.x, p.y));
    }
    if (!way.empty()) svg += fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", way, stroke(s));
    svg += marks;
}

constexpr const char* GUIDE_STROKE = "stroke=\"#777777\" stroke-width=\"1.5\" stroke-dasharray=\"6 5\"";

void add_guide(std::string& svg, const LogPlot& plot, const Axis& x, const Axis& y) {
    double sum_x = 0, sum_y = 0;
    int count = 0;
    for (const PlotLine& line : plot.lines) {
        const auto first = std::find_if(line.points.begin(), line.points.end(), showable);
        if (first == line.points.end()) continue;
        sum_x += std::log10(first->x), sum_y += std::log10(first->y), ++count;
    }
    if (count == 0) return;
    const auto height = [&](double log_x) {
        return y.at(sum_y / count + *plot.guide_exponent * (log_x - sum_x / count));
    };
    svg += fmt::format("<path clip-path=\"url(#area)\" d=\"M{:.2f},{:.2f}L{:.2f},{:.2f}\" {}/>\n", x.from,
                       height(x.low), x.to, height(x.high), GUIDE_STROKE);
}

void add_legend(std::string& svg, const LogPlot& plot) {
    const double left = LEFT + WIDTH + LEGEND_GAP;
    double row = TOP + 12;
    const auto name = [&](const std::string& text) {
        svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", left + LEGEND_KEY, row + 4.5, plain(text));
        row += LEGEND_ROW;
    };
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const Style s = style(i);
        svg += fmt::format("<path d=\"M{},{}h26\" {}/>\n", left, row, stroke(s));
        svg += fmt::format("<path transform=\"translate({},{})\" d=\"{}\" fill=\"{}\" stroke=\"white\"/>\n",
                           left + 13, row, s.mark, s.color);
        name(plot.lines[i].name);
    }
    if (!plot.guide_exponent) return;
    svg += fmt::format("<path d=\"M{},{}h26\" {}/>\n", left, row, GUIDE_STROKE);
    name(fmt::format("slope {:g}", *plot.guide_exponent));
}

} // namespace

std::string log_log_svg(const LogPlot& plot) {
    Axis x, y;
    x.from = LEFT, x.to = LEFT + WIDTH, y.from = TOP + HEIGHT, y.to = TOP;
    std::size_t longest = 12;
    for (const PlotLine& line : plot.lines) {
        longest = std::max(longest, line.name.size());
        for (const PlotPoint& p : line.points)
            if (showable(p)) x.include(p.x), y.include(p.y);
    }
    const bool empty = !(x.low <= x.high);
    x.settle(), y.settle();
    const double width =
        LEFT + WIDTH + LEGEND_GAP + LEGEND_KEY + CHARACTER * static_cast<double>(longest) + 16;
    const double legend = TOP + LEGEND_ROW * static_cast<double>(plot.lines.size() + 2);
    const double height = std::max(TOP + HEIGHT + BOTTOM, legend);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" "
        "fill=\"#222222\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        "<clipPath id=\"area\"><rect x=\"{2}\" y=\"{3}\" width=\"{4}\" height=\"{5}\"/></clipPath>\n",
        width, height, LEFT, TOP, WIDTH, HEIGHT);
    add_axes(svg, plot, x, y);
    if (plot.guide_exponent) add_guide(svg, plot, x, y);
    for (std::size_t i = 0; i < plot.lines.size(); ++i) add_line(svg, plot.lines[i], style(i), x, y);
    if (empty)
        svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">nothing to show</text>\n",
                           LEFT + WIDTH / 2, TOP + HEIGHT / 2);
    add_legend(svg, plot);
    return svg + "</svg>\n";
}

} // namespace ajar
