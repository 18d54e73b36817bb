// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "io/markup.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut {
namespace {

constexpr double kWidth = 600.0;
constexpr double kHeight = 380.0;
constexpr double kLeft = 66.0;
constexpr double kRight = 18.0;
constexpr double kTop = 74.0;
constexpr double kBottom = 54.0;
constexpr std::size_t kNumColors = 5;
/// About the width of a letter.
constexpr double kLetter = 7.4;
/// Beyond this span of values bars stand on a logarithmic axis.
constexpr double kLogSpan = 30.0;
constexpr const char* kLogarithmic = " (logarithmic)";

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.5g", value);
    return text.data();
}

/// As it is read: 1.75 M, 12.3 k, 1,230 and 0.012.
std::string figure(double value) {
    std::array<char, 32> text{};
    const double magnitude = std::abs(value);
    if (magnitude >= 1e6) return number(std::round(value / 1e4) / 100.0) + " M";
    if (magnitude >= 1e4) return number(std::round(value / 100.0) / 10.0) + " k";
    const int decimals = magnitude >= 100.0 || magnitude == 0.0 ? 0
                         : magnitude >= 10.0                    ? 1
                         : magnitude >= 1.0                     ? 2
                                                                : 3;
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    std::string result = text.data();
    if (result.find('.') != std::string::npos) {
        result.erase(result.find_last_not_of('0') + 1);
        if (result.back() == '.') result.pop_back();
    }
    return reproduce::with_commas(std::move(result));
}

/// A round number of about a fifth of the range.
double tick(double range) {
    const double rough = std::max(range, 1e-9) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (rough <= step * power) return step * power;
    }
    return 10.0 * power;
}

double power_of_ten_below(double value) {
    return std::pow(10.0, std::floor(std::log10(value * 0.999)));
}

/// Collects an SVG; colours are classes, which follow the reader's choice of light or dark.
class Drawing {
public:
    explicit Drawing(const std::string& title) {
        svg_ = "<!-- Written by quadcut -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
               number(kWidth) + "\" height=\"" + number(kHeight) + "\" viewBox=\"0 0 " +
               number(kWidth) + " " + number(kHeight) + "\" role=\"img\">\n<title>" +
               io::escaped(title) +
               "</title>\n<style>\n"
               "text { font: 14px system-ui, 'DejaVu Sans', sans-serif; fill: #2d3642; }\n"
               ".title { font-weight: 600; font-size: 16px; } .soft { fill: #5d6874; }\n"
               ".value { font-size: 12px; } .paper { fill: #fdfdfb; }\n"
               ".grid { stroke: #dcdfe3; } .axis { stroke: #69737f; }\n"
               ".line { fill: none; stroke-width: 2; stroke-linejoin: round; }\n"
               ".s0 { stroke: #1f5fa8; } .f0 { fill: #1f5fa8; }\n"
               ".s1 { stroke: #c8502d; } .f1 { fill: #c8502d; }\n"
               ".s2 { stroke: #3c8c4a; } .f2 { fill: #3c8c4a; }\n"
               ".s3 { stroke: #7a5ba6; } .f3 { fill: #7a5ba6; }\n"
               ".s4 { stroke: #8a6d1f; } .f4 { fill: #8a6d1f; }\n"
               "@media (prefers-color-scheme: dark) {\n"
               "text { fill: #e2e6ea; } .soft { fill: #a8b2bd; } .paper { fill: #1d2228; }\n"
               ".grid { stroke: #343b44; } .axis { stroke: #9aa5b1; }\n"
               ".s0 { stroke: #6fb1f5; } .f0 { fill: #6fb1f5; }\n"
               ".s1 { stroke: #f0956f; } .f1 { fill: #f0956f; }\n"
               ".s2 { stroke: #7fce8d; } .f2 { fill: #7fce8d; }\n"
               ".s3 { stroke: #b89ae6; } .f3 { fill: #b89ae6; }\n"
               ".s4 { stroke: #d9bb62; } .f4 { fill: #d9bb62; }\n"
               "}\n</style>\n<rect class=\"paper\" width=\"" +
               number(kWidth) + "\" height=\"" + number(kHeight) + "\" rx=\"6\"/>\n";
        text(16.0, 26.0, "start", title, "title");
    }

    void text(double x, double y, const char* anchor, const std::string& words,
              const std::string& kind = "soft") {
        svg_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor +
                "\" class=\"" + kind + "\">" + io::escaped(words) + "</text>\n";
    }
    void line(double x1, double y1, double x2, double y2, const char* kind) {
        svg_ += "<line x1=\"" + number(x1) + "\" x2=\"" + number(x2) + "\" y1=\"" + number(y1) +
                "\" y2=\"" + number(y2) + "\" class=\"" + kind + "\"/>\n";
    }
    void bar(double x, double y, double width, double height, std::size_t color) {
        svg_ += "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) +
                "\" height=\"" + number(height) + "\" class=\"" + fill(color) + "\"/>\n";
    }
    void curve(const std::vector<Point>& points, std::size_t color) {
        svg_ += "<polyline class=\"line s" + std::to_string(color % kNumColors) + "\" points=\"";
        for (const Point& point : points) svg_ += number(point.x) + "," + number(point.y) + " ";
        svg_ += "\"/>\n";
    }
    void dots(const std::vector<Point>& points, std::size_t color) {
        svg_ += "<g class=\"" + fill(color) + "\">";
        for (const Point& point : points) {
            svg_ +=
                "<circle cx=\"" + number(point.x) + "\" cy=\"" + number(point.y) + "\" r=\"2.2\"/>";
        }
        svg_ += "</g>\n";
    }
    /// One line of names below the title, each with a square of its colour.
    void legend(const std::vector<std::string>& names) {
        double x = 16.0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            bar(x, 40.0, 11.0, 11.0, i);
            text(x + 16.0, 50.5, "start", names[i]);
            x += 34.0 + kLetter * static_cast<double>(names[i].size());
        }
    }
    std::string finish() { return std::move(svg_) + "</svg>\n"; }

private:
    static std::string fill(std::size_t color) { return "f" + std::to_string(color % kNumColors); }

    std::string svg_;
};

bool is_finite(const Point& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

/// The values of the y axis, and where they are.
class Scale {
public:
    Scale(double low, double high, bool is_log) : low_(low), high_(high), is_log_(is_log) {}

    [[nodiscard]] double at(double value) const {
        const double share = is_log_
                                 ? std::log(std::max(value, low_) / low_) / std::log(high_ / low_)
                                 : (std::min(value, high_) - low_) / (high_ - low_);
        return kHeight - kBottom - share * (kHeight - kTop - kBottom - 14.0);
    }
    void draw(Drawing& drawing) const {
        const double step = is_log_ ? 10.0 : tick(high_ - low_);
        for (double value = low_; value <= high_ * 1.0001;
             value = is_log_ ? value * step : value + step) {
            drawing.line(kLeft, at(value), kWidth - kRight, at(value), "grid");
            drawing.text(kLeft - 8.0, at(value) + 5.0, "end", figure(value));
        }
    }

private:
    double low_;
    double high_;
    bool is_log_;
};

}  // namespace

std::string to_svg(const Plot& plot) {
    double x_max = 1e-9;
    double y_max = std::max(plot.y_max, 1e-9);
    double y_min = std::numeric_limits<double>::max();
    const auto is_shown = [&plot](const Point& point) {
        return is_finite(point) && (!plot.is_y_log || point.y > 0.0);
    };
    std::vector<std::string> names;
    for (const Curve& curve : plot.curves) {
        names.push_back(curve.name);
        for (const Point& point : curve.points) {
            if (!is_shown(point)) continue;
            x_max = std::max(x_max, point.x);
            y_min = std::min(y_min, point.y);
            if (plot.y_max == 0.0) y_max = std::max(y_max, point.y);
        }
    }
    const Scale scale(plot.is_y_log ? power_of_ten_below(std::min(y_min, y_max)) : 0.0, y_max,
                      plot.is_y_log);
    const auto px = [&](double x) { return kLeft + x / x_max * (kWidth - kLeft - kRight); };
    Drawing drawing(plot.title);
    if (names.size() > 1) drawing.legend(names);
    scale.draw(drawing);
    const double x_step = plot.is_x_whole ? std::max(1.0, std::floor(tick(x_max))) : tick(x_max);
    for (double x = 0.0; x <= x_max * 1.0001; x += x_step) {
        drawing.text(px(x), kHeight - kBottom + 20.0, "middle", figure(x));
    }
    drawing.line(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom, "axis");
    drawing.text((kLeft + kWidth) / 2.0, kHeight - 12.0, "middle", plot.x_name);
    drawing.text(16.0, kTop - 2.0, "start", plot.y_name + (plot.is_y_log ? kLogarithmic : ""));
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        std::vector<Point> points;
        for (const Point& point : plot.curves[i].points) {
            if (is_shown(point)) points.push_back({px(point.x), scale.at(point.y)});
        }
        if (plot.curves[i].style == CurveStyle::line) drawing.curve(points, i);
        if (plot.curves[i].style == CurveStyle::dots || points.size() < 12) drawing.dots(points, i);
    }
    return drawing.finish();
}

std::string to_svg(const BarPlot& plot) {
    double low = 0.0;
    double high = 0.0;
    std::vector<std::string> names;
    for (const BarSeries& series : plot.series) {
        names.push_back(series.name);
        for (const double value : series.values) {
            if (!(value > 0.0) || !std::isfinite(value)) continue;
            low = low == 0.0 ? value : std::min(low, value);
            high = std::max(high, value);
        }
    }
    high = std::max(high, 1e-9);
    const bool is_log = low > 0.0 && high / low > kLogSpan;
    const double base = is_log ? power_of_ten_below(low) : 0.0;
    const Scale scale(base, high, is_log);
    Drawing drawing(plot.title);
    if (names.size() > 1) drawing.legend(names);
    scale.draw(drawing);
    drawing.text((kLeft + kWidth) / 2.0, kHeight - 12.0, "middle", plot.x_name);
    const double group = (kWidth - kLeft - kRight) /
                         static_cast<double>(std::max<std::size_t>(1, plot.groups.size()));
    const double width =
        0.84 * group / static_cast<double>(std::max<std::size_t>(1, plot.series.size()));
    for (std::size_t i = 0; i < plot.groups.size(); ++i) {
        const double left = kLeft + (static_cast<double>(i) + 0.08) * group;
        drawing.text(left + 0.42 * group, kHeight - kBottom + 20.0, "middle", plot.groups[i]);
        for (std::size_t k = 0; k < plot.series.size(); ++k) {
            const double value = i < plot.series[k].values.size() ? plot.series[k].values[i] : 0.0;
            if (!(value > 0.0) || !std::isfinite(value)) continue;
            const double x = left + static_cast<double>(k) * width;
            const double y = scale.at(value);
            drawing.bar(x + 1.0, y, width - 2.0, std::max(1.0, kHeight - kBottom - y), k);
            drawing.text(x + width / 2.0, y - 5.0, "middle", figure(value), "value");
        }
    }
    drawing.line(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom, "axis");
    drawing.text(16.0, kTop - 2.0, "start", plot.y_name + (is_log ? kLogarithmic : ""));
    return drawing.finish();
}

}  // namespace quadcut
