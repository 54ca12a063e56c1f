// Writes the seeds of the unit tests into a folder, as GLB and as text: fuzz_seeds FOLDER
#include "base/file.hpp"
#include "unit/import/seeds.hpp"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        for (const ajar::test::Seed& seed : ajar::test::seeds()) {
            ajar::write_file(folder / (seed.name + ".glb"), seed.builder.glb());
            ajar::write_file(folder / (seed.name + ".gltf"), seed.builder.text());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fuzz_seeds: %s\n", error.what());
        return 1;
    }
    return 0;
}
