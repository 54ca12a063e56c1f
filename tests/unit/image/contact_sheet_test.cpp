// Contact sheets: where things go, what is shown of pictures, and how places to magnify are found.
#include "image/contact_sheet.hpp"

#include "base/error.hpp"
#include "pictures.hpp"

#include <gtest/gtest.h>
#include <set>

namespace ajar::test {

namespace {

glm::vec3 pixel(const Image& image, std::uint32_t x, std::uint32_t y) {
    const float* p = image.layers[0].pixels.data() + 4 * (std::size_t{y} * image.width + x);
    return {p[0], p[1], p[2]};
}

std::size_t pixels_of(const Image& image, const glm::vec3& color, float tolerance = 0.02f) {
    std::size_t count = 0;
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const glm::vec3 off = glm::abs(pixel(image, x, y) - color);
            count += off.x < tolerance && off.y < tolerance && off.z < tolerance;
        }
    return count;
}

ContactSheet sheet_of(const Image& image, std::size_t columns, std::size_t rows) {
    ContactSheet sheet;
    sheet.title = "title";
    for (std::size_t r = 0; r < rows; ++r) {
        sheet.rows.emplace_back();
        for (std::size_t c = 0; c < columns; ++c) sheet.rows.back().push_back({"name", "caption", &image});
    }
    return sheet;
}

std::size_t ink(std::string_view text, float capitals) {
    Canvas canvas(400, 60, glm::vec3(1));
    canvas.text(10, 40, text, capitals, glm::vec3(0));
    const Image image = canvas.image();
    return image.pixel_count() - pixels_of(image, glm::vec3(1), 1e-4f);
}

} // namespace

TEST(CanvasTest, EveryLetterOfAsciiLeavesInkOfItsOwn) {
    std::set<std::vector<float>> seen;
    for (char c = '!'; c <= '~'; ++c) {
        Canvas canvas(60, 60, glm::vec3(1));
        canvas.text(10, 40, std::string(1, c), 24, glm::vec3(0));
        const Image image = canvas.image();
        EXPECT_LT(pixels_of(image, glm::vec3(1)), image.pixel_count()) << c;
        EXPECT_TRUE(seen.insert(image.layers[0].pixels).second) << c << " looks like another";
    }
    EXPECT_EQ(ink(" ", 20), 0u);
}

TEST(CanvasTest, TextIsAsWideAsItSays) {
    for (const std::string text : {"relMSE 0.0123", "WWW", "il", "ä"}) {
        const float width = text_width(text, 12);
        Canvas canvas(400, 60, glm::vec3(1));
        canvas.text(10, 40, text, 12, glm::vec3(0));
        const Image image = canvas.image();
        std::uint32_t right = 0;
        for (std::uint32_t x = 0; x < 400; ++x)
            for (std::uint32_t y = 0; y < 60; ++y)
                if (pixel(image, x, y).x < 0.5f) right = x;
        EXPECT_NEAR(static_cast<float>(right), 10 + width, 2.0f) << text;
    }
    EXPECT_EQ(text_width("", 12), 0);
}

TEST(CanvasTest, DrawsNothingOutsideOfItself) {
    Canvas canvas(20, 10, glm::vec3(0.5f));
    canvas.text(-30, 5, "far beyond the right end of it", 12, glm::vec3(0));
    canvas.text(5, 1000, "below", 12, glm::vec3(0));
    canvas.fill({15, 5, 100, 100}, glm::vec3(1));
    canvas.frame({18, 8, 50, 50}, 3, glm::vec3(0));
    canvas.picture({10, 0, 50, 50}, flat(3, 3, {1, 0, 0}), {0, 0, 3, 3}, Tonemap{});
    EXPECT_EQ(canvas.image().pixel_count(), 200u);
}

TEST(CanvasTest, PicturesAreEnlargedByRepeatingAndReducedByAveraging) {
    const Image checks = make_image(4, 4, [](std::uint32_t x, std::uint32_t y) {
        return (x + y) % 2 == 0 ? glm::vec3(1) : glm::vec3(0);
    });
    Canvas large(8, 8, glm::vec3(0.3f));
    large.picture({0, 0, 8, 8}, checks, {0, 0, 4, 4}, Tonemap{});
    const Image doubled = large.image();
    for (std::uint32_t y = 0; y < 8; ++y)
        for (std::uint32_t x = 0; x < 8; ++x)
            EXPECT_NEAR(pixel(doubled, x, y).x, (x / 2 + y / 2) % 2 == 0 ? 1 : 0, 1e-5);
    Canvas small(2, 2, glm::vec3(0));
    small.picture({0, 0, 2, 2}, checks, {0, 0, 4, 4}, Tonemap{});
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(pixel(small.image(), i % 2, i / 2).x, 0.5, 1e-3);
}

TEST(Sheet, ShowsEveryPictureAsOftenAsItIsThere) {
    const glm::vec3 red(0.8f, 0.1f, 0.1f);
    const Image image = flat(300, 200, red);
    const Image one = contact_sheet(sheet_of(image, 1, 1));
    EXPECT_EQ(pixels_of(one, red), 300u * 200u);
    const Image six = contact_sheet(sheet_of(image, 3, 2));
    EXPECT_EQ(pixels_of(six, red), 6u * 300u * 200u);
    EXPECT_EQ(six.width - one.width, 2 * (six.width - contact_sheet(sheet_of(image, 2, 2)).width));
    EXPECT_EQ(one.range, Range::display);
}

TEST(Sheet, EnlargesSmallPicturesAndReducesLargeOnes) {
    const glm::vec3 red(0.8f, 0.1f, 0.1f);
    const Image tiny = flat(16, 16, red), huge = flat(1920, 1080, red);
    EXPECT_EQ(pixels_of(contact_sheet(sheet_of(tiny, 1, 1)), red) % (16u * 16u), 0u);
    EXPECT_GE(contact_sheet(sheet_of(tiny, 1, 1)).width, 220u);
    EXPECT_EQ(pixels_of(contact_sheet(sheet_of(huge, 1, 1)), red), 480u * 270u);
}

TEST(Sheet, MagnifiesInsetsAndFramesTheirPlaces) {
    const glm::vec3 red(0.8f, 0.1f, 0.1f), blue(0.1f, 0.1f, 0.8f);
    const Image image = make_image(300, 200, [&](std::uint32_t x, std::uint32_t y) {
        return x >= 40 && x < 60 && y >= 50 && y < 65 ? blue : red;
    });
    ContactSheet sheet = sheet_of(image, 1, 1);
    sheet.insets = {{40, 50, 20, 15}};
    const std::size_t without = pixels_of(contact_sheet(sheet_of(image, 1, 1)), blue);
    EXPECT_EQ(without, 20u * 15u);
    const std::size_t with = pixels_of(contact_sheet(sheet), blue);
    // 300 pixels wide, less the frame of three on each side.
    EXPECT_NEAR(static_cast<double>(with), 300.0 + 294.0 * (300.0 * 15 / 20 - 6), 600);
    sheet.rows[0][0].frames_insets = true;
    EXPECT_LT(pixels_of(contact_sheet(sheet), blue), with) << "the frame lies on the picture";
}

TEST(Sheet, BearsInsetsBeyondThePictureAndLongNames) {
    const Image image = flat(40, 30, {0.5f, 0.5f, 0.5f});
    ContactSheet sheet = sheet_of(image, 2, 1);
    sheet.insets = {{0, 0, 4000, 4000}, {39, 29, 1, 1}, {4000, 4000, 0, 0}};
    sheet.rows[0][0].title = std::string(5000, 'W');
    sheet.rows[0][1].caption = "\xff\xfe\n\t";
    sheet.title.clear();
    EXPECT_GT(contact_sheet(sheet).pixel_count(), 0u);
}

TEST(Sheet, RefusesNothingAndUnlikeSizes) {
    EXPECT_THROW(contact_sheet({}), Error);
    const Image a = flat(4, 4, {1, 1, 1}), b = flat(5, 4, {1, 1, 1});
    ContactSheet sheet = sheet_of(a, 1, 1);
    sheet.rows[0].push_back({"b", "", &b});
    EXPECT_THROW(contact_sheet(sheet), Error);
}

TEST(Sheet, FlowKeepsOrderAndFillsRows) {
    const Image image = flat(200, 200, {1, 1, 1});
    for (std::size_t count = 1; count <= 30; ++count) {
        std::vector<SheetCell> cells;
        for (std::size_t i = 0; i < count; ++i) cells.push_back({std::to_string(i), "", &image});
        const auto rows = flow(cells, {});
        std::size_t next = 0;
        for (const auto& row : rows) {
            EXPECT_LE(row.size(), rows.front().size());
            for (const SheetCell& cell : row) EXPECT_EQ(cell.title, std::to_string(next++));
        }
        EXPECT_EQ(next, count);
    }
}

TEST(Insets, LieWhereThePicturesDiffer) {
    const Image reference = flat(60, 40, {0.5f, 0.5f, 0.5f});
    // Both err on the left alike, one alone on the right and less.
    const auto wrong = [](bool right) {
        return make_image(60, 40, [right](std::uint32_t x, std::uint32_t y) {
            if (x < 10 && y < 10) return glm::vec3(1);
            return right && x >= 45 && x < 55 && y >= 20 && y < 28 ? glm::vec3(0.7f) : glm::vec3(0.5f);
        });
    };
    const Image a = wrong(false), b = wrong(true);
    const auto both = choose_insets({&a, &b}, reference, Tonemap{}, 10, 8, 2);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].x, 45u);
    EXPECT_EQ(both[0].y, 20u);
    const auto alone = choose_insets({&b}, reference, Tonemap{}, 10, 8, 1);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_LE(alone[0].x + alone[0].y, 2u) << "one picture: where it errs most";
}

TEST(Insets, NeverOverlapNorLeaveThePicture) {
    const Image a = make_image(30, 20, [](std::uint32_t x, std::uint32_t y) {
        return glm::vec3(static_cast<float>((x * 7 + y * 13) % 10) / 10);
    });
    const Image reference = flat(30, 20, {0.5f, 0.5f, 0.5f});
    const auto insets = choose_insets({&a}, reference, Tonemap{}, 9, 9, 50);
    EXPECT_GE(insets.size(), 2u);
    EXPECT_LE(insets.size(), 6u);
    for (std::size_t i = 0; i < insets.size(); ++i) {
        EXPECT_LE(insets[i].x + insets[i].width, 30u);
        EXPECT_LE(insets[i].y + insets[i].height, 20u);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_TRUE(insets[i].x + 9 <= insets[k].x || insets[k].x + 9 <= insets[i].x ||
                        insets[i].y + 9 <= insets[k].y || insets[k].y + 9 <= insets[i].y);
    }
    EXPECT_TRUE(choose_insets({&a}, reference, Tonemap{}, 31, 5, 2).empty());
    EXPECT_TRUE(choose_insets({}, reference, Tonemap{}, 3, 5, 2).empty());
}

} // namespace ajar::test
