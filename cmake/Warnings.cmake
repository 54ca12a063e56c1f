# The warnings of the dev preset, as one interface target that every room links.
option(AJAR_WARNINGS_AS_ERRORS "Turn on every warning of the dev preset and make it an error" OFF)
add_library(ajar_warnings INTERFACE)
target_compile_options(ajar_warnings INTERFACE -Wall -Wextra)
if(AJAR_WARNINGS_AS_ERRORS)
  target_compile_options(ajar_warnings INTERFACE -Wshadow -Wconversion -Werror)
endif()
