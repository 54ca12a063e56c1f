#include "import/uri.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

constexpr std::string_view DATA = "data:";

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::array<std::int8_t, 256> base64_values() {
    std::array<std::int8_t, 256> values;
    values.fill(-1);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
    values['-'] = 62; // the URL-safe alphabet is unambiguous, so it is read as well
    values['_'] = 63;
    return values;
}

std::vector<std::byte> decode_base64(std::string_view text) {
    const std::array<std::int8_t, 256> values = base64_values();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    if (text.size() % 4 == 1) throw Error("its base64 data is cut off");
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = values[static_cast<unsigned char>(c)];
        if (value < 0) throw Error("its base64 data holds a character that is not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count & 0xff));
        }
    }
    return bytes;
}

bool starts_with_scheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri[0])))
        return false;
    return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                       [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

} // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with(DATA); }

std::vector<std::byte> decode_data_uri(std::string_view uri) {
    uri.remove_prefix(DATA.size());
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) throw Error("is a data URI without a comma");
    const std::string_view data = uri.substr(comma + 1);
    if (uri.substr(0, comma).ends_with(";base64"))
        return decode_base64(data.find('%') == std::string_view::npos ? data : percent_decode(data));
    const std::string text = percent_decode(data);
    std::vector<std::byte> bytes(text.size());
    std::transform(text.begin(), text.end(), bytes.begin(), [](char c) { return static_cast<std::byte>(c); });
    return bytes;
}

std::string percent_decode(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && text.size() - i > 2 ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        if (low >= 0) {
            result += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri) {
    if (uri.empty()) throw Error("is empty");
    if (starts_with_scheme(uri))
        throw Error(
            fmt::format("'{}' is not a relative path (download the file and refer to it by name)", uri));
    const std::string decoded = percent_decode(uri);
    if (decoded.front() == '/' || decoded.front() == '\\')
        throw Error(
            fmt::format("'{}' is an absolute path (refer to the file relative to the glTF file)", uri));
    if (decoded.find('\0') != std::string::npos) throw Error("holds a zero byte");
    if (folder.empty())
        throw Error(fmt::format("refers to the file '{}', and there is no folder to look in", uri));
    const std::filesystem::path path = folder / decoded;
    std::error_code code;
    // A name may hold a literal percent sign that its exporter did not escape.
    if (!std::filesystem::exists(path, code) && std::filesystem::exists(folder / uri, code))
        return folder / uri;
    return path;
}

} // namespace ajar::gltf
