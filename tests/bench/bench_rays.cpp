// Traces the very same rays with Ajar's kernels and with Embree's single-ray functions, one thread each, in
// rounds that take turns, and prints the medians in millions of rays a second. Exits with 3 when hits
// disagree.
#include "base/error.hpp"
#include "bench_scenes.hpp"
#include "embree_tracer.hpp"
#include "kernels/trace/trace_rig.hpp"
#include "rays.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

namespace ajar::bench {
namespace {

struct Settings {
    bool json = false;
    int rounds = 7;
    std::uint32_t size = 512;
    std::uint32_t segment_size = 512;
    std::vector<std::string> scenes = {"big", "small"};
};

struct Rates {
    double ajar_mrays = 0;
    double embree_mrays = 0;
    double ratio = 0; // median of the rounds' ratios
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

// Processor time, as other work on the machine would disturb a clock. One round of each in turn; the first,
// in which the driver compiles, does not count.
template <class A, class E>
Rates race(const Settings& settings, std::size_t rays, A trace_ajar, E trace_embree) {
    std::vector<double> ajar, embree, ratio;
    for (int round = -1; round < settings.rounds; ++round) {
        const double ajar_seconds = trace_ajar();
        const double start = thread_seconds();
        trace_embree();
        const double embree_seconds = thread_seconds() - start;
        if (round < 0) continue;
        ajar.push_back(double(rays) * 1e-6 / ajar_seconds);
        embree.push_back(double(rays) * 1e-6 / embree_seconds);
        ratio.push_back(embree_seconds / ajar_seconds);
    }
    return {median(ajar), median(embree), median(ratio)};
}

// Where the line meets a triangle's plane, in double precision.
struct ExactHit {
    double t;
    double inside; // the least barycentric weight: above 0 well inside, about 0 on an edge, below 0 outside
};

ExactHit exact_hit(const shared::TriangleRecord& triangle, const glm::vec3& origin,
                   const glm::vec3& direction) {
    const glm::dvec3 a = bvh::record_vertex(triangle, 0);
    const glm::dvec3 e1 = glm::dvec3(bvh::record_vertex(triangle, 1)) - a;
    const glm::dvec3 e2 = glm::dvec3(bvh::record_vertex(triangle, 2)) - a;
    const glm::dvec3 d = direction, s = glm::dvec3(origin) - a, h = glm::cross(d, e2), q = glm::cross(s, e1);
    const double f = 1 / glm::dot(e1, h);
    const double u = f * glm::dot(s, h), v = f * glm::dot(d, q);
    return {f * glm::dot(e2, q), std::min({u, v, 1 - u - v})};
}

constexpr double SAME_T = 1e-4; // relative
constexpr double EDGE = 1e-4;   // barycentric: within it either answer is right

// Whether one of the two answers is wrong. Embree's default mode lets rays through edges; Ajar must not.
bool disagree(std::span<const shared::TriangleRecord> triangles, const glm::vec3& origin,
              const glm::vec3& direction, std::uint32_t ajar, const EmbreeHit& embree) {
    if (ajar == embree.triangle) return false;
    if (ajar == shared::NO_TRIANGLE) return true; // a leak
    const ExactHit exact = exact_hit(triangles[ajar], origin, direction);
    if (embree.triangle == shared::NO_TRIANGLE) return std::abs(exact.inside) > EDGE;
    const ExactHit other = exact_hit(triangles[embree.triangle], origin, direction);
    const bool tie = std::abs(exact.t - other.t) <= SAME_T * std::abs(exact.t);
    const bool edge = std::abs(exact.inside) <= EDGE || std::abs(other.inside) <= EDGE;
    return !tie && !edge;
}

class SceneBench {
  public:
    SceneBench(const gpu::Device& device, const BenchScene& scene, const Settings& settings)
        : settings_(settings), scene_(scene),
          camera_(device, {{scene.triangles}, {}},
                  {.segment_size = settings.segment_size, .extend_option = shared::EXTEND_CAMERA}),
          bounce_(device, {{scene.triangles}, {}},
                  {.segment_size = settings.segment_size,
                   .extend_option = shared::EXTEND_BOUNCE,
                   .connect_option = bvh::suits_shadow_packets(camera_.bvh()) ? shared::CONNECT_TOGETHER
                                                                              : shared::CONNECT_APART}),
          embree_(camera_.triangles()) {}

    nlohmann::json run() {
        const auto primary = primary_rays(scene_, settings_.size);
        nlohmann::json report{{"triangles", scene_.triangles.size()}};
        const auto [primary_rates, hits] = closest(camera_, primary);
        const auto [bounce_rates, bounce_hits] = closest(bounce_, bounce_rays(hits, camera_.triangles(), 11));
        const Rates shadow_rates = any(shadow_rays(scene_, hits, camera_.triangles(), 13));
        report["primary"] = to_json(primary_rates);
        report["bounce"] = to_json(bounce_rates);
        report["shadow"] = to_json(shadow_rates);
        report["mismatches"] = mismatches_;
        if (exhausted_ > 0)
            throw Error(scene_.name + ": " + std::to_string(exhausted_) + " rays ran out of iterations");
        return report;
    }

  private:
    static nlohmann::json to_json(const Rates& rates) {
        return {
            {"ajar_mrays", rates.ajar_mrays}, {"embree_mrays", rates.embree_mrays}, {"ratio", rates.ratio}};
    }

    std::pair<Rates, std::vector<shared::PathState>> closest(test::TraceRig& rig,
                                                             const std::vector<shared::PathState>& rays) {
        test::RigResult result;
        std::vector<EmbreeHit> hits(rays.size());
        const Rates rates = race(
            settings_, rays.size(),
            [&] {
                result = rig.extend(rays);
                return result.cpu_seconds;
            },
            [&] { embree_.intersect(rays, hits); });
        exhausted_ += result.exhausted;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (disagree(rig.triangles(), rays[i].origin, rays[i].direction, result.paths[i].triangle,
                         hits[i]))
                ++mismatches_;
        }
        return {rates, std::move(result.paths)};
    }

    Rates any(const std::vector<shared::ShadowRay>& rays) {
        test::RigResult result;
        std::vector<char> open(rays.size());
        const Rates rates = race(
            settings_, rays.size(),
            [&] {
                result = bounce_.connect(rays);
                return result.cpu_seconds;
            },
            [&] { embree_.occluded(rays, open); });
        exhausted_ += result.exhausted;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (result.open[i] != (open[i] != 0) && wrong_visibility(rays[i], result.open[i])) ++mismatches_;
        }
        return rates;
    }

    // The two differ; that is no mistake where the blocker's edge or the ray's end decides.
    bool wrong_visibility(const shared::ShadowRay& ray, bool ajar_open) const {
        bool clear_blocker = false, any_blocker = false;
        for (const shared::TriangleRecord& triangle : camera_.triangles()) {
            const ExactHit hit = exact_hit(triangle, ray.origin, ray.direction);
            const double margin = SAME_T * ray.reach;
            any_blocker |= hit.inside > -EDGE && hit.t > -margin && hit.t < ray.reach + margin;
            clear_blocker |= hit.inside > EDGE && hit.t > margin && hit.t < ray.reach - margin;
        }
        return ajar_open ? clear_blocker : !any_blocker;
    }

    const Settings& settings_;
    const BenchScene& scene_;
    test::TraceRig camera_, bounce_;
    EmbreeTracer embree_;
    std::uint64_t mismatches_ = 0;
    std::uint64_t exhausted_ = 0;
};

BenchScene make_scene(const std::string& name) {
    if (name == "big") return big_scene();
    if (name == "small") return small_scene();
    return load_scene(name);
}

void print(const std::string& name, const nlohmann::json& report) {
    std::printf("%s: %llu triangles, %llu mismatches\n", name.c_str(),
                report["triangles"].get<unsigned long long>(),
                report["mismatches"].get<unsigned long long>());
    for (const char* kind : {"primary", "bounce", "shadow"}) {
        const nlohmann::json& rates = report[kind];
        std::printf("  %-8s Ajar %6.2f Mrays/s   Embree %6.2f Mrays/s   ratio %.2f\n", kind,
                    rates["ajar_mrays"].get<double>(), rates["embree_mrays"].get<double>(),
                    rates["ratio"].get<double>());
    }
}

int run(const Settings& settings) {
    const gpu::Device device(gpu::DeviceOptions{});
    nlohmann::json reports;
    std::uint64_t mismatches = 0;
    for (const std::string& name : settings.scenes) {
        const BenchScene scene = make_scene(name);
        const nlohmann::json report = SceneBench(device, scene, settings).run();
        mismatches += report["mismatches"].get<std::uint64_t>();
        if (!settings.json) print(scene.name, report);
        reports[scene.name] = report;
    }
    if (settings.json) std::printf("%s\n", reports.dump().c_str());
    return mismatches == 0 ? 0 : 3;
}

} // namespace
} // namespace ajar::bench

int main(int argc, char** argv) {
    setenv("LP_NUM_THREADS", "1", 1); // lavapipe reads it when the device is created
    ajar::bench::Settings settings;
    CLI::App app("Ajar's ray kernels against Embree, one thread each, on the same rays.");
    app.add_flag("--json", settings.json, "One JSON object instead of a table");
    app.add_option("--rounds", settings.rounds, "Timed rounds; the medians are reported")
        ->check(CLI::Range(1, 1000));
    app.add_option("--size", settings.size, "Side of the picture, a power of two")
        ->check(CLI::Range(8, 4096));
    app.add_option("--segment", settings.segment_size, "Rays per segment")->check(CLI::Range(64, 1024));
    app.add_option("scenes", settings.scenes, "big, small or glTF files (default: big small)");
    CLI11_PARSE(app, argc, argv);
    try {
        return ajar::bench::run(settings);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_rays: error: %s\n", error.what());
        return 1;
    }
}
