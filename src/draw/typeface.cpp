// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/typeface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include "draw/font.hpp"
#include "io/utf8.hpp"

namespace quadcut::draw {
namespace {

/// Straight pieces a curve of a letter becomes: at label sizes no corner is seen.
constexpr int kPiecesPerCurve = 5;

/// Frees the outline that stb allocated.
struct GlyphOutline {
    const stbtt_fontinfo* font = nullptr;
    stbtt_vertex* vertices = nullptr;
    int num_vertices = 0;

    GlyphOutline(const stbtt_fontinfo& info, int glyph) : font(&info) {
        num_vertices = stbtt_GetGlyphShape(&info, glyph, &vertices);
    }
    GlyphOutline(const GlyphOutline&) = delete;
    GlyphOutline& operator=(const GlyphOutline&) = delete;
    ~GlyphOutline() { stbtt_FreeShape(font, vertices); }

    [[nodiscard]] std::span<const stbtt_vertex> span() const {
        return {vertices, static_cast<std::size_t>(std::max(num_vertices, 0))};
    }
};

Point between(Point a, Point b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

void append_glyph(const GlyphOutline& glyph, double left, double scale,
                  std::vector<std::vector<Point>>& lines) {
    const auto place = [&](short x, short y) { return Point{left + scale * x, -scale * y}; };
    for (const stbtt_vertex& vertex : glyph.span()) {
        const Point to = place(vertex.x, vertex.y);
        if (vertex.type == STBTT_vmove) {
            lines.emplace_back(1, to);
        } else if (vertex.type == STBTT_vline) {
            lines.back().push_back(to);
        } else {  // TrueType has quadratic curves only.
            const Point from = lines.back().back();
            const Point control = place(vertex.cx, vertex.cy);
            for (int i = 1; i <= kPiecesPerCurve; ++i) {
                const double t = static_cast<double>(i) / kPiecesPerCurve;
                lines.back().push_back(
                    between(between(from, control, t), between(control, to, t), t));
            }
        }
    }
}

/// A line of text in font units.
struct TextLayout {
    struct Glyph {
        int index = 0;
        int x = 0;
    };
    std::vector<Glyph> glyphs;
    int width = 0;
};

}  // namespace

struct Typeface::Font {
    stbtt_fontinfo info = {};

    [[nodiscard]] double scale(double size) const {
        return static_cast<double>(stbtt_ScaleForMappingEmToPixels(&info, 1.0F)) * size;
    }

    [[nodiscard]] TextLayout lay_out(std::string_view bytes) const {
        TextLayout layout;
        int previous = 0;
        for (const char32_t code_point : io::decode_utf8(bytes)) {
            const int glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(code_point));
            if (previous != 0) layout.width += stbtt_GetGlyphKernAdvance(&info, previous, glyph);
            layout.glyphs.push_back({glyph, layout.width});
            int advance = 0;
            int bearing = 0;
            stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
            layout.width += advance;
            previous = glyph;
        }
        return layout;
    }
};

Typeface::Typeface() : font_(std::make_unique<Font>()) {
    if (stbtt_InitFont(&font_->info, label_font().data(), 0) == 0) {
        throw std::logic_error("the label font is no TrueType font");
    }
}
Typeface::Typeface(Typeface&&) noexcept = default;
Typeface& Typeface::operator=(Typeface&&) noexcept = default;
Typeface::~Typeface() = default;

double Typeface::width(std::string_view text, double size) const {
    return width(length_units(text), size);
}

int Typeface::length_units(std::string_view text) const { return font_->lay_out(text).width; }

double Typeface::width(int length_units, double size) const {
    return font_->scale(size) * length_units;
}

double Typeface::cap_height(double size) const {
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;
    stbtt_GetCodepointBox(&font_->info, 'H', &left, &bottom, &right, &top);
    return font_->scale(size) * top;
}

std::vector<std::vector<Point>> Typeface::outlines(std::string_view text, double size) const {
    const double scale = font_->scale(size);
    std::vector<std::vector<Point>> lines;
    for (const TextLayout::Glyph& glyph : font_->lay_out(text).glyphs) {
        append_glyph(GlyphOutline(font_->info, glyph.index), scale * glyph.x, scale, lines);
    }
    return lines;
}

}  // namespace quadcut::draw
