// OpenImageIO's readers behind one door, for the rest of this room: the size is checked before anything is
// allocated, rows come in bands (so that memory grows only as data is really there), and every failure is an
// Error of one line.
#pragma once

#include "image/format.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ajar {

class Decoder {
  public:
    // The bytes must outlive the decoder. Refuses more than `max_pixels`.
    Decoder(std::span<const std::byte> bytes, std::string name, std::uint64_t max_pixels);
    ~Decoder();
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    Format format() const { return claim_.format; }
    std::uint32_t width() const { return static_cast<std::uint32_t>(claim_.width); }
    std::uint32_t height() const { return static_cast<std::uint32_t>(claim_.height); }
    std::uint32_t channels() const { return static_cast<std::uint32_t>(spec_.nchannels); }
    const OIIO::ImageSpec& spec() const { return spec_; }

    // Reads all rows from the top, all channels interleaved as T, in bands: on_rows(first row, values).
    template <class T> void read(const std::function<void(std::uint32_t, std::span<const T>)>& on_rows) {
        const std::uint32_t step = band_height();
        std::vector<T> band;
        for (std::uint32_t y = 0; y < height(); y += step) {
            const std::uint32_t end = y + std::min(step, height() - y);
            band.resize(std::size_t{width()} * channels() * (end - y));
            read_band(y, end, OIIO::BaseTypeFromC<T>::value, band.data());
            on_rows(y, band);
        }
    }

  private:
    std::uint32_t band_height() const;
    void read_band(std::uint32_t begin, std::uint32_t end, OIIO::TypeDesc type, void* values);
    [[noreturn]] void fail() const; // with OpenImageIO's message

    std::string name_;
    Claim claim_;
    std::vector<std::byte> png_; // what is left of a PNG file for the reader
    OIIO::Filesystem::IOMemReader source_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
};

// Runs `body`; whatever OpenImageIO or a codec throws, and running out of memory, becomes an Error.
void guard_decoding(const std::string& name, const std::function<void()>& body);

} // namespace ajar
