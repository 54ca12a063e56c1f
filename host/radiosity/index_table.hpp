// A hash table of indices of things that are kept elsewhere: open addressing, linear probing, no removal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ajar {

class IndexTable {
  public:
    // The index i for which same(i); where there is none, what make() returns, which is kept from then on.
    // `hash`: all bits good; rehash(i) must give that of index i again.
    template <class Same, class Make, class Rehash>
    std::uint32_t find_or_make(std::uint64_t hash, Same&& same, Make&& make, Rehash&& rehash) {
        if (2 * (count_ + 1) > slots_.size()) grow(rehash);
        std::size_t at = hash & (slots_.size() - 1);
        for (; slots_[at] != EMPTY; at = (at + 1) & (slots_.size() - 1))
            if (same(slots_[at])) return slots_[at];
        ++count_;
        return slots_[at] = make();
    }

    // Fibonacci hashing with the high bits folded down (Knuth, volume 3, section 6.4).
    static std::uint64_t mix(std::uint64_t key) {
        key *= 0x9e3779b97f4a7c15u;
        return key ^ key >> 32;
    }

  private:
    static constexpr std::uint32_t EMPTY = 0xffffffffu;

    template <class Rehash> void grow(Rehash&& rehash) {
        const std::vector<std::uint32_t> old = std::move(slots_);
        slots_.assign(old.empty() ? 64 : 2 * old.size(), EMPTY);
        for (const std::uint32_t index : old) {
            if (index == EMPTY) continue;
            std::size_t at = rehash(index) & (slots_.size() - 1);
            while (slots_[at] != EMPTY) at = (at + 1) & (slots_.size() - 1);
            slots_[at] = index;
        }
    }

    std::vector<std::uint32_t> slots_; // a power of two of them
    std::size_t count_ = 0;
};

} // namespace ajar
