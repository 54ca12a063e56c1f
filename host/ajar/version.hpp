// The version of the library, for programs that check it at run time.
#pragma once

#include <string_view>

namespace ajar {

// "MAJOR.MINOR.PATCH"
std::string_view version();

} // namespace ajar
