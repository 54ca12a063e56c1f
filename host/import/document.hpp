// The file being imported: its JSON, its GLB chunk, the files it refers to, its warnings, and what it may
// still cost.
#pragma once

#include "import/import.hpp"
#include "import/json.hpp"

#include <memory>
#include <nlohmann/json.hpp>

namespace ajar::gltf {

class Document {
  public:
    // `bytes` must outlive the document. Reads the container, the JSON and the asset, and checks the version.
    Document(std::span<const std::byte> bytes, std::string file, std::filesystem::path folder,
             const ImportOptions& options);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const JsonObject& root() const { return *root_; }
    const std::string& file() const { return info_.file; }
    const ImportOptions& options() const { return options_; }
    std::span<const std::byte> bin() const { return bin_; } // the GLB's binary chunk, or nothing
    AssetInfo& info() { return info_; }

    // Length of a top-level array; 0 when missing.
    std::size_t count(std::string_view key) const;

    // The bytes that the object's `uri` means: a data URI's own, or a file's.
    std::vector<std::byte> resource(const JsonObject& object);

    // One line, prefixed by the file's name.
    void warn(std::string_view message);

    // Says before allocating that `bytes` more are about to be decoded. Throws Error past the limit.
    void charge(std::uint64_t bytes, const JsonObject& cause);
    void charge_triangles(std::uint64_t count, const JsonObject& cause);

  private:
    void read_container(std::span<const std::byte> bytes);
    void read_asset();

    const ImportOptions& options_;
    std::filesystem::path folder_;
    AssetInfo info_;
    nlohmann::json json_;
    std::unique_ptr<JsonObject> root_;
    std::span<const std::byte> bin_;
    std::uint64_t decoded_ = 0;
    std::uint64_t triangles_ = 0;
};

} // namespace ajar::gltf
