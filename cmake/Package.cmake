# cmake --install and the CMake package: find_package(ajar) gives the target ajar::ajar.
