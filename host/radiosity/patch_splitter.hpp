// Bisection of a PatchMesh's patches that keeps it conforming.
//
// Edges are split from the longest of those that are wanted. Where it is the longest of each patch that
// shares it, all of them are split at once; where it is not, that patch's longest edge is wanted first. If
// every edge is wanted, the longest is always the longest of all its patches: nothing has to be put first.
#pragma once

#include "radiosity/patch_mesh.hpp"
#include "radiosity/vertex_welder.hpp"

#include <array>
#include <queue>

namespace ajar {

class PatchSplitter {
  public:
    // `mesh` must outlive this; between construction and finish() its nodes and patches are unordered.
    explicit PatchSplitter(PatchMesh& mesh);

    void want_all();
    void want(std::uint32_t patch); // its longest edge

    // Splits wanted edges that are longer than `length` (metres), until there are none or `patches` patches.
    // `follow`: the edges that come into being are wanted too.
    void split(double length, std::uint32_t patches, bool follow);

    // Orders sources' patches along their trees, vertices by first use. Returns what each was part of at
    // construction.
    std::vector<std::uint32_t> finish();

  private:
    static constexpr std::uint32_t NONE = 0xffffffffu;

    struct Edge {
        std::uint32_t a = 0; // vertices, a < b
        std::uint32_t b = 0;
        std::uint32_t first_use = NONE; // 3 * patch + place; next_use_ leads on
        bool frozen = false;            // cannot be split: floats are too coarse, or a tree too deep
        bool was_split = false;
    };
    struct Wanted {
        double squared_length;
        std::uint32_t edge;
        bool operator<(const Wanted& other) const { // the queue's top is the greatest
            return squared_length != other.squared_length ? squared_length < other.squared_length
                                                          : edge > other.edge;
        }
    };

    std::uint32_t edge_between(std::uint32_t v, std::uint32_t w);
    Wanted wanted(std::uint32_t edge) const;
    void want_edge(std::uint32_t edge) { queue_.push(wanted(edge)); }
    std::uint32_t longest_edge(std::uint32_t patch) const;
    void link(std::uint32_t patch);
    void unlink(std::uint32_t patch);
    bool ready(std::uint32_t edge);
    void split_edge(std::uint32_t edge, std::uint32_t middle, bool follow);
    void bisect(std::uint32_t patch, std::uint32_t place, std::uint32_t middle);

    PatchMesh& mesh_;
    VertexWelder welder_;
    std::vector<Edge> edges_;
    IndexTable edge_table_;
    std::vector<std::array<std::uint32_t, 3>> patch_edges_; // by place
    std::vector<std::uint32_t> next_use_;                   // by use
    std::vector<std::uint32_t> node_of_;                    // by patch
    std::vector<std::uint32_t> origin_;                     // by patch: its number at construction
    std::vector<std::uint8_t> depth_;                       // by patch
    std::priority_queue<Wanted> queue_;
};

} // namespace ajar
