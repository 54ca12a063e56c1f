#include "import/extras.hpp"

#include <fmt/format.h>

namespace ajar::gltf {

std::optional<float> extras_number(Document& document, const JsonObject& object, std::string_view key,
                                   float highest, std::string_view owner) {
    const auto extras = object.extras();
    if (!extras || !extras->has(key)) return std::nullopt;
    const std::optional<double> number = extras->if_number(key);
    if (number && *number == 0) return std::nullopt; // as good as missing
    const auto value = static_cast<float>(number.value_or(-1));
    if (value > 0 && value <= highest) return value;
    document.warn(
        fmt::format("{}: extras.{} is ignored: it is not a number from 0 to {:g}", owner, key, highest));
    return std::nullopt;
}

bool extras_flag(Document& document, const JsonObject& object, std::string_view key, std::string_view owner) {
    const auto extras = object.extras();
    if (!extras || !extras->has(key)) return false;
    const std::optional<bool> value = extras->if_flag(key);
    if (!value) document.warn(fmt::format("{}: extras.{} is ignored: it is not true or false", owner, key));
    return value.value_or(false);
}

} // namespace ajar::gltf
