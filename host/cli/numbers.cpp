#include "cli/numbers.hpp"

#include <cstdlib>
#include <fmt/format.h>

namespace ajar::cli {

CLI::Validator number(double low, double high) {
    return CLI::Validator(
        [low, high](const std::string& text) {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (!text.empty() && *end == '\0' && value >= low && value <= high) return std::string();
            if (high == HUGE_NUMBER && low == -HUGE_NUMBER)
                return fmt::format("'{}' is not a finite number", text);
            if (high == HUGE_NUMBER) return fmt::format("'{}' is not a number of at least {}", text, low);
            return fmt::format("'{}' is not a number from {} to {}", text, low, high);
        },
        "");
}

CLI::Validator count(std::uint32_t low, std::uint32_t high) { return number(low, high); }

} // namespace ajar::cli
