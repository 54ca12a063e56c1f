# cmake --install and the CMake package: find_package(ajar) gives the target ajar::ajar.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The library of the public interface. Whole rooms where a program may call what the interface
# itself does not.
set(exports ${PROJECT_SOURCE_DIR}/cmake/exports.map)
add_library(ajar_library SHARED $<TARGET_OBJECTS:ajar_ajar> $<TARGET_OBJECTS:ajar_gpu>
                                $<TARGET_OBJECTS:ajar_image>)
add_library(ajar::ajar ALIAS ajar_library)
target_link_libraries(ajar_library PRIVATE ajar_ajar -Wl,--version-script=${exports})
target_compile_features(ajar_library INTERFACE cxx_std_20)
set_target_properties(
  ajar_library
  PROPERTIES OUTPUT_NAME ajar
             EXPORT_NAME ajar
             VERSION ${PROJECT_VERSION}
             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
             LINK_DEPENDS ${exports}
             LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# The headers that other programs include: <ajar/ajar.hpp> and what it needs. Their includes of rooms
# are rewritten from "base/error.hpp" to <ajar/base/error.hpp>, so that no name can meet one of the
# program's own.
set(host ${PROJECT_SOURCE_DIR}/host)
set(generated ${PROJECT_BINARY_DIR}/include/ajar)
file(GLOB public_headers RELATIVE ${host} CONFIGURE_DEPENDS ${host}/ajar/*.hpp)
list(REMOVE_ITEM public_headers ajar/manifest.hpp ajar/radiosity_manifest.hpp ajar/scene_hash.hpp)
list(APPEND public_headers bake/settings.hpp base/error.hpp base/events.hpp gpu/device.hpp image/image.hpp
     radiosity/settings.hpp render/settings.hpp)
foreach(header IN LISTS public_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${host}/${header})
  string(REGEX REPLACE "^ajar/" "" installed ${header})
  cmake_path(GET installed PARENT_PATH folder)
  file(READ ${host}/${header} text)
  string(REGEX REPLACE "#include \"ajar/([^\"]+)\"" "#include <ajar/\\1>" text "${text}")
  string(REGEX REPLACE "#include \"([^\"]+)\"" "#include <ajar/\\1>" text "${text}")
  file(WRITE ${generated}/${installed} "${text}")
  install(FILES ${generated}/${installed} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ajar/${folder})
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/ajar)
install(TARGETS ajar_command RUNTIME)
install(TARGETS ajar_library EXPORT ajarTargets LIBRARY
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT ajarTargets NAMESPACE ajar:: DESTINATION ${package})
file(WRITE ${PROJECT_BINARY_DIR}/ajarConfig.cmake
     "include(\"\${CMAKE_CURRENT_LIST_DIR}/ajarTargets.cmake\")\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ajarConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ajarConfig.cmake ${PROJECT_BINARY_DIR}/ajarConfigVersion.cmake
        DESTINATION ${package})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/cornell-box
        DESTINATION ${CMAKE_INSTALL_DATADIR}/ajar/scenes)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
