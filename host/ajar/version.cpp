#include "ajar/version.hpp"

namespace ajar {

std::string_view version() { return AJAR_VERSION; }

} // namespace ajar
