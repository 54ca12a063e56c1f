#include "image/contact_sheet.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace ajar {
namespace {

constexpr std::uint32_t MARGIN = 28, GAP = 20;    // pixels: around the sheet, between cells
constexpr std::uint32_t TITLE = 30, CAPTION = 26; // heights of a cell's lines
constexpr std::uint32_t SHEET_TITLE = 44;         // height of the sheet's
constexpr std::uint32_t INSET_GAP = 6, FRAME = 3; // between picture and insets; their frames
constexpr std::uint32_t SMALLEST_CELL = 220;      // room for a line of text
constexpr std::uint32_t LARGEST_CELL = 480;
constexpr float TITLE_CAPITALS = 11, CAPTION_CAPITALS = 9, SHEET_CAPITALS = 15; // heights in pixels
constexpr std::uint64_t MOST_PIXELS = std::uint64_t{1} << 27;

const glm::vec3 PAPER(1), INK(0.13f), FAINT(0.36f);
// Of Okabe and Ito (2008), the ones that stand out of pictures: vermilion, sky blue, yellow, bluish green.
const std::array FRAMES{glm::vec3(0.90f, 0.25f, 0.0f), glm::vec3(0.16f, 0.62f, 0.96f),
                        glm::vec3(0.94f, 0.89f, 0.26f), glm::vec3(0.0f, 0.62f, 0.45f)};

struct Layout {
    std::uint32_t picture_width = 0, picture_height = 0; // as shown
    std::uint32_t inset_width = 0, inset_height = 0;     // of one, 0 without
    std::uint32_t cell_width() const { return picture_width; }
    std::uint32_t cell_height() const {
        return TITLE + picture_height + (inset_height > 0 ? INSET_GAP + inset_height : 0) + CAPTION;
    }
    std::uint64_t sheet_width(std::size_t columns) const {
        return 2 * MARGIN + std::uint64_t{columns} * (cell_width() + GAP) - GAP;
    }
    std::uint64_t sheet_height(std::size_t rows) const {
        return 2 * MARGIN + SHEET_TITLE + std::uint64_t{rows} * (cell_height() + GAP) - GAP;
    }
};

// Whole multiples or fractions of the pictures' size, so that every pixel is shown alike.
Layout layout(std::uint32_t width, std::uint32_t height, const std::vector<Region>& insets) {
    Layout l;
    const std::uint32_t up = std::max(1u, (SMALLEST_CELL + width - 1) / width);
    const std::uint32_t down = (width + LARGEST_CELL - 1) / LARGEST_CELL;
    l.picture_width = std::max(1u, width * up / down);
    l.picture_height = std::max(1u, height * up / down);
    if (insets.empty()) return l;
    const auto count = static_cast<std::uint32_t>(insets.size());
    l.inset_width = (l.picture_width - std::min((count - 1) * INSET_GAP, l.picture_width / 2)) / count;
    double aspect = 0; // the tallest decides
    for (const Region& r : insets)
        aspect = std::max(aspect, static_cast<double>(r.height) / std::max(r.width, 1u));
    const double tall = std::clamp(l.inset_width * aspect, 1.0, 2.0 * l.picture_height);
    l.inset_height = static_cast<std::uint32_t>(tall);
    return l;
}

Region cut(Region r, std::uint32_t width, std::uint32_t height) {
    r.x = std::min(r.x, width - 1), r.y = std::min(r.y, height - 1);
    r.width = std::clamp(r.width, 1u, width - r.x), r.height = std::clamp(r.height, 1u, height - r.y);
    return r;
}

std::vector<Region> cut(std::vector<Region> insets, const Image& image) {
    for (Region& r : insets) r = cut(r, image.width, image.height);
    return insets;
}

// Smaller letters where a line would be too long, then an end in dots.
void fitted_text(Canvas& canvas, std::uint32_t x, std::uint32_t y, std::string text, float capitals,
                 std::uint32_t room, const glm::vec3& color) {
    const auto fits = static_cast<float>(room);
    while (capitals > 8 && text_width(text, capitals) > fits) capitals -= 0.5f;
    if (text_width(text, capitals) > fits) {
        while (!text.empty() && text_width(text + "...", capitals) > fits) text.pop_back();
        text += "...";
    }
    canvas.text(static_cast<float>(x), static_cast<float>(y), text, capitals, color);
}

void draw_insets(Canvas& canvas, const ContactSheet& sheet, const Layout& l, const SheetCell& cell,
                 std::uint32_t x, std::uint32_t y) {
    const Image& image = *cell.image;
    const std::vector<Region> insets = cut(sheet.insets, image);
    for (std::size_t i = 0; i < insets.size(); ++i) {
        const glm::vec3 color = FRAMES[i % FRAMES.size()];
        const auto left = x + static_cast<std::uint32_t>(i) * (l.inset_width + INSET_GAP);
        const std::uint32_t tall = std::max(1u, l.inset_width * insets[i].height / insets[i].width);
        const Region to{left, y + l.picture_height + INSET_GAP, l.inset_width,
                        std::min(tall, l.inset_height)};
        canvas.picture(to, image, insets[i], sheet.tonemap);
        canvas.frame(to, FRAME, color);
        if (!cell.frames_insets) continue;
        const auto scaled = [&](std::uint32_t v) {
            return static_cast<std::uint32_t>(std::uint64_t{v} * l.picture_width / image.width);
        };
        canvas.frame({x + scaled(insets[i].x), y + scaled(insets[i].y), std::max(scaled(insets[i].width), 4u),
                      std::max(scaled(insets[i].height), 4u)},
                     2, color);
    }
}

void draw_cell(Canvas& canvas, const ContactSheet& sheet, const Layout& l, const SheetCell& cell,
               std::uint32_t x, std::uint32_t y) {
    fitted_text(canvas, x, y + TITLE - 10, cell.title, TITLE_CAPITALS, l.cell_width(), INK);
    canvas.picture({x, y + TITLE, l.picture_width, l.picture_height}, *cell.image,
                   {0, 0, cell.image->width, cell.image->height}, sheet.tonemap);
    draw_insets(canvas, sheet, l, cell, x, y + TITLE);
    fitted_text(canvas, x, y + l.cell_height() - 7, cell.caption, CAPTION_CAPITALS, l.cell_width(), FAINT);
}

const Image& check(const ContactSheet& sheet) {
    const Image* first = nullptr;
    for (const auto& row : sheet.rows)
        for (const SheetCell& cell : row) {
            if (!first) first = cell.image;
            if (cell.image->width != first->width || cell.image->height != first->height)
                throw Error(fmt::format("contact sheet: '{}' is {} x {} pixels, others are {} x {}",
                                        cell.title, cell.image->width, cell.image->height, first->width,
                                        first->height));
        }
    if (!first || first->pixel_count() == 0) throw Error("contact sheet: there is no picture to show");
    return *first;
}

} // namespace

Image contact_sheet(const ContactSheet& sheet) {
    const Image& first = check(sheet);
    const Layout l = layout(first.width, first.height, cut(sheet.insets, first));
    std::size_t columns = 0;
    for (const auto& row : sheet.rows) columns = std::max(columns, row.size());
    const std::uint64_t width = l.sheet_width(columns), height = l.sheet_height(sheet.rows.size());
    if (width * height > MOST_PIXELS)
        throw Error(fmt::format("contact sheet: {} x {} pixels are too many (fewer cases, or a narrower "
                                "picture, help)",
                                width, height));
    Canvas canvas(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), PAPER);
    fitted_text(canvas, MARGIN, MARGIN + 20, sheet.title, SHEET_CAPITALS,
                static_cast<std::uint32_t>(width) - 2 * MARGIN, INK);
    std::uint32_t y = MARGIN + SHEET_TITLE;
    for (const auto& row : sheet.rows) {
        std::uint32_t x = MARGIN;
        for (const SheetCell& cell : row) {
            draw_cell(canvas, sheet, l, cell, x, y);
            x += l.cell_width() + GAP;
        }
        y += l.cell_height() + GAP;
    }
    return canvas.image();
}

std::vector<std::vector<SheetCell>> flow(std::vector<SheetCell> cells, const ContactSheet& sheet) {
    if (cells.empty()) return {};
    constexpr double SCREEN = 1.6; // width over height
    const Image& image = *cells.front().image;
    const Layout l = layout(image.width, image.height, cut(sheet.insets, image));
    std::size_t best = 1;
    double least = INFINITY;
    for (std::size_t columns = 1; columns <= cells.size(); ++columns) {
        const std::size_t rows = (cells.size() + columns - 1) / columns;
        const double aspect =
            static_cast<double>(l.sheet_width(columns)) / static_cast<double>(l.sheet_height(rows));
        const double empty = 1 - static_cast<double>(cells.size()) / static_cast<double>(rows * columns);
        const double cost = std::abs(std::log(aspect / SCREEN)) + 1.5 * empty;
        if (cost < least) least = cost, best = columns;
    }
    std::vector<std::vector<SheetCell>> rows;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i % best == 0) rows.emplace_back();
        rows.back().push_back(std::move(cells[i]));
    }
    return rows;
}

} // namespace ajar
